// The cloth itself: shell elements in batches of eight, with what their law remembers. Its forces are the
// same bits for any number of threads: each batch writes into slots of its own, and each node sums its
// elements' slots in their order. Tangents: batches are in colours that share no node, and colours follow one
// another.
#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "law/peaks.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/law_states.hpp"
#include "mechanics/stiffness.hpp"
#include "mechanics/term.hpp"
#include "model/model.hpp"
#include "simd/aligned.hpp"

namespace fabricsh::mechanics {

// The point that is farthest beyond what its card was tested to.
struct Strained {
  double share = 0;   // of the tested strain: 1.2 is 20 % beyond it
  double strain = 0;  // E11, E22 or |E12| (tensor)
  double tested = 0;  // the strain that the card was tested to
  int yarn = 0;       // 0 warp, 1 weft, 2 shear
  Index element = -1;
};

struct BendingEnergy {
  double stored = 0, lost = 0;  // J
};

class Cloth final : public Term {
 public:
  // Errors: a degenerate element (named); warp without a direction. directors: of the nodes, unit.
  Cloth(const model::Model& model, const Configuration& configuration, const std::vector<Vec3>& directors);
  ~Cloth() override;

  const char* name() const override { return "cloth"; }
  bool starts() const override { return true; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  bool symmetric() const override;
  bool hangs_on_time() const;  // has some card a law that does
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  double stable_step(bool scaled) const override;
  void expect_energies(bool expected) override { sums_expected_ = expected; }
  void commit() override;
  void rollback() override { states_.rollback(); }
  void keep(Archive& archive) override { states_.keep(archive); }

  // The elements' tangents into their slots; forces too. law_only: K_M, the law's part alone
  // [williams2010, eq. 5.71].
  Outcome scatter_tangents(const law::Step& step, bool law_only, Stiffness& stiffness,
                           const Stiffness::Target& to);
  void sum_forces(Forces& forces) const;  // of the last evaluation

  // kg per node, lumped; kg m, its first moment about the reference surface.
  const std::vector<double>& mass() const { return mass_; }
  const std::vector<double>& mass_moment() const { return mass_moment_; }
  // kg m^2 per node. Rotary inertia of an element per mass: what its thickness has, t^2/12 + t^2
  // zeta_bar^2/4, and if scaled at least what takes the step that waves in the
  // plane of the cloth allow, after the idea of [hughes1978].
  const std::vector<double>& rotary_inertia(bool scaled) const { return rotary_[scaled]; }
  double smallest_size() const;    // m, h of the smallest element
  double largest_stretch() const;  // of edges and diagonals, current over reference

  // --- strain beyond what the cards were tested to (cloth_strained.cpp), of the forces or tangent that were
  // computed last; the yarns' is the largest so far. 0: no card says what it was tested to.
  double largest_share() const;
  Strained most_strained() const;
  double share(Index element) const;  // of one element; 0: its card does not say

  // --- reading
  Index elements() const { return static_cast<Index>(place_.size()); }
  std::span<const Batch> batches() const { return batches_; }
  std::span<const Place> places() const { return place_; }
  // Material strains and law states of one element: f(point weight m^3, law, E[5], state*).
  using PointVisitor =
      std::function<void(double weight, const law::Law& law, const double* E, const double* state)>;
  void visit(Index element, const PointVisitor& f) const;  // trial configuration
  // Warp and weft of an element in the trial configuration: unit vectors, global, convected with the cloth,
  // at its middle.
  std::pair<Vec3, Vec3> yarns(Index element) const;
  Vec3 centre(Index element) const;                   // m, mean of its corners in the trial configuration
  BendingEnergy bending_energy(Index element) const;  // of separate bending; zero without
  // The first element turned inside out or crushed past zero length, (a1 x a2).d <= 0 at one of its points;
  // -1.
  Index inverted_element() const;
  Index element_at(Index node) const { return node_element_[node]; }  // some element of a node, -1: none

 private:
  void set_kinds();  // before the batches, which point to them
  void make_batches();
  void add_batches(const std::vector<int>& colours, int colour, bool triangles, int region);
  void make_geometry(const std::vector<Vec3>& directors);
  void add_mass(const Batch& batch, int lane);
  void add_inertia();
  double membrane_step() const;
  double inertia_per_mass(const section::Section& section, bool scaled) const;
  void make_force_slots();
  void gather(const Batch& batch, double* x, double* d, double* b) const;
  // J of the elements of one batch at x, d with the law's states: stored, dissipated in warp, weft and shear,
  // created, as law::BatchEnergy; entry i of lane l at [i * lanes + l].
  void batch_energies(const Batch& batch, const double* x, const double* d, const double* law,
                      double* sum) const;
  std::vector<double> all_batch_energies() const;
  Outcome outcome(Index failed) const;  // of the element that failed, -1: none
  Index evaluate(Index batch, const law::Step& step, double* trial, double* K, bool law_only = false);

  // Points through the thickness whose card says what it was tested to.
  struct TestedPoint {
    const law::Law* law;
    int state;
    std::array<double, 3> tested, inverse;  // E11, E22, E12; 1 over them, 0 where not known
  };
  void find_tested();
  const std::vector<TestedPoint>& tested(const Batch& batch) const;
  double share_of(const Batch& batch, const double* law) const;
  Strained most_strained_of(const Batch& batch, int first_lane, int last_lane) const;

  const model::Model& model_;
  const Configuration& configuration_;
  const std::vector<Vec3>& X_;
  std::vector<Kind> kinds_;  // per region: four corners, three corners
  std::vector<Batch> batches_;
  std::vector<Index> colour_start_;  // batches of colour c: [colour_start_[c], colour_start_[c + 1])
  std::vector<Place> place_;         // per element
  LineVector geometry_;              // per batch, contiguous
  LawStates states_;
  // Forces of the elements as the kernels write them, and where each node finds its own in there: the entries
  // of node n are [first_slot_[n], first_slot_[n + 1]), the first of three components `lanes` apart.
  struct ForceSlot {
    std::uint32_t on_x, on_d;
  };
  LineVector element_force_;
  std::vector<ForceSlot> force_slots_;
  std::vector<std::uint32_t> first_slot_;
  std::vector<double> mass_, mass_moment_;
  std::vector<double> rotary_[2];  // kg m^2 per node: true, scaled
  double step_of_membrane_ = 0;    // s
  std::vector<Index> node_element_;
  std::vector<std::vector<TestedPoint>> tested_;  // per region
  law::SharesFunction shares_ = nullptr;
  // Energies of the batches as batch_energies() gives them, summed with the forces where they are expected;
  // they are those of the configuration with this version.
  bool sums_expected_ = false;
  std::vector<double> sums_;
  std::uint64_t sums_version_ = 0;
  std::vector<double> share_;  // per batch the largest share; empty: no card says what it was tested to
};

}  // namespace fabricsh::mechanics
