#include "section/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "law/compression.hpp"
#include "law/data.hpp"
#include "law/law.hpp"
#include "law/transverse.hpp"

namespace fabricsh::section {

namespace {

// Legendre polynomial P_n(x) and its derivative, by the three-term recurrence.
std::pair<double, double> legendre(int n, double x) {
  double p0 = 1, p1 = x;
  for (int k = 2; k <= n; ++k) {
    const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
    p0 = p1;
    p1 = p2;
  }
  return {p1, n * (x * p1 - p0) / (x * x - 1)};
}

}  // namespace

std::vector<std::pair<double, double>> gauss_legendre(int n) {
  if (n < 1 || n > 9) throw Error("points: expected 1 to 9 thickness points, got " + std::to_string(n));
  if (n == 1) return {{0.0, 2.0}};
  std::vector<std::pair<double, double>> rule(n);
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    if (2 * i + 1 == n) x = 0;
    for (int newton = 0; newton < 8; ++newton) {
      const auto [p, dp] = legendre(n, x);
      x -= p / dp;
    }
    const double dp = legendre(n, x).second;
    rule[i] = {x, 2 / ((1 - x * x) * dp * dp)};
  }
  return rule;
}

namespace {

void check(double thickness, double offset) {
  if (!(thickness > 0) || !std::isfinite(thickness))
    throw Error("thickness: expected a positive length in m, got " + number(thickness));
  if (!(std::abs(offset) <= 1))
    throw Error("offset: expected a number from -1 to 1, got " + std::to_string(offset));
}

card::Card unfolded(card::Card card) {
  card.folds = card::Folds::resolved;
  return card;
}

// Folds take the whole force of a sheet, not the stress of a point that bends with it.
bool shares_folds(const card::Card& card, int points) {
  return card.folds == card::Folds::within && points > 1;
}

// The energy that folds release, W - w of law/folds.hpp, is counted at the middle of the sheet: a point with
// folds, of the weight of the ply, less one without. Both have the same strain, so that all else cancels
// where nothing folds, and a sheet that is not bent has W alone.
void add_shared_folds(Section& s, const card::Card& card, double weight, double angle, int ply) {
  for (const bool folds : {true, false}) {
    const auto law = law::compile(folds ? card : unfolded(card), false);
    s.points.push_back({0, folds ? weight : -weight, angle, card.density, law, s.state_size, ply});
    s.state_size += law::state_size(*law);
  }
}

// Adds the points of a ply between zeta = low and zeta = high.
void add_points(Section& s, const card::Card& card, int points, double low, double high, double angle,
                int ply, bool transverse_shear = true) {
  const bool shares = shares_folds(card, points);
  const auto law = law::compile(shares ? unfolded(card) : card, transverse_shear);
  s.symmetric = s.symmetric && law::symmetric(*law);
  for (const auto& [zeta, weight] : gauss_legendre(points)) {
    const double half = (high - low) / 2;
    s.points.push_back(
        {(low + high) / 2 + half * zeta, half * weight, angle, card.density, law, s.state_size, ply});
    s.state_size += law::state_size(*law);
  }
  if (shares) add_shared_folds(s, card, high - low, angle, ply);
}

void add_bending(Section& s, const card::Card& card) {
  s.bends_apart = true;
  s.bending = law::bending_springs(card);
  if (s.bending[0].friction <= 0 && s.bending[1].friction <= 0) return;
  s.bending_state = s.state_size;
  s.bending_states = s.bending[0].fading || s.bending[1].fading ? 3 : 2;
  s.state_size += 2 * s.bending_states;
}

// Moduli of the points, turned into the axes of the first one and summed.
void weigh_yarns(Section& s) {
  double axis[2] = {0, 0}, shear = 0;
  for (const Point& p : s.points) {
    const law::ByDirection m = law::by_direction(*p.law);
    const double turn = p.angle - s.points.front().angle;
    const double c = std::pow(std::cos(turn), 2), n = std::pow(std::sin(turn), 2);
    for (int i = 0; i < 2; ++i)
      axis[i] += p.weight * (m.axis[i] * c * c + m.axis[1 - i] * n * n + 4 * m.shear * c * n);
    shear += p.weight * ((m.axis[0] + m.axis[1]) * c * n + m.shear * (c - n) * (c - n));
  }
  if (!(shear > 0)) return;
  s.yarns_over_shear = {axis[0] / shear, axis[1] / shear};
}

void find_plain(Section& s) {
  weigh_yarns(s);
  const auto& law = s.points[0].law;
  const bool one =
      std::all_of(s.points.begin(), s.points.end(), [&](const Point& p) { return p.law == law; });
  if (one && law->is_plain) s.plain = &law->plain;
}

constexpr double kFibre = 1500;  // kg/m3: what cloth is made of (cotton 1540, polyester 1380)
constexpr double kLikely = 0.75, kFullest = 0.95;  // of the thickness: what fibres fill at most

// The thickness that the fibres fill: at most three quarters of the sheet if their density is not given.
double solid_thickness_of(const card::Card& card, double thickness) {
  const double filled = card.density / card.fibre_density.value_or(kFibre);
  return thickness * std::min(filled, card.fibre_density ? kFullest : kLikely);
}

// A sheet that is thicker than its card says is thicker in the same proportion at every pressure.
law::CompressionCurve pressed(const card::Card& card, double thickness) {
  return {card.compression, card.thickness, thickness / card.thickness};
}

}  // namespace

