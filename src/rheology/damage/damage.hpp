// Yarns that break anywhere in the cloth, smeared over the elements: the spring of a yarn that has reached
// its strength softens with the strain, and the energy that this takes does not depend on the mesh (the crack
// band of [bazant1983]). S is the stress of the yarn's spring, f that where it breaks, E_f the strain and l_f
// = sqrt(1 + 2 E_f) the stretch there, E_r = E_f - f / Du the residual strain, k the largest strain so far
// and l = sqrt(1 + 2 k):
//   S = d(k) Du (E - E_r) beyond E_f,   d(k) = (E_f - E_r) / (k - E_r) l_f / l (l_u - l) / (l_u - l_f) >= 0
// Under growing stretch the force S l falls linearly from f l_f to zero at l_u; unloading goes straight back
// to E_r. The energy from E_f on, with what the yarn had stored there, is f^2 / (2 Du) + f l_f (l_u - l_f) /
// 2 per volume. It is the energy per length of the tear over thickness and size of the element along the
// yarn, which determines l_u.
#pragma once
#include "rheology/element.hpp"
#include "simd/pack.hpp"

namespace fabricsh::rheology::damage {

struct Parameters {  // 0: these yarns do not break
  double warp_strength = 0, warp_energy = 0, weft_strength = 0, weft_energy = 0;  // N/m, J/m
  bool operator==(const Parameters&) const = default;
};

struct Data {
  bool on = false;
  std::array<double, 2> strength{}, energy{};  // of warp and weft, N/m, J/m
};

// The state of each yarn: the largest strain so far, and what its site determines. All zero: it does not
// break.
namespace state {
inline constexpr int largest = 0, begin = 1, residual = 2;  // k, E_f, E_r
inline constexpr int stretch = 3, end = 4, stress = 5;      // l_f, l_u; f, Pa
inline constexpr int count = 6;
}  // namespace state

struct Element {
  static constexpr const char* name = "damage";
  static constexpr const char* sentence =
      "yarns that soften and break wherever they reach their strength, law potential only; where a tear runs "
      "along a line that is known, rupture and tearable zones are sharper";
  static constexpr Acts acts = Acts::on_springs;
  static constexpr const char* dissipation = "damage";
  static constexpr int numbers = 2 * state::count;
  static constexpr bool is_rate_dependent = false;
  static constexpr bool softens = true;
  static constexpr bool depends_on_site = true;
  static std::vector<ParameterRow<Parameters>> rows();
  static Data compile(const Parameters& given, double) {
    return {true, {given.warp_strength, given.weft_strength}, {given.warp_energy, given.weft_energy}};
  }
  static Stiffest stiffest(const Data&) { return {}; }
  // A site without size does not break. Error: the site is too long for the energy, which would be released
  // in a jump: how long it may be.
  static void set_initial(const std::array<YarnSpring, 2>& yarns, const PointSite& site, const Data& data,
                          double* s);
};

inline namespace FABRICSH_ISA {

// The rest of a yarn that breaks, at its largest strain k. The divisors of a yarn that does not break are
// tiny; its factors are not used.
template <class T>
struct Softened {
  T way, stretch, width;  // k - E_r; l; l_u - l_f
  T reach, left;          // (E_f - E_r) / (k - E_r) l_f / l; (l_u - l) / (l_u - l_f), at least 0
  decltype(T() < T()) begun;
};

template <class T>
Softened<T> softened(const T* s, T largest) {
  using Mask = decltype(T() < T());
  const T tiny(1e-300), zero(0.0);
  Softened<T> out;
  out.way = max(largest - s[state::residual], tiny);
  out.stretch = sqrt(T(1.0) + T(2.0) * largest);
  out.width = max(s[state::end] - s[state::stretch], tiny);
  out.reach = (s[state::begin] - s[state::residual]) / out.way * (s[state::stretch] / out.stretch);
  out.left = max(s[state::end] - out.stretch, zero) / out.width;
  out.begun = Mask((s[state::begin] > zero) & (largest >= s[state::begin]));
  return out;
}

template <class T>
YarnFactor<T> yarn_factor(const Data&, int yarn, bool loading, T E, const T* s0, T* s1) {
  const T* const old = s0 + yarn * state::count;
  T* const now = s1 + yarn * state::count;
  for (int i = 0; i < state::count; ++i) now[i] = old[i];
  now[state::largest] = max(E, old[state::largest]);
  const auto soft = softened(now, now[state::largest]);
  const T one(1.0), zero(0.0), near(loading ? -1e-12 : 1e-12);
  const auto grows = soft.begun & (E >= old[state::largest] + near) & (soft.left > zero);
  return {select(old[state::begin] > zero, old[state::begin], T(1e300)),
          select(soft.begun, soft.left * soft.reach, one),
          select(grows,
                 -soft.reach * (soft.left * (one / soft.way + one / (soft.stretch * soft.stretch)) +
                                one / (soft.width * soft.stretch)),
                 zero)};
}

template <class T>
T yarn_factor_at(const Data&, int yarn, const T* s) {
  const T* const own = s + yarn * state::count;
  const auto soft = softened(own, own[state::largest]);
  return select(soft.begun, soft.left * soft.reach, T(1.0));
}

template <class T>
void add_energy(const Data&, const T* s, T&, T& lost) {
  for (int yarn = 0; yarn < 2; ++yarn, s += state::count) {
    const auto soft = softened(s, s[state::largest]);
    const T half(0.5), x = min(soft.stretch, s[state::end]) - s[state::stretch];
    const T reached = s[state::begin] - s[state::residual];
    const T work = s[state::stretch] * (x - half * x * x / soft.width);
    const T stored = half * (s[state::stretch] / soft.stretch) * soft.left * soft.way;
    lost += select(soft.begun, s[state::stress] * (half * reached + work - stored), T(0.0));
  }
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::rheology::damage
