// All rheological elements together. list.hpp is made by the build: it includes the header of each folder of
// this room, and defines FABRICSH_RHEOLOGY(X) as X(name) for each.
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <string_view>

#include "rheology/element.hpp"
#include "rheology/list.hpp"
#include "simd/pack.hpp"

namespace fabricsh::rheology {

// The elements that a card states, by name: given.viscous.
struct Given {
#define FABRICSH_MEMBER(name) std::optional<name::Parameters> name = {};
  FABRICSH_RHEOLOGY(FABRICSH_MEMBER)
#undef FABRICSH_MEMBER
};

// Their data for the kernels.
struct Compiled {
#define FABRICSH_MEMBER(name) name::Data name = {};
  FABRICSH_RHEOLOGY(FABRICSH_MEMBER)
#undef FABRICSH_MEMBER
};

// Calls visit(element, member of Given, member of Compiled) for each element.
template <class Visit>
void for_each(Visit visit) {
#define FABRICSH_VISIT(name) visit(name::Element{}, &Given::name, &Compiled::name);
  FABRICSH_RHEOLOGY(FABRICSH_VISIT)
#undef FABRICSH_VISIT
}

// Numbers of a state if all elements are on.
#define FABRICSH_SUM(name) +name::Element::numbers
inline constexpr int most_numbers = 0 FABRICSH_RHEOLOGY(FABRICSH_SUM);
#undef FABRICSH_SUM

// The same without those on the springs.
#define FABRICSH_SUM(name) +(name::Element::acts == Acts::in_parallel ? name::Element::numbers : 0)
inline constexpr int most_parallel_numbers = 0 FABRICSH_RHEOLOGY(FABRICSH_SUM);
#undef FABRICSH_SUM

#define FABRICSH_SUM(name) +(all.name.on ? name::Element::numbers : 0)
inline int numbers(const Compiled& all) { return 0 FABRICSH_RHEOLOGY(FABRICSH_SUM); }
#undef FABRICSH_SUM

#define FABRICSH_ANY(name) || all.name.on
inline bool any(const Compiled& all) { return false FABRICSH_RHEOLOGY(FABRICSH_ANY); }
#undef FABRICSH_ANY

// Whether the stress of an element that is on changes at constant strain.
#define FABRICSH_ANY(name) || (all.name.on && name::Element::is_rate_dependent)
inline bool is_rate_dependent(const Compiled& all) { return false FABRICSH_RHEOLOGY(FABRICSH_ANY); }
#undef FABRICSH_ANY

// Whether an element that is on multiplies the stress of the springs.
#define FABRICSH_ANY(name) || (all.name.on && name::Element::acts == Acts::on_springs)
inline bool any_on_springs(const Compiled& all) { return false FABRICSH_RHEOLOGY(FABRICSH_ANY); }
#undef FABRICSH_ANY

// Whether the state of virgin cloth is that of its site; otherwise it is zero.
#define FABRICSH_ANY(name) || (all.name.on && name::Element::depends_on_site)
inline bool depends_on_site(const Compiled& all) { return false FABRICSH_RHEOLOGY(FABRICSH_ANY); }
#undef FABRICSH_ANY

// Whether an element that is on can make the stress fall while the strain grows.
#define FABRICSH_ANY(name) || (all.name.on && name::Element::softens)
inline bool softens(const Compiled& all) { return false FABRICSH_RHEOLOGY(FABRICSH_ANY); }
#undef FABRICSH_ANY

// The names under which energy is dissipated: those of the springs of warp, weft and shear, then those that
// elements have of their own. Energies of a law, of a run, of files and of tables go by this list.
#define FABRICSH_ONE(name) +1
inline constexpr int kinds = 0 FABRICSH_RHEOLOGY(FABRICSH_ONE);
#undef FABRICSH_ONE
struct DissipationNames {
  std::array<std::string_view, 3 + kinds> name{"warp", "weft", "shear"};
  int count = 3;
  constexpr int index(std::string_view wanted) const {
    for (int i = 0; i < count; ++i)
      if (name[i] == wanted) return i;
    return -1;
  }
  constexpr void add(std::string_view one) {
    if (index(one) < 0) name[count++] = one;
  }
};
constexpr DissipationNames list_dissipations() {
  DissipationNames all;
#define FABRICSH_ADD(name) all.add(name::Element::dissipation);
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
  return all;
}
inline constexpr DissipationNames dissipation_names = list_dissipations();
inline constexpr int dissipations = dissipation_names.count;

// Sets the numbers of a new point, which are zero on entry.
inline void set_initial(const Compiled& all, const std::array<YarnSpring, 2>& yarns, const PointSite& site,
                        double* s) {
  int at = 0;
#define FABRICSH_SET(name)                                     \
  if (all.name.on) {                                           \
    name::Element::set_initial(yarns, site, all.name, s + at); \
    at += name::Element::numbers;                              \
  }
  FABRICSH_RHEOLOGY(FABRICSH_SET)
#undef FABRICSH_SET
}

inline Stiffest stiffest(const Compiled& all) {
  Stiffest sum;
  const auto add = [&sum](const Stiffest& one) {
    sum.axial += one.axial;
    sum.shear += one.shear;
  };
#define FABRICSH_ADD(name) \
  if (all.name.on) add(name::Element::stiffest(all.name));
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
  return sum;
}

inline namespace FABRICSH_ISA {

// The stresses and tangents of all in parallel that are on; s0 and s1: where the numbers of the first element
// begin.
template <class T, class Out>
void add_stresses(const Compiled& all, double dt, const T E[5], const T* s0, T* s1, Out& out) {
  int at = 0;
#define FABRICSH_ADD(name)                                  \
  if (all.name.on) {                                        \
    if constexpr (name::Element::acts == Acts::in_parallel) \
      add_stress(all.name, dt, E, s0 + at, s1 + at, out);   \
    at += name::Element::numbers;                           \
  }
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
}

// The product of the factors of all on the springs that are on.
template <class T>
YarnFactor<T> yarn_factors(const Compiled& all, int yarn, bool loading, T E, const T* s0, T* s1) {
  YarnFactor<T> product{T(std::numeric_limits<double>::infinity()), T(1.0), T(0.0)};
  int at = 0;
#define FABRICSH_MULTIPLY(name)                                                            \
  if (all.name.on) {                                                                       \
    if constexpr (name::Element::acts == Acts::on_springs) {                               \
      const YarnFactor<T> one = yarn_factor(all.name, yarn, loading, E, s0 + at, s1 + at); \
      product = {min(product.limit, one.limit), product.value * one.value,                 \
                 product.rate * one.value + product.value * one.rate};                     \
    }                                                                                      \
    at += name::Element::numbers;                                                          \
  }
  FABRICSH_RHEOLOGY(FABRICSH_MULTIPLY)
#undef FABRICSH_MULTIPLY
  return product;
}

// The same in a committed state.
template <class T>
T yarn_factors_at(const Compiled& all, int yarn, const T* s) {
  T product(1.0);
  int at = 0;
#define FABRICSH_MULTIPLY(name)                            \
  if (all.name.on) {                                       \
    if constexpr (name::Element::acts == Acts::on_springs) \
      product *= yarn_factor_at(all.name, yarn, s + at);   \
    at += name::Element::numbers;                          \
  }
  FABRICSH_RHEOLOGY(FABRICSH_MULTIPLY)
#undef FABRICSH_MULTIPLY
  return product;
}

// dissipated: by dissipation_names.
template <class T>
void add_energies(const Compiled& all, const T* s, T& stored, T* dissipated) {
  int at = 0;
#define FABRICSH_ADD(name)                                                                                 \
  if (all.name.on) {                                                                                       \
    add_energy(all.name, s + at, stored, dissipated[dissipation_names.index(name::Element::dissipation)]); \
    at += name::Element::numbers;                                                                          \
  }
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::rheology
