// The progress of a run on standard error: a bar on a terminal, lines at intervals in a log.
#pragma once
#include <cstdio>
#include <string>

#include "script/session/session.hpp"

namespace fabricsh::app {

class ProgressLine {
 public:
  // terminal: whether the stream is one; the bar is updated at most ten times a second. In a log the first
  // line is written after 2 s and the others at intervals of 10 s, so that a short run writes nothing.
  ProgressLine(std::FILE* stream, bool terminal) : stream_(stream), terminal_(terminal) {}
  void show(const script::RunProgress& progress);
  void clear();  // removes the bar

 private:
  double ledger(const script::RunProgress& progress);
  std::FILE* stream_;
  bool terminal_, drawn_ = false;
  std::int64_t run_ = 0;
  double next_ = 0;                           // s of the run's elapsed time
  double error_ = 0, dear_ = 0, asked_ = -1;  // of the ledger; its cost and the time of its last update, s
};

// "t = 0.32 of 1 s, step 16, 5 iterations, ledger 1.2e-06, 12 s, 26 s left"
std::string progress_text(const script::RunProgress& progress, double ledger_error);
// "12 s", "3 min 20 s", "2 h 05 min"
std::string duration_text(double seconds);
// "[=====>    ] ", with this number of characters; empty if there is no room.
std::string bar_text(double fraction, int width);

}  // namespace fabricsh::app
