// Numbers as text, the one place where that is done: with a decimal point whatever the language of the
// machine; "nan", "inf" and "-inf" for what is not finite.
#pragma once
#include <string>

namespace fabricsh {

// For people: so many significant digits, without the zeros at the end.
std::string number(double x, int digits = 6);
// The fewest digits that read back to the same double.
std::string exact_number(double x);
// 17 significant digits, which read back to the same double; columns of them keep their width.
std::string full_number(double x);

}  // namespace fabricsh
