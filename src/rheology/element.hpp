// A rheological element acts in parallel to the springs of the woven law: its stress is added to theirs.
// Every folder of this room holds one, which the build finds by its folder alone. The folder NAME has a
// header NAME.hpp that defines, in the namespace fabricsh::rheology::NAME,
//
//   struct Parameters    what a card states: numbers, and operator==
//   struct Data          what the kernels use; its member `on` is false in a card without the element
//   struct Element       description, as viscous::Element
//   add_stress(data, dt, E, s0, s1, out)
//     A kernel over a number type T, in the namespace FABRICSH_ISA. dt: the length of the step, s. E: the
//     strain at its end. s0, s1: the element's own numbers of the committed and of the trial state. It adds
//     to out.S (5-vector, Pa) and to the entries out.C11, C12, C21, C22, C55 of dS/dE, with C12 = C21, since
//     cards with law "potential" go to the solver of symmetric matrices; conventions of law/law.hpp.
//   add_energy(data, s, out)
//     Likewise: adds to out.stored and to out.warp, .weft and .shear, the energies dissipated in warp, weft
//     and shear, J/m^3, functions of the state alone.
#pragma once
#include <string>
#include <utility>
#include <vector>

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

  std::string name;
  double Parameters::*place = nullptr;
  std::string unit, sentence;
  Range range, usual;    // usual: for cloth; outside it the question is asked
  std::string question;  // empty: none is asked
  std::string phrase;    // of a printed card, "over # s"; the number is multiplied by `scale`
  double scale = 1;
};

// What an element adds to the largest eigenvalue of the stiffest tangent, Pa.
struct Stiffest {
  double axial = 0, shear = 0;
};

}  // namespace fabricsh::rheology
