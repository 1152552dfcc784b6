// Colours of the prompt, of errors and of notices, if the terminal has them and the user wants them.
#pragma once
#include <string>

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

}  // namespace fabricsh::repl
