#include "base/number.hpp"

#include <charconv>
#include <cmath>

namespace fabricsh {

namespace {

template <class... Form>
std::string text_of(double x, Form... form) {
  if (std::isnan(x)) return "nan";  // whatever the sign bit says
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, form...).ptr;
  return {buffer, end};
}

}  // namespace

std::string number(double x, int digits) { return text_of(x, std::chars_format::general, digits); }

std::string exact_number(double x) { return text_of(x); }

std::string full_number(double x) { return text_of(x, std::chars_format::general, 17); }

}  // namespace fabricsh
