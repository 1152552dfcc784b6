// Colours: only on a terminal, and not where somebody asked for none.
#include "catch.hpp"
#include "repl/editor.hpp"

using namespace fabricsh::repl;

TEST_CASE("when colours are wanted") {
  CHECK(colours_wanted(true, nullptr, "xterm"));
  CHECK(colours_wanted(true, "", "xterm"));  // no-color.org: set and not empty
  CHECK_FALSE(colours_wanted(true, "1", "xterm"));
  CHECK_FALSE(colours_wanted(false, nullptr, "xterm"));
  CHECK_FALSE(colours_wanted(true, nullptr, "dumb"));
  CHECK_FALSE(colours_wanted(true, nullptr, ""));
  CHECK_FALSE(colours_wanted(true, nullptr, nullptr));
}

TEST_CASE("how a text is dressed") {
  CHECK(TerminalStyle(false).dress(Tone::error, "no") == "no");
  CHECK(TerminalStyle(true).dress(Tone::error, "no") == "\033[31mno\033[0m");
  CHECK(TerminalStyle(true).dress(Tone::notice, "") == "");
  CHECK(TerminalStyle(true).dress(Tone::prompt, ">", "\1") == "\1\033[1;34m\1>\1\033[0m\1");
}
