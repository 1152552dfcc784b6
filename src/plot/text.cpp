#include "plot/text.hpp"

#include <algorithm>
#include <string_view>

namespace fabricsh::plot {

namespace {

// Length of the UTF-8 character at `at`; 0: invalid UTF-8, or a character that XML does not allow.
std::size_t character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned char>(i < text.size() ? text[i] : '\0');
  };
  const unsigned first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4) return 0;
  unsigned code = first & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(at + i) & 0x3fU);
  }
  const bool too_long = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool no_character = (code >= 0xd800 && code < 0xe000) || code > 0x10ffff || (code & 0xfffe) == 0xfffe;
  return too_long || no_character ? 0 : length;
}

// Width of a character as a fraction of the font size.
double width_of(std::string_view one) {
  if (one.size() >= 3) return one < "\xe2\xba\x80" ? 0.85 : 1.0;  // signs; Chinese, Japanese and Korean
  if (one.size() == 2) return 0.65;
  const char c = one[0];
  if (std::string_view("ijlI.,:;'|! ()[]ft/\\\"").find(c) != std::string_view::npos) return 0.38;
  if (std::string_view("mwMW@%+=<>").find(c) != std::string_view::npos) return 0.92;
  return c >= 'A' && c <= 'Z' ? 0.72 : 0.62;
}

}  // namespace

// Only a single quote itself must be doubled, but some releases of gnuplot fail if a text begins with
// one; so it is appended between double quotes instead.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    if (length == 0)
      out += "\xef\xbf\xbd";
    else if (byte < 32 || byte == 127)
      out += ' ';
    else
      out += byte == '\'' ? R"('."'".')" : text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return out + "'";
}

double text_width(const std::string& text, double size) {
  double sum = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = std::max<std::size_t>(character(text, at), 1);
    sum += width_of(std::string_view(text).substr(at, length));
    at += length;
  }
  return sum * size;
}

std::string superscript(int value) {
  static const std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = value < 0 ? "⁻" : "";
  for (const char c : std::to_string(value < 0 ? -value : value)) out += digits[c - '0'];
  return out;
}

}  // namespace fabricsh::plot
