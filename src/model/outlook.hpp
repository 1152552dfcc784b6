// Details of cloth of given cards that a mesh resolves, before anything is computed: how yarns run across its
// elements, and how large its folds are.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "card/card.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

// Yarns lock triangles that they cross obliquely, and in full_yarns also quadrilaterals.
struct YarnsAcross {
  double degrees = 0;    // between yarns and the nearest sides of their elements, the mean over the area
  double most = 0;       // of any element
  double stiffness = 0;  // of the stiffer yarns over that of shear
  double triangles = 0;  // share of the area in triangles
  double locking = 0;    // share of the area in elements that lock
  double across = 0;     // elements that a square of the same area would have along its side
  Index worst = -1;      // the element that locks most
};

// Lengths from one fold to the next, m, with the rigidity B of the softer yarns.
struct OwnFolds {
  double length = 0;   // by the sheet's own weight, 2 pi (B / (rho g t))^(1/3)
  double flesh = 0;    // on what gives way under it by k, Pa/m, 2 pi (B / k)^(1/4); 0: there is none
  double element = 0;  // mean side
};

// How the cloth is loaded, by the declarations of the model.
enum class Test {
  unknown,
  flat,     // it cannot leave its plane
  pulled,   // neither weight nor body
  falls,    // it has weight
  pressed,  // bodies with a stiffness of their own press on it
};

struct Outlook {
  std::string region;  // empty: the only one
  YarnsAcross yarns;
  OwnFolds folds;
  Test test = Test::unknown;
};

// Of each region. flesh: Pa/m, of what the cloth lies on; the softest body by default.
std::vector<Outlook> outlook(const Model& model, std::optional<double> flesh = {});
// Two lines: about the yarns and about the folds.
std::array<std::string, 2> words(const Outlook& outlook);
// The text of a warning; empty: none.
std::string warning_of(const Outlook& outlook);

// --- How thick cloth is that nothing presses, as contact has it.

struct Loose {
  double thickness = 0;        // m, at which contact with a plate on either side begins
  double solid_thickness = 0;  // m, what the fibres alone fill
};

// Without a measured compression contact begins at the thickness of the card.
Loose loose(const card::Card& card);

}  // namespace fabricsh::model
