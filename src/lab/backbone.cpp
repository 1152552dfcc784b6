#include "lab/backbone.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "lab/statistics.hpp"

namespace fabricsh::lab {

double backbone_stress(const std::vector<double>& d, double E) {
  double sum = 0;
  for (std::size_t i = d.size(); i-- > 0;) sum = (sum + d[i] / static_cast<double>(i + 1)) * E;
  return sum;
}

double backbone_tangent(const std::vector<double>& d, double E) {
  double sum = 0;
  for (std::size_t i = d.size(); i-- > 0;) sum = sum * E + d[i];
  return sum;
}

std::pair<double, double> from_contact(double E, double S, double e) {
  return {((1 + 2 * E) / ((1 + e) * (1 + e)) - 1) / 2, S * (1 + e)};
}

namespace {

using Weights = std::vector<double>;  // one per point, 1/Pa^2

// Fits the polynomial through zero to one specimen for a given stretch of contact, by linear least squares.
SpecimenFit fit_given(const Tension& t, const Weights& weights, int degree, double slack) {
  const Eigen::Index n = degree;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), powers(n);
  SpecimenFit fit;
  fit.slack = slack;
  fit.points = t.E.size();
  const double scale = std::max(1e-12, *std::max_element(t.E.begin(), t.E.end()));
  double before = 0, total = 0;
  for (std::size_t i = 0; i < t.E.size(); ++i) {
    const auto [E, S] = from_contact(t.E[i], t.S[i], slack);
    if (E <= 0) {
      before += weights[i] * S * S;
      continue;
    }
    fit.reach = std::max(fit.reach, E);
    double power = 1;
    for (Eigen::Index k = 0; k < n; ++k) powers(k) = power *= E / scale;
    normal.noalias() += weights[i] * powers * powers.transpose();
    right.noalias() += weights[i] * S * powers;
    total += weights[i] * S * S;
  }
  const Eigen::VectorXd c = normal.ldlt().solve(right);
  fit.squares = before + std::max(0.0, total - 2 * c.dot(right) + c.dot(normal * c));
  for (int k = 1; k <= degree; ++k) fit.d.push_back(c(k - 1) * k / std::pow(scale, k));
  return fit;
}

// The largest stretch of contact to try: where the stress reaches a tenth of its peak.
double largest_slack(const Tension& t) {
  const double peak = *std::max_element(t.S.begin(), t.S.end());
  std::size_t i = 0;
  while (t.S[i] < 0.1 * peak) ++i;
  return std::sqrt(1 + 2 * std::max(0.0, t.E[i])) - 1;
}

// Finds the stretch of contact with the least sum of squares: a scan, then golden section search.
SpecimenFit fit_with_slack(const Tension& t, const Weights& weights, int degree) {
  constexpr int steps = 40;
  constexpr double golden = 0.6180339887498949;
  const double most = largest_slack(t);
  const auto squares = [&](double e) { return fit_given(t, weights, degree, e).squares; };
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
    if (const double s = squares(most * i / steps); s < least) least = s, best = i;
  double low = most * std::max(0, best - 1) / steps, high = most * std::min(steps, best + 1) / steps;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = squares(a), fb = squares(b);
  for (int i = 0; i < 40; ++i) {
    if (fa < fb) {
      high = b, b = a, fb = fa;
      fa = squares(a = high - golden * (high - low));
    } else {
      low = a, a = b, fa = fb;
      fb = squares(b = low + golden * (high - low));
    }
  }
  return fit_given(t, weights, degree, (low + high) / 2);
}

SpecimenFit fit_weighted(const Tension& t, const Weights& weights, int degree, bool find_slack) {
  return find_slack ? fit_with_slack(t, weights, degree) : fit_given(t, weights, degree, 0);
}

struct FitScatter {
  std::vector<double> squares;   // of the residuals, Pa^2
  std::vector<double> tangents;  // squared, Pa^2
};

FitScatter scatter_about(const SpecimenFit& fit, const Tension& t) {
  FitScatter out;
  for (std::size_t i = 0; i < t.E.size(); ++i) {
    const auto [E, S] = from_contact(t.E[i], t.S[i], fit.slack);
    const double miss = S - (E > 0 ? backbone_stress(fit.d, E) : 0);
    out.squares.push_back(miss * miss);
    out.tangents.push_back(E > 0 ? std::pow(backbone_tangent(fit.d, E), 2) : 0);
  }
  return out;
}

}  // namespace

std::vector<double> effective_weights(const std::vector<double>& squares,
                                      const std::vector<double>& tangents) {
  const auto n = static_cast<double>(squares.size());
  const double largest = *std::max_element(tangents.begin(), tangents.end());
  double best = std::numeric_limits<double>::infinity();
  Weights out(squares.size()), trial(out);
  for (int i = -1; i < 80; ++i) {
    const double ratio = i < 0 ? 0 : std::pow(10.0, -3 + 0.1 * i) / largest;
    double a = std::numeric_limits<double>::min(), logs = 0;
    for (std::size_t k = 0; k < out.size(); ++k) {
      trial[k] = 1 / (1 + ratio * tangents[k]);
      a += squares[k] * trial[k] / n;
      logs -= std::log(trial[k]) / n;
    }
    if (std::log(a) + logs >= best) continue;
    best = std::log(a) + logs;
    std::transform(trial.begin(), trial.end(), out.begin(), [a](double w) { return w / a; });
  }
  return out;
}

