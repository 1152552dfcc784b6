// The cloth: shell elements in batches of eight, with the states of their laws. The forces have the same bits
// for any number of threads: each batch writes into its own slots, and each node adds up the slots of its
// elements in a fixed order. For tangents the batches are coloured such that those of one colour share no
// node, and the colours are computed one after another.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "law/peaks.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/element_rates.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/geometry_store.hpp"
#include "mechanics/joints.hpp"
#include "mechanics/law_states.hpp"
#include "mechanics/rest_shape.hpp"
#include "model/model.hpp"
#include "simd/aligned.hpp"

namespace fabricsh::mechanics {

// The point with the largest strain relative to the range in which its card was tested.
struct Strained {
  double strain_ratio = 0;  // strain over tested strain: 1.2 is 20 % beyond
  double strain = 0;        // E11, E22 or |E12| (tensor)
  double tested = 0;        // the strain up to which the card was tested
  int yarn = 0;             // 0 warp, 1 weft, 2 shear
  Index element = -1;
};

struct BendingEnergy {
  double stored = 0, lost = 0;  // J
};

class Cloth final : public Term, public ElementTerm {
 public:
  // Errors: a degenerate element (named); warp without a direction; an element that its law cannot bear (see
  // law::set_initial). directors: of the nodes, unit.
  Cloth(const model::Model& model, const Configuration& configuration, const std::vector<Vec3>& directors);
  ~Cloth() override;
  // Forces are computed from the positions of the leaders of joints, where the model has any: their other
  // nodes, up to three quarters of all, need not be read. Keeps a reference.
  void read_leaders_of(const Joints& joints);
  void renumbered(Forces&) override { find_sources(); }

