// From the record of a testing machine to stress and strain [williams2010, eqs. 3.1, 3.2, appendix A].
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace fabricsh::lab {

struct Specimen {
  double gauge_length = 0, width = 0, thickness = 0;  // m
  int plies = 1;                                      // layers that carry load: 2 for a sewn loop on pins
  double area() const { return width * thickness * plies; }  // A0, m^2
};

// Displacements recorded besides the stretch of the specimen; all are subtracted.
struct Corrections {
  double compliance = 0;  // of machine and load cell, m/N, elastic
  double slip = 0;        // in the grips, m/N of the largest force so far; irreversible
  double slack = 0;       // displacement at first contact, m: the specimen is longer than the gauge by it
};

struct Tension {
  std::vector<double> E, S;  // Green-Lagrange strain; second Piola-Kirchhoff stress, Pa; along the pull
};

// Displacement of the end of the specimen, m, one value per force (N). Slack is not subtracted here.
std::vector<double> end_displacement(std::span<const double> displacement, std::span<const double> force,
                                     const Corrections& corrections);

// e = u / l, E = e + e^2/2, S = P / (A0 (1 + e)), with l = gauge_length + slack and u reduced by the slack.
Tension stress_strain(std::span<const double> displacement, std::span<const double> force,
                      const Specimen& specimen, double slack = 0);

// The interpolated displacement at which the force rises above `threshold` (N) and stays above it up to the
// largest force. Empty: it never does.
std::optional<double> first_contact(std::span<const double> displacement, std::span<const double> force,
                                    double threshold);

enum class BranchKind { loading, unloading, reloading, hold };
struct PullBranch {
  BranchKind kind;
  std::size_t begin, end;  // rows [begin, end); the row of a reversal belongs to the earlier branch
};

// The branches of a record between reversals of the displacement larger than `tolerance`. Reloading ends
// where the largest displacement so far is reached again. Five or more rows at an extreme (within half a
// usual step, or eight standard deviations of the displacement's noise) are a hold, during which cloth
// relaxes; they belong to no branch.
std::vector<PullBranch> branches(std::span<const double> displacement, double tolerance);

struct Marks {
  std::optional<std::size_t> yield, failure;  // rows
};
// For the loading rows [0, end). Failure: the largest stress, if the stress falls below `kept` of it
// afterwards. Yield: the row from which the tangent (the slope of a line through a window of rows) stays
// below half of its largest value before, up to the failure. Rows below a twentieth of the largest
// stress are ignored, because slack is also soft.
Marks yield_and_failure(std::span<const double> E, std::span<const double> S, std::size_t end, double kept);

}  // namespace fabricsh::lab
