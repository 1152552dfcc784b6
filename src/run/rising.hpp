// Accounts of energy that can only rise: what damping, friction, impacts and yarns take never comes back.
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "run/values.hpp"

namespace fabricsh::run {

class RisingAccounts {
 public:
  struct Fall {
    std::string name;       // of the account, as decks have it
    double by = 0, to = 0;  // J, below the most that it ever was; where it is
    double since = 0;       // s, when it was that
  };
  // The account that has fallen farthest below the most that it was in earlier calls, if that is by more than
  // `tolerance` (J), or, for what the time scheme takes, `of_scheme`.
  std::optional<RisingAccounts::Fall> look(const EnergyAccount& account, double time, double tolerance,
                                           double of_scheme) {
    std::vector<EnergyPart> parts = {{"damping", account.damping}};
    for (const EnergyPart& part : account.lost) {
      const auto same =
          std::find_if(parts.begin(), parts.end(), [&](const EnergyPart& p) { return p.name == part.name; });
      same == parts.end() ? parts.push_back(part) : void(same->value += part.value);
    }
    std::optional<Fall> worst;
    for (const EnergyPart& part : parts) {
      auto known = std::find_if(highest_.begin(), highest_.end(),
                                [&](const Highest& h) { return h.name == part.name; });
      if (known == highest_.end()) known = highest_.insert(known, {part.name, part.value, time});
      // Explicit steps may go back to an earlier time.
      if (part.value >= known->value || known->time > time) *known = {part.name, part.value, time};
      const double by = known->value - part.value, most = part.name == "damping" ? of_scheme : tolerance;
      if (!(by <= most) && !(worst && by <= worst->by)) worst = Fall{part.name, by, part.value, known->time};
    }
    return worst;
  }

  void keep(Archive& archive) { archive(highest_); }

 private:
  struct Highest {
    std::string name;
    double value = 0, time = 0;  // J, s
    void keep(Archive& archive) { archive(name, value, time); }
  };
  std::vector<Highest> highest_;
};

}  // namespace fabricsh::run
