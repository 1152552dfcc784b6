#include "run/rising.hpp"

#include <algorithm>

namespace fabricsh::run {

std::optional<RisingAccounts::Fall> RisingAccounts::look(const EnergyAccount& account, double time,
                                                         double tolerance, double of_scheme) {
  std::vector<EnergyPart> parts = {{"damping", account.damping}};
  for (const EnergyPart& part : account.lost) {
    const auto same =
        std::find_if(parts.begin(), parts.end(), [&](const EnergyPart& p) { return p.name == part.name; });
    same == parts.end() ? parts.push_back(part) : void(same->value += part.value);
  }
  std::optional<Fall> worst;
  for (const EnergyPart& part : parts) {
    auto known =
        std::find_if(highest_.begin(), highest_.end(), [&](const Highest& h) { return h.name == part.name; });
    if (known == highest_.end()) known = highest_.insert(known, {part.name, part.value, time});
    // Explicit steps may go back to an earlier time.
    if (part.value >= known->value || known->time > time) *known = {part.name, part.value, time};
    const double by = known->value - part.value, most = part.name == "damping" ? of_scheme : tolerance;
    if (!(by <= most) && !(worst && by <= worst->by)) worst = Fall{part.name, by, part.value, known->time};
  }
  return worst;
}

}  // namespace fabricsh::run
