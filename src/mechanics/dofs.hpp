// The degrees of freedom of a compiled model: which displacements and rotations are unknown, held, driven or
// tied; how unknowns move the nodes; and how nodal forces act on unknowns.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/configuration.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/joints.hpp"
#include "mechanics/motion.hpp"
#include "mechanics/sewing.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Dofs {
 public:
  // Projects the reference directors into planes of symmetry, makes those of tied nodes equal, numbers the
  // unknowns and sets the configuration to the reference.
  Dofs(const model::Model& model, Configuration& configuration);

  // Keeps a reference to the mesh of the model.
  Index unknowns() const { return freedoms_.unknowns; }
  const Joints& joints() const { return joints_; }
  // Sets the open edges and numbers the unknowns anew; empty: the joints stay as they are. Joints that close
  // take the mean of their nodes' positions and directors, weighted by the masses (kg, kg m^2 per node), in
  // the trial configuration. Error: nodes of one of these are farther apart than `within`, m; nothing is
  // changed.
  std::optional<Transfer> open(std::vector<Joints::Edge> edges, std::span<const double> mass,
                               std::span<const double> rotary, double within);
  // The same when a state is restored: the configuration has it already.
  bool reopen(std::vector<Joints::Edge> edges);

  // --- seams. To be called at the committed state.
  const std::vector<model::Stitch>& stitches() const { return stitches_; }
  const std::vector<model::Seam>& seams() const { return seams_; }
  const Sewn& sewn() const { return sewn_; }
  // Whether a seam at the node has been opened or has burst.
  bool has_parted(Index node) const;
  // Sets which stitches are closed and numbers the unknowns anew; empty: nothing changes. Where stitches
  // close, the edges meet so that the centre of mass stays, in the trial configuration. Errors: an edge is
  // farther than `within`, m, from the other where it closes; those of sewn_followers. Nothing is changed
  // then.
  std::optional<Transfer> sew(Sewn next, std::span<const double> mass, std::span<const double> rotary,
                              double within);
  bool resew(Sewn sewn);  // the same when a state is restored: the configuration has it already
  // m, from the place on the other edge to the node.
  static Vec3 gap(const model::Stitch& stitch, std::span<const double> x);

  const Freedoms& freedoms() const { return freedoms_; }
  const std::vector<Vec3>& reference() const { return X_; }
  const std::vector<Vec3>& reference_directors() const { return directors_; }
  bool has_ties() const { return !freedoms_.followers.empty() || !freedoms_.bodies.empty(); }
  // The equations of a plain node: its frame is the global one, it is not tied and leads its joint, and its
  // director is neither driven nor restricted to some axes. Null for all other nodes.
  const std::int32_t* plain_equations(Index node) const {
    return plain_[node].is_plain ? plain_[node].equation.data() : nullptr;
  }
  // Nodes with a driven displacement or director, ascending.
  const std::vector<Index>& driven_nodes() const { return driven_nodes_; }

  // --- moving the nodes. Trial = iterate moved by scale * delta, with the driven degrees of freedom at
  // `targets` (m along the frames, rad).
  void begin_iterate();  // iterate = trial
  void apply_increment(std::span<const double> delta, double scale, std::span<const double> targets);
  // From now on what is held stays where it is in the committed state, not where it was in the reference.
  void hold_here();
  std::vector<double> targets(double time) const;  // of the driven freedoms; Error if not finite

  // --- forces on unknowns. All arrays have 3 numbers per node, global; N, N m. on_d may be empty.
  // r = external - internal, in the nodes' frames, through ties. moments: of the loads, per node, or null.
  void residual(std::span<const double> external, std::span<const double> internal_x,
                std::span<const double> internal_d, std::span<const double> on_d,
                const std::vector<Vec3>* moments, std::span<double> r) const;
  // N, global: force of the supports on a node, internal minus external along the held and driven directions.
  Vec3 support_force(Index node, std::span<const double> internal_x, std::span<const double> external) const;

  // --- rates
  // Converts rates of the unknowns and of the driven degrees of freedom to nodal velocities, at the trial
  // configuration.
  void spread_rates(std::span<const double> rates, std::span<const double> driven, NodalRates& out) const;
  // Converts nodal velocities to rates of the unknowns. Tied nodes follow their leads.
  std::vector<double> collect_rates(const NodalRates& nodal) const;
  // Converts masses per node (kg, kg m^2) to lumped masses per unknown. Error: ties that have no positive
  // lumped mass.
  std::vector<double> lump(std::span<const double> mass, std::span<const double> rotary) const;

  // --- ties and frames
  // The unknowns that move a node's five degrees of freedom (in its frame), at the trial configuration.
  void links(Index node, std::vector<Link>& out) const;
  // The nodes whose displacements move a node, by weights along the global axes: itself, or those that it
  // follows. A node of a rigid set has none.
  struct AxisLead {
    Index node;
    Vec3 weight;
  };
  void leads(Index node, std::vector<AxisLead>& out) const;
  Vec3 centroid(const RigidBody& body, std::span<const double> x) const;
  // Increment of a driven degree of freedom: a displacement; or for a rotated director its angle times the
  // rate of q1 or q2.
  double lead_of(Index motion, std::span<const double> lead) const;

  // --- properties of unknowns
  bool turns(Index unknown) const { return turns_[unknown]; }  // whether it is a rotation
  Index node_of(Index unknown) const { return unknown_node_[unknown]; }
  double length() const { return length_; }  // m, mean edge of the elements, by which moments are divided
  // The largest residual in N, and its unknown (-1: none). Moments are divided by the length, those of rigid
  // bodies by their radius.
  std::pair<double, Index> largest_residual(std::span<const double> r) const;
  // N: the largest of nodal forces and of moments on directors (perpendicular to them) over the length.
  double largest_force(std::span<const double> on_x, std::span<const double> on_d) const;
  // N: nodal force caused by rounding of the coordinates, 16 eps max |x| max K_ii over displacements.
  double rounding_floor(const linear::Matrix& K) const;

  std::span<const double> iterate() const;  // kinematics, as in Configuration

 private:
  void meet_directors();
  void find_plain_nodes();
  void number();
  void list_unknowns();
  void measure(const model::Model& model);
  struct Axes {
    Vec3 q1, q2;  // of a node's rotations
  };
  std::vector<Axes> axes() const;
  void meet(double within, std::span<const double> mass, std::span<const double> rotary);
  Transfer transfer(const std::vector<std::array<Index, 5>>& before, Index bodies_before,
                    const std::vector<Axes>& axes_before, std::span<const double> mass,
                    std::span<const double> rotary) const;
  void list_led();
  void mixed_links(const model::Follower& f, const model::Lead& lead, std::vector<Link>& out) const;
  void begin_seams(const model::Model& model);
  void follow_seams();
  void follow();
  void check_gaps(const Sewn& before, double within) const;
  void meet_seams(std::span<const double> mass, std::span<const double> rotary);
  struct DofRow {  // what an unknown does to a node and to its director, global
    Index equation;
    Vec3 x, d;
  };
  std::vector<DofRow> row_of(Index node) const;
  Transfer transfer_seams(const std::vector<std::array<Index, 5>>& before, Index bodies_before,
                          const std::vector<std::vector<DofRow>>& rows, std::span<const double> mass,
                          std::span<const double> rotary) const;
  double lever(Index unknown) const;  // m, by which its moments are divided; 1 for a displacement
  void realign(Index node);
  void apply_ties(std::span<const double> delta, double scale);
  void add_tied_residual(std::span<const double> external, std::span<const double> internal_x,
                         std::span<const double> internal_d, std::span<const double> on_d,
                         const std::vector<Vec3>* moments, std::span<double> r) const;
  void gather(std::span<double> on_nodes) const;
  double largest_nodal_force(std::span<const double> on_x, std::span<const double> on_d) const;
  Vec3 tied_force(Index lead, std::span<const double> internal_x, std::span<const double> external) const;

  Configuration& configuration_;
  Joints joints_;
  const std::vector<Vec3> X_;
  std::vector<Vec3> directors_;   // reference
  std::vector<Vec3> first_axes_;  // of the reference directors, for driven directors
  Freedoms freedoms_;
  std::vector<model::Seam> seams_;
  std::vector<model::Stitch> stitches_;
  Sewn sewn_;
  std::vector<Index> seam_nodes_;             // ascending
  std::vector<model::Follower> ties_;         // without those of seams; not used if there are no seams
  std::vector<std::array<Index, 5>> unsewn_;  // see sewn_followers; not used if there are no seams
  // As in Configuration; not used while the iterate is the committed copy.
  std::vector<double> iterate_;
  bool iterate_is_committed_ = true;
  struct PlainNode {  // an eighth of the size of NodeFreedoms; an explicit step reads it twice
    std::array<std::int32_t, 5> equation{};
    bool is_plain = false;
  };
  std::vector<PlainNode> plain_;
  std::vector<Index> driven_nodes_;
  std::vector<Vec3> held_at_;  // m, displacements of the nodes in their frames; empty: held at the reference
  std::vector<std::int32_t> unknown_node_;
  std::vector<bool> turns_;                              // per unknown
  std::vector<double> radius_;                           // m, per body
  std::vector<std::vector<std::pair<Index, int>>> led_;  // per node: followers it leads, and as which lead
  std::vector<Index> tied_nodes_;                        // ascending
  double length_ = 1;
  // Places of the diagonal in the values of a matrix with the pattern of this version.
  mutable std::vector<Index> diagonal_[2];  // entries of the matrix: displacements, rotations
  mutable std::uint64_t diagonal_version_ = 0;
};

}  // namespace fabricsh::mechanics
