// One material point, driven to a strain or to a uniaxial stress: the single-element test of [williams2010,
// section 7.2]. Strains and stresses are TENSOR components in material axes (1 = warp, 2 = weft).
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "law/law.hpp"

namespace fabricsh::law {

// One committed point of a curve.
struct Sample {
  double time = 0;                    // s
  double S11 = 0, S22 = 0, S12 = 0;   // Pa
  double E11 = 0, E22 = 0, E12 = 0;   // tensor
  double stored = 0, dissipated = 0;  // J/m^3
  double dissipated_warp = 0, dissipated_weft = 0, dissipated_shear = 0, created = 0;
  double S = 0, E = 0, E_lateral = 0;  // in the load frame, after uniaxial(); else 0
};

class PointDriver {
 public:
  explicit PointDriver(std::shared_ptr<const law::Law> law);

  // Total strain reached in one straight increment over so many seconds and committed; a component without a
  // value stays. Throws NumericalFailure where the law fails (strain not finite).
  Sample strain(std::optional<double> E11, std::optional<double> E22, std::optional<double> E12,
                double over = 0);

  // Strain E along a direction `angle` (rad, counter-clockwise from the warp), the stress across it and the
  // shear stress in that frame driven to zero; committed. Throws NumericalFailure where no such state is
  // found.
  Sample uniaxial(double angle, double E, double over = 0);

  // Many straight increments in one call: each row E11 E22 E12, and the seconds that the increment takes.
  std::vector<Sample> path(const std::vector<std::array<double, 4>>& rows);
  // E11 = E, E22 = ratio E, E12 unchanged, for each E.
  std::vector<Sample> biaxial(double ratio, const std::vector<double>& strains);
  // A whole curve of uniaxial(), one call; each increment takes so many seconds.
  std::vector<Sample> uniaxial(double angle, const std::vector<double>& strains, double over = 0);

  Sample now() const { return sample_; }
  law::Internal internal() const;
  const std::vector<double>& state() const { return committed_; }
  void reset();  // virgin cloth at zero strain and time 0

 private:
  void begin(double over);  // an increment of so many seconds
  bool update(const std::array<double, 3>& e);
  void commit(const std::array<double, 3>& e);
  std::array<double, 3> solve_uniaxial(double angle, double E);

  std::shared_ptr<const law::Law> law_;
  std::vector<double> committed_, trial_;
  std::array<double, 5> strain_{}, stress_{};  // Voigt-5, of the last commit; stress of the last update
  std::array<double, 25> tangent_{};           // of the last update, Pa
  law::Step step_;                             // of the increment under way
  Sample sample_;
};

}  // namespace fabricsh::law
