// Accounts of energy that can only rise: what damping, friction, impacts and yarns take never comes back.
#pragma once
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
  std::optional<Fall> look(const EnergyAccount& account, double time, double tolerance, double of_scheme);
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
