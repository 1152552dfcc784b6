#include "mechanics/terms/inertia.hpp"

namespace fabricsh::mechanics {

void Inertia::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  out.push_back({"kinetic", Account::kinetic, trial.motion == nullptr ? 0 : trial.motion->kinetic()});
}

void MassDamping::add_energies(const Trial&, std::vector<Energy>& out) const {
  out.push_back({"mass damping", Account::damping, lost_});
}

}  // namespace fabricsh::mechanics
