// The context of the cursor in Lua text: what is being typed, in which call, after which object. Uses only
// the text, not the Lua state.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "repl/lexer.hpp"

namespace fabricsh::repl {

// The steps of a path such as a.b["c"][2]:d(...).e; the first one is a global.
struct PathStep {
  std::string name;  // empty: the step is `number`
  long long number = 0;
  bool method = false;  // after a colon
  bool called = false;  // the result of calling it
};
using Path = std::vector<PathStep>;

// A bracket or block that is still open.
struct OpenBracket {
  std::string open;                // "(", "{", "[", or the keyword of a block
  std::optional<Path> callee;      // what is called by ( or {, or indexed by [; empty: not known, or nothing
  std::size_t argument = 0;        // number of commas so far
  std::string key;                 // inside {: `key =` of the entry being typed
  std::vector<std::string> given;  // inside {: the keys of all entries so far
};

struct CursorContext {
  enum class ContextKind {
    nothing,  // a comment, a number
    word,     // a name
    member,   // a name after `path.` or `path:`
    text,     // within quotes
  };
  ContextKind kind = ContextKind::nothing;
  std::size_t from = 0;                  // position where the word begins, without the quote
  std::string word = {};                 // the part typed so far
  char quote = '\0';                     // for a string
  std::optional<Path> path = {};         // for a member; empty: not known
  bool method = false;                   // after a colon
  bool behind_value = false;             // nothing typed yet, directly after a string or a closed bracket
  bool first = false;                    // the word may be the key of an entry in a table
  std::vector<OpenBracket> frames = {};  // outermost first
};

CursorContext context_at_end(std::string_view text);

}  // namespace fabricsh::repl