  const char* name() const override { return "cloth"; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  // Updates the law's states in place (see LawStates): for runs that compute the forces once in a step.
  void update_in_place();
  bool symmetric() const override;
  bool is_rate_dependent() const;  // whether the law of any card depends on time
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  double stable_step(bool scaled) const override;
  // s: the time in which waves in the plane cross the smallest height of an element. The default stiffness of
  // contact follows it also where the stable step is longer, so that a rim of small elements is pressed no
  // deeper.
  double step_across_heights() const;
  void expect_energies(bool expected) override { sums_expected_ = expected; }
  void commit() override;
  void rollback() override { states_.rollback(); }
  // Of yarns and shear in the tangents from here on, and the forces with them: their own; or each keeps to
  // the line of the branch that it had in the last such tangent, and leaves it for the neighbouring one alone
  // (law/branches.hpp). anew: there was none.
  enum class Branches { own, anew, kept };
  void take_branches(Branches which);
  void keep(Archive& archive) override { states_.keep(archive); }

  Outcome scatter_tangents(const law::Step& step, bool law_only, Stiffness& stiffness,
                           const Stiffness::Target& to, std::span<const double> before) override;
  void sum_forces(Forces& forces) const override;

  // Lumped mass per node, kg; and its first moment about the reference surface, kg m.
  const std::vector<double>& mass() const override { return mass_; }
  const std::vector<double>& mass_moment() const { return mass_moment_; }
  // kg m^2 per node. The rotary inertia per mass of an element is t^2/12 + t^2 zeta_bar^2/4; if scaled, it is
  // at least so large that it permits the stable step of the waves in the plane of the cloth, after the idea
  // of [hughes1978].
  const std::vector<double>& rotary_inertia(bool scaled) const override { return bounds(scaled).rotary; }
  // 1/s^2, per element: an upper bound of the squares of its frequencies in the reference configuration
  // (element_rates.hpp), with true or scaled rotary inertia.
  const std::vector<double>& highest_rates(bool scaled) const { return bounds(scaled).rates; }
  // 1/s^2, per node: the mean of `rates` over its elements, weighted by their masses or by their rotary
  // inertia, whichever is more. If no frequency squared of an element is above its rate, none of the cloth is
  // above the largest of these.
  std::vector<double> rates_at_nodes(std::span<const double> rates, bool scaled) const;
  // The factor by which stretching has raised that bound: s^2 for the law's part, and (s^2 - 1) / 2 for
  // that of the stresses, which are at most the strain times the stiffest modulus; s: the largest stretch.
  double growth(Index element) const;
  double smallest_size() const { return smallest_size_; }  // m, h of the smallest element
  // N/m, along warp and weft: the most that the cloth of an element carries if it folds within the element
  // (cloth_folds.cpp); 0 for a membrane, which has no rigidity.
  std::array<double, 2> fold_tensions(Index element) const;
  double largest_stretch() const;  // of edges and diagonals, current over reference length

  // rad: the largest turn on a way of the nodes, of a director, or of an edge: the difference of its ends
  // over its reference length.
  double largest_turn(const NodalRates& way) const;

  // --- strain beyond the tested range of the cards (cloth_strained.cpp), at the last forces or tangent. For
  // yarns it is the largest strain so far. 0: no card states its tested range.
  double largest_strain_ratio() const;
  Strained most_strained() const;
  double strain_ratio(Index element) const;  // of one element; 0: its card does not state a tested range

  // --- reading
  Index elements() const { return static_cast<Index>(place_.size()); }
  const RestShape& rest() const { return rest_; }
  const std::vector<std::array<Index, 4>>& mesh_elements() const { return model_.mesh().elements; }
  std::span<const Batch> batches() const override { return batches_; }
  std::span<const BatchLane> places() const override { return place_; }
  // Material strains and law states of one element: f(point weight in m^3, law, E[5], state*). In-plane point
  // by in-plane point, and for each through the thickness in the order of the section's points.
  using PointVisitor =
      std::function<void(double weight, const law::Law& law, const double* E, const double* state)>;
  void visit(Index element, const PointVisitor& f) const;  // trial configuration
  // Directions of warp and weft in the trial configuration, means over the element (cloth_yarns.cpp): unit
  // vectors, global, convected with the cloth. ply: from 0; all_plies: in the axes that they have in common.
  static constexpr int all_plies = -1;
  std::pair<Vec3, Vec3> yarns(Index element, int ply = all_plies) const;
  Vec3 centre(Index element) const;                   // m, mean of its corners in the trial configuration
  BendingEnergy bending_energy(Index element) const;  // of separate bending; zero without
  // The first element that is inverted or of zero area, (a1 x a2).d <= 0 at one of its points, among those
  // without any of the given nodes (ascending); -1: none.
  Index inverted_element(std::span<const Index> but_for) const;
  // For each batch the lanes, by bits, whose elements bend or lean so far that the guard of the directors
  // must look at them; see Shell4Astray. watch_directors() sets the limits, one of the bend (m^2) for each
  // batch.
  void watch_directors(double cosine, std::vector<double> bent);
  std::span<const unsigned char> astray();                            // trial configuration
  Index element_at(Index node) const { return node_element_[node]; }  // any element of a node, -1: none

 private:
  void set_kinds();  // before the batches, which refer to them
  void set_initial_states();
  // Unit vectors along warp and weft in the reference, and the corners, of an element.
  struct Corners {
    Vec3 at[4], axes[2];
    int count;
    double area;  // m^2
  };
  Corners corners_of(Index element) const;
  law::Site site_of(Index element) const;  // of a section's points, but for strength and thickness
  std::vector<std::array<double, 2>> strengths_of_elements() const;
  void make_batches();
  void add_batches(const std::vector<int>& colours, int colour, bool triangles, int region);
  void make_geometry();
  void put_geometry(const Batch& batch, double* geometry) const;
  void add_mass(const Batch& batch, int lane);
  double plane_rate_of(Index element, const Stiffest& stiffest, double speed) const;
  double membrane_step() const;
  std::vector<double> corner_masses() const;
  std::vector<double> means_at_nodes(std::span<const double> rates, std::span<const double> weights) const;
  double inertia_per_mass(const section::Section& section, bool scaled) const;
  // The rotary inertia of the nodes and the bounds of the elements' frequencies, computed when first used.
  struct FrequencyBounds {
    bool made = false;
    std::vector<double> rates, rotary;
    std::vector<double> masses, inertias;  // of each corner of an element, kg, kg m^2; empty: as the masses
  };
  const FrequencyBounds& bounds(bool scaled) const;
  struct ElementBound {
    double rate, inertia_per_mass;  // 1/s^2, m^2
  };
  std::array<ElementBound, lanes> bounds_of(const Batch& batch, const Stiffest& stiffest, bool scaled,
                                            double permitted) const;
  ElementBound bound_of(const ElementMatrix& stiffness, Index element, bool scaled, double permitted) const;
  double corner_mass(Index element) const;  // kg
  void make_force_slots();
  void order_batches();
  void order_sums();
  Index evaluate_and_sum(const law::Step& step, double* aside, Forces& forces);
  void sum_node(Index node, Forces& forces) const;
  void find_sources();
  void fetch(const Batch& batch, const double* trial) const;
  void fetch_nodes(const Batch& batch) const;
  void gather(const Batch& batch, double* x, double* d, double* b) const;
  void gather(const Batch& batch, std::span<const double> from, double* to) const;
  // Energies (J) of the elements of one batch at x, d with the law's states: stored, dissipated by name,
  // created, as law::BatchEnergy; entry i of lane l at [i * lanes + l].
  void batch_energies(const Batch& batch, const double* x, const double* d, const double* law,
                      double* sum) const;
  std::vector<double> all_batch_energies() const;
  Outcome outcome(Index failed);  // for the element that failed, -1: none
  // A tangent that is asked for beside the forces; K null: none. law_only: B^T C B alone. wanted: see
  // ShellBatch.
  struct TangentOf {
    double* K = nullptr;
    bool law_only = false;
    bool known = false;  // the trial states are those of the last forces
    unsigned wanted = 0xffff;
    std::span<const double> before = {};  // positions, directors and frames before the step; see ShellBatch
  };
  Index evaluate(Index batch, const law::Step& step, double* trial, const TangentOf& tangent);

  // A point through the thickness whose card states a tested range.
  struct TestedPoint {
    const law::Law* law;
    int state;
    std::array<double, 3> tested, inverse;  // E11, E22, E12; 1 over them, 0 if not known
  };
  void find_tested();
  const std::vector<TestedPoint>& tested(const Batch& batch) const;
  double strain_ratio_of(const Batch& batch, const double* states) const;  // states: of this batch
  void look_for_astray(Index batch, const double* x, const double* d);
  Strained most_strained_of(const Batch& batch, int first_lane, int last_lane) const;

  const model::Model& model_;
  const Configuration& configuration_;
  const std::vector<Vec3>& X_;  // of the mesh
  const RestShape rest_;
  std::vector<BatchKind> kinds_;  // per region: quadrilaterals, triangles
  std::vector<Batch> batches_;
  const Joints* joints_ = nullptr;
  std::vector<std::array<std::array<Index, 4>, lanes>> sources_;  // leaders of each batch's nodes; or empty
  std::vector<Index> colour_start_;  // the batches of colour c are [colour_start_[c], colour_start_[c + 1])
  std::vector<Index> order_;         // in which the forces of the batches are computed
  std::vector<BatchLane> place_;     // per element
  GeometryStore geometry_;
  LawStates states_;
  LineVector branches_;  // of warp, weft and shear, at the places of the first numbers of a law's state
  bool keeps_branches_ = false;
  std::size_t most_states_ = 0;  // numbers of a batch
  // The configuration and step of the last forces, whose trial states are stored; version 0: none.
  struct Evaluated {
    std::uint64_t version = 0;
    law::Step step;
  } evaluated_;
  // The forces of the elements as the kernels write them, and the location of each node's forces therein: the
  // entries of node n are [first_slot_[n], first_slot_[n + 1]), and its three components are `lanes` apart.
  struct ForceSlot {
    std::uint32_t on_x, on_d;
  };
  LineVector element_force_;
  std::vector<ForceSlot> force_slots_;
  std::vector<std::uint32_t> first_slot_;
  // The nodes whose last batch is at place i of order_ are finished_[first_finished_[i]] and the following
  // ones, up to those of place i + 1. begun_: per node the place of its first batch.
  std::vector<std::uint32_t> finished_, first_finished_, begun_;
  std::vector<double> mass_, mass_moment_;
  mutable FrequencyBounds bounds_[2];  // with true and with scaled rotary inertia
  double smallest_size_ = 0;           // m
  double step_of_membrane_ = 0;        // s
  std::vector<Index> node_element_;
  std::vector<std::vector<TestedPoint>> tested_;  // per region
  law::StrainRatioFunction strain_ratio_at_ = nullptr;
  // Energies of the batches, as from batch_energies(), summed together with the forces if they are expected.
  // They belong to the configuration with this version.
  bool sums_expected_ = false;
  std::vector<double> sums_;
  std::uint64_t sums_version_ = 0;
  double least_cosine_ = 0;
  std::vector<double> most_bent_;  // per batch; empty: directors are not watched
  std::vector<unsigned char> astray_;
  std::uint64_t astray_version_ = 0;  // the configuration of astray_
  std::vector<double> strain_ratio_;  // per batch the largest; empty: no card states a tested range
};

}  // namespace fabricsh::mechanics