namespace {

Weights weights_of(const Tension& t, int degree, bool find_slack) {
  Weights weights(t.E.size(), 1.0);
  for (int turn = 0; turn < 4; ++turn) {
    const FitScatter s = scatter_about(fit_weighted(t, weights, degree, find_slack), t);
    weights = effective_weights(s.squares, s.tangents);
  }
  return weights;
}

DegreeCandidate judged(DegreeCandidate c, bool with_slack) {
  double reach = std::numeric_limits<double>::infinity();
  std::vector<double> mean(static_cast<std::size_t>(c.degree));
  for (const SpecimenFit& s : c.specimens) {
    c.criterion += s.squares + (c.degree + (with_slack ? 1 : 0)) * std::log(static_cast<double>(s.points));
    reach = std::min(reach, s.reach);
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += s.d[k] / static_cast<double>(c.specimens.size());
  }
  c.initial = c.least = mean[0];
  for (int i = 1; i <= 200; ++i) c.least = std::min(c.least, backbone_tangent(mean, reach * i / 200));
  c.admissible = c.initial > 0 && c.least > 0;
  return c;
}

}  // namespace

std::vector<DegreeCandidate> fit_backbones(const std::vector<Tension>& loading,
                                           const BackboneOptions& options) {
  const int richest = *std::max_element(options.degrees.begin(), options.degrees.end());
  std::vector<Weights> weights;
  for (const Tension& t : loading) {
    if (t.E.size() < static_cast<std::size_t>(richest) + 2)
      throw Error("expected at least " + std::to_string(richest + 2) +
                  " loading points of every specimen, got " + std::to_string(t.E.size()) + " of specimen " +
                  std::to_string(weights.size() + 1));
    weights.push_back(weights_of(t, richest, options.find_slack));
  }
  std::vector<DegreeCandidate> out;
  for (const int degree : options.degrees) {
    DegreeCandidate c;
    c.degree = degree;
    for (std::size_t i = 0; i < loading.size(); ++i) {
      c.specimens.push_back(fit_weighted(loading[i], weights[i], degree, options.find_slack));
      const auto squares = scatter_about(c.specimens.back(), loading[i]).squares;
      c.specimens.back().residual = std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0) /
                                              static_cast<double>(squares.size()));
    }
    out.push_back(judged(std::move(c), options.find_slack));
  }
  return out;
}

std::optional<std::size_t> choose(const std::vector<DegreeCandidate>& candidates) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].admissible && (!best || candidates[i].criterion < candidates[*best].criterion))
      best = i;
  return best;
}

namespace {

struct PooledBins {  // adjacent bins with a common mean
  double weight, E, S;
};

std::vector<PooledBins> binned(const std::vector<Tension>& loading, int bins) {
  double reach = std::numeric_limits<double>::infinity();
  for (const Tension& t : loading) reach = std::min(reach, *std::max_element(t.E.begin(), t.E.end()));
  std::vector<PooledBins> sums(static_cast<std::size_t>(bins), PooledBins{0, 0, 0});
  for (const Tension& t : loading)
    for (std::size_t i = 0; i < t.E.size(); ++i) {
      if (t.E[i] <= 0 || t.E[i] > reach) continue;
      const int bin = std::min(bins - 1, static_cast<int>(t.E[i] / reach * bins));
      PooledBins& b = sums[static_cast<std::size_t>(bin)];
      b.weight += 1;
      b.E += t.E[i];
      b.S += t.S[i];
    }
  std::vector<PooledBins> out;
  for (const PooledBins& b : sums)
    if (b.weight > 0) out.push_back({b.weight, b.E / b.weight, b.S / b.weight});
  return out;
}

}  // namespace

std::vector<std::pair<double, double>> monotone_points(const std::vector<Tension>& loading, int bins) {
  std::vector<PooledBins> pooled;
  for (PooledBins b : binned(loading, bins)) {
    while (!pooled.empty() && pooled.back().S >= b.S) {
      const PooledBins& a = pooled.back();
      const double w = a.weight + b.weight;
      b = {w, (a.weight * a.E + b.weight * b.E) / w, (a.weight * a.S + b.weight * b.S) / w};
      pooled.pop_back();
    }
    pooled.push_back(b);
  }
  std::vector<std::pair<double, double>> points{{0, 0}};
  for (const PooledBins& b : pooled)
    if (b.S > 0) points.emplace_back(b.E, b.S);
  return points;
}

namespace {

double line_slope(std::span<const double> x, std::span<const double> y) {
  const Eigen::Map<const Eigen::ArrayXd> ex(x.data(), static_cast<Eigen::Index>(x.size()));
  const Eigen::Map<const Eigen::ArrayXd> ey(y.data(), static_cast<Eigen::Index>(y.size()));
  const Eigen::ArrayXd dx = ex - ex.mean();
  return (dx * (ey - ey.mean())).sum() / dx.square().sum();
}

double median_slope(std::span<const double> x, std::span<const double> y) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if (x[j] != x[i]) slopes.push_back((y[j] - y[i]) / (x[j] - x[i]));
  return median(std::move(slopes));
}

}  // namespace

std::optional<double> unloading_modulus(std::span<const double> E, std::span<const double> S,
                                        const UnloadingOptions& options) {
  std::size_t n = std::min(options.count, E.size());
  if (options.rule == UnloadingRule::robust) {
    n = 0;
    while (n < S.size() && n < 200 && S[n] > options.kept * S[0]) ++n;
  }
  if (n < 2 || E[0] == E[n - 1]) return {};
  return options.rule == UnloadingRule::first ? line_slope(E.first(n), S.first(n))
                                              : median_slope(E.first(n), S.first(n));
}

}  // namespace fabricsh::lab
