#include "repl/style.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace fabricsh::repl {

bool colours_wanted(bool terminal, const char* no_color, const char* term) {
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool able = term != nullptr && *term != '\0' && std::string_view(term) != "dumb";
  return terminal && !refused && able;
}

TerminalStyle TerminalStyle::of(int descriptor) {
  return TerminalStyle(colours_wanted(isatty(descriptor) != 0, std::getenv("NO_COLOR"), std::getenv("TERM")));
}

std::string TerminalStyle::dress(Tone tone, const std::string& text, const std::string& mark) const {
  if (!colours_ || text.empty()) return text;
  const char* code = tone == Tone::prompt ? "1;34" : tone == Tone::error ? "31" : "33";
  return mark + "\033[" + code + "m" + mark + text + mark + "\033[0m" + mark;
}

}  // namespace fabricsh::repl
