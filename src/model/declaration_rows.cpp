#include "model/declaration_rows.hpp"

namespace fabricsh::model {

namespace {

// A flag that its owner may do without.
template <class Owner>
field::FieldOf<Owner> optional_flag(std::string name, std::optional<bool> Owner::*place,
                                    std::string sentence) {
  auto f = field::row<Owner>(std::move(name), field::FieldType::flag, "", {}, std::move(sentence)).optional();
  f.get = [place](const Owner& o) { return o.*place ? field::Value(*(o.*place)) : field::Value(); };
  f.set = [place](Owner& o, const field::Value& v) { o.*place = std::get<bool>(v); };
  return f;
}

}  // namespace

const std::vector<field::FieldOf<StrengthGiven>>& strength_rows() {
  using namespace field;
  using S = StrengthGiven;
  static const std::vector<field::FieldOf<S>> rows{
      number("factor", &S::factor, "", positive,
             "strength of the yarns there over that of the card, the mean")
          .or_else(1.0),
      number("modulus", &S::modulus, "", positive,
             "Weibull modulus, with which it differs from element to element; without it it does not")
          .optional()};
  return rows;
}

const std::vector<field::FieldOf<CreaseGiven>>& crease_rows() {
  using namespace field;
  using C = CreaseGiven;
  static const std::vector<field::FieldOf<C>> rows{
      number("angle", &C::angle, "degrees", Range{-180, 180},
             "between the normals of both sides where the crease is at rest; positive where they lean "
             "towards each other, as in a valley seen from the side of the normals"),
      number("stiffness", &C::stiffness, "N/rad", Range{0, 1e6},
             "N m/rad per metre of crease: makes it a hinge, whose moment is this times the angle from rest; "
             "without it the sheet is as stiff there as elsewhere")};
  return rows;
}

const std::vector<field::FieldOf<Seam>>& seam_rows() {
  using namespace field;
  static const std::vector<field::FieldOf<Seam>> rows{
      number("over", &Seam::over, "s", positive,
             "time in which threads draw the edges together, before they become one; without it they lie on "
             "each other and are one from the start"),
      number("ease", &Seam::ease, "", Range{0, 0.5, false, true},
             "by what share of the longer edge the other may be shorter; the rest is spread evenly")
          .or_else(Seam{}.ease),
      optional_flag(
          "reverse", &Seam::reverse,
          "whether the edges are matched from different ends, the end of an edge with the lowest number of "
          "a node being its first; default so that the ends lie nearer"),
      optional_flag(
          "hinge", &Seam::hinge,
          "whether the edges can turn against each other; default where their normals are more than 60 "
          "degrees apart as they become one"),
      number("stiffness", &Seam::stiffness, "N/m^2", positive,
             "force per metre of seam and metre of opening, of a seam that gives way; default none, the "
             "edges become one"),
      number("strength", &Seam::strength, "N/m", positive,
             "force per metre at which the seam bursts; default never"),
      number("energy", &Seam::energy, "J/m", positive, "that bursting takes, per metre; with strength")};
  return rows;
}

const std::vector<field::FieldOf<GasGiven>>& gas_rows() {
  using namespace field;
  using G = GasGiven;
  static const std::vector<field::FieldOf<G>> rows{
      number("initial", &G::initial, "Pa", everything, "pressure above that outside at time 0; default 0")
          .optional(),
      number("mass", &G::mass, "kg", positive, "mass of the gas at time 0, in place of a pressure"),
      number("temperature", &G::temperature, "K", positive, "at time 0, and of what flows in")
          .or_else(G{}.temperature),
      number("exponent", &G::exponent, "", Range{1, 5.0 / 3}, "n of p V^n: 1 isothermal, 1.4 adiabatic")
          .or_else(G{}.exponent),
      number("outside", &G::outside, "Pa", positive, "absolute pressure outside").or_else(G{}.outside)};
  return rows;
}

const std::vector<field::FieldOf<ContactGiven>>& contact_rows() {
  using namespace field;
  using C = ContactGiven;
  const auto needed = [](field::FieldOf<C> row) {
    row.required = true;
    return row;
  };
  const auto film = [&] {
    const std::vector<field::FieldOf<C>> rows{
        needed(number("viscosity", &C::viscosity, "Pa s", positive,
                      "of what is between the surfaces, such as a hot matrix")),
        needed(number("thickness", &C::film, "m", positive, "of it")),
        number("speed", &C::film_speed, "m/s", positive,
               "of sliding from which the viscosity falls; default: it stays")
            .optional(),
        number("exponent", &C::film_exponent, "", Range{0, 1, true},
               "of the speed in the traction far above that: 1 would be the same viscosity at all speeds")
            .optional()};
    const auto same = [](auto& contact) -> auto& { return contact; };
    auto all = field::grouped<C>(
        "film", rows, same,
        "beside friction, viscosity times sliding speed over thickness, where the surfaces touch; with "
        "speed and exponent n times (1 + (v / speed)^2)^((n - 1) / 2)");
    return all.optional();
  };
  static const std::vector<field::FieldOf<C>> rows{
      film(),
      number("thickness", &C::thickness, "m", positive,
             "of the cloth in contact; default: the cloth's own, or that of its card's compression"),
      number("stiffness", &C::stiffness, "Pa/m", positive,
             "pressure per closed gap; default: the compression curve of the card, or else 1 MPa down to the "
             "floor; in explicit runs no more than the cloth's own stable step carries"),
      number("restitution", &C::restitution, "", Range{0.4, 1},
             "speed after over speed before of a sheet that meets something flat; 1: nothing is lost")
          .or_else(C::usual_restitution),
      number("settle", &C::settle, "s", positive,
             "time from the start in which sheets and bodies that begin too near to each other, but not one "
             "through the other, are brought apart; without it they are refused")};
  return rows;
}

}  // namespace fabricsh::model
