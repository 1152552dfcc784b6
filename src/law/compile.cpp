// Compiles a card to a law; refuses what share/doc/theory.md, section 4, excludes.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "card/fields.hpp"
#include "law/curve.hpp"
#include "law/data.hpp"
#include "law/law.hpp"
#include "law/laws.hpp"
#include "law/potential.hpp"
#include "law/text.hpp"
#include "law/transverse.hpp"

namespace fabricsh::law {

namespace {

void require_ratios(const card::Card& card, double nu12, double nu21) {
  if ((nu12 == 0) != (nu21 == 0))
    throw Error(card::at_field(card, nu12 == 0 ? "warp.poisson" : "weft.poisson") +
                "expected both Poisson ratios zero or neither, got nu12 = " + number(nu12) +
                ", nu21 = " + number(nu21));
  if (nu12 * nu21 >= 1)
    throw Error(card::at_field(card, "warp.poisson") + "expected nu12 nu21 < 1, got " + number(nu12) + " x " +
                number(nu21) + " = " + number(nu12 * nu21));
}

void compile_axis(const card::Card& card, const std::string& side, const std::string& strain,
                  const card::Yarn& yarn, double tested, AxisData& axis, std::vector<CurvePiece>& pieces) {
  axis.unloading = yarn.unloading;
  axis.poisson = yarn.poisson;
  CurveSpec spec;
  spec.card = card.name;
  spec.field = side + ".loading";
  spec.strain = strain;
  spec.unloading = yarn.unloading;
  spec.tested = tested;
  axis.curve = compile_curve(yarn.loading, spec, pieces);
}

void compile_shear(const card::Card& card, const card::Shear& shear, double tested, ShearData& out,
                   std::vector<CurvePiece>& pieces) {
  const bool tensor = shear.measure == card::StrainMeasure::tensor;
  CurveSpec spec;
  spec.card = card.name;
  spec.field = "shear.loading";
  spec.strain = tensor ? "E12" : "2E12";
  spec.scale = tensor ? 2 : 1;
  spec.unloading = shear.unloading / spec.scale;
  spec.tested = 2 * tested;
  spec.assumed = 0.6;
  spec.lenient = !tensor;
  out.unloading = spec.unloading;
  out.fading = shear.memory == card::ShearMemory::fading;
  out.curve = compile_curve(shear.loading, spec, pieces);
}

void compile_biaxial(const card::Biaxial& spring, BiaxialData& out, std::vector<CurvePiece>& pieces) {
  pieces = polynomial_pieces({0, spring.loading}, 1);
  out.on = true;
  out.alpha = spring.alpha;
  out.offset = spring.offset;
  out.unloading = spring.unloading;
  out.curve.piece = pieces.data();
  out.curve.pieces = 1;
  out.curve.limit = spring.unloading / spring.loading;
}

// Shear with friction: while the friction slips back the total must remain stiff (D >
// growth), and the sticking stiffness must exceed the rate at which the limit changes.
void compile_friction(const card::Card& card, const card::Woven& woven, WovenData& w) {
  const auto refuse = [&](const std::string& words) {
    throw Error(card::at_field(card, "shear.friction") + words);
  };
  if (woven.shear.memory == card::ShearMemory::fading)
    refuse("expected shear.memory = \"printed\": friction has a memory of its own");
  const double scale = woven.shear.measure == card::StrainMeasure::tensor ? 2 : 1;
  const auto& shear = w.shear;
  FrictionData& f = w.friction;
  f = {true, woven.shear.friction->stress, woven.shear.friction->growth / scale,
       shear.unloading - shear.curve.initial, shear.curve.tested};
  if (!(f.stiffness > std::fabs(f.growth)))
    refuse("expected unloading above the initial modulus by more than growth, got unloading " +
           pressure(shear.unloading * scale) + ", initial " + pressure(shear.curve.initial * scale) +
           ", growth " + pressure(f.growth * scale));
  if (!(f.stress > 0) || !(f.stress + f.growth * f.limit > 0))
    refuse("expected a stress above 0 up to the tested strain, got " + pressure(f.stress) + " + " +
           pressure(f.growth * scale) + " x " + number(f.limit / scale));
  constexpr int samples = 1000;
  for (int i = 0; i <= samples; ++i) {
    const double gamma = f.limit * i / samples, D = backbone_at(shear.curve, gamma).D;
    if (!(D > std::fabs(f.growth)))
      refuse("expected a growth below the modulus of loading up to the tested strain, got growth " +
             pressure(f.growth * scale) + " and D = " + pressure(D * scale) + " at " + number(gamma / scale));
  }
}

// Elements on the springs of the yarns take these as straight unloading and two yarns make them.
void compile_elements(const card::Card& card, const card::Woven& woven, rheology::Compiled& out) {
  const double measure = woven.shear.measure == card::StrainMeasure::tensor ? 0.5 : 1;
  const char* other = woven.warp.loop ? "warp.loop" : woven.weft.loop ? "weft.loop" : "biaxial";
  rheology::for_each([&](auto element, auto given, auto compiled) {
    const auto& parameters = woven.parallel.*given;
    if (!parameters) return;
    if (element.acts == rheology::Acts::on_springs && (woven.warp.loop || woven.weft.loop || woven.biaxial))
      throw Error(card::at_field(card, element.name) + "expected a card without " + other +
                  ", whose stress it does not change");
    out.*compiled = element.compile(*parameters, measure);
  });
}

// Unloading along a curve (yarn_loop.hpp). Strands slip evenly over the reach, so that the friction lost at
// the distance y from the peak is friction (1 - (1 - y / reach)^2), met at the ends of each strand.
LoopData loop_of(const card::YarnLoop& loop) {
  LoopData out;
  const double elastic = 1 - loop.friction, n = loop_strands;
  out.on = true;
  out.linear = elastic * (1 - loop.curve);
  out.square = elastic * loop.curve;
  out.stored = out.linear / 2 + out.square / 3;
  out.flattest = out.linear;
  out.steepest = out.linear + 2 * out.square;
  for (int j = 0; j < loop_strands; ++j) {
    const bool last = j + 1 == loop_strands;
    out.reach[j] = last ? loop.reach : loop.reach * (j + 1) / n;
    out.stiffness[j] = (last ? 1 : 2) * loop.friction / (n * loop.reach);
    out.stored += out.stiffness[j] * out.reach[j] * out.reach[j] / 2;
    out.steepest += out.stiffness[j];
  }
  return out;
}

// The tail may not be softer than slack cloth: with that the tangent is positive definite on every branch.
void compile_loop(const card::Card& card, const card::Woven& woven, int i, WovenData& w) {
  const auto& yarn = i == 0 ? woven.warp : woven.weft;
  if (!yarn.loop) return;
  const std::string side = i == 0 ? "warp" : "weft";
  w.loop[i] = loop_of(*yarn.loop);
  const AxisData& axis = w.axis[i];
  const double least = axis.slack - w.coupling * axis.poisson, tail = axis.unloading * w.loop[i].flattest;
  if (!(tail >= least))
    throw Error(card::at_field(card, side + ".loop") +
                "expected a tail (1 - friction) (1 - curve) unloading of at least " + pressure(least) +
                ", the modulus of slack cloth, got " + number(1 - yarn.loop->friction) + " x " +
                number(1 - yarn.loop->curve) + " x " + pressure(axis.unloading) + " = " + pressure(tail));
}

// c = min(nu21 d, nu12 k) / (1 - nn), h1 = c / nu21, h2 = c / nu12; for two zero ratios c = 0, h_i = D_i(0).
void compile_coupling(WovenData& w) {
  AxisData &warp = w.axis[0], &weft = w.axis[1];
  const double nu12 = warp.poisson, nu21 = weft.poisson;
  const double d = warp.curve.initial, k = weft.curve.initial;
  w.coupling = std::min(nu21 * d, nu12 * k) / (1 - nu12 * nu21);
  warp.slack = nu21 > 0 ? w.coupling / nu21 : d;
  weft.slack = nu12 > 0 ? w.coupling / nu12 : k;
}

// The length of the state and the symmetry of the law of a woven card.
void compile_state(Law& law) {
  switch (law.kind) {
#define FABRICSH_CASE(name)                \
  case CompiledKind::name:                 \
    law.state_size = name::Kind::numbers;  \
    law.symmetric = name::Kind::symmetric; \
    break;
    FABRICSH_WOVEN_LAWS(FABRICSH_CASE)
#undef FABRICSH_CASE
    default:
      law.state_size = loop_slot(law.woven, 1) + (law.woven.loop[1].on ? loop_state::count : 0);
      law.symmetric = true;
  }
}

std::optional<CubicBackbone> cubic(const Backbone& curve) {
  const CurvePiece& piece = curve.piece[0];
  if (curve.pieces != 1 || curve.terms != 4 || piece.start != 0 || piece.P0 != 0 || piece.U0 != 0) return {};
  CubicBackbone c;
  c.limit = curve.limit;
  std::copy_n(piece.d, 4, c.d);
  std::copy_n(piece.p, 4, c.p);
  std::copy_n(piece.u, 4, c.u);
  return c;
}

void compile_plain(Law& law) {
  const WovenData& w = law.woven;
  const auto warp = cubic(w.axis[0].curve), weft = cubic(w.axis[1].curve), shear = cubic(w.shear.curve);
  law.plain_cloth = law.kind == CompiledKind::potential && warp && weft && shear && !w.shear.fading &&
                    !w.biaxial.on && !rheology::any(w.elements) && !w.friction.on && !is_curved(w);
  law.is_plain = law.plain_cloth;
  if (!law.plain_cloth) return;
  const auto axis = [&](int i, const CubicBackbone& curve) {
    const AxisData& a = w.axis[i];
    return AxisOf<CubicBackbone>{curve, a.unloading, a.softness, a.poisson, a.slack};
  };
  law.plain = {{axis(0, *warp), axis(1, *weft)},
               {*shear, w.shear.unloading, w.shear.softness, false, true},
               w.coupling,
               w.transverse};
}

void compile_woven(const card::Card& card, const card::Woven& woven, Law& law) {
  WovenData& w = law.woven;
  require_ratios(card, woven.warp.poisson, woven.weft.poisson);
  compile_axis(card, "warp", "E11", woven.warp, woven.tested.warp, w.axis[0], law.warp_pieces);
  compile_axis(card, "weft", "E22", woven.weft, woven.tested.weft, w.axis[1], law.weft_pieces);
  compile_shear(card, woven.shear, woven.tested.shear, w.shear, law.shear_pieces);
  compile_coupling(w);
  w.transverse = 5.0 / 6.0 * w.shear.curve.initial;
  law.kind = static_cast<CompiledKind>(woven.law);  // both list the folders in the same order
  if (law.kind != CompiledKind::potential) {
    w.follow = woven.transverse == card::Transverse::follow;
    w.shear.hysteresis = woven.shear_hysteresis;
    w.shear.fading = false;
  }
  if (law.kind == CompiledKind::potential && woven.biaxial)
    compile_biaxial(*woven.biaxial, w.biaxial, law.biaxial_pieces);
  if (woven.shear.friction) compile_friction(card, woven, w);
  compile_elements(card, woven, w.elements);
  for (int i = 0; i < 2; ++i) compile_loop(card, woven, i, w);
  w.axis[0].softness = 1 / w.axis[0].unloading;
  w.axis[1].softness = 1 / w.axis[1].unloading;
  w.shear.softness = 1 / w.shear.unloading;
  compile_state(law);
  compile_plain(law);
}

// C11 = d / (1 - nn), C22 = k / (1 - nn), C12 = sqrt(nn d k) / (1 - nn): preserves both moduli and nn.
void compile_svk(const card::Card& card, const card::Svk& svk, ElasticData& e) {
  const double nn = svk.nu12 * svk.nu21;
  if (!std::isfinite(nn) || svk.nu12 < 0 || svk.nu21 < 0 || nn >= 1)
    throw Error(card::at_field(card, "poisson") +
                "expected two ratios of 0 or more with nu12 nu21 < 1, got " + number(svk.nu12) + " and " +
                number(svk.nu21));
  e.C11 = svk.warp / (1 - nn);
  e.C22 = svk.weft / (1 - nn);
  e.C12 = std::sqrt(nn * svk.warp * svk.weft) / (1 - nn);
  e.G12 = svk.shear;
  e.G13 = svk.g13.value_or(5.0 / 6.0 * svk.shear);
  e.G23 = svk.g23.value_or(5.0 / 6.0 * svk.shear);
  e.young1 = svk.warp;
  e.young2 = svk.weft;
}

// [williams2010, eq. 4.2] with nu12 / E1 = nu21 / E2; otherwise the law would have no energy.
void compile_linear(const card::Card& card, const card::LinearElastic& linear, ElasticData& e) {
  const double a = linear.nu12 * linear.weft, b = linear.nu21 * linear.warp;
  if (std::fabs(a - b) > 1e-6 * std::fmax(std::fabs(a), std::fabs(b)))
    throw Error(card::at_field(card, "poisson") +
                "expected nu12 / E1 = nu21 / E2 (a symmetric law), got nu12 = " + number(linear.nu12) +
                ", nu21 = " + number(linear.nu21) + " with E1 = " + pressure(linear.warp) +
                ", E2 = " + pressure(linear.weft) + "; nu21 = " + number(a / linear.warp) + " would do");
  card::Svk same{linear.warp, linear.weft, linear.shear, linear.nu12, linear.nu21, {}, {}};
  compile_svk(card, same, e);
}

void compile_elastic(const card::Card& card, Law& law) {
  law.kind = CompiledKind::elastic;
  law.symmetric = true;
  law.state_size = 0;
  if (const auto* svk = std::get_if<card::Svk>(&card.law))
    compile_svk(card, *svk, law.elastic);
  else
    compile_linear(card, std::get<card::LinearElastic>(card.law), law.elastic);
}

// The density of the fibres, the cloth and its compression must be consistent.
void require_compression(const card::Card& card) {
  const auto& curve = card.compression;
  const auto fibre = card.fibre_density;
  if (fibre && !(*fibre > card.density))
    throw Error(card::at_field(card, "fibre_density") + "expected more than the cloth's own density of " +
                number(card.density) + " kg/m^3, got " + number(*fibre) + " kg/m^3");
  if (curve.empty()) return;
  const double least = fibre ? card.density * card.thickness / *fibre : 0;
  if (!(curve.front().first > least))
    throw Error(card::at_field(card, "compression") + "expected gaps above the " + number(least) +
                " m that the fibres alone fill (areal mass over fibre_density), got " +
                number(curve.front().first) + " m");
  constexpr double far = 10;
  if (curve.front().first > far * card.thickness || far * curve.back().first < card.thickness)
    throw Error(card::at_field(card, "compression") + "expected gaps in m that are near the thickness of " +
                number(card.thickness) + " m, got from " + number(curve.front().first) + " m to " +
                number(curve.back().first) + " m");
}

// Laws in the place of the springs have no energy that folds could make least.
void add_folds(const card::Card& card, Law& law) {
  if (card.folds == card::Folds::resolved) return;
  if (law.kind != CompiledKind::potential && law.kind != CompiledKind::elastic)
    throw Error(card::at_field(card, "folds") + "expected \"resolved\", or law = \"potential\", got \"" +
                card::fold_words[static_cast<std::size_t>(card.folds)] + "\"");
  law.folds = card.folds;
  law.state_size += fold_state::count;
  law.is_plain = false;
}

void drop_transverse_shear(Law& law) {
  law.woven.transverse = law.plain.transverse = law.elastic.G13 = law.elastic.G23 = 0;
  law.woven.follow = false;
}

}  // namespace

namespace {
std::shared_ptr<Law> compile_all(const card::Card& card) {
  card::require(card);
  require_compression(card);
  auto law = std::make_shared<Law>();
  law->thickness = card.thickness;
  if (const auto* woven = std::get_if<card::Woven>(&card.law))
    compile_woven(card, *woven, *law);
  else
    compile_elastic(card, *law);
  add_folds(card, *law);
  return law;
}
}  // namespace

std::shared_ptr<const Law> compile(const card::Card& card, bool transverse_shear) {
  const auto law = compile_all(card);
  if (!transverse_shear) drop_transverse_shear(*law);
  return law;
}

std::shared_ptr<const Law> compile_stiffer(const card::Card& card, const TransverseModuli& least) {
  const auto law = compile_all(card);
  const auto raise = [](double& modulus, double to) { return to > modulus ? (modulus = to, true) : false; };
  if (law->kind == CompiledKind::potential) {
    if (!raise(law->woven.transverse, std::max(least.warp, least.weft))) return nullptr;
    law->plain.transverse = law->woven.transverse;
    return law;
  }
  if (law->kind != CompiledKind::elastic) return nullptr;
  const auto* const svk = std::get_if<card::Svk>(&card.law);
  const bool warp = !(svk != nullptr && svk->g13) && raise(law->elastic.G13, least.warp),
             weft = !(svk != nullptr && svk->g23) && raise(law->elastic.G23, least.weft);
  return warp || weft ? law : nullptr;
}

std::array<DerivedShear, 2> derived_shear(const card::Card& card) {
  const auto law = compile_all(card);
  if (law->kind == CompiledKind::potential)
    return {{{law->woven.transverse, law->woven.axis[0].curve.initial},
             {law->woven.transverse, law->woven.axis[1].curve.initial}}};
  if (law->kind != CompiledKind::elastic) return {};
  const auto* const svk = std::get_if<card::Svk>(&card.law);
  const ByDirection modulus = by_direction(*law);
  return {{{svk != nullptr && svk->g13 ? 0 : law->elastic.G13, modulus.axis[0]},
           {svk != nullptr && svk->g23 ? 0 : law->elastic.G23, modulus.axis[1]}}};
}

}  // namespace fabricsh::law
