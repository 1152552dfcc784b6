// A model compiled into arrays: element batches, equation numbers, the sparse pattern with fixed slots, the
// state store. Gives forces and tangents for the trial configuration, the same bits for any number of
// threads. Forces: each batch writes into slots of its own, and each node sums its elements' slots in their
// order. Tangents: batches are in colours that share no node, and colours follow one another.
//
// An explicit step: move state().x(), d() and b1() (or retract()), state().touch(), aim(time), forces(),
// read internal_on_x() and internal_on_d(), state().commit(time).
#pragma once
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "assembly/freedoms.hpp"
#include "assembly/loads.hpp"
#include "assembly/state.hpp"
#include "base/aligned.hpp"
#include "element/shell3.hpp"
#include "fabric/peaks.hpp"
#include "model/model.hpp"
#include "solver/sparse.hpp"

namespace fabricsh::assembly {

// Where an element sits in the batches.
struct Place {
  Index batch;
  int lane;
};

// What the assembly must know of a kind of element.
struct Kind {
  element::Shell4Kernels kernels;
  int corners, in_plane, dofs;
  int first_point;    // of the geometry column: where the points' transforms begin, eight numbers each
  int geometry_size;  // of the column of one lane
  int point(int g, int k, int points) const { return first_point + 8 * (points * g + k); }
};

struct BendingEnergy {
  double stored = 0, lost = 0;  // J
};

// What does work on the cloth from outside, 3 per node, global.
struct WorkingForces {
  std::vector<double> on_x;  // N
  std::vector<double> on_d;  // N m, on directors; empty where no load and no moving support acts on them
};

// The point that is farthest beyond what its card was tested to.
struct Strained {
  double share = 0;   // of the tested strain: 1.2 is 20 % beyond it
  double strain = 0;  // E11, E22 or |E12| (tensor)
  double tested = 0;  // the strain that the card was tested to
  int yarn = 0;       // 0 warp, 1 weft, 2 shear
  Index element = -1;
};

// Velocities of all nodes, 3 per node, global.
struct NodalRates {
  std::vector<double> x;  // m/s
  std::vector<double> d;  // 1/s, tangent to the sphere of directors
};

class Assembly {
 public:
  // Errors: a degenerate element (named); warp without a direction.
  explicit Assembly(const model::Model& model);
  ~Assembly();

  Index unknowns() const { return freedoms_.unknowns; }
  StateStore& state() { return *state_; }
  const StateStore& state() const { return *state_; }
  const Freedoms& freedoms() const { return freedoms_; }
  const std::vector<Vec3>& reference() const { return X_; }

  // --- configurations; trial = iterate moved by scale * delta, driven freedoms at `targets` (m, along the
  // frames).
  void begin_iterate();  // iterate = trial
  void retract(std::span<const double> delta, double scale, std::span<const double> targets);
  std::vector<double> targets(double time) const;  // values of the driven freedoms; Error when not finite

  // --- at the trial configuration. False: the law failed in some element (see failed_element).
  bool forces(fabric::AtSwitch at);  // internal forces, trial law states
  // Tangent into K (its pattern is pattern()). With `lead` (increments of the driven freedoms) also the
  // product of the coupling block with them, one number per unknown, into `product`.
  bool tangent(fabric::AtSwitch at, solver::SparseMatrix& K, std::span<const double> lead,
               std::span<double> product);
  // K_M, the law's part of the tangent at the trial configuration [williams2010, eq. 5.71]; forces stay as
  // they are. lead, product: as tangent().
  bool material_tangent(solver::SparseMatrix& K, std::span<const double> lead, std::span<double> product);
  Index failed_element() const { return failed_element_; }
  // The first element turned inside out or crushed past zero length, (a1 x a2).d <= 0 at one of its points;
  // -1.
  Index inverted_element() const;
  // Sets the time of the follower loads (pressure, moments), which forces() and tangent() count against the
  // internal ones.
  void aim(double time) { loads_->aim(time); }
  // Dead loads at a time, 3 per node, N, global.
  void external(double time, std::vector<double>& out) const;
  bool constant_loads() const { return loads_->constant(); }  // dead loads: the same at all times
  // Follower loads on x at a time, at the trial configuration, 3 per node, N, global.
  void follower(double time, std::vector<double>& out) const;
  bool symmetric_loads() const { return loads_->symmetric(); }
  double spring_energy() const;  // J, stored in springs to ground
  // r = f_ext - f_int on the unknowns, along the nodes' frames. on_d: N m, further forces on directors.
  void residual(std::span<const double> external, std::span<double> r,
                std::span<const double> on_d = {}) const;
  std::span<const double> internal_on_x() const { return force_x_; }  // 3 per node, N, global
  std::span<const double> internal_on_d() const { return force_d_; }  // 3 per node, N m
  // Residuals and forces of one kind: N, moments on directors divided by the mean edge length. The largest of
  // each; the second of the pair is the unknown that carries it, -1: none.
  std::pair<double, Index> largest_residual(std::span<const double> r) const;
  double largest_force() const;
  // The nodal force that rounding makes: 16 eps max |x| max K_ii over
  // displacements, N.
  double rounding_floor(const solver::SparseMatrix& K) const;
  // Force of the supports on one node, N, global: internal minus external along the held and driven
  // directions.
  Vec3 support_force(Index node, std::span<const double> external) const;

