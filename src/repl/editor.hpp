// Where lines come from: a terminal with editing, history and completion, or any stream.
#pragma once
#include <functional>
#include <istream>
#include <memory>
#include <string>

#include "repl/completion.hpp"
#include "repl/style.hpp"

namespace fabricsh::repl {

class Lines {
 public:
  virtual ~Lines() = default;
  enum class State { line, interrupted, end };
  // The next line, without its newline (one taken from the history may hold several). before: what the input
  // has so far, empty at its beginning. interrupted: Ctrl-C while typing.
  virtual State next(const std::string& before, std::string& line) = 0;
  // What is run becomes one item of the history.
  virtual void remember(const std::string&) {}
  // Takes a notice while a line is being typed, and shows it without spoiling the line; false at any other
  // time.
  virtual bool interject(const std::string&) { return false; }
};

// Plain lines, no prompt.
std::unique_ptr<Lines> stream_lines(std::istream& in);

struct TerminalOptions {
  std::string history_file = {};  // empty: not kept
  Style style = Style();
  std::function<Completion(const std::string& text)> complete = {};  // text: the input up to the cursor
};

// The terminal, by libedit. One at a time.
std::unique_ptr<Lines> terminal_lines(TerminalOptions options);

}  // namespace fabricsh::repl
