#include "run/gas.hpp"

#include "base/error.hpp"
#include "mechanics/terms/gas.hpp"

namespace fabricsh::run {

GasReading gas_state(const Readings& run, const model::GasGiven& gas) {
  const auto* const term = run.assembly().terms().find<mechanics::Gas>();
  if (term == nullptr)
    throw Error("gas: the model of this run has no gas volume: expected one declared with m:gas");
  const auto now = term->read(gas);
  return {now.pressure, now.volume, now.mass, now.temperature};
}

}  // namespace fabricsh::run
