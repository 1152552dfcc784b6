// A speckled surface followed through photographs: subsets of the first are found again on each other one.
// Positions in pixels: x to the right and y downwards from the middle of the first pixel.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "lab/photographs.hpp"
#include "photograph/image.hpp"
#include "photograph/spline.hpp"

namespace fabricsh::photograph {

using lab::CorrelationOptions;
using lab::PixelRegion;

// The pixels of a region, which must lie in the picture.
Image cropped(const Image& image, const PixelRegion& region);

// Where the subset with its middle at X has gone: x = X + u + G (X' - X) for its places X'.
struct Subset {
  enum class SubsetState : std::uint8_t { found, textureless, lost };
  double x = 0, y = 0;  // middle on the first photograph
  SubsetState state = SubsetState::lost;
  double u = 0, v = 0;             // displacement
  std::array<double, 4> G{};       // du/dx, du/dy, dv/dx, dv/dy
  double correlation = 0;          // zero-mean normalised
  double deviation = 0;            // of u and v (root mean square), from what differs between the two subsets
  std::array<double, 3> strain{};  // Green-Lagrange xx, yy, xy of the neighbours' displacements; nan: too few
};

class Correlator {
 public:
  // Error: the region holds no subset, or none with a texture that determines a displacement.
  Correlator(const Image& first, const CorrelationOptions& options);
  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  // The subsets, row by row from the top, on another photograph of the same size. Each photograph starts from
  // where the one before left off.
  const std::vector<Subset>& add(const Image& image);
  const std::vector<Subset>& subsets() const { return subsets_; }

 private:
  // The first photograph's part of a subset, without its mean and over its norm, with what moving it changes.
  struct SubsetPattern {
    std::vector<double> values;                    // zero mean, length one
    std::vector<std::array<double, 6>> descent;    // by u, G0, G1, v, G2, G3
    std::array<double, 36> products{}, inverse{};  // of the descent: their sum, and its inverse
    double norm = 0;
  };
  void seed(const Spline& image, const Image& pixels, std::size_t subset);
  bool refine(const Spline& image, Subset& s, std::size_t subset) const;
  double deviation(const SubsetPattern& p, const Subset& s, double rest) const;
  bool searched(const Image& pixels, Subset& s, std::size_t subset) const;
  void spread(const Spline& image, std::vector<std::size_t> found);
  void part_strays();
  void strains();

  int width_, height_;
  CorrelationOptions options_;
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<SubsetPattern> patterns_;
  std::vector<std::size_t> order_;  // subsets with texture, the clearest first
  std::vector<Subset> subsets_;
};

}  // namespace fabricsh::photograph
