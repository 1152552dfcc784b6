// Joints: which nodes move as one. Nodes never change during a run, joints do.
//
// In a tearable zone each corner of an element has a node of its own (mesh/corners.hpp). The nodes at one
// place start as one joint. An edge between two elements can be opened: at each of its ends the elements
// around that are no longer connected by a closed edge then come apart. At the tip of a cut they are still
// connected the other way round, so that it stays whole. Every node outside of zones is a joint of its own.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::mechanics {

using Index = std::int64_t;

class Joints {
 public:
  // One end of an edge: the place where it is, and that of the other end, as numbers of nodes of the mesh
  // without zones. A cut opens both ends of an edge; a yarn that breaks at a place opens the ends there.
  using Edge = std::pair<Index, Index>;

  explicit Joints(const mesh::Mesh& mesh);  // keeps a reference

  bool any() const { return !leader_.empty(); }  // whether there are zones
  // The node that leads the joint of a node, the first of its nodes.
  Index leader(Index node) const { return leader_.empty() ? node : leader_[static_cast<std::size_t>(node)]; }
  const std::vector<Index>& leaders() const { return leader_; }  // empty: there are no zones
  bool leads(Index node) const { return leader(node) == node; }
  // The next node of the joint of a node, in ascending order; -1: it is the last one.
  Index next(Index node) const { return next_.empty() ? -1 : next_[static_cast<std::size_t>(node)]; }
  std::size_t places() const { return at_.size(); }  // with several nodes
  std::size_t open() const;                          // of these, how many have more than one joint
  bool is_open(Index node) const;                    // whether its place has

  // Both ends of the edges in zones, ascending, whose ends are in a set of nodes; or lie on a line of points
  // in the reference, m, to a hundredth of their length.
  std::vector<Edge> edges_between(std::span<const Index> nodes) const;
  std::vector<Edge> edges_on(std::span<const Vec3> line) const;
  const std::vector<Edge>& opened() const { return opened_; }  // ascending
  // Sets the open ends of edges; returns whether the joints are others now.
  bool set_opened(std::vector<Edge> edges);

 private:
  void divide(Index place);
  void link();
  const mesh::Mesh& mesh_;
  std::vector<Index> leader_, next_;
  std::map<Index, std::vector<Index>> at_;  // of each place with several nodes: its elements
  std::vector<Edge> edges_;                 // that can be opened, both ends, ascending
  std::vector<Edge> opened_;
};

// How the unknowns before a change of the joints become those after it. To be applied to rates of unknowns
// and to directions. Where a joint opens, all of its parts have what it had; where joints close, they have
// the mean weighted by their masses, so that the momentum stays as it was.
class Transfer {
 public:
  struct WeightedUnknown {
    Index old;
    double weight;
  };
  // Adds the next new unknown, by the old ones that it comes from; the weights add up to one.
  void add(std::span<const WeightedUnknown> from) {
    parts_.insert(parts_.end(), from.begin(), from.end());
    first_.push_back(parts_.size());
  }
  std::vector<double> apply(std::span<const double> old) const;
  bool closes() const { return parts_.size() >= first_.size(); }  // whether a joint closed

 private:
  std::vector<WeightedUnknown> parts_;
  std::vector<std::size_t> first_{0};
};

}  // namespace fabricsh::mechanics