double Section::thickness_of(int ply) const {
  double weights = 0;
  for (const Point& p : points)
    if (p.ply == ply) weights += p.weight;
  return thickness * weights / 2;
}

bool Section::turned_plies() const {
  return std::any_of(points.begin(), points.end(),
                     [this](const Point& p) { return p.angle != points.front().angle; });
}

namespace {

// A section of one card without its points.
Section plain_section(const card::Card& card, double thickness, double offset) {
  check(thickness, offset);
  Section s;
  s.thickness = thickness;
  s.offset = offset;
  s.areal_mass = card.density * thickness;
  s.solid_thickness = solid_thickness_of(card, thickness);
  s.compression = law::pressed_together({pressed(card, thickness)});
  return s;
}

}  // namespace

Section membrane(const card::Card& card, double thickness) {
  Section s = plain_section(card, thickness, 0);
  add_points(s, card, 1, -1, 1, 0, 0, false);
  find_plain(s);
  return s;
}

Section integrated(const card::Card& card, double thickness, int points, double offset) {
  Section s = plain_section(card, thickness, offset);
  add_points(s, card, card.bending ? 1 : points, -1, 1, 0, 0);
  if (card.bending) add_bending(s, card);
  find_plain(s);
  return s;
}

Section stacked(const std::vector<Ply>& plies, int points, double offset) {
  if (plies.empty()) throw Error("layers: expected at least one layer");
  Section s;
  std::vector<law::CompressionCurve> parts;
  for (std::size_t i = 0; i < plies.size(); ++i) {
    const std::string name = "layers: layer " + std::to_string(i + 1) + ": ";
    if (!(plies[i].thickness > 0) || !std::isfinite(plies[i].thickness))
      throw Error(name + "thickness: expected a positive length in m, got " + number(plies[i].thickness));
    if (plies[i].card.bending)
      throw Error(name + "a card with its own bending rigidity can't be one of several layers");
    s.thickness += plies[i].thickness;
    s.areal_mass += plies[i].card.density * plies[i].thickness;
    s.solid_thickness += solid_thickness_of(plies[i].card, plies[i].thickness);
    parts.push_back(pressed(plies[i].card, plies[i].thickness));
  }
  s.compression = law::pressed_together(parts);
  s.offset = offset;
  check(s.thickness, offset);
  double low = -1;
  for (std::size_t i = 0; i < plies.size(); ++i) {
    const double high = low + 2 * plies[i].thickness / s.thickness;
    add_points(s, plies[i].card, points, low, high, plies[i].angle * std::numbers::pi / 180,
               static_cast<int>(i));
    low = high;
  }
  find_plain(s);
  return s;
}

namespace {
constexpr double kHidden = 20;          // G_t t h^2 / B
constexpr double kOfMembrane = 1. / 3;  // of the stiffest modulus in the plane: no sheet is stiffer in shear
}  // namespace

void hide_transverse_shear(Section& section, const card::Card& card, double size) {
  if (!section.bends_apart || !(size > 0)) return;
  const double most = kOfMembrane * law::stiffest(*section.points.front().law);
  const auto least = [&](const law::BendingSpring& spring) {
    return std::min(most, kHidden * law::stiffest(spring) / (section.thickness * size * size));
  };
  const auto stiffer = law::compile_stiffer(card, {least(section.bending[0]), least(section.bending[1])});
  if (!stiffer) return;
  for (Point& point : section.points) point.law = stiffer;
  section.plain = section.points.front().law->is_plain ? &section.points.front().law->plain : nullptr;
}

}  // namespace fabricsh::section
