#include "law/bending_spring.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "card/fields.hpp"
#include "law/curve.hpp"
#include "law/text.hpp"

namespace fabricsh::law {

namespace {

constexpr double usual_range = 100;  // 1/m, used as the tested range if the card states none
constexpr double least_fraction =
    0.1;  // fraction of B(0) that a curve keeps at least beyond its tested range
constexpr int samples = 2000;

struct BendingDirection {
  const card::Card& card;
  const char* field;  // "bending.warp"
};

std::string micro(double rigidity) { return number(1e6 * rigidity) + " uN.m"; }

// The curvature (1/m) up to which the pieces are used; beyond it B is constant.
double range_of(const BendingDirection& side, const card::Curve& curve,
                const std::vector<CurvePiece>& pieces) {
  const double stated = side.card.bending->tested;
  const double last = curve.points.empty() ? usual_range : curve.points.back().first;
  const double end = stated > 0 ? (curve.points.empty() ? stated : std::min(stated, last)) : last;
  const double initial = raw_curve(pieces, 0).D;
  for (int i = 0; i <= samples; ++i) {
    const double kappa = end * i / samples, B = raw_curve(pieces, kappa).D;
    if (B > 0 && (stated > 0 || !curve.points.empty() || B >= least_fraction * initial)) continue;
    if (B > 0 || (stated <= 0 && i > 0 && curve.points.empty())) return end * std::max(i - 1, 0) / samples;
    throw Error(card::at_field(side.card, side.field) + "expected a positive rigidity up to the tested " +
                number(end) + " 1/m, got " + micro(B) + " at " + number(kappa) + " 1/m");
  }
  return end;
}

void require_curve(const BendingDirection& side, const card::Curve& curve) {
  const auto wrong = [&](const std::string& words) {
    return Error(card::at_field(side.card, side.field) + words);
  };
  if (curve.coefficients.size() > 4)
    throw wrong("expected at most 4 coefficients, got " + std::to_string(curve.coefficients.size()));
  for (const double c : curve.coefficients)
    if (!std::isfinite(c)) throw wrong("expected finite coefficients, got " + number(c));
  if (!curve.points.empty() && (curve.points.size() < 2 || curve.points[0] != std::pair(0.0, 0.0)))
    throw wrong("expected at least two points, the first {0, 0}");
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const auto [x, y] = curve.points[i];
    if (std::isfinite(x) && std::isfinite(y) && x > curve.points[i - 1].first &&
        y > curve.points[i - 1].second)
      continue;
    throw wrong("expected curvature and moment both rising strictly, got {" + number(x) + ", " + number(y) +
                "} as point " + std::to_string(i + 1));
  }
}

std::shared_ptr<const BendingCurve> compiled(const BendingDirection& side, const card::Curve& curve) {
  require_curve(side, curve);
  auto out = std::make_shared<BendingCurve>();
  out->pieces =
      curve.points.empty() ? polynomial_pieces(curve.coefficients, 1) : pchip_pieces(curve.points, 1);
  Backbone& b = out->backbone;
  b.piece = out->pieces.data();
  b.pieces = static_cast<int>(out->pieces.size());
  b.tested = b.limit = range_of(side, curve, out->pieces);
  const auto end = backbone_at(b, b.limit);
  b.D_limit = end.D;
  b.P_limit = end.P;
  b.U_limit = end.U;
  b.initial = raw_curve(out->pieces, 0).D;
  for (int i = 0; i <= samples; ++i)
    out->steepest = std::max(out->steepest, raw_curve(out->pieces, b.limit * i / samples).D);
  return out;
}

BendingSpring spring_of(const BendingDirection& side, double rigidity, const card::Curve& curve,
                        const std::optional<card::BendingFriction>& friction) {
  BendingSpring spring{rigidity};
  if (!curve.coefficients.empty() || !curve.points.empty()) {
    spring.curve = compiled(side, curve);
    spring.rigidity = spring.curve->backbone.initial;
  }
  if (!friction || friction->moment <= 0) return spring;
  spring.friction = friction->moment;
  spring.curvature = friction->curvature;
  spring.fading = friction->memory == card::FrictionMemory::fading;
  return spring;
}

}  // namespace

std::array<BendingSpring, 3> bending_springs(const card::Card& card) {
  const card::Bending& b = *card.bending;
  return {spring_of({card, "bending.warp"}, b.warp, b.warp_curve, b.friction_warp),
          spring_of({card, "bending.weft"}, b.weft, b.weft_curve, b.friction_weft),
          spring_of({card, "bending.twist"}, b.twist, {}, {})};
}

double stiffest(const BendingSpring& spring) {
  const double most =
      spring.curve != nullptr ? std::max(spring.rigidity, spring.curve->steepest) : spring.rigidity;
  // After a reversal fading friction has twice its initial stiffness.
  const double rubs = spring.friction > 0 ? spring.friction / spring.curvature : 0;
  return most + (spring.fading ? 2 : 1) * rubs;
}

}  // namespace fabricsh::law
