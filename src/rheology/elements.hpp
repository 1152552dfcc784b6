// All rheological elements together. list.hpp is made by the build: it includes the header of each folder of
// this room, and defines FABRICSH_RHEOLOGY(X) as X(name) for each.
#pragma once
#include <optional>

#include "rheology/element.hpp"
#include "rheology/list.hpp"

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

// The stresses and tangents of all that are on; s0 and s1: where the numbers of the first one begin.
template <class T, class Out>
void add_stresses(const Compiled& all, double dt, const T E[5], const T* s0, T* s1, Out& out) {
  int at = 0;
#define FABRICSH_ADD(name)                              \
  if (all.name.on) {                                    \
    add_stress(all.name, dt, E, s0 + at, s1 + at, out); \
    at += name::Element::numbers;                       \
  }
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
}

template <class T, class Out>
void add_energies(const Compiled& all, const T* s, Out& out) {
  int at = 0;
#define FABRICSH_ADD(name)             \
  if (all.name.on) {                   \
    add_energy(all.name, s + at, out); \
    at += name::Element::numbers;      \
  }
  FABRICSH_RHEOLOGY(FABRICSH_ADD)
#undef FABRICSH_ADD
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::rheology