  // Dead loads, follower loads and the forces of supports that move, at the trial configuration (its forces
  // computed, aimed at its time).
  void working_forces(std::span<const double> dead, WorkingForces& out) const;
  // The committed state and its internal forces. Error when reading: of another model.
  void keep(Archive& archive);

  // --- strain beyond what the cards were tested to (strained.cpp), of the forces or tangent that were
  // computed last; the yarns' is the largest so far. 0: no card says what it was tested to.
  double largest_share() const;
  Strained most_strained() const;

  // --- motion (motion.cpp)
  // kg per unknown displacement, kg m^2 per unknown rotation, lumped. Rotary inertia of an element per mass:
  // what its thickness has, t^2/12 + t^2 zeta_bar^2/4, and if scaled at least what takes the step that waves
  // in the plane of the cloth allow, after the idea of [hughes1978]. Error: ties whose lumped mass is not
  // positive.
  std::vector<double> lumped_mass(bool scaled) const;
  const std::vector<double>& rotary_inertia(bool scaled) const { return rotary_[scaled]; }  // kg m^2 per node
  // Rates of the unknowns (and of the driven freedoms) to velocities of the nodes, at the trial
  // configuration.
  void spread_rates(std::span<const double> rates, std::span<const double> driven, NodalRates& out) const;
  // The other way: what the nodes' velocities give the unknowns. Tied nodes follow what they are tied to.
  std::vector<double> collect_rates(const NodalRates& nodal) const;
  // The largest stable step of central differences, s, for the reference configuration: h / c for every
  // element, c^2 the stiffest tangent over the density, and what the thickness' own rotary inertia allows
  // where it isn't scaled.
  double stable_step(bool scaled) const;
  double smallest_size() const;    // m, h of the smallest element
  double largest_stretch() const;  // of edges and diagonals, current over reference
  // Adds c_x to the diagonal of the nodes' displacements and c_d to that of their rotations, through ties.
  void add_diagonal(std::span<const double> c_x, std::span<const double> c_d, solver::SparseMatrix& K) const;

  // --- reading a state
  // Material strains and law states of one element: f(point weight m^3, law, E[5], state*).
  using PointVisitor =
      std::function<void(double weight, const fabric::Law& law, const double* E, const double* state)>;
  void visit(Index element, const PointVisitor& f) const;  // trial configuration
  // Warp and weft of an element in the trial configuration: unit vectors, global, convected with the cloth,
  // at its middle.
  std::pair<Vec3, Vec3> yarns(Index element) const;
  Vec3 centre(Index element) const;                   // m, mean of its corners in the trial configuration
  BendingEnergy bending_energy(Index element) const;  // of separate bending; zero without
  Index elements() const { return static_cast<Index>(place_.size()); }
  bool turns(Index unknown) const { return turns_[unknown]; }  // a rotation, not a displacement
  Index element_of_unknown(Index unknown) const;               // some element of the node that carries it
  Index node_of_unknown(Index unknown) const;
  const std::vector<double>& nodal_mass() const { return mass_; }  // kg, lumped
  const solver::SparseMatrix& pattern() const { return pattern_; }

 private:
  struct Batch;
  void set_kinds();
  void colour_elements();
  void add_batches(const std::vector<int>& colours, int colour, const Kind& kind);
  void add_mass(const Batch& batch, int lane);
  void make_geometry(const std::vector<Vec3>& directors);
  void make_pattern();
  void make_slots();
  void add_inertia();
  void gather(const Batch& batch, double* x, double* d, double* b) const;
  void make_force_slots();
  Index evaluate(Index batch, fabric::AtSwitch at, double* trial, double* K, bool law_only = false);
  Index element_tangents(fabric::AtSwitch at, bool law_only, solver::SparseMatrix& K,
                         std::span<const double> lead, std::span<double> product);
  void sum_forces();
  void scatter_tangent(const Batch& batch, const double* K, solver::SparseMatrix& out,
                       std::span<const double> lead, std::span<double> product);
  void scatter_with_care(const Batch& batch, int lane, const double* K, solver::SparseMatrix& out,
                         std::span<const double> lead, std::span<double> product);
  void realign(Index node, std::span<double> d, std::span<double> b1) const;
  void add_load_stiffness(solver::SparseMatrix& K, std::span<const double> lead,
                          std::span<double> product) const;
  void find_tested();
  double share_of(const Batch& batch, const double* law) const;
  double lead_of(Index motion, std::span<const double> lead) const;

