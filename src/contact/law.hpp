// The law of contact: energy and pressure as functions of the gap d between two midsurfaces.
//
//   The stiffness -dp/dd is a piecewise linear function of d and zero for d >= d0, so that the energy
//   has two continuous derivatives. Without a measured curve it rises from zero to kappa over the first
//   fifth of the way from d0 to the floor d_f and stays there; a measured compression curve replaces it,
//   and below its smallest gap the stiffness goes on rising with the inverse square of the height above the
//   floor.
//   In the last quarter of the way above the floor a guard g (1 - y)^3 / y with y = (d - d_f)/(a quarter of
//   the way) is added. It has two continuous derivatives where it begins and is unbounded at the floor. Below
//   a measured curve it takes at most half of the height of the lowest point, so that no point is changed.
#pragma once
#include <utility>
#include <vector>

namespace fabricsh::contact {

struct LawData {
  double gap = 0;    // d0, m: where contact begins; not used with a curve
  double floor = 0;  // d_f, m: thickness of the compacted fibres
  double stiffness =
      0;  // kappa, Pa/m: of the linear part; with a curve the most that is allowed, 0: no bound
  // Measured compression: gap (m) ascending, pressure (Pa) descending and positive. Empty: linear.
  std::vector<std::pair<double, double>> curve = {};
};

struct ContactResponse {
  double contact = 0, guard = 0;  // energies per area, J/m2
  double pressure = 0;            // -d(contact + guard)/dd, Pa
  double stiffness = 0;           // -d pressure/dd, Pa/m
};

class ContactLaw {
 public:
  ContactLaw() = default;
  // Errors: floor not below the gap, a value not positive and finite, a curve that is not strictly monotone
  // or reaches down to the floor.
  explicit ContactLaw(const LawData& data);

  double gap() const { return gap_; }            // m
  double floor() const { return floor_; }        // m
  double guard_gap() const { return guard_; }    // m: where the guard begins
  double stiffest() const { return stiffest_; }  // Pa/m, without the guard
  // Evaluates at a gap d (m). At and below the floor all values are infinite: such a state cannot occur.
  ContactResponse operator()(double d) const;
  // The same law with all lengths multiplied by `scale` (0 to 1) and the same stiffness,
  // for neighbours in a sheet whose reference distance is smaller than the gap.
  ContactResponse scaled(double d, double scale) const;

  struct Knot {
    double gap, stiffness, pressure, energy;
  };
  const std::vector<Knot>& knots() const { return knots_; }

 private:
  void add(double gap, double stiffness);
  void add_curve(const LawData& data);
  std::vector<Knot> knots_;  // in order of descending gaps; the stiffness is constant below the last knot
  double gap_ = 0, floor_ = 0, guard_ = 0, guard_energy_ = 0, stiffest_ = 0;
};

}  // namespace fabricsh::contact
