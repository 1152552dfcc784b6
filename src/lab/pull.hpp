// From the record of a load frame to stress and strain [williams2010, eqs. 3.1, 3.2, appendix A].
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fabricsh::lab {

struct Specimen {
  double gauge_length = 0, width = 0, thickness = 0;         // m
  int plies = 1;                                             // layers that carry: 2 for a sewn loop on pins
  double area() const { return width * thickness * plies; }  // A0, m^2
};

// What the frame shows beside the stretch of the specimen; all of it is taken off the displacement.
struct Corrections {
  double compliance = 0;  // of frame and load cell, m/N, elastic
  double slip = 0;        // in the grips, m/N of the largest force so far: it does not come back
  double slack = 0;       // displacement of first contact, m: the specimen is that much longer than the gauge
};

struct Tension {
  std::vector<double> E, S;  // Green-Lagrange; second Piola-Kirchhoff, Pa; along the pull
};

// Displacement of the specimen's end, m, of one length with force, N. Slack is not taken off here.
std::vector<double> end_displacement(std::span<const double> displacement, std::span<const double> force,
                                     const Corrections& corrections);

// e = u / l, E = e + e^2/2, S = P / (A0 (1 + e)), with l = gauge_length + slack and u less the slack.
Tension stress_strain(std::span<const double> displacement, std::span<const double> force,
                      const Specimen& specimen, double slack = 0);

// Displacement at which the force rises above `threshold` (N) to stay there until the largest force;
// interpolated. Nothing: it never does.
std::optional<double> first_contact(std::span<const double> displacement, std::span<const double> force,
                                    double threshold);

enum class BranchKind { loading, unloading, reloading, hold };
struct Branch {
  BranchKind kind;
  std::size_t begin, end;  // rows [begin, end); the row of a reversal belongs to the branch before it
};

// Parts of a record between reversals of the displacement larger than `tolerance`; reloading ends where the
// largest displacement so far is reached again. Five rows and more that stay at an extreme (within half a
// usual step or eight deviations of the displacement's noise) are a hold, in which cloth relaxes: it belongs
// to neither side.
std::vector<Branch> branches(std::span<const double> displacement, double tolerance);

struct Marks {
  std::optional<std::size_t> yield, failure;  // rows
};
// On the loading rows [0, end): failure is the largest stress when the stress falls below `kept` of it
// afterwards; yield the row from which on, up to that, the tangent (a line through a window of rows) stays
// below `softening` of its largest value before. Rows below a twentieth of the largest stress do not count:
// slack is soft too.
Marks yield_and_failure(std::span<const double> E, std::span<const double> S, std::size_t end, double kept,
                        double softening);

}  // namespace fabricsh::lab
