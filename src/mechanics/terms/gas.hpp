// Gas in closed volumes: its pressure is uniform and follows from the volume that the faces enclose, and from
// what flows. A volume without flow has a potential, and so has its pressure; the change of the pressure with
// the volume couples all nodes of the surface, by one rank of the tangent for each volume.
#pragma once
#include <vector>

#include "base/archive.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/terms/contact_gas.hpp"
#include "mechanics/terms/faces.hpp"
#include "model/gas.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// The gas of one volume. Its temperature is p V / (m R).
struct GasState {
  double volume = 0;    // m3
  double pressure = 0;  // Pa, absolute
  double mass = 0;      // kg
  double temperature(const model::GasGiven& gas) const { return pressure * volume / (mass * gas.specific()); }
  void keep(Archive& archive) { archive(volume, pressure, mass); }
};

// kg/s through 1 m2 of a nozzle without losses [shapiro1953, ch. 4], from a gas at rest to a lower pressure.
double nozzle_flow(double ratio, double specific, double pressure, double temperature, double behind);

// J that the gas gives if it expands, or is pressed, to the pressure outside without exchange of mass: the
// integral of (p - outside) dV. Never negative.
double available_energy(const model::GasGiven& gas, const GasState& state);

class GasFlow {
 public:
  // area of each volume's cloth, m2, for leakage; those of its vents.
  struct VolumeGiven {
    model::GasPointer gas;
    double area = 0;
    std::vector<double> vents;
  };
  explicit GasFlow(std::vector<VolumeGiven> volumes);

  std::size_t size() const { return volumes_.size(); }
  const model::GasGiven& gas(std::size_t i) const { return *volumes_[i].gas; }
  bool flows() const { return flows_; }  // whether anything but the volumes changes

  struct GasStep {
    std::vector<GasState> states;
    double supplied = 0, lost = 0;  // J: work of what flows in, and what flows through vents and cloth loses
    int empty = -1;                 // the volume from which more is taken than it has
  };
  // From a state to other volumes, which change evenly from `time` on in dt. open: of each vent.
  GasStep advance(const std::vector<GasState>& from, const std::vector<char>& open,
                  std::vector<double> volumes, double time, double dt) const;
  // Opens the vents whose pressure difference has been reached.
  void open(const std::vector<GasState>& states, std::vector<char>& open) const;
  std::vector<char> begin() const;  // which vents are open at first

 private:
  struct Opening {
    std::size_t from;
    int to;        // -1: the outside
    double area;   // m2, of the jet; of leakage that of the cloth
    double opens;  // Pa
    bool leaks;
  };
  double rate(const Opening& o, const GasState& up, const model::GasGiven& gas, double behind) const;
  double passed(const Opening& o, double dt, const GasState& up, const GasState* down,
                const model::GasGiven& gas, double outside) const;
  void pass(const Opening& o, double dt, GasStep& step) const;
  void supply(std::size_t i, double mass, GasStep& step) const;
  void change_volume(std::size_t i, double volume, GasStep& step) const;
  std::vector<double> supplies(std::size_t i, int count, double time, double dt) const;
  static std::vector<double> progress(const std::vector<double>& supplies);
  int parts(const std::vector<GasState>& from, const std::vector<char>& open, double time, double dt) const;
  double available(const GasStep& step) const;

  std::vector<VolumeGiven> volumes_;
  std::vector<Opening> openings_;
  bool flows_ = false;
};

class Gas final : public Term, public FewRankTerm {
 public:
  explicit Gas(const model::Model& model);
  const char* name() const override { return "gas"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void couple(const Trial&, std::vector<NodePair>& pairs) override;
  void add_ranks(const Trial& trial, NodalRanks& out) const override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  StepWork step_work() const override { return {trial_.supplied, 0}; }
  double stable_step(bool scaled) const override;
  void commit() override;
  void rollback() override;
  void keep(Archive& archive) override;

  // Rigid bodies that close volumes are those of this term, which comes after this one.
  void press_on(GasOnBodies& bodies, const Trial& start);
  // Of the rims that lie at bodies, the node that is farthest from its place there.
  struct RimGap {
    double apart = 0;  // m, more than at the start
    Index node = -1;
    const model::Rigid* body = nullptr;
    double size = 0;  // m, of a rim's mean edge
  };
  RimGap farthest_rim(const Trial& trial) const;

  // Of a declared volume in the trial state: pressure above that outside, Pa.
  struct GasReading {
    double pressure, volume, mass, temperature;
  };
  GasReading read(const model::GasGiven& gas) const;  // Error: it is not one of the model
  bool flows() const { return flow_.flows(); }        // whether gas comes or goes
  bool pushes() const;                                // whether a pressure differs from that outside

 private:
  struct Volume {
    std::vector<FaceNodes> faces;          // outwards, of cloth and of strips along seams
    std::vector<std::vector<Index>> lids;  // rings around holes, whose force their nodes share evenly
    Vec3 apex;                             // m, from which the volume is seen, see model::planes_of_gas
    double bulge = 0;                      // m3, of bodies beyond the rings that stand for them
    double volume(std::span<const double> x) const;
    void add_pressure(double pressure, std::span<const double> x, std::span<double> on_x) const;
    void add_lid_tangent(double pressure, std::span<const double> x, TangentSink& sink) const;
  };
  // Points of the cloth, and after them those of bodies.
  void place(const Trial& trial, std::vector<double>& x) const;
  void push(const GasFlow::GasStep& step);
  bool on_bodies() const { return !rims_.empty(); }
  std::vector<const model::Rigid*> closing() const;  // each body once
  struct Rim {
    Index node, seat;  // seat: a point of a body
    const model::Rigid* body;
    double apart, edge;  // m, at the start
  };
  GasFlow::GasStep after(std::vector<double> volumes, double time) const;
  double gauge(std::size_t i, const GasFlow::GasStep& step) const;
  std::vector<double> volumes(std::span<const double> x) const;

  void add_volume(const model::Model& model, const model::GasGiven& gas, std::vector<double>& x);
  Eigen::MatrixXd core(const std::vector<double>& volumes, double time) const;
  NodalRanks all_ranks(std::span<const double> x, double time) const;

  std::vector<Volume> volumes_;
  std::size_t nodes_ = 0;
  std::vector<Rim> rims_;
  GasOnBodies* bodies_ = nullptr;
  mutable std::vector<double> x_, push_;  // m, N, of all points
  GasFlow flow_;
  std::vector<GasState> states_;  // committed
  std::vector<char> open_;        // which vents are, at the committed state
  double time_ = 0;               // s, of that state
  double lost_ = 0;               // J, through vents and cloth until then
  GasFlow::GasStep trial_;
  double aimed_ = 0;  // s, of the trial state
};

}  // namespace fabricsh::mechanics
