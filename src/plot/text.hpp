// Texts of figures: quoting for gnuplot, and their width.
#pragma once
#include <string>

namespace fabricsh::plot {

// A text between single quotes, in which gnuplot interprets no escapes, commands, macros or formats.
// Characters that would make an SVG invalid are replaced: control characters by blanks, bytes that
// are not UTF-8 by the replacement character.
std::string quoted(const std::string& text);

// Estimated width of a text in points, for a wide font; other fonts need less.
double text_width(const std::string& text, double size);

// 6: "⁶", for powers of ten.
std::string superscript(int value);

}  // namespace fabricsh::plot
