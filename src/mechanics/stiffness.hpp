// Assembles stiffness between nodes into a matrix on unknowns: its pattern, fixed slots for the elements'
// tangents, and the treatment of blocks with frames, ties and driven degrees of freedom.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/term.hpp"

namespace fabricsh::mechanics {

// Where the block of two nodes of an element is added: for each of the five columns the index of the entry in
// the row node's first row.
struct ElementBlock {
  static constexpr std::uint32_t none = 0xffffffff;
  signed char row = -1, column = -1;  // corners of the element; -1: there is no block
  std::array<std::uint32_t, 5> slot{none, none, none, none, none};
  bool used() const { return row >= 0; }
};

class Stiffness {
 public:
  // batches: those of the cloth. upper: the pattern keeps the upper triangle, which is enough for a solver of
  // symmetric matrices; the node's own blocks are whole.
  Stiffness(const Dofs& dofs, std::span<const Batch> batches, std::span<const BatchLane> places, bool upper);

  // The pattern of elements, ties and coupled pairs.
  const std::shared_ptr<const linear::Pattern>& pattern() const { return pattern_; }
  // Makes a new pattern of the elements, the ties and these pairs of nodes.
  void couple(std::span<const NodePair> pairs);

  // A matrix to be filled. With `lead` (increments of the driven degrees of freedom) the product of the
  // coupling block with them is added to `product`, one number per unknown. read: gets the tangents of each
  // batch as the kernels write them, whole; called from several threads.
  using Reader = std::function<void(Index batch, const double* K)>;
  struct Target {
    linear::Matrix& K;
    std::span<const double> lead;
    std::span<double> product;
    const Reader* read = nullptr;
  };
  void fetch(Index batch, const Target& to) const;  // to be called some time before scatter()
  // The blocks of a batch's tangents that are read: bit 4 a + b of nodes a and b.
  unsigned wanted(Index batch, const Target& to) const {
    return to.read != nullptr ? 0xffffu : wanted_[static_cast<std::size_t>(batch)];
  }
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
  void find_slots();
  void pair_elements();
  void list_tied_elements(std::span<const BatchLane> places);
  void keep_upper(std::vector<std::vector<Index>>& columns) const;
  void scatter_with_care(const Batch& batch, Index element, int lane, const double* K, const Target& to);

  const Dofs& dofs_;
  std::span<const Batch> batches_;
  bool upper_;
  std::vector<Index> block_end_;  // for each unknown the last one of its node or body; empty if not upper_
  std::shared_ptr<const linear::Pattern> own_, pattern_;  // of elements and ties; with the coupled pairs
  std::size_t per_element() const { return upper_ ? 10 : 16; }  // blocks
  std::span<const ElementBlock> blocks_of(Index element, int count) const {
    const auto n = per_element();
    return {blocks_.data() + static_cast<std::size_t>(element) * n, static_cast<std::size_t>(count) * n};
  }
  // For each batch and lane: its blocks; the offsets of its rows from their node's first row, -1: no unknown;
  // and whether the element needs special treatment.
  enum class Care : char { none, driven, frames };
  std::vector<ElementBlock> blocks_;
  std::vector<std::uint16_t> wanted_;
  std::vector<signed char> offsets_;
  std::vector<Care> care_;
  std::vector<bool> paired_;
  std::vector<Index> tied_place_;  // for each lane: index in tied_elements_ or -1; empty without ties
  std::vector<BatchLane> tied_elements_;
  std::vector<double> tied_tangent_;  // per tied element, 20 x 20
};

class Stiffness::Sink final : public TangentSink {
 public:
  // apart: for what is kept apart; null: nothing is.
  Sink(const Stiffness& stiffness, const Target& to, linear::Matrix* apart)
      : stiffness_(stiffness), to_(to), apart_(apart) {}
  bool has_apart() const { return has_apart_; }
  void on_positions(Index a, Index b, const Mat3& k) override { add_positions(a, b, k, to_); }
  void on_positions_apart(Index a, Index b, const Mat3& k, const Mat3& apart) override;
  void on_director(Index a, const Eigen::Matrix2d& k) override;
  void on_nodes(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k) override;
  void on_lead(Index a, const Vec3& force) override;

 private:
  bool through_ties(Index a, Index b) const;
  void add_positions(Index a, Index b, const Mat3& k, const Target& to);
  const Stiffness& stiffness_;
  const Target& to_;
  linear::Matrix* apart_;
  bool has_apart_ = false;
};

}  // namespace fabricsh::mechanics
