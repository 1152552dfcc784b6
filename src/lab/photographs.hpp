// Photographs of cloth: dots and speckles followed through a series, or drawn for trying that. They are an
// optional part, the module photographs.so of the room photograph, which is loaded when one of them is first
// asked for, so that the program starts and is installed without the libraries of picture formats.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/markers.hpp"

namespace fabricsh::lab {

// Pixels from `left` to `right` - 1, `top` to `bottom` - 1.
struct PixelRegion {
  int left = 0, top = 0, right = 0, bottom = 0;
};

// Photographs in order: PNG, JPEG, TIFF or BMP. The caller reads their files, and says which part of one to
// look at.
struct PhotographSeries {
  std::vector<std::string> names;
  std::function<std::string(const std::string& name)> read;
  std::function<PixelRegion(int width, int height)> region;
};

struct DotOptions {
  bool dark = true;      // dark dots on a lighter background
  double smallest = 12;  // area, pixels
  double largest = 1e5;
  double contrast = 0.1;  // least
};

struct DoubtfulMarker {
  std::size_t frame, marker;
  bool lost;  // not found (its position is then NaN); otherwise found, but changed
};

struct TrackedDots {
  Tracks tracks;  // pixels, y upwards from the first row of pixels in the first photograph
  std::vector<DoubtfulMarker> doubts;
};

struct CorrelationOptions {
  PixelRegion
      region;     // of the first photograph, in which whole subsets lie; four pixels at its rim are left out
  int half = 12;  // a subset is 2 half + 1 pixels wide and high
  int step = 12;  // between the middles of neighbours
  int search =
      20;  // how far a subset may have moved since the photograph before where no neighbour leads to it
  double least = 0.8;  // correlation below which a subset is lost
  int gauge = 5;       // neighbours in a row whose displacements make a strain
};

// Columns of numbers, a photograph's subsets behind those of the one before, row by row from the lowest; y
// upwards.
struct CorrelatedSubsets {
  std::size_t rows = 0, columns = 0;
  std::vector<double> x, y, E11, E22, E12, correlation, deviation;  // pixels; nan: lost, or without texture
  std::vector<double> found;                                        // part of the subsets, by photograph
};

// A grid of dots under an affine map, as seen by a camera.
struct DotGrid {
  int width = 0, height = 0;            // pixels
  std::size_t rows = 2, columns = 2;    // of dots
  double pitch = 0, radius = 0;         // of the undeformed grid, pixels
  std::array<double, 4> F{1, 0, 0, 1};  // about the centre of image and grid; y downwards
  double ground = 0.85, ink = 0.15;     // brightness of background and dots
  double blur = 1;                      // standard deviation of the point spread, pixels
  double noise = 0.01;                  // standard deviation per pixel, brightness
  std::uint64_t seed = 1;
};

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

// The part. It opens no file: bytes go in and out.
class Photographs {
 public:
  virtual ~Photographs() = default;
  virtual TrackedDots track(const PhotographSeries& series, std::size_t rows, std::size_t columns,
                            const DotOptions& options) const = 0;
  // The region of the options is that which the series gives for its first photograph.
  virtual CorrelatedSubsets correlate(const PhotographSeries& series, CorrelationOptions options) const = 0;
  // PNG, 8-bit grey.
  virtual std::string picture(const DotGrid& scene) const = 0;
  virtual std::string picture(const Speckles& speckles) const = 0;
};

// Loads the part at the first call. Error: it is not installed, is of another version, or a library that it
// needs is missing.
const Photographs& photographs();

}  // namespace fabricsh::lab
