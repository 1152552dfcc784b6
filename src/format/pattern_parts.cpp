#include "format/pattern_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::format {

using mesh::PlaneCurve;
using mesh::Vec2;

namespace {

// The angle by which the direction turns at the start of a piece, rad, without sign.
double turn_at(const mesh::Loop& loop, std::size_t i) {
  const PlaneCurve& before = loop[(i + loop.size() - 1) % loop.size()].curve;
  const Vec2 a = before.tangent(before.length()), b = loop[i].curve.tangent(0);
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

}  // namespace

void name_edges(mesh::Loop& loop) {
  std::size_t sharpest = 0;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (turn_at(loop, i) > turn_at(loop, sharpest) + 1e-6) sharpest = i;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(sharpest), loop.end());
  int edge = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (i == 0 || turn_at(loop, i) > std::numbers::pi / 6) ++edge;
    loop[i].edge = "edge" + std::to_string(edge);
  }
}

Vec2 on_boundary(const PatternPiece& piece, const Vec2& x) {
  Vec2 best = piece.panel.outline.front().curve.start();
  for (const mesh::OutlinePiece& side : piece.panel.outline) {
    const Vec2 near = side.curve.at(side.curve.nearest(x));
    if ((near - x).norm() < (best - x).norm()) best = near;
  }
  return best;
}

void add_notch(PatternPiece& piece, const std::string& name, const Vec2& x, const std::string& who) {
  constexpr double reach = 2e-3;
  const Vec2 best = on_boundary(piece, x);
  if (const double off = (best - x).norm(); off > reach)
    piece.remarks.push_back(who + name + " at (" + number(x.x()) + ", " + number(x.y()) +
                            ") m is left out, " + number(off) + " m off the boundary");
  else
    piece.panel.notches.push_back({name, "", {}, {}, best});
}

double unit_of_file(const std::string& file, std::optional<double> given, std::optional<double> own,
                    Remarks* remarks) {
  if (!given && !own)
    throw Error(file +
                ": its lengths have no unit: expected unit= (1*mm if one in the file is a millimetre)");
  if (given && own && std::abs(*given / *own - 1) > 1e-9 && remarks != nullptr)
    remarks->push_back(file + ": its unit is " + number(*own) + " m by its own words, and taken as " +
                       number(*given) + " m");
  return given ? *given : *own;
}

}  // namespace fabricsh::format
