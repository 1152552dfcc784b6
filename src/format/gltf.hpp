// Surfaces that move and change their colours, as a binary glTF 2.0 file (.glb), which browsers and modellers
// show. Either the frames after the first are morph targets, and an animation goes from one to the next; or
// each frame is a mesh of its own, and an animation shows one after the other.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::format {

struct GltfSurface {
  using Colour = std::array<float, 3>;  // red, green, blue, linear, 0 to 1
  std::string name;
  std::vector<std::array<mesh::Index, 4>> cells;  // ids from 0; a triangle has -1 in the last place
  std::vector<std::vector<Vec3>> frames;          // m: places of the points, one list a frame
  std::vector<std::vector<Colour>> colours = {};  // of the points, one list a frame; none: plain
  Colour plain = {0.5f, 0.5f, 0.5f};
};

struct GltfScene {
  std::vector<double> times;  // s of the animation, rising from 0, one a frame
  std::vector<GltfSurface> surfaces;
  bool morph = true;
  bool z_up = true;  // glTF has y up: the scene is turned
  std::string generator = "fabricsh";
};

// Error: no frame, no cell, lists of other lengths than the frames and points.
std::string glb(const GltfScene& scene);

}  // namespace fabricsh::format
