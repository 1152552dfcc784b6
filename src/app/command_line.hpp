// The parsed command line.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "script/session/session.hpp"

namespace fabricsh::app {

struct CommandLine {
  std::vector<std::pair<char, std::string>> before;  // ('e', chunk) and ('l', module), in order
  bool interactive = false;                          // -i
  bool check = false, quiet = false, strict = false, version = false, help = false;
  script::StudyOptions study;  // --cases, --case
  int threads = 0;
  bool safe = false;           // --safe, and its further options
  std::string output;          // --output; empty: out
  script::SafeOptions limits;  // --limit-...
  std::string restart;         // path of a checkpoint; empty: none
  bool has_deck = false;
  std::string deck;  // empty while has_deck is true: standard input
  std::size_t deck_place = 0;
  std::vector<std::string> line;       // all words, the program's name first
  std::vector<std::string> arguments;  // after the deck
  std::string error;                   // not empty: a usage error
};

CommandLine read_command_line(int count, char** words);
extern const char* const usage;

}  // namespace fabricsh::app
