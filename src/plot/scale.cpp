#include "plot/scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "base/number.hpp"
#include "plot/text.hpp"

namespace fabricsh::plot {

namespace {

constexpr double kSmallest = 1e-290, kLargest = 1e290;  // beyond them steps and powers of ten are lost

const std::string times = "\u00d7", minus = "\u2212";

std::string with_decimals(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(decimals, 0, 20), std::abs(value));
  const bool zero = std::string(text).find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? minus : "") + std::string(text);
}

// Number of decimals that distinguishes multiples of this step.
int decimals_of(double step) { return -static_cast<int>(std::floor(std::log10(step) + 1e-9)); }

// Values from 0.001 to a million are written plainly, others with a power of ten.
std::string text_of(double value, double step, double largest) {
  if (std::abs(value) < 1e-9 * step) return "0";
  if (largest >= 1e-3 && largest < 1e6) return with_decimals(value, decimals_of(step));
  const int power = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  return with_decimals(value / std::pow(10, power), decimals_of(step) + power) + times + "10" +
         superscript(power);
}

std::string decade_text(int power) {
  if (power >= -3 && power <= 4) return with_decimals(std::pow(10, power), -power);
  return "10" + superscript(power);
}

// Fixed ends are kept; the others are the next multiples of half the step.
Scale linear(const Axis& axis, double low, double high, double step) {
  Scale s;
  const double half_step = step / 2;  // values may exceed a tick by a thousandth of it (rounding errors)
  s.low = axis.low.value_or(std::min(low, half_step * std::floor(low / half_step + 1e-3)));
  s.high = axis.high.value_or(std::max(high, half_step * std::ceil(high / half_step - 1e-3)));
  const double largest = std::max(std::abs(s.low), std::abs(s.high)), slack = 1e-9 * (s.high - s.low);
  const double first = std::ceil((s.low - slack) / half_step);
  for (int i = 0; i < 1000; ++i) {
    const double half = first + i, value = half * half_step;
    if (value > s.high + slack) break;
    const bool numbered = std::fmod(half, 2) == 0;
    s.ticks.push_back({value, numbered ? text_of(value, step, largest) : ""});
  }
  return s;
}

double room_of(const Scale& s, double letter, bool upright) {
  double widest = 0;
  for (const Tick& tick : s.ticks) widest = std::max(widest, text_width(tick.text, letter));
  return upright ? 2.2 * letter : widest + 0.9 * letter;
}

Scale with_round_steps(const Axis& axis, double low, double high, double length, double letter,
                       bool upright) {
  const double range = axis.high.value_or(high) - axis.low.value_or(low);
  if (!std::isfinite(range) || range < kSmallest)
    throw Error("figure: the values from " + number(low) + " to " + number(high) +
                " can't be shown on one axis");
  const double decade = std::pow(10, std::floor(std::log10(range)) - 1);
  Scale s;
  for (const double part : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    const double step = part * decade;
    if (range / step > 12) continue;
    s = linear(axis, low, high, step);
    if (length * step / (s.high - s.low) >= room_of(s, letter, upright)) break;
  }
  return s;
}

// A tick with its name at 1, 2, ..., half a step from the ends.
Scale named(const Axis& axis) {
  Scale s;
  s.low = axis.low.value_or(0.5);
  s.high = axis.high.value_or(static_cast<double>(axis.names.size()) + 0.5);
  for (std::size_t i = 0; i < axis.names.size(); ++i)
    if (const auto value = static_cast<double>(i + 1); value >= s.low && value <= s.high)
      s.ticks.push_back({value, axis.names[i]});
  return s;
}

void add_decade(Scale& s, int power, bool numbered) {
  const double decade = std::pow(10, power);
  if (decade >= s.low * (1 - 1e-9) && decade <= s.high * (1 + 1e-9))
    s.ticks.push_back({decade, numbered ? decade_text(power) : ""});
}

Scale decades(const Axis& axis, double low, double high, double length, double letter, bool upright) {
  const double first_shown = axis.low.value_or(low), last_shown = axis.high.value_or(high);
  if (first_shown < kSmallest || last_shown > kLargest)
    throw Error("figure: a logarithmic axis has room for values from " + number(kSmallest) + " to " +
                number(kLargest) + ", got " + number(first_shown) + " to " + number(last_shown) +
                "; give a range of the axis");
  Scale s;
  s.logarithmic = true;
  s.low = axis.low.value_or(std::min(low, std::pow(10, std::floor(std::log10(low) + 1e-9))));
  s.high = axis.high.value_or(std::max(high, std::pow(10, std::ceil(std::log10(high) - 1e-9))));
  if (!(s.low < s.high)) (axis.high ? s.low /= 10 : s.high *= 10);
  const int first = static_cast<int>(std::floor(std::log10(s.low))),
            last = static_cast<int>(std::ceil(std::log10(s.high)));
  const double each = length / std::log10(s.high / s.low),
               needed = upright ? 2.2 * letter : text_width("10000", letter) + 0.9 * letter;
  const int every = std::max(1, static_cast<int>(std::ceil(needed / each)));
  for (int power = first; power <= last; ++power) {
    add_decade(s, power, power % every == 0);
    if (every > 1) continue;
    for (int k = 2; k < 10; ++k)
      if (const double v = k * std::pow(10, power); v >= s.low && v <= s.high)
        // Less than a decade holds no power of ten, or one.
        s.ticks.push_back(
            {v, last - first <= 1 && (k == 2 || k == 5) ? with_decimals(v, -power) : std::string()});
  }
  return s;
}

}  // namespace

double Scale::part(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double Scale::held(double value) const { return logarithmic && value <= 0 ? low : value; }

double Scale::at(double part) const {
  return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
}

Scale scale_of(const Axis& axis, double low, double high, double length, double letter, bool upright) {
  if (!axis.names.empty()) return named(axis);
  if (axis.logarithmic) return decades(axis, low, high, length, letter, upright);
  if (low == high) {
    const double around = low == 0 ? 1 : 0.1 * std::abs(low);
    low -= around, high += around;
  }
  return with_round_steps(axis, low, high, length, letter, upright);
}

}  // namespace fabricsh::plot
