// Text that every file format can hold.
#pragma once
#include <string>
#include <string_view>

namespace fabricsh {

// Length of the UTF-8 sequence at the start of a text that is not empty; 0: invalid (truncated, overlong,
// surrogate, too large).
std::size_t utf8_length(std::string_view text);

// Whether the text is valid UTF-8 without control characters (tabs and line ends among them) and without the
// two characters that XML excludes.
bool is_plain(std::string_view text);

// The text as plain text: control characters become blanks, bytes that are no UTF-8 are taken for Latin-1.
std::string made_plain(std::string_view text);

// Error "what: expected a name without control characters, in UTF-8, got 'a?b'" unless it is plain.
void want_plain(std::string_view name, const std::string& what);

}  // namespace fabricsh
