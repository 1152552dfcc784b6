// Photographs of speckled cloth under a known map, for trying the correlation.
#pragma once
#include <array>
#include <cstdint>

#include "format/image.hpp"

namespace fabricsh::lab {

struct Speckles {
  int width = 0, height = 0;            // pixels
  double size = 2;                      // of a speckle: deviation of its round blot, pixels
  double cover = 0.5;                   // blots of one deviation's area over the area of the cloth
  std::array<double, 4> F{1, 0, 0, 1};  // about the middle of the picture; rows downwards
  std::array<double, 2> shift{0, 0};    // and then by so many pixels
  double noise = 0;                     // of a pixel, brightness
  std::uint64_t pattern = 1;            // seed of the blots
  std::uint64_t seed = 1;               // of the noise
};

// Every blot lets 1 - exp(-r^2 / (2 size^2)) of the light through, so the brightness is a smooth function
// that is known at every place, and a map of the cloth is exact: no picture is interpolated. 8 bits.
format::Image photograph(const Speckles& speckles);

}  // namespace fabricsh::lab
