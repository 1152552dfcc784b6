// The warnings of a session, for the results of virtual tests and studies.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "run/warnings.hpp"

namespace fabricsh::script {

class WarningLog {
 public:
  using Warnings = std::vector<run::Warning>;

  // A place in the log.
  struct LogPosition {
    std::size_t lists = 0, runs = 0;
  };
  LogPosition end() {
    last_place_ = lists_.size();
    return {lists_.size(), runs_};
  }

  // A warning that is given in a loop is added once behind each place that was asked for.
  void add(run::Warning warning);
  // Of a run: the list as it will be when it is read.
  void add(std::shared_ptr<const Warnings> of_run);
  // Warnings added from the place on, equal ones once; whether that includes a run.
  Warnings since(LogPosition place) const;
  bool ran_since(LogPosition place) const { return runs_ > place.runs; }

  // From now on nothing is shown any more, only logged: for a copy of the program whose warnings are
  // evaluated by the process that made it.
  void stop_showing() { shows_ = false; }
  bool shows() const { return shows_; }

  // The same as bytes, for the log of another process.
  std::string packed_since(LogPosition place) const;
  void adopt(const std::string& packed);

 private:
  std::vector<std::shared_ptr<const Warnings>> lists_;
  std::size_t runs_ = 0, last_place_ = 0;
  bool shows_ = true;
};

}  // namespace fabricsh::script
