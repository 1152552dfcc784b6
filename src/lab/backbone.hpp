// Loading curves and unloading moduli from stress and strain [williams2010, section 7.1].
#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "lab/pull.hpp"

namespace fabricsh::lab {

// S(E) = d0 E + d1 E^2/2 + ... + d(n-1) E^n / n, where d are the coefficients of the tangent D(E), Pa.
double backbone_stress(const std::vector<double>& d, double E);
double backbone_tangent(const std::vector<double>& d, double E);

// Corrects E, S for a gauge that is longer by 1 + e because contact begins at that nominal stretch: E' =
// ((1+2E)/(1+e)^2 - 1)/2, S' = S (1+e).
std::pair<double, double> from_contact(double E, double S, double e);

struct SpecimenFit {
  std::vector<double> d;  // Pa
  double slack = 0;       // nominal stretch of first contact, minus one
  double squares = 0;     // sum of squared residuals over their variance
  double residual = 0;    // root of the mean squared residual, Pa
  std::size_t points = 0;
  double reach = 0;  // largest strain, counted from contact
};

struct BackboneOptions {
  std::vector<int> degrees = {2, 4};  // of the stress polynomial
  bool find_slack = false;            // fit the first contact too; the stress is zero before it
};

struct DegreeCandidate {
  int degree = 0;
  double criterion = 0;     // Schwarz criterion: squares + parameters ln(points), summed over the specimens
  double initial = 0;       // mean D(0), Pa
  double least = 0;         // smallest tangent of the mean curve up to the least reach of the specimens
  bool admissible = false;  // initial and least are positive
  std::vector<SpecimenFit> specimens;
};

// Weighted least squares for each specimen and degree. The variance of a point is that of the stress plus the
// squared tangent times that of the strain (effective variance [orear1982]); both are found by turns, from
// the scatter about the curve of the highest degree, and serve all degrees. Candidates in the order of
// degrees.
std::vector<DegreeCandidate> fit_backbones(const std::vector<Tension>& loading,
                                           const BackboneOptions& options);

// Weights of points, 1/Pa^2, from their squared residuals and squared tangents about a curve: 1/v with v = a
// (1 + ratio D^2), by maximum likelihood; a follows from the ratio, which is searched on a logarithmic scale.
std::vector<double> effective_weights(const std::vector<double>& squares,
                                      const std::vector<double>& tangents);

// The admissible candidate with the smallest criterion.
std::optional<std::size_t> choose(const std::vector<DegreeCandidate>& candidates);

// Measured points (0, 0), (E, S), ... strictly increasing, one per bin of strain: the means of the bins, made
// monotone by pooling adjacent bins that decrease [barlow1972].
std::vector<std::pair<double, double>> monotone_points(const std::vector<Tension>& loading, int bins);

enum class UnloadingRule {
  first,   // least-squares line through the first `count` points
  robust,  // median of the slopes between points with a stress above `kept` of that at reversal [sen1968]
};
struct UnloadingOptions {
  UnloadingRule rule = UnloadingRule::first;
  std::size_t count = 3;
  double kept = 0.7;
};
// Slope dS/dE (Pa) just after a reversal; E and S begin with the first row after it. Empty: too few points.
std::optional<double> unloading_modulus(std::span<const double> E, std::span<const double> S,
                                        const UnloadingOptions& options);

}  // namespace fabricsh::lab