  // Ties (ties.cpp). An element with a tied node is scattered after the parallel loop, in element order: what
  // it leads to is shared across colours.
  void meet_directors(std::vector<Vec3>& directors) const;
  void list_tied_elements();
  void links(Index node, std::vector<Link>& out) const;
  void add_link_pattern(std::vector<std::vector<Index>>& rows) const;
  void retract_ties(std::span<const double> delta, double scale);
  Vec3 director_force(Index node, std::span<const double> on_d) const;
  void add_tied_residual(std::span<const double> external, std::span<double> r,
                         std::span<const double> on_d) const;
  Vec3 tied_force(Index lead, std::span<const double> external) const;
  void scatter_tied(solver::SparseMatrix& K, std::span<const double> lead, std::span<double> product) const;
  void add_block(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k, solver::SparseMatrix& K,
                 std::span<const double> lead, std::span<double> product) const;
  void add_body_stiffness(solver::SparseMatrix& K) const;
  void add_entry(Index row, Index column, double value, solver::SparseMatrix& K, std::span<const double> lead,
                 std::span<double> product) const;
  Vec3 centroid(const Body& body, std::span<const double> x) const;

  const model::Model& model_;
  std::vector<Vec3> X_;
  Freedoms freedoms_;
  std::unique_ptr<StateStore> state_;
  Kind quad_, triangle_;
  std::vector<Batch> batches_;
  std::vector<Index> colour_start_;  // batches of colour c: [colour_start_[c], colour_start_[c + 1])
  std::vector<Place> place_;         // per element
  LineVector geometry_;              // per batch, contiguous
  solver::SparseMatrix pattern_;
  // Per batch and lane: slots of each column's first row of each node (4 x 20, the column first), -1: none;
  // what is added to them for the node's five rows, -1: no unknown; what a scatter must mind besides.
  enum class Care : char { none, driven, frames };
  std::vector<Index> slots_;
  std::vector<signed char> offsets_;
  std::vector<Care> care_;
  // Forces of the elements as the kernels write them, and where each node finds its own in there: the entries
  // of node n are [first_slot_[n], first_slot_[n + 1]), the first of three components `lanes` apart.
  struct ForceSlot {
    std::uint32_t on_x, on_d;
  };
  LineVector element_force_;
  std::vector<ForceSlot> force_slots_;
  std::vector<std::uint32_t> first_slot_;
  std::vector<double> iterate_;  // kinematics
  std::vector<double> force_x_, force_d_, mass_,
      mass_moment_;                  // mass kg, its first moment about the surface kg m
  std::vector<double> rotary_[2];    // kg m^2 per node: true, scaled
  std::vector<Index> driven_nodes_;  // with a displacement or a director that is driven
  std::unique_ptr<Loads> loads_;
  std::vector<Vec3> first_axes_;  // of the reference directors, for directors that are driven
  std::vector<Vec3> reference_directors_;
  std::vector<Index> node_element_, unknown_node_;
  std::vector<bool> turns_;        // per unknown: is it a rotation
  std::vector<Index> tied_place_;  // per batch and lane: place in tied_elements_ or -1; empty without ties
  std::vector<Place> tied_elements_;
  std::vector<double> tied_tangent_;                     // per tied element, 20 x 20
  std::vector<std::vector<std::pair<Index, int>>> led_;  // per node: followers it leads, and as which lead
  std::vector<double> lever_;  // per unknown: m that a rotation's moment is divided by; 1
  double length_ = 1;          // m, mean edge of the elements
  // Points through the thickness whose card says what it was tested to; per batch the largest share of that.
  struct TestedPoint {
    const fabric::Law* law;
    int state;
    std::array<double, 3> tested, inverse;  // E11, E22, E12; 1 over them, 0 where not known
  };
  std::vector<TestedPoint> tested_;
  fabric::SharesFunction shares_ = nullptr;
  std::vector<double> share_;
  Index failed_element_ = -1;
};

// Colours such that elements of one colour share no node: greedy in element order. Returns the colour of each
// element.
std::vector<int> colour(const mesh::Mesh& mesh);

}  // namespace fabricsh::assembly
