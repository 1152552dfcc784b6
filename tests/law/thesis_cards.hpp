// The four cards of the thesis as its tables print them (tables 7.1 to 7.3, densities corrected), for tests.
#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "card/card.hpp"
#include "law/law.hpp"

namespace fabricsh::test {

inline constexpr double MPa = 1e6;

// Green-Lagrange strain at the largest displacement of the tensile test, mm on a gauge of 76.2 mm.
inline double tested_strain(double displacement) {
  const double u = displacement / 76.2;
  return u + u * u / 2;
}

inline std::vector<double> in_MPa(std::vector<double> c) {
  for (double& x : c) x *= MPa;
  return c;
}

struct ThesisRow {
  const char* name;
  std::vector<double> warp;
  double Du1;
  std::vector<double> weft;
  double Du2;
  std::vector<double> shear;
  double Gu, nu12, nu21, thickness, density, max_warp, max_weft;
};

inline const std::array<ThesisRow, 4>& thesis_rows() {
  static const std::array<ThesisRow, 4> rows{{
      {"blend", {8, 826}, 864, {37, 1650}, 1080, {2, -18, 90, -24}, 12, 0.25, 0.42, 0.38, 590, 18, 10},
      {"duck",
       {9, 5620},
       1570,
       {28, -1000, 48300, -79200},
       887,
       {1, -10, 105, -143},
       14,
       0.99,
       0.68,
       0.62,
       470,
       6,
       7},
      {"muslin", {9, 15300}, 1570, {6, 274}, 205, {2, -8, 13, 22}, 6, 2.04, 0.41, 0.28, 360, 3, 10},
      {"denim",
       {7, 3, -200, 1810},
       385,
       {15, -184, 6240, 3040},
       402,
       {1, -4, 33, -53},
       2,
       0.12,
       0.22,
       1.12,
       350,
       20,
       9},
  }};
  return rows;
}

inline card::Card thesis_card(int i) {
  const ThesisRow& row = thesis_rows()[i];
  card::Woven w;
  w.warp = {{in_MPa(row.warp), {}}, row.Du1 * MPa, row.nu12};
  w.weft = {{in_MPa(row.weft), {}}, row.Du2 * MPa, row.nu21};
  w.shear.loading.coefficients = in_MPa(row.shear);
  w.shear.unloading = row.Gu * MPa;
  w.tested = {tested_strain(row.max_warp), tested_strain(row.max_weft), 0.30};
  card::Card c;
  c.name = row.name;
  c.density = row.density;
  c.thickness = row.thickness * 1e-3;
  c.law = w;
  return c;
}

inline card::Woven& woven(card::Card& c) { return std::get<card::Woven>(c.law); }

inline card::Card thesis_card(int i, card::LawKind law,
                              card::Transverse transverse = card::Transverse::elastic) {
  card::Card c = thesis_card(i);
  woven(c).law = law;
  woven(c).transverse = transverse;
  return c;
}

// The biaxial spring fitted to the thesis' +59 % for the blend; the others get one of the same shape.
inline card::Card with_biaxial(card::Card c) {
  woven(c).biaxial = card::Biaxial{1.568, 0.1606, 294 * MPa, 111 * MPa};
  return c;
}

// Shear with a relaxing part: modulus in the tensor measure, Pa, and time, s.
inline card::Card with_viscous(card::Card c, double modulus = 6 * MPa, double time = 0.7) {
  woven(c).parallel.viscous = rheology::viscous::Parameters{modulus, time};
  return c;
}

// Shear with friction that grows (or falls) with the strain, by a share of what its modulus allows.
inline card::Card with_friction(card::Card c, double share = 0.5) {
  auto& shear = woven(c).shear;
  shear.friction = card::ShearFriction{0.05 * MPa, share * 0.1 * MPa};
  return c;
}

// Yarns that break at half their tested strain, over which they soften, in a millimetre of cloth.
inline card::Card with_damage(card::Card c) {
  constexpr double size = 1e-3;
  auto& w = woven(c);
  const auto of = [&](const card::Yarn& yarn, double tested, double& strength, double& energy) {
    double f = 0, x = tested / 2;
    for (std::size_t k = 0; k < yarn.loading.coefficients.size(); ++k)
      f += yarn.loading.coefficients[k] * std::pow(x, k + 1) / (k + 1);
    strength = c.thickness * f * std::sqrt(1 + 2 * x);
    energy = c.thickness * size * (f * f / (2 * yarn.unloading) + f * tested / 2);
  };
  rheology::damage::Parameters given;
  of(w.warp, w.tested.warp, given.warp_strength, given.warp_energy);
  of(w.weft, w.tested.weft, given.weft_strength, given.weft_energy);
  w.parallel.damage = given;
  return c;
}

// Both yarns unload along curves.
inline card::Card with_loops(card::Card c) {
  woven(c).warp.loop = card::YarnLoop{0.35, 0.6, 0.5};
  woven(c).weft.loop = card::YarnLoop{0.2, 1.0, 0.8};
  return c;
}

// P(x) and U(x) of a polynomial modulus, written out anew.
inline double stress_of(const std::vector<double>& D, double x) {
  double P = 0;
  for (std::size_t k = 0; k < D.size(); ++k) P += D[k] * std::pow(x, k + 1) / (k + 1);
  return P;
}
inline double modulus_of(const std::vector<double>& D, double x) {
  double sum = 0;
  for (std::size_t k = 0; k < D.size(); ++k) sum += D[k] * std::pow(x, k);
  return sum;
}
inline double energy_of(const std::vector<double>& D, double x) {
  double U = 0;
  for (std::size_t k = 0; k < D.size(); ++k) U += D[k] * std::pow(x, k + 2) / ((k + 1) * (k + 2));
  return U;
}

}  // namespace fabricsh::test
