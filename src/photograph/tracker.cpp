#include "photograph/tracker.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "lab/statistics.hpp"

namespace fabricsh::photograph {

namespace {

using Affine = std::array<double, 6>;

std::pair<double, double> moved(const Affine& m, double x, double y) {
  return {m[0] * x + m[1] * y + m[2], m[3] * x + m[4] * y + m[5]};
}

struct DotStep {
  double x, y;
  double length() const { return std::hypot(x, y); }
};

// The vector from a dot to its nearest neighbour within 45 degrees of a direction (of length one): the median
// over all dots that have such a neighbour; empty if none has.
std::optional<DotStep> step_along(const std::vector<Dot>& dots, const DotStep& direction) {
  std::vector<double> x, y;
  for (const Dot& from : dots) {
    std::optional<DotStep> nearest;
    for (const Dot& to : dots) {
      const DotStep d{to.x - from.x, to.y - from.y};
      const double along = d.x * direction.x + d.y * direction.y;
      const double across = std::abs(d.x * direction.y - d.y * direction.x);
      if (along > across && (!nearest || d.length() < nearest->length())) nearest = d;
    }
    if (!nearest) continue;
    x.push_back(nearest->x);
    y.push_back(nearest->y);
  }
  if (x.empty()) return std::nullopt;
  return DotStep{lab::median(x), lab::median(y)};
}

using Label = std::pair<int, int>;  // row, column, relative to any dot

// Walks from dot to dot by the vectors of the lattice, with a tolerance of 0.3 of the shorter one.
std::map<Label, std::size_t> labelled(const std::vector<Dot>& dots, const DotStep& right, const DotStep& up) {
  const double gate = 0.3 * std::min(right.length(), up.length());
  std::map<Label, std::size_t> place{{{0, 0}, 0}};
  std::vector<char> taken(dots.size(), 0);
  taken[0] = 1;
  std::vector<Label> open{{0, 0}};
  while (!open.empty()) {
    const Label from = open.back();
    open.pop_back();
    for (const auto& [r, c] : {Label{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
      const Label to{from.first + r, from.second + c};
      const Dot& here = dots[place.at(from)];
      const double x = here.x + c * right.x + r * up.x, y = here.y + c * right.y + r * up.y;
      for (std::size_t d = 0; d < dots.size(); ++d) {
        if (taken[d] || place.contains(to) || std::hypot(dots[d].x - x, dots[d].y - y) > gate) continue;
        taken[d] = 1;
        place[to] = d;
        open.push_back(to);
      }
    }
  }
  return place;
}

// The dots in the order of the grid, from their neighbours: rows from bottom to top, each from left to right.
// Empty if they do not form such a grid.
std::vector<Dot> in_order(const std::vector<Dot>& dots, std::size_t rows, std::size_t columns) {
  const auto right = step_along(dots, {1, 0}), up = step_along(dots, {0, -1});
  if (!right || !up) return {};
  const auto place = labelled(dots, *right, *up);
  if (place.size() != dots.size()) return {};
  int low = 0, high = 0;
  for (const auto& [label, dot] : place) {
    low = std::min(low, label.second);
    high = std::max(high, label.second);
  }
  const int height = place.rbegin()->first.first - place.begin()->first.first + 1;
  if (static_cast<std::size_t>(high - low + 1) != columns || static_cast<std::size_t>(height) != rows)
    return {};
  std::vector<Dot> out;
  for (const auto& [label, dot] : place) out.push_back(dots[dot]);  // a map is ordered by row, then column
  return out;
}

}  // namespace

Tracker::Tracker(std::size_t rows, std::size_t columns, const std::vector<Dot>& first) {
  if (first.size() != rows * columns)
    throw Error(
        "track: expected " + std::to_string(rows * columns) + " dots on the first photograph, found " +
        std::to_string(first.size()) +
        (first.size() < rows * columns
             ? "; what is fainter than contrast=, larger than largest= or outside of region= is no dot"
             : ""));
  tracks_.rows = rows;
  tracks_.columns = columns;
  const auto dots = in_order(first, rows, columns);
  if (dots.empty())
    throw Error("track: the " + std::to_string(first.size()) +
                " dots on the first photograph are no grid of " + std::to_string(rows) + " rows and " +
                std::to_string(columns) + " columns within 40 degrees of upright");
  for (const Dot& d : dots) last_.push_back({d.x, d.y, d.area});
  record(last_);
}

void Tracker::record(const std::vector<DotPosition>& places) {
  for (const DotPosition& p : places) {
    tracks_.x.push_back(p.x);
    tracks_.y.push_back(-p.y);
  }
  ++tracks_.frames;
}

double Tracker::spacing() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < last_.size(); ++i)
    for (std::size_t j = i + 1; j < last_.size(); ++j)
      least = std::min(least, std::hypot(last_[i].x - last_[j].x, last_[i].y - last_[j].y));
  return least;
}

namespace {

using Matches = std::vector<std::optional<std::size_t>>;

// Positions of any type with x and y.
template <class Places>
Matches nearest(const Places& last, const std::vector<Dot>& dots, const Affine& map, double gate) {
  Matches out(last.size());
  for (std::size_t m = 0; m < last.size(); ++m) {
    const auto [x, y] = moved(map, last[m].x, last[m].y);
    double best = gate;
    for (std::size_t d = 0; d < dots.size(); ++d)
      if (const double away = std::hypot(dots[d].x - x, dots[d].y - y); away < best) best = away, out[m] = d;
  }
  return out;
}

// The affine map of the matched markers; the old one if too few are matched.
template <class Places>
Affine affine(const Places& last, const std::vector<Dot>& dots, const Matches& matches, const Affine& old) {
  const auto n = std::count_if(matches.begin(), matches.end(), [](const auto& m) { return m.has_value(); });
  if (n < 4) return old;
  Eigen::MatrixXd A(n, 3), b(n, 2);
  Eigen::Index row = 0;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    if (!matches[m]) continue;
    A.row(row) << last[m].x, last[m].y, 1;
    b.row(row++) << dots[*matches[m]].x, dots[*matches[m]].y;
  }
  const Eigen::MatrixXd s = A.colPivHouseholderQr().solve(b);
  return {s(0, 0), s(1, 0), s(2, 0), s(0, 1), s(1, 1), s(2, 1)};
}

}  // namespace

void Tracker::add(const std::vector<Dot>& dots) {
  const double gate = 0.4 * spacing();
  Matches matches = nearest(last_, dots, step_, gate);
  for (int turn = 0; turn < 2; ++turn) {
    step_ = affine(last_, dots, matches, step_);
    matches = nearest(last_, dots, step_, gate);
  }
  std::vector<int> claims(dots.size(), 0);
  for (const auto& m : matches)
    if (m) ++claims[*m];
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<DotPosition> seen;
  for (std::size_t m = 0; m < last_.size(); ++m) {
    const auto [x, y] = moved(step_, last_[m].x, last_[m].y);
    if (!matches[m] || claims[*matches[m]] > 1) {
      doubts_.push_back({tracks_.frames, m, true});
      seen.push_back({nan, nan, last_[m].area});
      last_[m] = {x, y, last_[m].area};
      continue;
    }
    const Dot& dot = dots[*matches[m]];
    const double change = dot.area / last_[m].area;
    if (change > 1.4 || change < 1 / 1.4) doubts_.push_back({tracks_.frames, m, false});
    seen.push_back({dot.x, dot.y, dot.area});
    last_[m] = seen.back();
  }
  record(seen);
}

}  // namespace fabricsh::photograph
