// The degrees of freedom of a compiled model: which displacements and rotations are unknown, held, driven or
// tied, how unknowns move the nodes, and how nodal forces come to act on unknowns.
#pragma once
#include <span>
#include <utility>
#include <vector>

#include "linear/matrix.hpp"
#include "mechanics/configuration.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/motion.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Dofs {
 public:
  // Lays the reference directors into planes of symmetry, makes those of tied nodes meet, numbers the
  // unknowns and brings the configuration to the reference.
  Dofs(const model::Model& model, Configuration& configuration);

  Index unknowns() const { return freedoms_.unknowns; }
  const Freedoms& freedoms() const { return freedoms_; }
  const std::vector<Vec3>& reference() const { return X_; }
  const std::vector<Vec3>& reference_directors() const { return directors_; }
  bool has_ties() const { return !freedoms_.followers.empty() || !freedoms_.bodies.empty(); }
  // Nodes with a displacement or a director that is driven, ascending.
  const std::vector<Index>& driven_nodes() const { return driven_nodes_; }

  // --- moving the nodes. Trial = iterate moved by scale * delta, driven freedoms at `targets` (m along the
  // frames, rad).
  void begin_iterate();  // iterate = trial
  void retract(std::span<const double> delta, double scale, std::span<const double> targets);
  void return_to_iterate();                        // trial = iterate
  std::vector<double> targets(double time) const;  // values of the driven freedoms; Error when not finite

  // --- forces on unknowns. All 3 per node, global; N, N m. on_d may be empty.
  // r = external - internal, along the nodes' frames, through ties. moments: of the loads, per node, or null.
  void residual(std::span<const double> external, std::span<const double> internal_x,
                std::span<const double> internal_d, std::span<const double> on_d,
                const std::vector<Vec3>* moments, std::span<double> r) const;
  // N, global: what supports exert on a node, internal minus external along the held and driven directions.
  Vec3 support_force(Index node, std::span<const double> internal_x, std::span<const double> external) const;

  // --- rates
  // Rates of the unknowns (and of the driven freedoms) to velocities of the nodes, at the trial
  // configuration.
  void spread_rates(std::span<const double> rates, std::span<const double> driven, NodalRates& out) const;
  // The other way: what the nodes' velocities give the unknowns. Tied nodes follow what they are tied to.
  std::vector<double> collect_rates(const NodalRates& nodal) const;
  // Masses per node (kg, kg m^2) to masses per unknown, lumped. Error: ties whose lumped mass is not
  // positive.
  std::vector<double> lump(std::span<const double> mass, std::span<const double> rotary) const;

  // --- through ties and frames
  // What moves a node's five freedoms (along its frame), at the trial configuration.
  void links(Index node, std::vector<Link>& out) const;
  Vec3 centroid(const Body& body, std::span<const double> x) const;
  // Increment of a driven freedom: a displacement, or for a turned director its angle times the rate of q1 or
  // q2.
  double lead_of(Index motion, std::span<const double> lead) const;

  // --- what an unknown is
  bool turns(Index unknown) const { return turns_[unknown]; }  // a rotation, not a displacement
  Index node_of(Index unknown) const { return unknown_node_[unknown]; }
  double length() const { return length_; }  // m, mean edge of the elements: moments are measured over it
  // The largest residual, N (moments over the length, for rigid bodies over their radius), and the unknown
  // that carries it; -1: none.
  std::pair<double, Index> largest_residual(std::span<const double> r) const;
  // N: of nodal forces and of moments on directors (across them) over the length.
  double largest_force(std::span<const double> on_x, std::span<const double> on_d) const;
  // N: the nodal force that rounding of the coordinates makes, 16 eps max |x| max K_ii over displacements.
  double rounding_floor(const linear::Matrix& K) const;

 private:
  std::span<const double> iterate() const;
  void meet_directors();
  void measure_unknowns(const model::Model& model);
  void realign(Index node);
  void retract_ties(std::span<const double> delta, double scale);
  void add_tied_residual(std::span<const double> external, std::span<const double> internal_x,
                         std::span<const double> internal_d, std::span<const double> on_d,
                         const std::vector<Vec3>* moments, std::span<double> r) const;
  Vec3 tied_force(Index lead, std::span<const double> internal_x, std::span<const double> external) const;

  Configuration& configuration_;
  const std::vector<Vec3> X_;
  std::vector<Vec3> directors_;   // reference
  std::vector<Vec3> first_axes_;  // of the reference directors, for directors that are driven
  Freedoms freedoms_;
  std::vector<double>
      iterate_;  // kinematics, as Configuration's; unused while the iterate is the committed copy
  bool iterate_is_committed_ = true;
  std::vector<Index> driven_nodes_, unknown_node_;
  std::vector<bool> turns_;                              // per unknown
  std::vector<double> lever_;                            // per unknown: m that a moment is divided by; 1
  std::vector<std::vector<std::pair<Index, int>>> led_;  // per node: followers it leads, and as which lead
  double length_ = 1;
};

}  // namespace fabricsh::mechanics
