// Readings of the cloth in the trial configuration: strains, yarns, shapes of elements.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "law/law.hpp"
#include "law/peaks.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/law_states.hpp"
#include "mechanics/mesh_tools.hpp"
#include "mechanics/motion.hpp"
#include "model/model.hpp"

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

// --- Strain beyond the tested range of the cards, at the last forces or tangent. For yarns it is the largest
// strain so far.

// The point with the largest strain relative to the range in which its card was tested.
struct Strained {
  double strain_ratio = 0;  // strain over tested strain: 1.2 is 20 % beyond
  double strain = 0;        // E11, E22 or |E12| (tensor)
  double tested = 0;        // the strain up to which the card was tested
  int yarn = 0;             // 0 warp, 1 weft, 2 shear
  Index element = -1;
};

class StrainsReached {
 public:
  StrainsReached(const model::Model& model, const std::vector<Batch>& batches,
                 const std::vector<BatchLane>& place, const LawStates& states);
  void record(Index batch, const double* states);  // as the kernels have just written them
  double largest_ratio() const;                    // 0: no card states its tested range
  Strained most() const;
  double ratio(Index element) const;  // of one element; 0: its card does not state a tested range

 private:
  // A point through the thickness whose card states a tested range.
  struct TestedPoint {
    const law::Law* law;
    int state;
    std::array<double, 3> tested, inverse;  // E11, E22, E12; 1 over them, 0 if not known
  };
  const std::vector<TestedPoint>& tested(const Batch& batch) const;
  Strained most_of(const Batch& batch, int first_lane, int last_lane) const;

  const model::Model& model_;
  const std::vector<Batch>& batches_;
  const std::vector<BatchLane>& place_;
  const LawStates& states_;
  std::vector<std::vector<TestedPoint>> tested_;  // per region
  law::StrainRatioFunction ratio_at_ = nullptr;
  std::vector<double> ratio_;  // per batch the largest; empty: no card states a tested range
};

}  // namespace fabricsh::mechanics
