// Texts of figures: as gnuplot reads them, and the room that they take.
#pragma once
#include <string>

namespace fabricsh::plot {

// Between single quotes gnuplot takes every character for itself: no backslash, no command in backquotes, no
// macro, no format. What no reader of an SVG would take is replaced: control characters by blanks, bytes that
// are not UTF-8 by the replacement character.
std::string quoted(const std::string& text);

// Points that a text takes in letters of a size, in a wide upright typeface: others take less.
double text_width(const std::string& text, double size);

// 6: "⁶", for powers of ten.
std::string superscript(int value);

}  // namespace fabricsh::plot
