// Numbers as text that every program reads the same: a decimal point whatever the language of the machine.
#pragma once
#include <string>

namespace fabricsh::files {

// 17 significant digits (what "%.17g" prints), which read back to the same double; "nan", "inf", "-inf".
std::string number(double x);
// The fewest digits that read back to the same double.
std::string short_number(double x);

}  // namespace fabricsh::files
