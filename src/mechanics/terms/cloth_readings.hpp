// What is read of the cloth in the trial configuration: strains, yarns, shapes of elements.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <utility>

#include "law/law.hpp"
#include "mechanics/mesh_tools.hpp"
#include "mechanics/motion.hpp"

namespace fabricsh::mechanics {

class Cloth;

class ClothReadings {
 public:
  explicit ClothReadings(const Cloth& cloth) : cloth_(cloth) {}

  // Material strains and law states of one element: f(point weight in m^3, law, E[5], state*). In-plane point
  // by in-plane point, and for each through the thickness in the order of the section's points.
  using PointVisitor =
      std::function<void(double weight, const law::Law& law, const double* E, const double* state)>;
  void visit(Index element, const PointVisitor& f) const;
  // Directions of warp and weft, means over the element: unit vectors, global, convected with the cloth. ply:
  // from 0; all_plies: in the axes that they have in common.
  static constexpr int all_plies = -1;
  std::pair<Vec3, Vec3> yarns(Index element, int ply = all_plies) const;
  Vec3 centre(Index element) const;  // m, mean of its corners
  // The first element that is inverted or of zero area, (a1 x a2).d <= 0 at one of its points, among those
  // without any of the given nodes (ascending); -1: none.
  Index inverted_element(std::span<const Index> but_for) const;
  // N/m, along warp and weft: the most that the cloth of an element carries if it folds within the element
  // (cloth_folds.cpp); 0 for a membrane, which has no rigidity.
  std::array<double, 2> fold_tensions(Index element) const;
  // The factor by which stretching has raised the bound of an element's frequencies: s^2 for the law's part,
  // and (s^2 - 1) / 2 for that of the stresses, which are at most the strain times the stiffest modulus; s:
  // the largest stretch.
  double growth(Index element) const;
  double largest_stretch() const;  // of edges and diagonals, current over reference length
  // rad: the largest turn on a way of the nodes, of a director, or of an edge: the difference of its ends
  // over its reference length.
  double largest_turn(const NodalRates& way) const;

 private:
  const Cloth& cloth_;
};

}  // namespace fabricsh::mechanics
