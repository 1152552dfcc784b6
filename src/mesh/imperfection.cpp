// A small deviation of a sheet from its shape, which breaks its symmetry.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/box.hpp"
#include "mesh/generators.hpp"
#include "mesh/normals.hpp"

namespace fabricsh::mesh {

namespace {

constexpr int kWaves = 12;

// Directions are spread over the sphere, wavelengths and phases over their ranges, by multiples of irrational
// numbers: no wave is along a side, and none a multiple of another.
double waves(const Vec3& place) {
  constexpr double golden = 0.6180339887498949, root = 0.41421356237309515;
  double sum = 0;
  for (int k = 1; k <= kWaves; ++k) {
    const double part = (k - 0.5) / kWaves, turn = 2 * std::numbers::pi * k * golden;
    const double rise = 1 - 2 * part, flat = std::sqrt(1 - rise * rise);
    const Vec3 way(flat * std::cos(turn), flat * std::sin(turn), rise);
    const double count = 0.5 + 9.5 * std::fmod(k * root, 1.0);
    sum += std::cos(2 * std::numbers::pi * (count * way.dot(place) + k * root * golden)) / std::sqrt(count);
  }
  return sum;
}

}  // namespace

Mesh imperfect(const Mesh& mesh, double amplitude) {
  Mesh moved = mesh;
  moved.in_use = false;
  const auto normals = node_normals(mesh);
  const auto box = box_of(mesh.nodes);
  const double size = box.size().norm();
  std::vector<double> by(mesh.nodes.size());
  double mean = 0, most = 0;
  for (std::size_t n = 0; n < by.size(); ++n) {
    by[n] = waves((mesh.nodes[n] - mesh.nodes.front()) / size);
    mean += by[n] / static_cast<double>(by.size());
  }
  for (double& b : by) most = std::max(most, std::abs(b -= mean));
  for (std::size_t n = 0; n < by.size() && most > 0; ++n)
    moved.nodes[n] += amplitude / most * by[n] * normals[n];
  return moved;
}

}  // namespace fabricsh::mesh
