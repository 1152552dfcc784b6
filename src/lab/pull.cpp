#include "lab/pull.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/statistics.hpp"

namespace fabricsh::lab {

std::vector<double> end_displacement(std::span<const double> displacement, std::span<const double> force,
                                     const Corrections& c) {
  std::vector<double> u(displacement.size());
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    largest = std::max(largest, force[i]);
    u[i] = displacement[i] - c.compliance * force[i] - c.slip * largest;
  }
  return u;
}

Tension stress_strain(std::span<const double> displacement, std::span<const double> force,
                      const Specimen& specimen, double slack) {
  Tension out{std::vector<double>(displacement.size()), std::vector<double>(displacement.size())};
  const double length = specimen.gauge_length + slack;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double e = (displacement[i] - slack) / length;
    out.E[i] = e + e * e / 2;
    out.S[i] = force[i] / (specimen.area() * (1 + e));
  }
  return out;
}

std::optional<double> first_contact(std::span<const double> displacement, std::span<const double> force,
                                    double threshold) {
  const auto peak = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  if (force.empty() || force[peak] <= threshold) return {};
  std::size_t i = peak;
  while (i > 0 && force[i - 1] > threshold) --i;
  if (i == 0) return displacement[0];
  const double part = (threshold - force[i - 1]) / (force[i] - force[i - 1]);
  return displacement[i - 1] + part * (displacement[i] - displacement[i - 1]);
}

namespace {

// Rows of the extremes of the displacement, between which it is monotone.
std::vector<std::size_t> reversals(std::span<const double> u, double tolerance) {
  std::vector<std::size_t> turns;
  bool up = true;
  std::size_t extreme = 0;
  for (std::size_t i = 1; i < u.size(); ++i) {
    const double ahead = up ? u[i] - u[extreme] : u[extreme] - u[i];
    if (ahead >= 0) {
      extreme = i;
    } else if (-ahead > tolerance) {
      turns.push_back(extreme);
      up = !up;
      extreme = i;
    }
  }
  return turns;
}

// Within this width of an extreme a displacement does not show whether the machine moves: half a usual step
// between rows, or eight deviations of the noise (a hold's extreme may be four above its level, other values
// four below). The noise comes from second differences, whose variance is six times that of a reading.
double hold_width(std::span<const double> u) {
  if (u.size() < 3) return 0;
  std::vector<double> steps, bends;
  for (std::size_t i = 1; i < u.size(); ++i) steps.push_back(std::abs(u[i] - u[i - 1]));
  for (std::size_t i = 2; i < u.size(); ++i) bends.push_back(std::abs(u[i] - 2 * u[i - 1] + u[i - 2]));
  const double noise = median(std::move(bends)) / (0.6745 * std::sqrt(6.0));
  return std::max(median(std::move(steps)) / 2, 8 * noise);
}

constexpr std::size_t kHold = 5;  // number of rows near an extreme that make a hold

// First and last row of the hold at an extreme; the extreme itself if there is no hold.
std::pair<std::size_t, std::size_t> hold_at(std::span<const double> u, std::size_t extreme, double width) {
  std::size_t first = extreme, last = extreme;
  while (first > 0 && std::abs(u[first - 1] - u[extreme]) <= width) --first;
  while (last + 1 < u.size() && std::abs(u[last + 1] - u[extreme]) <= width) ++last;
  if (last - first < kHold) return {extreme, extreme};
  return {first, last};
}

// Adds an increase that may exceed the largest displacement so far: reloading below it, loading above.
void add_way_up(std::vector<PullBranch>& out, std::span<const double> u, std::size_t begin, std::size_t end,
                double largest) {
  std::size_t middle = begin;
  while (middle < end && u[middle] < largest) ++middle;
  if (middle > begin) out.push_back({BranchKind::reloading, begin, middle});
  if (middle < end) out.push_back({BranchKind::loading, middle, end});
}

}  // namespace

std::vector<PullBranch> branches(std::span<const double> u, double tolerance) {
  std::vector<PullBranch> out;
  if (u.empty()) return out;
  const double width = std::min(hold_width(u), tolerance);
  auto turns = reversals(u, tolerance);
  turns.push_back(u.size() - 1);
  std::size_t begin = 0;
  double largest = u[0];
  bool up = true;
  for (const std::size_t turn : turns) {
    const auto [first, last] = hold_at(u, turn, width);
    const std::size_t end = std::max(begin, first + 1);
    if (begin < end) {
      if (up)
        add_way_up(out, u, begin, end, largest);
      else
        out.push_back({BranchKind::unloading, begin, end});
    }
    if (last + 1 > end) out.push_back({BranchKind::hold, end, last + 1});
    largest = std::max(largest, u[turn]);
    begin = std::max(end, last + 1);
    up = !up;
  }
  return out;
}

namespace {

// Slopes of the regression lines through `window` rows, starting at every row below `end`; from running sums
// about the first row.
std::vector<double> slopes(std::span<const double> x, std::span<const double> y, std::size_t begin,
                           std::size_t end, std::size_t window) {
  std::vector<double> out;
  const auto n = static_cast<double>(window);
  double sx = 0, sy = 0, xx = 0, xy = 0;
  const auto add = [&](std::size_t i, double sign) {
    const double a = x[i] - x[begin], b = y[i] - y[begin];
    sx += sign * a, sy += sign * b, xx += sign * a * a, xy += sign * a * b;
  };
  for (std::size_t i = begin; i < end; ++i) {
    add(i, 1);
    if (i + 1 < begin + window) continue;
    const double spread = xx - sx * sx / n;
    out.push_back(spread > 0 ? (xy - sx * sy / n) / spread : 0);
    add(i + 1 - window, -1);
  }
  return out;
}

constexpr double kSoft = 0.5;   // of the largest tangent; below it the cloth has yielded
constexpr double kTaut = 0.05;  // of the largest stress; below it slack may still be taken up

}  // namespace

Marks yield_and_failure(std::span<const double> E, std::span<const double> S, std::size_t end, double kept) {
  Marks marks;
  if (end < 3) return marks;
  const auto top = static_cast<std::size_t>(
      std::max_element(S.begin(), S.begin() + static_cast<std::ptrdiff_t>(end)) - S.begin());
  for (std::size_t i = top; i < end && !marks.failure; ++i)
    if (S[i] < kept * S[top]) marks.failure = top;
  std::size_t taut = top;
  while (taut > 0 && S[taut - 1] > kTaut * S[top]) --taut;
  const std::size_t window = std::max<std::size_t>(5, (top + 1 - taut) / 20);
  const auto tangent = slopes(E, S, taut, top + 1, window);
  double stiffest = 0;
  std::size_t soft = 0;  // windows from here on have slopes below that part of the largest before
  for (std::size_t i = 0; i < tangent.size(); ++i) {
    stiffest = std::max(stiffest, tangent[i]);
    if (tangent[i] >= kSoft * stiffest) soft = i + 1;
  }
  if (soft < tangent.size()) marks.yield = taut + soft + window / 2;
  return marks;
}

}  // namespace fabricsh::lab
