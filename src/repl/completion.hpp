// What can be meant by the word before the cursor. Never runs code of the user's: script/peek.hpp.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "script/session.hpp"

namespace fabricsh::repl {

struct Completion {
  std::size_t from = 0;                      // where in the text the word begins
  std::vector<std::string> candidates = {};  // whole words that may stand there, sorted
  std::string common = {};  // what they all begin with; of a single one, a closing quote with it
};

// text: the input up to the cursor, earlier lines and all.
Completion complete(script::Session& session, std::string_view text);

// Names in the folder that a path begins with ("out/dr" -> "out/drape.csv"), folders with a slash behind.
std::vector<std::string> files_like(const std::string& path);

// Words in columns, read downwards, lines no wider than `width`; of a path its last part. At most `most`
// words, then how many more there are.
std::string in_columns(const std::vector<std::string>& words, std::size_t width, std::size_t most = 200);

}  // namespace fabricsh::repl
