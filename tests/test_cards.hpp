// The four fabrics of the thesis as cards, for tests: tables 7.1-7.3, 3.3 and 3.4 as corrected in
// share/cards.
#pragma once
#include "card/card.hpp"

namespace fabricsh::test {

struct ThesisNumbers {
  const char* name;
  std::vector<double> warp, weft, shear;  // tangent moduli, MPa, ascending powers, tensor strain
  double warp_unloading, weft_unloading, shear_unloading, nu12, nu21, thickness_mm, density;
  double stroke_warp_mm, stroke_weft_mm;
};

inline card::Card make_card(const ThesisNumbers& n) {
  const auto scaled = [](std::vector<double> v) {
    for (double& x : v) x *= 1e6;
    return card::Curve{std::move(v), {}};
  };
  const auto tested = [](double mm) {
    const double u = mm / 76.2;
    return u + u * u / 2;
  };
  card::Woven w;
  w.warp = {scaled(n.warp), n.warp_unloading * 1e6, n.nu12};
  w.weft = {scaled(n.weft), n.weft_unloading * 1e6, n.nu21};
  w.shear = {scaled(n.shear), n.shear_unloading * 1e6};
  w.tested = {tested(n.stroke_warp_mm), tested(n.stroke_weft_mm), 0.30};
  card::Card c;
  c.name = n.name;
  c.source = "Williams 2010";
  c.density = n.density;
  c.thickness = n.thickness_mm * 1e-3;
  c.law = w;
  return c;
}

// St. Venant-Kirchhoff cloth with the blend's first moduli.
inline card::Card svk() {
  card::Card c;
  c.name = "svk";
  c.density = 590;
  c.thickness = 0.38e-3;
  c.law = card::Svk{8e6, 37e6, 2e6, 0.25, 0.42, {}, {}};
  return c;
}

inline card::Card blend() {
  return make_card(
      {"blend", {8, 826}, {37, 1650}, {2, -18, 90, -24}, 864, 1080, 12, 0.25, 0.42, 0.38, 590, 18, 10});
}
inline card::Card duck() {
  return make_card({"duck",
                    {9, 5620},
                    {28, -1000, 48300, -79200},
                    {1, -10, 105, -143},
                    1570,
                    887,
                    14,
                    0.99,
                    0.68,
                    0.62,
                    470,
                    6,
                    7});
}
inline card::Card muslin() {
  return make_card(
      {"muslin", {9, 15300}, {6, 274}, {2, -8, 13, 22}, 1570, 205, 6, 2.04, 0.41, 0.28, 360, 3, 10});
}
inline card::Card denim() {
  return make_card({"denim",
                    {7, 3, -200, 1810},
                    {15, -184, 6240, 3040},
                    {1, -4, 33, -53},
                    385,
                    402,
                    2,
                    0.12,
                    0.22,
                    1.12,
                    350,
                    20,
                    9});
}

}  // namespace fabricsh::test
