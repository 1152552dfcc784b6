// The structure through the thickness: integration points with laws
// and weights, or a membrane with separate bending rigidities.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "card/card.hpp"
#include "law/bending_spring.hpp"
#include "law/law.hpp"

namespace fabricsh::law {
struct PlainWoven;
}

namespace fabricsh::section {

// One integration point: zeta in [-1, 1] and weight (the weights sum to 2) over the whole
// thickness, its law, the angle from the section's warp to its own, and its density.
struct Point {
  double zeta = 0, weight = 2;
  double angle = 0;    // rad, counter-clockwise about the normal
  double density = 0;  // kg/m^3
  std::shared_ptr<const law::Law> law;
  int state = 0;  // index in the section's state at which its own begins
};

struct Section {
  double thickness = 0;   // m
  double offset = 0;      // zeta_bar of the reference surface; z = (t/2)(zeta - zeta_bar)
  double areal_mass = 0;  // kg/m^2
  double density = 0;     // kg/m^3
  std::vector<Point> points;
  int state_size = 0;  // numbers per in-plane integration point, all thickness points together
  const law::PlainWoven* plain = nullptr;  // set if all points have one and the same plain law
  bool symmetric = true;                   // whether every tangent is symmetric
  // Separate bending: one thickness point in the middle, and three springs on the material
  // curvatures k11, k22, 2 k12. With friction, warp and weft have two states each (slip, lost), or
  // three (also the last curvature) if one of the frictions fades; they begin at bending_state.
  bool bends_apart = false;
  std::array<law::BendingSpring, 3> bending;
  int bending_state = -1;  // -1: no friction
  int bending_states = 2;  // numbers of each of warp and weft
};

// One ply of a stack; the first ply is on the side away from the normal.
struct Ply {
  card::Card card;
  double thickness = 0;  // m
  double angle = 0;      // degrees from the model's warp direction
};

// A section with Gauss-Legendre points in every ply. Errors: no ply; a ply of zero thickness
// (with its number); a ply whose card has bending of its own; a card refused by its law.
Section stacked(const std::vector<Ply>& plies, int points, double offset);

// A section with Gauss-Legendre points through the thickness (share/doc/theory.md,
// 3). Errors: a card refused by its law; points outside 1..9.
Section integrated(const card::Card& card, double thickness, int points, double offset);

// Nodes and weights of the n-point Gauss-Legendre rule on [-1, 1], 1 <= n <= 9.
std::vector<std::pair<double, double>> gauss_legendre(int n);

}  // namespace fabricsh::section
