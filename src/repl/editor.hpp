// Where lines come from: a terminal with editing and history, or any stream.
#pragma once
#include <istream>
#include <memory>
#include <optional>
#include <string>

namespace fabricsh::repl {

class Lines {
 public:
  virtual ~Lines() = default;
  enum class State { line, interrupted, end };
  // The next line, without its newline. interrupted: Ctrl-C while typing.
  virtual State next(const std::string& prompt, std::string& line) = 0;
  // What was run becomes one item of the history.
  virtual void remember(const std::string&) {}
};

// Plain lines, no prompt.
std::unique_ptr<Lines> stream_lines(std::istream& in);
// The terminal, by libedit; history is kept in the file between sessions (empty: not kept).
std::unique_ptr<Lines> terminal_lines(const std::string& history_file);
// $XDG_STATE_HOME/fabricsh_history, else ~/.fabricsh_history, else empty.
std::string history_file();

}  // namespace fabricsh::repl
