// One material point under prescribed strain or uniaxial stress: the single-element test of [williams2010,
// section 7.2]. Strains and stresses are TENSOR components in material axes (1 = warp, 2 = weft).
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "law/law.hpp"

namespace fabricsh::law {

// One committed point of a curve.
struct StressPoint {
  double time = 0;                          // s
  double S11 = 0, S22 = 0, S12 = 0;         // Pa
  double E11 = 0, E22 = 0, E12 = 0;         // tensor
  double stored = 0, dissipated = 0;        // J/m^3
  std::array<double, dissipations> lost{};  // J/m^3, dissipated, by dissipation_names
  double created = 0;                       // J/m^3
  double S = 0, E = 0, E_lateral = 0;       // in the load frame, after uniaxial(); otherwise 0
};

class PointDriver {
 public:
  // site: of the cloth that the point stands for, see law::set_initial. Error: a site that the law cannot
  // bear.
  explicit PointDriver(std::shared_ptr<const law::Law> law, const law::Site& site = {});

  // Reaches the given total strain in one straight increment of the given duration (s) and commits;
  // components without a value are kept. Throws NumericalFailure if the law fails (strain not finite).
  StressPoint strain(std::optional<double> E11, std::optional<double> E22, std::optional<double> E12,
                     double over = 0);

  // Applies the strain E along the direction `angle` (rad, counter-clockwise
  // from the warp), with zero lateral stress and zero shear stress in that
  // frame, and commits. Throws NumericalFailure if no such state is found.
  StressPoint uniaxial(double angle, double E, double over = 0);

  // Many straight increments in one call; each row has E11 E22 E12 and the duration of the increment (s).
  std::vector<StressPoint> path(const std::vector<std::array<double, 4>>& rows);
  // For each E: E11 = E, E22 = ratio E, E12 unchanged.
  std::vector<StressPoint> biaxial(double ratio, const std::vector<double>& strains);
  // A whole curve of uniaxial() in one call; each increment takes `over` seconds.
  std::vector<StressPoint> uniaxial(double angle, const std::vector<double>& strains, double over = 0);

  StressPoint now() const { return sample_; }
  law::Internal internal() const;
  const std::vector<double>& state() const { return committed_; }
  void reset();  // virgin cloth at zero strain and time 0

 private:
  void begin(double over);  // starts an increment of this duration, s
  bool update(const std::array<double, 3>& e);
  void commit(const std::array<double, 3>& e);
  std::array<double, 3> solve_uniaxial(double angle, double E);

  std::shared_ptr<const law::Law> law_;
  law::Site site_;
  std::vector<double> committed_, trial_;
  std::array<double, 5> strain_{}, stress_{};  // order of law.hpp; of the last commit, last update
  std::array<double, 25> tangent_{};           // of the last update, Pa
  law::Step step_;                             // of the present increment
  StressPoint sample_;
};

}  // namespace fabricsh::law
