// Sources of input lines: a terminal with editing, history and completion, or any stream.
#pragma once
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "base/version.hpp"
#include "repl/completion.hpp"

namespace fabricsh::repl {

enum class Tone { prompt, error, notice };

// no_color, term: the values of $NO_COLOR and $TERM, null if unset. See no-color.org.
bool colours_wanted(bool terminal, const char* no_color, const char* term);

class TerminalStyle {
 public:
  explicit TerminalStyle(bool colours = false) : colours_(colours) {}
  // The style for output to a file descriptor.
  static TerminalStyle of(int descriptor);
  // The text with the escape sequences of its tone; `mark` encloses each sequence (libedit needs that).
  std::string dress(Tone tone, const std::string& text, const std::string& mark = "") const;

 private:
  bool colours_;
};

class Lines {
 public:
  virtual ~Lines() = default;
  enum class InputState { line, interrupted, end };
  // Reads the next line, without its newline (one from the history may contain several lines). before: the
  // preceding lines of the same input, empty at its beginning. interrupted: Ctrl-C during typing.
  virtual InputState next(const std::string& before, std::string& line) = 0;
  // Stores a complete input as one item of the history.
  virtual void remember(const std::string&) {}
  // Shows a notice while a line is being typed, without damaging the line; false if no line is being
  // typed.
  virtual bool interject(const std::string&) { return false; }
};

// Lines of a stream, without a prompt.
std::unique_ptr<Lines> stream_lines(std::istream& in);

struct TerminalOptions {
  std::string history_file = {};  // empty: no history file
  TerminalStyle style = TerminalStyle();
  std::function<Completion(const std::string& text)> complete = {};  // text: the input up to the cursor
};

// The terminal, by libedit. Only one at a time.
std::unique_ptr<Lines> terminal_lines(TerminalOptions options);

std::vector<Library> libraries();  // Lua, libedit

}  // namespace fabricsh::repl
