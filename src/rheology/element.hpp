// A rheological element acts on the springs of the woven law, or in parallel to them. The stress of a point
// is
//   springs -> elements on the springs -> elements in parallel
// that is, the yarn springs' stresses are multiplied by factors, and further stresses are added. Every folder
// of this room holds one element, which the build finds by its folder alone. The folder NAME has a header
// NAME.hpp that defines, in the namespace fabricsh::rheology::NAME,
//
//   struct Parameters    what a card states: numbers, and operator==
//   struct Data          what the kernels use; its member `on` is false in a card without the element
//   struct Element       description, as viscous::Element and damage::Element
//
// and kernels over a number type T, in the namespace FABRICSH_ISA. s0, s1: the element's own numbers of the
// committed and of the trial state. E: the strain at the end of the step; conventions of law/law.hpp. In
// parallel:
//   add_stress(data, dt, E, s0, s1, out)
//     dt: the length of the step, s. It adds to out.S (5-vector, Pa) and to the entries out.C11, C12, C21,
//     C22, C55 of dS/dE, with C12 = C21, since cards with law "potential" go to the solver of symmetric
//     matrices.
//   add_energy(data, s, stored, lost)
//     Adds to the energy stored, and to that dissipated under the name Element::dissipation, J/m^3, functions
//     of the state alone.
// On the springs:
//   yarn_factor(data, yarn, loading, E, s0, s1) -> YarnFactor
//     yarn: 0 warp, 1 weft, whose strain is E. loading: which tangent holds where loading and unloading meet.
//   yarn_factor_at(data, yarn, s) -> T
//     The factor in a committed state.
//   add_energy(data, s, stored, lost)
//     As above; what the springs store is multiplied by the factor already.
#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "base/range.hpp"

namespace fabricsh::rheology {

// One parameter in a card: its field in decks, checks, messages, help and the reference. A name with a dot
// stands in the group before it, a row without `place`, of which only name and sentence are used.
template <class Parameters>
struct ParameterRow {
  ParameterRow(std::string name_, std::string sentence_)
      : name(std::move(name_)), sentence(std::move(sentence_)) {}
  ParameterRow(std::string name_, double Parameters::*place_, std::string unit_, Range range_,
               std::string sentence_)
      : name(std::move(name_)),
        place(place_),
        unit(std::move(unit_)),
        sentence(std::move(sentence_)),
        range(range_) {}
  ParameterRow ask(double low, double high, std::string words) const {
    ParameterRow copy = *this;
    copy.usual = {low, high};
    copy.question = std::move(words);
    return copy;
  }
  ParameterRow printed(std::string words, double by = 1) const {
    ParameterRow copy = *this;
    copy.phrase = std::move(words);
    copy.scale = by;
    return copy;
  }

  // Of a group that a card may leave out; its numbers are then zero.
  ParameterRow not_needed() const {
    ParameterRow copy = *this;
    copy.required = false;
    return copy;
  }

  std::string name;
  double Parameters::*place = nullptr;
  std::string unit, sentence;
  Range range, usual;    // usual: for cloth; outside it the question is asked
  std::string question;  // empty: none is asked
  std::string phrase;    // of a printed card, "over # s"; the number is multiplied by `scale`
  double scale = 1;
  bool required = true;
};

// How an element acts on the stress.
enum class Acts { in_parallel, on_springs };

// Data by which points of one card differ: uniform over a sheet, or each element's own. A law reads them
// once, when it makes the initial state of the point, which keeps the part that it needs.
struct PointSite {
  std::array<double, 2> size{};  // m, extent along warp and weft of the cloth that the point stands for
  double thickness = 0;          // m, of its ply; 0: that of the card
  std::array<double, 2> strength{1, 1};  // of its warp and weft yarns, over that of the card
  // Pa, compressive stress along warp and weft at which it folds within itself; negative: it does not.
  std::array<double, 2> folding{-1, -1};
};

// The spring of a yarn, without its coupling to the other yarn.
struct YarnSpring {
  std::function<double(double)> stress;  // Pa, virgin, of the strain
  double unloading = 0;                  // Pa
};

// The factor of a yarn's spring in a step. Up to the strain `limit` the spring follows its virgin curve; from
// there on it continues along its unloading line, and is multiplied by value; rate is d value / dE.
template <class T>
struct YarnFactor {
  T limit, value, rate;
};

// Contribution of an element to the largest eigenvalue of the stiffest tangent, Pa.
struct Stiffest {
  double axial = 0, shear = 0;
};

}  // namespace fabricsh::rheology
