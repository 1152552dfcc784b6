#include "base/utf8.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace fabricsh {

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (length < 3) return length;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) > 0x9F;
  const bool too_large = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || too_large ? 0 : length;
}

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

// U+FFFE and U+FFFF
bool is_excluded(std::string_view character) {
  return character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
}

std::string latin_1(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return {static_cast<char>(0xC0U | byte >> 6U), static_cast<char>(0x80U | (byte & 0x3FU))};
}

}  // namespace

std::string made_plain(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto character = text.substr(0, std::max<std::size_t>(length, 1));
    if (length == 0)
      plain += latin_1(text[0]);
    else if (is_control(text[0]) || is_excluded(character))
      plain += ' ';
    else
      plain += character;
    text.remove_prefix(character.size());
  }
  return plain;
}

bool is_plain(std::string_view text) { return made_plain(text) == text; }

void want_plain(std::string_view name, const std::string& what) {
  if (is_plain(name)) return;
  std::string shown(name);
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  throw Error(what + ": expected a name in UTF-8 without control characters, got '" + shown + "'");
}

}  // namespace fabricsh
