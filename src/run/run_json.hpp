// run.json, beside the outputs of a run: program, options, steps, energy balance, warnings.
#pragma once
#include <string>

#include "run/listener.hpp"

namespace fabricsh::run {

// Writes it when a run first begins, and where each call ends.
class RunJson final : public Listener {
 public:
  Turn turn() const override { return Turn::report; }
  void begin(Job& job) override;
  void end(Job& job, const Ending& ending) override;
};

// "fnv1a64:...", the hash by which run.json identifies files.
std::string hash_text(const std::string& bytes);

}  // namespace fabricsh::run
