// Colours of the prompt, of errors and of notices, where a terminal shows them and nobody asked for none.
#pragma once
#include <string>

namespace fabricsh::repl {

enum class Tone { prompt, error, notice };

// no_color, term: what $NO_COLOR and $TERM say, null when unset. See no-color.org.
bool colours_wanted(bool terminal, const char* no_color, const char* term);

class Style {
 public:
  explicit Style(bool colours = false) : colours_(colours) {}
  // For what is written to a file descriptor.
  static Style of(int descriptor);
  // The text between the escape sequences of its tone; `mark` before and behind each (libedit wants that).
  std::string dress(Tone tone, const std::string& text, const std::string& mark = "") const;

 private:
  bool colours_;
};

}  // namespace fabricsh::repl
