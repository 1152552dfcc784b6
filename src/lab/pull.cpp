#include "lab/pull.hpp"

#include <algorithm>
#include <cmath>

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

// Rows of the extremes between which the displacement runs one way.
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

// A way up that may pass the largest displacement so far: reloading below it, loading above.
void add_way_up(std::vector<Branch>& out, std::span<const double> u, std::size_t begin, std::size_t end,
                double largest) {
  std::size_t middle = begin;
  while (middle < end && u[middle] < largest) ++middle;
  if (middle > begin) out.push_back({BranchKind::reloading, begin, middle});
  if (middle < end) out.push_back({BranchKind::loading, middle, end});
}

}  // namespace

std::vector<Branch> branches(std::span<const double> u, double tolerance) {
  std::vector<Branch> out;
  auto turns = reversals(u, tolerance);
  turns.push_back(u.size() - 1);
  std::size_t begin = 0;
  double largest = u.empty() ? 0 : u[0];
  bool up = true;
  for (const std::size_t turn : turns) {
    const std::size_t end = turn + 1;
    if (begin < end) {
      if (up)
        add_way_up(out, u, begin, end, largest);
      else
        out.push_back({BranchKind::unloading, begin, end});
    }
    largest = std::max(largest, u[turn]);
    begin = end;
    up = !up;
  }
  return out;
}

namespace {

// Slope of the line through rows [begin, end).
double slope(std::span<const double> x, std::span<const double> y, std::size_t begin, std::size_t end) {
  const double n = static_cast<double>(end - begin);
  double mx = 0, my = 0, xx = 0, xy = 0;
  for (std::size_t i = begin; i < end; ++i) {
    mx += x[i] / n;
    my += y[i] / n;
  }
  for (std::size_t i = begin; i < end; ++i) {
    xx += (x[i] - mx) * (x[i] - mx);
    xy += (x[i] - mx) * (y[i] - my);
  }
  return xx > 0 ? xy / xx : 0;
}

}  // namespace

Marks yield_and_failure(std::span<const double> E, std::span<const double> S, std::size_t end, double kept,
                        double softening) {
  Marks marks;
  if (end < 3) return marks;
  const auto top = static_cast<std::size_t>(
      std::max_element(S.begin(), S.begin() + static_cast<std::ptrdiff_t>(end)) - S.begin());
  for (std::size_t i = top; i < end && !marks.failure; ++i)
    if (S[i] < kept * S[top]) marks.failure = top;
  const std::size_t window = std::max<std::size_t>(5, (top + 1) / 20);
  double stiffest = 0;
  for (std::size_t i = 0; i + window <= top + 1; ++i) {
    const double tangent = slope(E, S, i, i + window);
    stiffest = std::max(stiffest, tangent);
    if (tangent >= softening * stiffest) continue;
    marks.yield = i + window / 2;
    break;
  }
  return marks;
}

}  // namespace fabricsh::lab
