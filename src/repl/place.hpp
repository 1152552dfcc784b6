// Where in Lua text a cursor stands: what is being typed there, in which call, behind which object. Text
// alone, no Lua.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "repl/lexer.hpp"

namespace fabricsh::repl {

// a.b["c"][2]:d(...).e as its steps; the first is a global.
struct Step {
  std::string name;  // empty: number
  long long number = 0;
  bool method = false;  // behind a colon
  bool called = false;  // what it returns is meant
};
using Path = std::vector<Step>;

// An opened bracket that the text has not closed.
struct Frame {
  std::string open;                // "(", "{", "[", or the keyword of a block
  std::optional<Path> callee;      // what is called by ( or {, or indexed by [; none: not known, or nothing
  std::size_t argument = 0;        // commas so far
  std::string key;                 // inside {: `key =` of the entry that is being typed
  std::vector<std::string> given;  // inside {: keys of all entries so far
};

struct Place {
  enum class Kind {
    nothing,  // a comment, a number
    word,     // a name
    member,   // a name behind `path.` or `path:`
    text,     // between quotes
  };
  Kind kind = Kind::nothing;
  std::size_t from = 0;            // where the word begins, the quote not included
  std::string word = {};           // typed so far
  char quote = '\0';               // of a text
  std::optional<Path> path = {};   // of a member; none: can't be known
  bool method = false;             // behind a colon
  bool behind_value = false;       // nothing typed, right behind a text or a closed bracket
  bool first = false;              // a word that may be the key of a table's entry
  std::vector<Frame> frames = {};  // outermost first
};

Place place_at_end(std::string_view text);

}  // namespace fabricsh::repl
