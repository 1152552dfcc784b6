// What gas in volumes does in a step: volumes change, gas flows in, out and between them.
#pragma once
#include <vector>

#include "base/archive.hpp"
#include "model/gas.hpp"

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

}  // namespace fabricsh::mechanics
