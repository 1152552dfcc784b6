// The gas of volumes in the present state of a run.
#pragma once
#include "model/gas.hpp"
#include "run/readings.hpp"

namespace fabricsh::run {

struct GasReading {
  double pressure;     // Pa, above that outside
  double volume;       // m3
  double mass;         // kg
  double temperature;  // K
};
// Error: the volume is not one of the run's model.
GasReading gas_state(const Readings& run, const model::GasGiven& gas);

}  // namespace fabricsh::run
