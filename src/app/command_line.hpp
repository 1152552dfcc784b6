// What the command line asks for.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "script/sandbox/limits.hpp"

namespace fabricsh::app {

struct CommandLine {
  std::vector<std::pair<char, std::string>> before;  // ('e', chunk) and ('l', module), in order
  bool interactive = false;                          // -i
  bool check = false, quiet = false, version = false, help = false;
  int threads = 0;
  bool safe = false;           // --safe, and what goes with it
  std::string output;          // --output; empty: out
  script::SafeOptions limits;  // --limit-...
  std::string restart;         // path of a checkpoint; empty: none
  bool has_deck = false;
  std::string deck;  // empty with has_deck: standard input
  std::size_t deck_place = 0;
  std::vector<std::string> line;       // everything, the program's name first
  std::vector<std::string> arguments;  // behind the deck
  std::string trouble;                 // not empty: wrong use
};

CommandLine read_command_line(int count, char** words);
extern const char* const usage;

}  // namespace fabricsh::app
