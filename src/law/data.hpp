// Compiled parameters of a law: plain data for the kernels. There are no functions here,
// because the kernels are compiled once per instruction set and all copies share this header.
#pragma once
#include <vector>

#include "card/laws.hpp"
#include "law/law.hpp"
#include "rheology/elements.hpp"

namespace fabricsh::law {

inline constexpr int max_terms = 8;  // largest number of coefficients of D in one piece

// One polynomial piece of a backbone in t = x - start: D = sum d_k t^k, P = P0 + sum p_k t^(k+1),
// U = U0 + P0 t + sum u_k t^(k+2).
struct CurvePiece {
  double start = 0, P0 = 0, U0 = 0;
  double d[max_terms] = {}, p[max_terms] = {}, u[max_terms] = {};
};

// Virgin loading curve of one spring: tangent modulus D, stress P = int D, energy U =
// int P, for x >= 0. Beyond `limit` (x_c, where the range guard begins) D is constant.
struct Backbone {
  const CurvePiece* piece = nullptr;
  int pieces = 0;
  int terms = 4;      // 4 or max_terms
  double limit = 0;   // x_c
  double tested = 0;  // x_t
  double D_limit = 0, P_limit = 0, U_limit = 0;
  double initial = 0;  // D(0)
};

// A backbone with one piece that starts at zero and has four terms, as for most cards: the
// other constants of the piece are zero, so that the batch kernels need no loop and no branch.
struct CubicBackbone {
  static constexpr double start = 0, P0 = 0, U0 = 0;
  double limit = 0;
  double d[4] = {}, p[4] = {}, u[4] = {};
};

template <class Curve>
struct AxisOf {
  Curve curve;
  double unloading = 0;  // Du, Pa
  double softness = 0;   // 1 / Du
  double poisson = 0;    // nu12 on the warp, nu21 on the weft
  double slack = 0;      // h, Pa
};
using AxisData = AxisOf<Backbone>;

template <class Curve>
struct ShearOf {  // in gamma = 2 E12
  Curve curve;
  double unloading = 0;  // Gu, Pa
  double softness = 0;   // 1 / Gu
  bool fading = false;
  bool hysteresis = true;
};
using ShearData = ShearOf<Backbone>;

struct BiaxialData {
  bool on = false;
  double alpha = 0, offset = 0;
  Backbone curve;
  double unloading = 0;  // Tu, Pa
};

// Friction parallel to elastic shear, in gamma = 2 E12. It sticks with `stiffness`
// and slips at stress + growth |gamma|; the limit is constant beyond `limit`.
struct FrictionData {
  bool on = false;
  double stress = 0, growth = 0, stiffness = 0;  // Pa
  double limit = 0;
};

// Unloading of a yarn along curves (yarn_loop.hpp), in fractions of the peak stress and of the strain to it.
inline constexpr int loop_strands = 6;
struct LoopData {
  bool on = false;
  double linear = 0, square = 0;        // of the elastic part
  double reach[loop_strands] = {};      // z_j, at which a strand slips
  double stiffness[loop_strands] = {};  // k_j
  double stored = 0.5;                  // stored at the peak, of P(m)^2 / Du
  double steepest = 1, flattest = 1;    // largest and smallest slope, of Du
};

struct WovenData {
  AxisData axis[2];  // warp, weft
  LoopData loop[2];
  ShearData shear;
  FrictionData friction;
  BiaxialData biaxial;
  rheology::Compiled elements;
  double coupling = 0;    // c, Pa
  double transverse = 0;  // G_t, Pa
  bool follow = false;    // transverse shear uses the in-plane branch [williams2010, eq. 6.30]
};

inline bool is_curved(const WovenData& law) { return law.loop[0].on || law.loop[1].on; }

// Data of law "potential" for a card with three cubic backbones,
// without biaxial spring, fading memory, rheological elements or curved loops.
struct PlainWoven {
  AxisOf<CubicBackbone> axis[2];
  ShearOf<CubicBackbone> shear;
  double coupling = 0, transverse = 0;  // Pa
};

struct ElasticData {  // constant symmetric tangent, Pa
  double C11 = 0, C12 = 0, C22 = 0, G23 = 0, G13 = 0, G12 = 0;
  double young1 = 0, young2 = 0;  // uniaxial moduli
};

// potential: the woven law; then the laws of folders that take its card in its place (card/laws.hpp).
#define FABRICSH_NAME(name) name,
enum class CompiledKind { potential, FABRICSH_WOVEN_LAWS(FABRICSH_NAME) elastic };
#undef FABRICSH_NAME

class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;

  CompiledKind kind = CompiledKind::elastic;
  int state_size = 0;
  bool symmetric = true;
  double thickness = 0;  // m, of its card
  WovenData woven;
  ElasticData elastic;
  bool is_plain = false;     // law "potential" with all data in `plain`, without folds
  bool plain_cloth = false;  // the same, with or without folds
  card::Folds folds = card::Folds::resolved;
  PlainWoven plain;
  std::vector<CurvePiece> warp_pieces, weft_pieces, shear_pieces,
      biaxial_pieces;  // referred to by the backbones
};

inline bool has_folds(const Law& law) { return law.folds != card::Folds::resolved; }

// State of law "potential": one number for each of these.
namespace potential_state {
inline constexpr int m1 = 0, m2 = 1;  // largest strains of warp and weft so far, at least 0
inline constexpr int g0 = 2;          // gamma at the origin of the present shear branch
inline constexpr int gp = 3;          // largest r (distance from g0) on that branch
inline constexpr int sg = 4;          // direction of that branch; 0 means +1
inline constexpr int lost = 5;        // J/m^3, dissipated on earlier branches
// Further numbers if the feature is used: the faded peak of the previous branch, or with friction the slip
// in gamma (then gp is the largest |gamma|, sg its side, and g0 zero); the biaxial peak; those of the
// rheological elements; the loops of warp and weft.
inline constexpr int count = 6;
}  // namespace potential_state

// A yarn's loop: normalised strain at which strand j carries no stress (p_j), and energy lost, J/m^3.
namespace loop_state {
inline constexpr int slack = 0, lost = loop_strands, count = loop_strands + 1;
}

// At the end of the state of a law whose points fold (folds.hpp). a = 0: this one does not.
namespace fold_state {
inline constexpr int a = 0, b = 1, c = 2;    // Pa^(1/2), scales
inline constexpr int s1 = 3, s2 = 4;         // Pa, at which folds begin along warp and weft
inline constexpr int m = 5, d = 6, m12 = 7;  // of F, scaled; zero where nothing is folded
inline constexpr int count = 8;
}  // namespace fold_state

// Length of the longest state of any law; law.cpp makes sure that those of all folders fit in.
inline constexpr int most_states =
    potential_state::count + 2 + rheology::most_numbers + 2 * loop_state::count + fold_state::count;

// Where the numbers of the folds begin in the state of a law that has them.
inline int fold_slot(const Law& law) { return law.state_size - fold_state::count; }

}  // namespace fabricsh::law
