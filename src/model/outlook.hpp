// What a mesh can show of cloth of given cards, before anything is computed: how yarns run across its
// elements, and how large its folds are.
#pragma once
#include <array>
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

// Folds by the sheet's own weight: 2 pi (B / (rho g t))^(1/3) from one to the next, B: of the softer yarns.
struct OwnFolds {
  double length = 0;   // m
  double element = 0;  // m, mean side
};

struct Outlook {
  std::string region;  // empty: the only one
  YarnsAcross yarns;
  OwnFolds folds;
};

std::vector<Outlook> outlook(const Model& model);  // of each region
// Two lines: about the yarns and about the folds.
std::array<std::string, 2> words(const Outlook& outlook);
// What to warn of; empty: nothing.
std::string warning_of(const Outlook& outlook);

// --- How thick cloth is that nothing presses, as contact has it.

struct Loose {
  double thickness = 0;        // m, at which contact with a plate on either side begins
  double solid_thickness = 0;  // m, what the fibres alone fill
};

// Without a measured compression contact begins at the thickness of the card.
Loose loose(const card::Card& card);

}  // namespace fabricsh::model
