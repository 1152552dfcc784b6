#include "plot/visible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::plot {

bool shows(const Axis& axis, double value) {
  return std::isfinite(value) && (value > 0 || !axis.logarithmic);
}

namespace {

bool in_range(const Axis& axis, double value) {
  return value >= axis.low.value_or(value) && value <= axis.high.value_or(value);
}

void check_axis(const std::string& name, const Axis& axis) {
  if (axis.logarithmic && (axis.low.value_or(1) <= 0 || axis.high.value_or(1) <= 0))
    throw Error("figure: a logarithmic axis has no room for zero and below, got a range of " + name +
                " from " + number(axis.low.value_or(1)) + " to " + number(axis.high.value_or(1)));
}

// Calls take(x, y) for every point, band end and error bar end.
template <class Take>
void each_point(const PlottedCurve& curve, Take take) {
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!curve.y.empty()) take(curve.x[i], curve.y[i]);
    for (const Ends* ends : {&curve.band, &curve.error})
      if (!ends->empty()) take(curve.x[i], ends->low[i]), take(curve.x[i], ends->high[i]);
    if (!curve.x_error.empty() && !curve.y.empty())
      take(curve.x_error.low[i], curve.y[i]), take(curve.x_error.high[i], curve.y[i]);
  }
}

void check_ends(const std::string& who, const char* what, const Ends& ends, std::size_t count) {
  if (ends.low.size() != ends.high.size() || (!ends.empty() && ends.low.size() != count))
    throw Error(who + "expected as many ends of its " + what + " as x, got " +
                std::to_string(ends.low.size()) + " and " + std::to_string(ends.high.size()) + " for " +
                std::to_string(count));
  for (std::size_t i = 0; i < ends.low.size(); ++i)
    if (ends.low[i] > ends.high[i])
      throw Error(who + "its " + what + " ends below where it begins at place " + std::to_string(i + 1) +
                  ": from " + number(ends.low[i]) + " to " + number(ends.high[i]));
}

void check_curve(const Figure& f, const PlottedCurve& curve) {
  const std::string who = "figure: curve '" + curve.label + "': ";
  const bool alone = curve.y.empty() && !curve.band.empty();
  if (curve.x.size() != curve.y.size() && !alone)
    throw Error(who + "expected as many y as x, got " + std::to_string(curve.y.size()) + " and " +
                std::to_string(curve.x.size()));
  check_ends(who, "band", curve.band, curve.x.size());
  check_ends(who, "error bars", curve.error, curve.x.size());
  check_ends(who, "error bars along x", curve.x_error, curve.x.size());
  bool any = false;
  each_point(curve, [&](double x, double y) { any = any || (shows(f.x, x) && shows(f.y, y)); });
  if (any) return;
  const bool logarithmic = f.x.logarithmic || f.y.logarithmic;
  throw Error(who + "nothing to draw: none of its " + std::to_string(curve.x.size()) + " points is finite" +
              (logarithmic ? " and positive on the logarithmic axis" : ""));
}

}  // namespace

Span visible_span(const Figure& f) {
  if (f.curves.empty()) throw Error("figure: expected at least one curve");
  check_axis("x", f.x);
  check_axis("y", f.y);
  for (const PlottedCurve& curve : f.curves) check_curve(f, curve);
  constexpr double far = std::numeric_limits<double>::infinity();
  Span s{far, -far, far, -far};
  // An axis without a given range is scaled by the points that lie within the range of the other axis.
  for (const PlottedCurve& curve : f.curves)
    each_point(curve, [&](double x, double y) {
      if (!shows(f.x, x) || !shows(f.y, y) || !in_range(f.x, x) || !in_range(f.y, y)) return;
      s.x_low = std::min(s.x_low, x), s.x_high = std::max(s.x_high, x);
      s.y_low = std::min(s.y_low, y), s.y_high = std::max(s.y_high, y);
    });
  if (s.x_low > s.x_high) throw Error("figure: no point of any curve lies inside the range asked for");
  return s;
}

namespace {

// How many of the values a logarithmic axis cannot show; a gap (not finite) is none of them.
std::size_t too_low(const Axis& axis, const std::vector<double>& values) {
  if (!axis.logarithmic) return 0;
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double v) { return std::isfinite(v) && v <= 0; }));
}

std::string left_out(const Figure& f, const PlottedCurve& c) {
  std::string what;
  bool points = false, edges = false;
  const auto add = [&](std::size_t count, std::size_t all, const char* of, bool& any) {
    if (count == 0) return;
    any = true;
    what += (what.empty() ? "" : ", ") + std::to_string(count) + " of " + std::to_string(all) + " " + of;
  };
  add(too_low(f.x, c.x), c.x.size(), "x", points);
  add(too_low(f.y, c.y), c.y.size(), "y", points);
  for (const auto& [axis, ends, of] :
       {std::tuple{&f.y, &c.band, "ends of its band"}, std::tuple{&f.y, &c.error, "ends of error bars"},
        std::tuple{&f.x, &c.x_error, "ends of error bars along x"}})
    add(too_low(*axis, ends->low) + too_low(*axis, ends->high), 2 * ends->low.size(), of, edges);
  if (what.empty()) return what;
  return what + " are zero or below, for which a logarithmic axis has no place; " +
         (points ? "such points are not drawn" : "") + (points && edges ? ", " : "") +
         (edges ? "what reaches there is drawn to the frame's edge" : "");
}

}  // namespace

std::vector<std::string> left_out(const Page& page) {
  std::vector<std::string> out;
  for (const Figure& f : page.panels)
    for (std::size_t i = 0; i < f.curves.size(); ++i)
      if (const std::string what = left_out(f, f.curves[i]); !what.empty()) {
        const std::string& label = f.curves[i].label;
        out.push_back("curve " + (label.empty() ? std::to_string(i + 1) : "'" + label + "'") + ": " + what);
      }
  return out;
}

}  // namespace fabricsh::plot
