// A material card: the name of a law and its parameters, checked for form. Pure data, SI units.
// Tensor strain everywhere except where a field says engineering. Material axes: 1 = warp, 2 = weft.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fabricsh::card {

// A loading curve: either a polynomial tangent modulus D(x) = c0 + c1 x + ... (Pa), or measured points (x,
// stress Pa) from (0, 0) on, x and stress strictly increasing. Exactly one of the two is non-empty.
struct Curve {
  std::vector<double> coefficients;
  std::vector<std::pair<double, double>> points;
};

struct Yarn {
  Curve loading;         // in Green-Lagrange strain along the yarn
  double unloading = 0;  // Du, Pa
  double poisson = 0;    // nu12 on the warp, nu21 on the weft
};

enum class Measure { tensor, engineering };  // dS12/dE12 in E12 | dS12/d(2 E12) in 2 E12
enum class ShearMemory {
  printed,
  fading
};  // share/doc/law.md, shear: the old branch is forgotten at once, or fades
struct Shear {
  Curve loading;
  double unloading = 0;
  Measure measure = Measure::tensor;
  ShearMemory memory = ShearMemory::printed;
};

struct Tested {  // strains up to which the curves were measured; shear in tensor E12. 0: not stated
  double warp = 0, weft = 0, shear = 0;
};

struct Biaxial {  // optional fourth spring: y = <E11 + alpha E22 - offset>, backbone T = q y^2 / 2
  double alpha = 0, offset = 0, loading = 0, unloading = 0;  // -, -, Pa, Pa
};

struct BendingFriction {  // KES 2HB: friction moment per width, N, and the curvature (1/m) over which it
                          // builds up
  double moment = 0, curvature = 0;
};
struct Bending {  // rigidities, N.m (N.m^2 per metre of width); used instead of thickness integration
  double warp = 0, weft = 0, twist = 0;
  std::optional<BendingFriction> friction_warp, friction_weft;
};

// Confidence bands of measured parameters, in the order loading coefficients, unloading, poisson (shear has
// no poisson). covariance is of the same parameters, row by row. Empty: not known.
struct Band {
  std::vector<double> low, high, covariance;
};
struct Bands {
  double level = 0.95;  // probability that a parameter lies in its band
  Band warp, weft, shear;
};

enum class LawKind { potential, incremental, thesis };
enum class Transverse { elastic, follow };

struct Woven {
  Yarn warp, weft;
  Shear shear;
  Tested tested;
  LawKind law = LawKind::potential;
  Transverse transverse = Transverse::elastic;  // comparison laws only
  bool shear_hysteresis = true;                 // comparison laws only
  std::optional<Biaxial> biaxial;
  std::optional<Bands> bands;  // polynomial loading curves only
};

struct Svk {  // St. Venant-Kirchhoff (theory.md, 4); shear is the engineering modulus, S12 = 2 G E12
  double warp = 0, weft = 0, shear = 0, nu12 = 0, nu21 = 0;
  std::optional<double> g13, g23;  // default 5/6 shear
};

struct Linear {  // linear orthotropic, small strain [williams2010, eq. 4.2]; refused unless nu12 / E1 = nu21
                 // / E2
  double warp = 0, weft = 0, shear = 0, nu12 = 0, nu21 = 0;
};

struct Card {
  std::string name, source;
  double density = 0;    // kg/m^3
  double thickness = 0;  // m
  std::variant<Woven, Svk, Linear> law;
  std::optional<Bending> bending;
};

}  // namespace fabricsh::card
