#include "files/number.hpp"

#include <charconv>
#include <cmath>

namespace fabricsh::files {

std::string number(double x) {
  if (std::isnan(x)) return "nan";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 17);
  return {buffer, end.ptr};
}

std::string short_number(double x) {
  if (std::isnan(x)) return "nan";
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x);
  return {buffer, end.ptr};
}

}  // namespace fabricsh::files
