#include "history/history.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::history {

namespace {

std::string text(double x) { return number(x, 10); }

void require(bool good, const std::string& message) {
  if (!good) throw Error(message);
}

void check_point(const std::vector<std::pair<double, double>>& points, std::size_t i) {
  const auto [t, v] = points[i];
  const std::string row = "history: row " + std::to_string(i + 1);
  require(std::isfinite(t), row + ": expected a finite time, got " + text(t));
  require(std::isfinite(v), row + ": expected a finite value, got " + text(v));
  require(i == 0 || t > points[i - 1].first, row + ": expected a time later than " +
                                                 text(points[std::max<std::size_t>(i, 1) - 1].first) +
                                                 ", got " + text(t));
}

// The first point later than t.
auto later(const std::vector<std::pair<double, double>>& points, double t) {
  return std::upper_bound(points.begin(), points.end(), t,
                          [](double time, const auto& point) { return time < point.first; });
}

}  // namespace

History::History(Points points) {
  std::vector<double> kinks;
  if (points.size() > 1)
    for (const auto& point : points) kinks.push_back(point.first);
  kinks_ = std::make_shared<const std::vector<double>>(std::move(kinks));
  points_ = std::make_shared<const Points>(std::move(points));
}

History History::constant(double value) {
  require(std::isfinite(value), "history: expected a finite value, got " + text(value));
  return History(Points{{0.0, value}});
}

History History::table(std::vector<std::pair<double, double>> points) {
  require(!points.empty(), "history: expected at least one row {time, value}, got an empty table");
  for (std::size_t i = 0; i < points.size(); ++i) check_point(points, i);
  return History(std::move(points));
}

History History::ramp(double value, double duration) {
  require(std::isfinite(value), "ramp: field 'value': expected a finite number, got " + text(value));
  require(std::isfinite(duration) && duration > 0,
          "ramp: field 'duration': expected a positive time, s, got " + text(duration));
  return table({{0.0, 0.0}, {duration, value}});
}

History History::callback(std::function<double(double)> f) {
  require(static_cast<bool>(f), "history: expected a function of time, got nothing");
  History h;
  h.callback_ = std::move(f);
  return h;
}

double History::value(double t) const {
  if (callback_) {
    const double v = callback_(t);
    require(std::isfinite(v),
            "history: expected a finite value from the function at time " + text(t) + " s, got " + text(v));
    return v;
  }
  if (points_->empty()) return 0.0;
  const auto next = later(*points_, t);
  if (next == points_->begin()) return points_->front().second;
  if (next == points_->end()) return points_->back().second;
  const auto& last = *(next - 1);
  // This form is exact at both ends of the interval.
  const double w = (t - last.first) / (next->first - last.first);
  return (1.0 - w) * last.second + w * next->second;
}

}  // namespace fabricsh::history
