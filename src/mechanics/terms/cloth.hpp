// The cloth: shell elements in batches of eight, with the states of their laws. The forces have the same bits
// for any number of threads: each batch writes into its own slots, and each node adds up the slots of its
// elements in a fixed order. For tangents the batches are coloured such that those of one colour share no
// node, and the colours are computed one after another.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mechanics/batch.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/geometry_store.hpp"
#include "mechanics/joints.hpp"
#include "mechanics/law_states.hpp"
#include "mechanics/rest_shape.hpp"
#include "mechanics/terms/cloth_rates.hpp"
#include "mechanics/terms/cloth_readings.hpp"
#include "model/model.hpp"
#include "simd/aligned.hpp"

namespace fabricsh::mechanics {

class Cloth final : public Term, public ElementTerm {
 public:
  // Errors: a degenerate element (named); warp without a direction; an element that its law cannot bear (see
  // law::set_initial). directors: of the nodes, unit.
  Cloth(const model::Model& model, const Configuration& configuration, const std::vector<Vec3>& directors);
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
  double stable_step(bool scaled) const override { return rates_->stable_step(scaled); }
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
  void scale_mass(bool keep) override;
  const std::vector<double>& mass_moment() const { return mass_moment_; }
  const std::vector<double>& rotary_inertia(bool scaled) const override {
    return rates_->rotary_inertia(scaled);
  }
  const ClothRates& rates() const { return *rates_; }
  const StrainsReached& strains() const { return *strains_; }
  ClothReadings readings() const { return ClothReadings(*this); }

  // --- reading
  Index elements() const { return static_cast<Index>(place_.size()); }
  const RestShape& rest() const { return rest_; }
  std::span<const Batch> batches() const override { return batches_; }
  std::span<const BatchLane> places() const override { return place_; }
  const model::Model& model() const { return model_; }
  const Configuration& configuration() const { return configuration_; }
  const LawStates& states() const { return states_; }
  // The positions and directors of a batch's corners in the trial configuration, and their axes; null: not
  // wanted.
  void gather(const Batch& batch, double* x, double* d, double* b) const;
  // For each batch the lanes, by bits, whose elements bend or lean so far that the guard of the directors
  // must look at them; see Shell4Astray. watch_directors() sets the limits, one of the bend (m^2) for each
  // batch.
  void watch_directors(double cosine, std::vector<double> bent);
  std::span<const unsigned char> astray();                            // trial configuration
  Index element_at(Index node) const { return node_element_[node]; }  // any element of a node, -1: none

 private:
  void set_kinds();  // before the batches, which refer to them
  void set_initial_states();
  law::Site site_of(Index element) const;  // of a section's points, but for strength and thickness
  std::vector<std::array<double, 2>> strengths_of_elements() const;
  void make_batches();
  void add_batches(const std::vector<int>& colours, int colour, bool triangles, int region);
  void make_geometry();
  void put_geometry(const Batch& batch, double* geometry) const;
  void add_mass(const Batch& batch, int lane);
  void make_force_slots();
  void order_batches();
  void order_sums();
  Index evaluate_and_sum(const law::Step& step, double* aside, Forces& forces);
  void sum_node(Index node, Forces& forces) const;
  void find_sources();
  void fetch(const Batch& batch, const double* trial) const;
  void fetch_nodes(const Batch& batch) const;
  void gather(const Batch& batch, std::span<const double> from, double* to) const;
  struct BendingEnergy {
    double stored = 0, lost = 0;  // J
  };
  BendingEnergy bending_energy(Index element) const;  // of separate bending; zero without
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

  void look_for_astray(Index batch, const double* x, const double* d);

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
  std::vector<Index> node_element_;
  std::optional<ClothRates> rates_;  // of the batches, when they are made
  std::optional<StrainsReached> strains_;
  // Energies of the batches, as from batch_energies(), summed together with the forces if they are expected.
  // They belong to the configuration with this version.
  bool sums_expected_ = false;
  std::vector<double> sums_;
  std::uint64_t sums_version_ = 0;
  double least_cosine_ = 0;
  std::vector<double> most_bent_;  // per batch; empty: directors are not watched
  std::vector<unsigned char> astray_;
  std::uint64_t astray_version_ = 0;  // the configuration of astray_
};

}  // namespace fabricsh::mechanics
