#include "contact/law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::contact {
namespace {

constexpr double onset = 0.2;     // share of the crush range over which the stiffness rises to kappa
constexpr double denser = 0.85;   // ratio of the heights above the floor of successive knots below a curve
constexpr double guarded = 0.25;  // share of the crush range, next to the floor, in which the guard acts

[[noreturn]] void refuse_law(const std::string& what) { throw Error("contact: " + what); }

void check_length(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    refuse_law(std::string(name) + ": expected a positive length in m, got " + number(value));
}

void check_curve(const LawData& data) {
  const auto& c = data.curve;
  if (c.size() < 2) refuse_law("compression: expected at least two points, got " + std::to_string(c.size()));
  for (std::size_t i = 0; i < c.size(); ++i) {
    const bool ordered = i == 0 || (c[i].first > c[i - 1].first && c[i].second < c[i - 1].second);
    if (!std::isfinite(c[i].first) || !std::isfinite(c[i].second) || !(c[i].second > 0) || !ordered)
      refuse_law(
          "compression: expected gaps (m) that ascend and positive pressures (Pa) that descend, got (" +
          number(c[i].first) + ", " + number(c[i].second) + ") as point " + std::to_string(i + 1));
  }
  if (!(c.front().first > data.floor))
    refuse_law("compression: expected gaps above the floor of " + number(data.floor) + " m, got " +
               number(c.front().first) + " m");
}

// Slope of a monotone curve at a point between two secants: the harmonic mean of their slopes.
double between(double a, double b) { return 2 * a * b / (a + b); }

}  // namespace

ContactLaw::ContactLaw(const LawData& data) : floor_(data.floor) {
  check_length("floor", data.floor);
  if (data.curve.empty()) {
    check_length("gap", data.gap);
    if (!(data.stiffness > 0) || !std::isfinite(data.stiffness))
      refuse_law("stiffness: expected a positive number in Pa/m, got " + number(data.stiffness));
    if (!(data.gap > data.floor))
      refuse_law("gap: expected more than the floor of " + number(data.floor) + " m, got " +
                 number(data.gap) + " m");
    gap_ = data.gap;
    add(gap_, 0);
    add(gap_ - onset * (gap_ - floor_), data.stiffness);
  } else {
    check_curve(data);
    add_curve(data);
  }
  for (const Knot& knot : knots_) stiffest_ = std::max(stiffest_, knot.stiffness);
  if (data.curve.empty()) guard_ = floor_ + guarded * (gap_ - floor_);
  const double quarter = guard_ - floor_;
  guard_energy_ = stiffest_ * quarter * quarter;
}

// Adds a knot below the last one. Between knots stiffness is linear, pressure quadratic, energy cubic.
void ContactLaw::add(double gap, double stiffness) {
  Knot knot{gap, stiffness, 0, 0};
  if (!knots_.empty()) {
    const Knot& last = knots_.back();
    const double h = last.gap - gap;
    knot.pressure = last.pressure + h * (last.stiffness + stiffness) / 2;
    knot.energy = last.energy + h * last.pressure + h * h * (2 * last.stiffness + stiffness) / 6;
  }
  knots_.push_back(knot);
}

// A monotone quadratic spline, two pieces per interval [schumaker1983]. Above the largest measured
// gap a parabola runs out to zero pressure and stiffness. Below the smallest measured gap, at the height a
// above the floor with the stiffness k, the stiffness is k a^2 / (d - d_f)^2 down to the guard, in linear
// pieces. A given bound replaces a larger stiffness.
void ContactLaw::add_curve(const LawData& data) {
  const auto& c = data.curve;
  const std::size_t n = c.size();
  std::vector<double> secant(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    secant[i] = (c[i].second - c[i + 1].second) / (c[i + 1].first - c[i].first);
  for (std::size_t i = 1; i + 1 < n; ++i) slope[i] = between(secant[i - 1], secant[i]);
  slope[0] = secant[0];
  slope[n - 1] = secant[n - 2];
  std::vector<std::pair<double, double>> line;  // gap, stiffness
  gap_ = c[n - 1].first + 2 * c[n - 1].second / slope[n - 1];
  line.emplace_back(gap_, 0);
  for (std::size_t i = n; i-- > 0;) {
    line.emplace_back(c[i].first, slope[i]);
    if (i > 0)
      line.emplace_back((c[i].first + c[i - 1].first) / 2, 2 * secant[i - 1] - (slope[i] + slope[i - 1]) / 2);
  }
  const double left = c[0].first - floor_;
  guard_ = floor_ + std::min(guarded * (gap_ - floor_), left / 2);
  for (double share = denser; floor_ + share * left > guard_; share *= denser)
    line.emplace_back(floor_ + share * left, slope[0] / (share * share));
  line.emplace_back(guard_, slope[0] * std::pow(left / (guard_ - floor_), 2));
  const double most = data.stiffness > 0 ? data.stiffness : std::numeric_limits<double>::infinity();
  add(line[0].first, 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto [g0, k0] = line[i - 1];
    const auto [g1, k1] = line[i];
    if ((k0 - most) * (k1 - most) < 0) add(g0 + (g1 - g0) * (most - k0) / (k1 - k0), most);
    add(g1, std::min(k1, most));
  }
}

ContactResponse ContactLaw::operator()(double d) const {
  ContactResponse out;
  if (d >= gap_) return out;
  if (!(d > floor_)) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    return {infinite, infinite, infinite, infinite};
  }
  std::size_t i = 0;
  while (i + 1 < knots_.size() && d < knots_[i + 1].gap) ++i;
  const Knot& k = knots_[i];
  const double rate =
      i + 1 < knots_.size() ? (knots_[i + 1].stiffness - k.stiffness) / (k.gap - knots_[i + 1].gap) : 0;
  const double h = k.gap - d;
  out.stiffness = k.stiffness + rate * h;
  out.pressure = k.pressure + h * (k.stiffness + rate * h / 2);
  out.contact = k.energy + h * (k.pressure + h * (k.stiffness / 2 + rate * h / 6));
  if (d < guard_) {
    const double quarter = guard_ - floor_, y = (d - floor_) / quarter, left = 1 - y;
    out.guard = guard_energy_ * left * left * left / y;
    out.pressure += guard_energy_ / quarter * left * left * (1 + 2 * y) / (y * y);
    out.stiffness += guard_energy_ / (quarter * quarter) * 2 * (1 - y * y * y) / (y * y * y);
  }
  return out;
}

ContactResponse ContactLaw::scaled(double d, double scale) const {
  ContactResponse out = (*this)(d / scale);
  out.contact *= scale * scale;
  out.guard *= scale * scale;
  out.pressure *= scale;
  return out;
}

}  // namespace fabricsh::contact
