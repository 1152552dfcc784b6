#include <clocale>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include "base/number.hpp"
#include "catch.hpp"

using namespace fabricsh;

namespace {

std::string printed(const char* format, double x) {
  char text[64];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

}  // namespace

TEST_CASE("numbers for people read as C prints them, with a decimal point in any language",
          "[base][number]") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  std::uniform_int_distribution<int> exponent(-30, 30);
  for (int i = 0; i < 2000; ++i) {
    const double x = mantissa(random) * std::pow(10.0, exponent(random));
    CHECK(number(x) == printed("%.6g", x));
    CHECK(number(x, 4) == printed("%.4g", x));
    CHECK(full_number(x) == printed("%.17g", x));
    CHECK(std::stod(exact_number(x)) == x);
    CHECK(exact_number(x).size() <= full_number(x).size());
  }
  CHECK(number(0.3414) == "0.3414");
  CHECK(number(1e6) == "1e+06");
  CHECK(exact_number(0.1) == "0.1");
  if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr) CHECK(number(0.5) == "0.5");
  std::setlocale(LC_NUMERIC, "C");
}

TEST_CASE("a value that is no finite number has a word", "[base][number]") {
  for (const auto text : {+[](double x) { return number(x); }, exact_number, full_number}) {
    CHECK(text(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(text(-std::numeric_limits<double>::infinity()) == "-inf");
    CHECK(text(std::nan("")) == "nan");
    CHECK(text(-std::nan("")) == "nan");
  }
}
