// Numbers in messages.
#pragma once
#include <sstream>
#include <string>

namespace fabricsh::analysis {

inline std::string number(double v) {
  std::ostringstream text;
  text.precision(6);
  text << v;
  return text.str();
}

}  // namespace fabricsh::analysis
