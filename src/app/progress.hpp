// How far a run is, on standard error: a bar on one line of a terminal, in a log a line now and then.
#pragma once
#include <cstdio>
#include <string>

#include "script/session.hpp"

namespace fabricsh::app {

class ProgressLine {
 public:
  // terminal: the stream is one; it is redrawn at most ten times a second. In a log the first line comes
  // after 2 s, the others 10 s apart: a short run says nothing.
  ProgressLine(std::FILE* stream, bool terminal) : stream_(stream), terminal_(terminal) {}
  void show(const script::Progress& progress);
  void clear();  // takes the bar away

 private:
  double ledger(const script::Progress& progress);
  std::FILE* stream_;
  bool terminal_, drawn_ = false;
  std::int64_t run_ = 0;
  double next_ = 0;                           // s on the run's clock
  double error_ = 0, dear_ = 0, asked_ = -1;  // the ledger's; what it costs, when it was asked for, s
};

// "t = 0.32 of 1 s, step 16, 5 iterations, ledger 1.2e-06, 12 s, 26 s left"
std::string progress_text(const script::Progress& progress, double ledger_error);
// "12 s", "3 min 20 s", "2 h 05 min"
std::string duration_text(double seconds);
// "[=====>    ] ", as many characters wide; empty where there is no room.
std::string bar_text(double share, int width);

}  // namespace fabricsh::app
