// Loading curves averaged over the laws that the points allow and over where contact may have begun.
#pragma once
#include <string>
#include <vector>

#include "lab/pull.hpp"

namespace fabricsh::lab {

struct AveragingOptions {
  std::vector<int> degrees;  // of polynomials for the stress; empty: 2 to 6, and splines with 2 to 12 knots
  double probability_none = 0.1;  // that contact begins at zero strain as recorded: 0 where slack is sure
  double earliest = 0;  // least stretch of contact less one, below 0 where the record begins after contact
  int strains = 40;     // of the answer, evenly up to the least reach
};

struct AveragedSpecimen {
  std::vector<double> S;                            // Pa, at the strains of the answer
  double slack = 0, slack_low = 0, slack_high = 0;  // stretch of contact less one, and where 95 % of it lies
  double none = 0;                                  // probability that contact begins at zero
  double variance = 0;                              // of the slack
  double reach = 0;                                 // largest strain from contact
  double residual = 0;  // root of the mean squared residual of the likeliest law, Pa
};

struct AveragedLaw {
  std::string name;  // "degree 3", "spline 8"
  double weight;     // all together 1
};

struct AveragedCurves {
  std::vector<double> E;  // strains from contact, above 0
  std::vector<AveragedSpecimen> specimens;
  // Covariance of one specimen's curve by what its record leaves open: noise, contact and law, Pa^2, row by
  // row.
  std::vector<double> within;
  // The part of it that is alike in all specimens, and that more of them do not make smaller: the law's, and
  // the contact's as far as it is decided by what was assumed of it and not by the records.
  std::vector<double> common;
  std::vector<AveragedLaw> laws;  // the likeliest first
  double correlation = 0;         // of neighbouring residuals of the likeliest law, 0 or more
};

// A specimen's stress is a law f(E') of the strain from contact, zero before it, with f(0) = 0 and no falling
// part. For every law and stretch of contact its coefficients follow from weighted least squares; contact is
// as probable as the residuals say (flat prior from `earliest` to where the stress leaves its noise, besides
// `probability_none` for zero), laws by Akaike's criterion corrected for few points, summed over the
// specimens, which are of one cloth [burnham2002]. Neighbouring residuals that are alike are a misfit, and
// count as fewer points.
AveragedCurves average_curves(const std::vector<Tension>& loading, const AveragingOptions& options);

}  // namespace fabricsh::lab
