// Completion of the word before the cursor. Never runs code of the user: script/peek.hpp.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "script/session/session.hpp"

namespace fabricsh::repl {

struct Completion {
  std::size_t from = 0;                      // position in the text where the word begins
  std::vector<std::string> candidates = {};  // possible whole words, sorted
  std::string common = {};  // their common beginning; for a single one, with the closing quote
};

// text: the input up to the cursor, including earlier lines.
Completion complete(script::Session& session, std::string_view text);

// File names that begin with a path ("out/dr" -> "out/drape.csv"); folders end with a slash.
std::vector<std::string> files_like(const std::string& path);

// Words in columns, to be read downwards, with lines of at most `width` characters; of a path only the last
// part. At most `most` words, followed by the number of the others.
std::string in_columns(const std::vector<std::string>& words, std::size_t width, std::size_t most = 200);

}  // namespace fabricsh::repl
