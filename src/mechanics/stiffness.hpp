// Assembles stiffness between nodes into a matrix on unknowns: its pattern, fixed slots for the elements'
// tangents, and the treatment of blocks with frames, ties and driven degrees of freedom.
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
  // batches: those of the cloth.
  Stiffness(const Dofs& dofs, std::span<const Batch> batches, std::span<const Place> places);

  // The pattern of elements, ties and coupled pairs.
  const std::shared_ptr<const linear::Pattern>& pattern() const { return pattern_; }
  // Makes a new pattern of the elements, the ties and these pairs of nodes.
  void couple(std::span<const NodePair> pairs);

  // A matrix to be filled. With `lead` (increments of the driven degrees of freedom) the product of the
  // coupling block with them is added to `product`, one number per unknown.
  struct Target {
    linear::Matrix& K;
    std::span<const double> lead;
    std::span<double> product;
  };
  void fetch(Index batch, const Target& to) const;  // to be called some time before scatter()
  // Adds the tangents of a batch, as the kernels write them; batches of one colour may run in parallel.
  void scatter(Index batch, const double* K, const Target& to);
  // Adds those of elements with tied nodes, which scatter() stores: their leads may be shared across colours.
  void scatter_tied(const Target& to) const;
  // Adds a block for the five degrees of freedom of two nodes, in their frames.
  void add_block(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k, const Target& to) const;
  void add_entry(Index row, Index column, double value, const Target& to) const;
  // Adds c_x to the diagonal of the nodes' displacements and c_d to that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K) const;
  // Adds the second variation of the arms and directors of the nodes in rigid sets, under the forces of the
  // trial configuration, internal minus external.
  void add_body_stiffness(const Configuration& at, std::span<const double> internal_x,
                          std::span<const double> internal_d, std::span<const double> external,
                          const std::vector<Vec3>* moments, const Target& to) const;

  class Sink;  // for the terms

 private:
  void make_pattern();
  void make_slots();
  void list_tied_elements(std::span<const Place> places);
  void scatter_with_care(const Batch& batch, Index element, int lane, const double* K, const Target& to);

  const Dofs& dofs_;
  std::span<const Batch> batches_;
  std::shared_ptr<const linear::Pattern> own_, pattern_;  // of elements and ties; with the coupled pairs
  // For each batch and lane: slot of each column's first row for each node (4 x 20, the column first), -1:
  // none; offsets for the node's five rows, -1: no unknown; and whether the element needs special treatment.
  enum class Care : char { none, driven, frames };
  std::vector<Index> slots_;
  std::vector<signed char> offsets_;
  std::vector<Care> care_;
  std::vector<Index> tied_place_;  // for each lane: index in tied_elements_ or -1; empty without ties
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
