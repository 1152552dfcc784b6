// A material card: the name of a law and its parameters, checked for form only. Plain data in SI units.
// Strains are tensor components unless a field says engineering. Material axes: 1 = warp, 2 = weft.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "card/laws.hpp"
#include "rheology/elements.hpp"

namespace fabricsh::card {

// A loading curve: either a polynomial tangent modulus D(x) = c0 + c1 x + ... (Pa), or measured points (x,
// stress in Pa) from (0, 0) on, both numbers strictly increasing. Exactly one of the two is not empty.
struct Curve {
  std::vector<double> coefficients;
  std::vector<std::pair<double, double>> points;
};

// Unloading and reloading that are not straight. All three numbers are fractions: friction of the peak
// stress, reach of the strain from the peak to zero stress, curve of the elastic part quadratic in it.
struct YarnLoop {
  double friction = 0, reach = 0.5, curve = 0;
};

struct Yarn {
  Curve loading;                      // in Green-Lagrange strain along the yarn
  double unloading = 0;               // Du, Pa; with a loop the secant from the peak to zero stress
  double poisson = 0;                 // nu12 on the warp, nu21 on the weft
  std::optional<YarnLoop> loop = {};  // law "potential" only
};

enum class StrainMeasure { tensor, engineering };  // dS12/dE12 in E12 | dS12/d(2 E12) in 2 E12
enum class ShearMemory {
  printed,
  fading
};  // share/doc/law.md, shear: memory of the branch left behind is erased at once, or fades
// Elastic-frictional shear: the loading curve is elastic, and a friction with the yield
// stress stress + growth |strain| (Pa) acts in parallel; the strain is that of the measure.
struct ShearFriction {
  double stress = 0, growth = 0;
};
struct Shear {
  Curve loading;
  double unloading = 0;
  StrainMeasure measure = StrainMeasure::tensor;
  ShearMemory memory = ShearMemory::printed;
  std::optional<ShearFriction> friction = {};  // law "potential" only
};

struct Tested {  // strains up to which the curves were measured; shear as tensor E12. 0: not stated
  double warp = 0, weft = 0, shear = 0;
};

struct Biaxial {  // optional fourth spring: y = <E11 + alpha E22 - offset>, backbone T = q y^2 / 2
  double alpha = 0, offset = 0, loading = 0, unloading = 0;  // -, -, Pa, Pa
};

enum class FrictionMemory { slip, fading };
struct BendingFriction {  // KES 2HB: friction moment per width, N, and the curvature (1/m) over which it
                          // builds up
  double moment = 0, curvature = 0;
  FrictionMemory memory = FrictionMemory::slip;
};
// Rigidities, N.m (N.m^2 per metre of width); they replace integration through the thickness.
// A rigidity may be given as a curve instead: the coefficients of the tangent rigidity
// B(kappa) (N.m, N.m^2, ...), or points of curvature (1/m) and moment per width (N).
struct Bending {
  double warp = 0, weft = 0, twist = 0;
  std::optional<BendingFriction> friction_warp, friction_weft;
  Curve warp_curve = {}, weft_curve = {};  // empty: the rigidity is constant
  double tested = 0;                       // 1/m, curvature up to which they were measured. 0: not stated
};

// Confidence bands of measured parameters, in the order of their rows: of a yarn loading coefficients (of
// points: their ordinates beyond the origin), unloading, poisson (shear has no poisson); of the bending warp,
// weft, twist, then moment and curvature of each friction; of the biaxial spring its four numbers. covariance
// refers to the same parameters, row by row. Empty: not known.
struct ParameterBand {
  std::vector<double> low, high, covariance;
};
struct ParameterBands {
  double level = 0.95;  // probability that a parameter lies in its band
  ParameterBand warp, weft, shear, bending, biaxial;
};
// The parts in the order in which cards are drawn from their bands.
inline constexpr std::pair<const char*, ParameterBand ParameterBands::*> banded_parts[] = {
    {"warp", &ParameterBands::warp},
    {"weft", &ParameterBands::weft},
    {"shear", &ParameterBands::shear},
    {"bending", &ParameterBands::bending},
    {"biaxial", &ParameterBands::biaxial}};

// The woven law, and those of folders of the room law that take its card in its place.
#define FABRICSH_NAME(name) name,
enum class LawKind { potential, FABRICSH_WOVEN_LAWS(FABRICSH_NAME) };
#undef FABRICSH_NAME
#define FABRICSH_NAME(name) #name,
inline constexpr const char* law_words[] = {"potential", FABRICSH_WOVEN_LAWS(FABRICSH_NAME)};
#undef FABRICSH_NAME
enum class Transverse { elastic, follow };

struct Woven {
  Yarn warp, weft;
  Shear shear;
  Tested tested;
  LawKind law = LawKind::potential;
  Transverse transverse = Transverse::elastic;  // comparison laws only
  bool shear_hysteresis = true;                 // comparison laws only
  std::optional<Biaxial> biaxial;
  rheology::Given parallel;  // law "potential" only: elements on its springs and in parallel to them
  std::optional<ParameterBands> bands;
};

struct Svk {  // St. Venant-Kirchhoff (theory.md, 4); shear is the engineering modulus, S12 = 2 G E12
  double warp = 0, weft = 0, shear = 0, nu12 = 0, nu21 = 0;
  std::optional<double> g13, g23;  // default 5/6 shear
};

struct LinearElastic {  // linear orthotropic, small strain [williams2010, eq. 4.2]; refused unless nu12 / E1
                        // = nu21
                        // / E2
  double warp = 0, weft = 0, shear = 0, nu12 = 0, nu21 = 0;
};

// An assumed bending rigidity, for a card without a measured one that asks for an estimate.
struct BendingEstimate {
  Bending bending;
  std::string source;
};

// Breaking of one family of yarns; per metre along the line on which they break.
struct StrengthScatter {  // of the strength, after Weibull
  double modulus = 0;
  std::optional<double> length = {};    // m of yarn, at which the strength was measured
  std::optional<double> exponent = {};  // of the size: strength goes with length^-exponent; 1 / modulus
};
struct YarnBreak {
  double strength = 0;  // N/m, the mean
  double energy = 0;    // J/m of tear
  std::optional<StrengthScatter> scatter = {};
  std::optional<double> yarns = {};  // 1/m, beside each other
};
struct Rupture {
  std::optional<YarnBreak> warp, weft;  // empty: not measured, does not break
};

// Where the folds of compressed cloth are: only in the shape of the mesh; also within its elements, which
// then carry no more than folds of their size would; or so without any force.
enum class Folds { resolved, within, free };
inline constexpr const char* fold_words[] = {"resolved", "within elements", "free"};

// Where the number of a field comes from: pairs of a field and words that begin with one of the origins
// (law/provenance.hpp), ascending by field, each once.
using Provenance = std::vector<std::pair<std::string, std::string>>;
// Where the number of an assumed field may lie, lowest and highest: of Poisson's ratios as they are, of other
// fields as factors on what the card has; ascending by field, each once.
using Ranges = std::vector<std::pair<std::string, std::array<double, 2>>>;

struct Card {
  std::string name, source;
  Provenance provenance = {};
  Ranges ranges = {};
  double density = 0;    // kg/m^3
  double thickness = 0;  // m
  std::variant<Woven, Svk, LinearElastic> law;
  std::optional<Bending> bending;
  std::optional<BendingEstimate> estimate = {};
  bool through_thickness = false;  // bending by integration is intended, however stiff it is
  // One sheet between two plates, as a compression tester measures it: thickness (m), ascending, and pressure
  // (Pa). Empty: not measured.
  std::vector<std::pair<double, double>> compression = {};
  std::optional<double> fibre_density = {};  // kg/m^3, of what the yarns are made of
  std::optional<Rupture> rupture = {};       // empty: not measured
  Folds folds = Folds::resolved;
};

}  // namespace fabricsh::card
