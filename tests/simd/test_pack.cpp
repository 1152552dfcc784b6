// Packs: every lane does what a double does, with other numbers in each of them.
#include <cmath>
#include <cstring>
#include <limits>

#include "catch.hpp"
#include "simd/pack.hpp"

using namespace fabricsh;

namespace {

// Two numbers for each lane, no two alike; equal in lane 1.
double left(int lane) { return lane == 1 ? -2.5 : (lane % 2 == 0 ? 1 : -1) * (0.75 + lane); }
double right(int lane) { return lane == 1 ? -2.5 : 3.0 - 1.5 * lane; }

Pack filled(double (*number)(int)) {
  Pack p;
  for (int i = 0; i < pack_width; ++i) p.set(i, number(i));
  return p;
}

template <class F, class G>
void check_lanes(F of_packs, G of_doubles) {
  const Pack got = of_packs(filled(left), filled(right));
  for (int i = 0; i < pack_width; ++i) {
    INFO("lane " << i);
    CHECK(got[i] == of_doubles(left(i), right(i)));
  }
}

template <class F>
void check_mask(F compares) {
  const unsigned mask = bits(compares(filled(left), filled(right)));
  for (int i = 0; i < pack_width; ++i) {
    INFO("lane " << i);
    CHECK(((mask >> i & 1u) == 1u) == bool(bits(compares(left(i), right(i)))));
  }
  CHECK(mask < 1u << pack_width);
}

}  // namespace

TEST_CASE("pack: sums, products and functions, lane by lane") {
  check_lanes([](Pack a, Pack b) { return a + b; }, [](double a, double b) { return a + b; });
  check_lanes([](Pack a, Pack b) { return a - b; }, [](double a, double b) { return a - b; });
  check_lanes([](Pack a, Pack b) { return a * b; }, [](double a, double b) { return a * b; });
  check_lanes([](Pack a, Pack b) { return a / (b * b + 1); },
              [](double a, double b) { return a / (b * b + 1); });
  check_lanes([](Pack a, Pack b) { return -a + 2.0 * b; }, [](double a, double b) { return -a + 2.0 * b; });
  check_lanes([](Pack a, Pack) { return abs(a); }, [](double a, double) { return std::fabs(a); });
  check_lanes([](Pack a, Pack b) { return sqrt(abs(a)) + exp(b); },
              [](double a, double b) { return std::sqrt(std::fabs(a)) + std::exp(b); });
  check_lanes([](Pack a, Pack b) { return a += b, a *= b, a -= 3.0, a /= 4.0, a; },
              [](double a, double b) { return ((a + b) * b - 3.0) / 4.0; });
}

TEST_CASE("pack: the larger, the smaller and the chosen one, and equal ones as the machine has them") {
  check_lanes([](Pack a, Pack b) { return max(a, b); }, [](double a, double b) { return a > b ? a : b; });
  check_lanes([](Pack a, Pack b) { return min(a, b); }, [](double a, double b) { return a < b ? a : b; });
  check_lanes([](Pack a, Pack b) { return select(a < b, a * 10.0, b * 100.0); },
              [](double a, double b) { return a < b ? a * 10.0 : b * 100.0; });
  // Of 0 and -0, and where one is no number, the second.
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::signbit(max(Pack(0.0), Pack(-0.0))[0]));
  CHECK(!std::signbit(min(Pack(-0.0), Pack(0.0))[pack_width - 1]));
  CHECK(max(Pack(none), Pack(2.0))[0] == 2);
  CHECK(std::isnan(max(Pack(2.0), Pack(none))[0]));
  CHECK(std::signbit(max(0.0, -0.0)));
}

TEST_CASE("pack: comparisons and what is made of them") {
  check_mask([](auto a, auto b) { return a < b; });
  check_mask([](auto a, auto b) { return a <= b; });
  check_mask([](auto a, auto b) { return a > b; });
  check_mask([](auto a, auto b) { return a >= b; });
  check_mask([](auto a, auto b) { return a == b; });
  check_mask([](auto a, auto b) { return (a < b) & (a < decltype(a)(0.0)); });
  check_mask([](auto a, auto b) { return (a < b) | (b < decltype(a)(0.0)); });
  const Pack a = filled(left), b = filled(right);
  CHECK(bits(!(a < b)) % (1u << pack_width) == (~bits(a < b)) % (1u << pack_width));
  CHECK(any(a == b));
  CHECK(!any(a == a + 1.0));
  CHECK(!any(Pack(std::numeric_limits<double>::quiet_NaN()) <= Pack(1.0)));
}

TEST_CASE("pack: which lanes differ in a bit, and batches in parts") {
  const Pack a = filled(left);
  CHECK(differing(a, a) == 0);
  for (int i = 0; i < pack_width; ++i) {
    Pack b = a;
    b.set(i, std::nextafter(a[i], 100));
    CHECK(differing(a, b) == 1u << i);
  }
  Pack zero(0.0), minus(0.0);
  minus.set(pack_width - 1, -0.0);
  CHECK(differing(zero, minus) == 1u << (pack_width - 1));  // equal, but other bits
  double column[lanes];
  for (int i = 0; i < lanes; ++i) column[i] = i * i - 3;
  // The mask of a batch has the lanes of each part in their places.
  const unsigned failed = at_parts([&](int first) {
    const Pack part = load(column + first);
    store(column + first, 2.0 * part);
    return bits(part > Pack(5.0));
  });
  for (int i = 0; i < lanes; ++i) {
    CHECK(column[i] == 2 * (i * i - 3));
    CHECK((failed >> i & 1u) == (i * i - 3 > 5 ? 1u : 0u));
  }
}
