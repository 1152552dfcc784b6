// The guard of the directors. The assumed transverse shear of the elements sees the mean of two directors
// along the edge between them, and nothing else: directors may splay, to opposite sides at the two ends of an
// edge, against the bending rigidity alone. The guard has two parts, which are zero in ordinary deformation;
// their energy is the account "directors". Formulas: share/doc/theory.md, section 3.
//
//   Splay. Where directors lean across a fold by an angle, the curvature of the fold seems smaller by its
//   cosine, and so does its energy B kappa^2 / 2. That is more than splaying costs as soon as B kappa^2 > 4
//   B' / b^2, with B' the rigidity across the fold and b the width of the element. From half of this on, the
//   energy that is lost is given back, so that directors gain nothing by leaning.
//
//   Lean. A director more than 45 degrees from the normal of the surface at its node is resisted by half of
//   the modulus of transverse shear. The normal is the mean of its elements' normals by area; in the limit of
//   a fold that closes, where it vanishes, the guard does so, too.
//
//   Lean of triangles. A thin triangle holds a director to its own normal by bending alone (shell3.hpp),
//   which sees the sine of the angle: in a sharp fold one side would take all of it and turn the director
//   over. From 60 degrees between a director and the normal of one triangle on, that is resisted by ten times
//   the bending rigidity; where the reference has an angle already, later.
//
//   Where a joint opens in a fold, its director, which stood upright on the mean of both sides, leans on
//   each. That must make no energy: the cosine at which leaning begins to cost is that which the part has
//   there, and goes back to that of 45 degrees as its director comes upright. The energy that the whole joint
//   had stored is lost.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "mechanics/dofs.hpp"
#include "mechanics/term.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Directors final : public Term {
 public:
  Directors(const model::Model& model, const Configuration& configuration, Cloth& cloth, const Dofs& dofs);

  const char* name() const override { return "directors"; }
  void renumbered(Forces&) override;
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void couple(const Trial& trial, std::vector<NodePair>& pairs) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  void commit() override;
  void keep(Archive& archive) override;

  // The first element that is turned inside out, and the first node whose director is turned over, more than
  // 90 degrees from the normal of sound elements, whose normals are on one side. -1: none.
  struct Overturned {
    Index inverted = -1, turned = -1;
  };
  Overturned overturned(const Configuration& configuration) const;

 private:
  std::vector<Index> turned_over(const Configuration& configuration) const;  // nodes, ascending
  // An edge, and the direction across it: sum of weights times positions, from the edge into the element.
  struct Ridge {
    std::array<Index, 4> nodes;  // of the element
    int corners, first, second;  // ends of the edge
    std::array<double, 4> across;
    double bend, width, energy;  // see OfEdge
  };
  // Data of an edge from the reference.
  struct OfEdge {
    double bend;    // (chord . delta)^2 from which the guard acts, m^2
    double width;   // length of the direction across in the reference, m
    double energy;  // J, of the ramp at one
  };
  // A node and the sum N of normals times areas, m^2, of its elements or of one, projected into its symmetry
  // plane.
  struct Lean {
    Index node;
    std::span<const Index> elements;
    double weight, area;    // J; m^2, |N| in the reference
    double upright, scale;  // cosines: where leaning begins to cost, and over which the cost grows
    Vec3 normal;
    Vec3 by_normal, by_director;  // derivatives of the energy
    double energy;                // J
  };

  // The elements about each node that leads its joint.
  struct Around {
    std::vector<Index> first, elements;  // those of node n from first[n] to first[n + 1]
    std::span<const Index> of(Index node) const;
  };
  bool changes_joints() const;
  double cosine_at(Index node) const;  // of director and normal in the configuration as it is
  bool sound(Index element, const Vec3& mean, const Configuration& configuration) const;
  void follow_joints();
  void find_weights();
  void find_planes();
  std::vector<double> bent_limits() const;
  OfEdge found_of_edge(const Batch& batch, int lane, int edge) const;
  const OfEdge& of_edge(std::size_t batch, int lane, int edge) const;
  Ridge ridge(std::size_t batch, int lane, int edge) const;
  std::span<const Index> elements_of(Index node) const { return around_.of(node); }
  double upright(Index node) const;
  Vec3 normal_at(Index node, std::span<const double> x) const;
  Vec3 plane_projected(Index node, const Vec3& v) const;
  // A director that leans by 45 degrees from an element: the node that leads it, and the element.
  struct Corner {
    Index node, element;
  };
  std::vector<Corner> sorted(const std::vector<Corner>& corners) const;
  std::vector<Corner> leaning_corners(const Configuration& configuration) const;
  std::vector<Index> leaning_nodes(const Configuration& configuration) const;
  bool lean_of(Index node, const Configuration& configuration, Lean& lean) const;
  bool lean_of(const Corner& corner, const Configuration& configuration, Lean& lean) const;
  bool costs(const Configuration& configuration, Lean& lean) const;
  template <class Visit>
  void visit_ridges(const Configuration& configuration, Visit visit) const;
  template <class Visit>
  void visit_leans(const Configuration& configuration, Visit visit) const;
  void add_lean_forces(const Lean& lean, std::span<const double> x, Forces& forces) const;
  void add_lean_tangent(const Lean& lean, const Configuration& configuration, TangentSink& sink) const;

  const Configuration& configuration_;
  Cloth& cloth_;
  const Dofs& dofs_;
  const model::Model& model_;
  const std::vector<Vec3>& X_;
  std::vector<double> limits_;  // per batch, of Ridge::bend, the least
  // Per batch, by lane and edge; those of batches whose edges have bent that far.
  mutable std::vector<std::unique_ptr<std::array<OfEdge, 4 * lanes>>> of_edges_;
  std::vector<std::array<double, 3>> rigidity_;  // per section: along warp and weft, and of twist, N m
  std::vector<double> weight_;  // J per node: half the shear modulus times thickness and area; 0: no guard
  std::vector<double> area_;    // m^2 per node, |N| in the reference
  std::unordered_map<Index, Vec3> plane_;  // normal of the plane in which a director must stay
  Around around_;
  std::map<Index, double> lowered_;  // cosine at which leaning begins to cost, of nodes where it is lowered
  double lost_ = 0;                  // J, as joints changed
};

}  // namespace fabricsh::mechanics
