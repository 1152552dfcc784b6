// From stiffness between nodes to a matrix on unknowns: its pattern, the fixed slots of the elements'
// tangents, and the way of every block through frames, ties and driven degrees of freedom.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/term.hpp"

namespace fabricsh::mechanics {

class Stiffness {
 public:
  // batches: of the cloth.
  Stiffness(const Dofs& dofs, std::span<const Batch> batches, std::span<const Place> places);

  // Of the elements, ties and coupled pairs.
  const std::shared_ptr<const linear::Pattern>& pattern() const { return pattern_; }
  // Makes the pattern anew, of the elements, ties and these pairs of nodes.
  void couple(std::span<const NodePair> pairs);

  // One matrix being filled. With `lead` (increments of the driven freedoms) the product of the coupling
  // block with them is gathered too, one number per unknown.
  struct Target {
    linear::Matrix& K;
    std::span<const double> lead;
    std::span<double> product;
  };
  // The tangents of a batch, as the kernels write them; batches of one colour side by side.
  void scatter(Index batch, const double* K, const Target& to);
  // Those of elements with tied nodes, which scatter() put aside: what they lead to is shared across colours.
  void scatter_tied(const Target& to) const;
  // A block on the five freedoms of two nodes, along their frames.
  void add_block(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k, const Target& to) const;
  void add_entry(Index row, Index column, double value, const Target& to) const;
  // c_x on the diagonal of the nodes' displacements, c_d on that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K) const;
  // Second variation of the arms and directors of rigid sets' nodes under the forces of the trial
  // configuration, internal minus external.
  void add_body_stiffness(const Configuration& at, std::span<const double> internal_x,
                          std::span<const double> internal_d, std::span<const double> external,
                          const std::vector<Vec3>* moments, const Target& to) const;

  class Sink;  // of terms

 private:
  void make_pattern();
  void make_slots();
  void list_tied_elements(std::span<const Place> places);
  void scatter_with_care(const Batch& batch, Index element, int lane, const double* K, const Target& to);

  const Dofs& dofs_;
  std::span<const Batch> batches_;
  std::shared_ptr<const linear::Pattern> own_, pattern_;  // of elements and ties; with the pairs
  // Per batch and lane: slots of each column's first row of each node (4 x 20, the column first), -1: none;
  // what is added to them for the node's five rows, -1: no unknown; what a scatter must mind besides.
  enum class Care : char { none, driven, frames };
  std::vector<Index> slots_;
  std::vector<signed char> offsets_;
  std::vector<Care> care_;
  std::vector<Index> tied_place_;  // per batch and lane: place in tied_elements_ or -1; empty without ties
  std::vector<Place> tied_elements_;
  std::vector<double> tied_tangent_;  // per tied element, 20 x 20
};

class Stiffness::Sink final : public TangentSink {
 public:
  Sink(const Stiffness& stiffness, const Target& to) : stiffness_(stiffness), to_(to) {}
  void on_positions(Index a, Index b, const Mat3& k) override;
  void on_director(Index a, const Eigen::Matrix2d& k) override;
  void on_lead(Index a, const Vec3& force) override;

 private:
  bool through_ties(Index a, Index b) const;
  const Stiffness& stiffness_;
  const Target& to_;
};

}  // namespace fabricsh::mechanics
