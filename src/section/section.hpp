// The structure through the thickness: integration points with laws
// and weights, or a membrane with separate bending rigidities.
#pragma once
#include <array>
#include <memory>
#include <string>
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
  int ply = 0;    // number of its ply, from 0 below; 0 in a section of one card
};

struct Section {
  double thickness = 0;        // m
  double offset = 0;           // zeta_bar of the reference surface; z = (t/2)(zeta - zeta_bar)
  double areal_mass = 0;       // kg/m^2
  double solid_thickness = 0;  // m, what the fibres alone fill: how thin it can be pressed at most
  // Thickness (m) ascending and pressure (Pa) where it is pressed flat; empty: not measured.
  std::vector<std::pair<double, double>> compression;
  double density = 0;  // kg/m^3
  std::vector<Point> points;
  int state_size = 0;  // numbers per in-plane integration point, all thickness points together
  const law::PlainWoven* plain = nullptr;  // set if all points have one and the same plain law
  bool symmetric = true;                   // whether every tangent is symmetric
  // The stiffest modulus along warp and weft over the first one in shear, sums through the thickness in the
  // axes of the first point. It decides how far elements ease the strain of oblique yarns
  // (element/shell4.hpp); zeros: not at all.
  std::array<double, 2> yarns_over_shear{};
  // Separate bending: one thickness point in the middle, and three springs on the material
  // curvatures k11, k22, 2 k12. With friction, warp and weft have two states each (slip, lost), or
  // three (also the last curvature) if one of the frictions fades; they begin at bending_state.
  bool bends_apart = false;
  std::array<law::BendingSpring, 3> bending;
  int bending_state = -1;  // -1: no friction
  int bending_states = 2;  // numbers of each of warp and weft

  double thickness_of(int ply) const;  // m

  // Whether the plies have different axes. Then no warp is that of all of them.
  bool turned_plies() const;
  // rad, from the section's warp to the axes in which components of all plies together are given: those that
  // the plies have in common, otherwise those of the section.
  double common_angle() const { return turned_plies() ? 0 : points.front().angle; }
};

// One ply of a stack; the first ply is on the side away from the normal.
struct Ply {
  card::Card card;
  double thickness = 0;   // m
  double angle = 0;       // degrees from the model's warp direction
  std::string name = {};  // by which its fields are asked for; empty: by its number alone
};

// Whether the section answers to the mirror image of a deformation by the mirror image of its stresses, for a
// mirror perpendicular to the surface whose normal lies at an angle (rad) from the section's warp.
bool mirrored(const Section& section, double angle);

// A section with Gauss-Legendre points in every ply. Errors: no ply; a ply of zero thickness
// (with its number); a ply whose card has bending of its own; a card refused by its law.
Section stacked(const std::vector<Ply>& plies, int points, double offset);

// A section with Gauss-Legendre points through the thickness (share/doc/theory.md,
// 3). Errors: a card refused by its law; points outside 1..9.
Section integrated(const card::Card& card, double thickness, int points, double offset);

// A membrane: one point in the middle, without transverse shear; the card's own bending does not count.
// Errors: as for integrated().
Section membrane(const card::Card& card, double thickness);

// Nodes and weights of the n-point Gauss-Legendre rule on [-1, 1], 1 <= n <= 9.
std::vector<std::pair<double, double>> gauss_legendre(int n);

// Where the card has bending rigidities B of its own, the assumed transverse shear alone makes the sheet
// softer than B. Raises its stiffness so far that the deflection by shear is small on elements of this size
// (m): of a cantilever n elements long it is 4 / (20 n^2) of that by bending. Without rigidities of its own:
// no change.
void hide_transverse_shear(Section& section, const card::Card& card, double size);

}  // namespace fabricsh::section
