// Numbers as text. Everything is written here, so that the decimal point does not
// depend on the locale, and values that are not finite read "nan", "inf" and "-inf".
#pragma once
#include <string>

namespace fabricsh {

// For people: this many significant digits, without trailing zeros.
std::string number(double x, int digits = 6);
// The fewest digits that read back to the same double.
std::string exact_number(double x);
// 17 significant digits, which read back to the same double; columns then have a constant width.
std::string full_number(double x);

}  // namespace fabricsh
