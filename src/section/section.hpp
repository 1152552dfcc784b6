// Through the thickness: integration points with their laws and weights, or a membrane with its own bending
// rigidity.
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

// One integration point: zeta in [-1, 1] and weight (the weights sum to 2) over the whole thickness, its law,
// the angle from the section's warp to its own, its density.
struct Point {
  double zeta = 0, weight = 2;
  double angle = 0;    // rad, counter-clockwise about the normal
  double density = 0;  // kg/m^3
  std::shared_ptr<const law::Law> law;
  int state = 0;  // where its state begins within the section's state
};

struct Section {
  double thickness = 0;   // m
  double offset = 0;      // zeta_bar of the reference surface; z = (t/2)(zeta - zeta_bar)
  double areal_mass = 0;  // kg/m^2
  double density = 0;     // kg/m^3
  std::vector<Point> points;
  int state_size = 0;  // numbers per in-plane integration point, all thickness points together
  const law::PlainWoven* plain = nullptr;  // of the law that all points have, if it is one and that plain
  bool symmetric = true;                   // is every tangent symmetric
  // Separate bending: one thickness point in the middle, and beside it three springs on the material
  // curvatures k11, k22, 2 k12. With friction two states each (slip, lost) for warp and weft, three (and the
  // last curvature) where one of the frictions fades, from bending_state on.
  bool bends_apart = false;
  std::array<law::BendingSpring, 3> bending;
  int bending_state = -1;  // -1: no friction
  int bending_states = 2;  // numbers for each of warp and weft
};

// One ply of a stack, from the side that the normal leaves to the side that it points to.
struct Ply {
  card::Card card;
  double thickness = 0;  // m
  double angle = 0;      // degrees from the model's warp direction
};

// Gauss-Legendre points in every ply. Errors: no ply; a ply of zero thickness (named by its number); a ply
// whose card carries its own bending; the law's refusals.
Section stacked(const std::vector<Ply>& plies, int points, double offset);

// Gauss-Legendre points through the thickness (share/doc/theory.md, 3). Errors: the law's refusals; points
// outside 1..9.
Section integrated(const card::Card& card, double thickness, int points, double offset);

// Nodes and weights of the n-point Gauss-Legendre rule on [-1, 1], 1 <= n <= 9.
std::vector<std::pair<double, double>> gauss_legendre(int n);

}  // namespace fabricsh::section
