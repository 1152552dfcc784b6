// The permitted range of a number, and its description in messages.
#pragma once
#include <limits>
#include <string>

namespace fabricsh {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
  bool holds(double x) const { return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high); }
  bool is_positive() const { return low == 0 && low_open && high > std::numeric_limits<double>::max(); }
};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range not_negative{0};
inline constexpr Range from_one{1};
inline constexpr Range everything{};

// " of at least 0", " above 0 to 1"; empty if every number is permitted.
std::string range_words(const Range& range);
// "a positive number in m", "an integer from 1 to 9".
std::string number_words(const Range& range, const std::string& unit, const std::string& noun = "number");

}  // namespace fabricsh
