// Steps that cannot pass: conservative advancement and the motion bound on moving pairs of which the exact
// answer is known [wang2021], and on motions made so that they meet.
#include <zlib.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "catch.hpp"
#include "contact/advance.hpp"
#include "contact/intersect.hpp"
#include "contact/slope.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;
using test::Random;

namespace {

struct Query {
  std::string name;
  bool meets = false;
  Corners start, end;
};

std::string folder() {
  const char* given = std::getenv("FABRICSH_DATA");
  return std::string(given != nullptr ? given : FABRICSH_SOURCE_DIR "/../shared/data") + "/ccd-queries/";
}

// Lines "name collides 24 coordinates": four points at the start, then at the end.
std::vector<Query> read(const std::string& file) {
  std::vector<Query> out;
  gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) return out;
  char line[4096];
  while (gzgets(in, line, sizeof line) != nullptr) {
    if (line[0] == '#') continue;
    std::istringstream words(line);
    Query query;
    words >> query.name >> query.meets;
    for (Corners* corners : {&query.start, &query.end})
      for (Vec3& x : *corners)
        for (int i = 0; i < 3; ++i) {
          std::string number;  // strtod reads what streams refuse, such as the smallest numbers
          words >> number;
          x[i] = std::strtod(number.c_str(), nullptr);
        }
    REQUIRE(!words.fail());
    out.push_back(query);
  }
  gzclose(in);
  return out;
}

double distance(Simplices kind, const Corners& x) {
  return std::sqrt(kind == Simplices::point_triangle ? squared_point_triangle(x[0], x[1], x[2], x[3])
                                                     : squared_segment_segment(x[0], x[1], x[2], x[3]));
}

void check_queries(Simplices kind, const char* file) {
  const auto queries = read(folder() + file);
  if (queries.empty()) {
    WARN("SKIPPED: no " << folder() << file << " (FABRICSH_DATA names another folder of measured data)");
    return;
  }
  int missed = 0, false_alarms = 0, apart = 0, bound_missed = 0, bound_free = 0;
  for (const Query& q : queries) {
    const bool alarm = safe_fraction(kind, q.start, q.end, 0) < 1;
    if (q.meets && !alarm) {
      ++missed;
      UNSCOPED_INFO("missed: " << q.name);
    }
    if (!q.meets) {
      ++apart;
      if (alarm) ++false_alarms;
    }
    double displacement = 0;
    for (std::size_t i = 0; i < 4; ++i) displacement = std::max(displacement, (q.end[i] - q.start[i]).norm());
    const bool free = cannot_meet(displacement, distance(kind, q.start));
    if (free) ++bound_free;
    if (free && q.meets) ++bound_missed;
  }
  const auto begin = std::chrono::steady_clock::now();
  double sum = 0;
  for (const Query& q : queries) sum += safe_fraction(kind, q.start, q.end, 0);
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - begin;
  std::cout << file << ": " << queries.size() << " queries, " << missed << " missed, " << false_alarms
            << " of " << apart << " false alarms, " << took.count() / double(queries.size())
            << " us a query; the motion bound frees " << bound_free << " and misses " << bound_missed
            << " (mean share " << sum / double(queries.size()) << ")\n";
  CHECK(missed == 0);
  CHECK(bound_missed == 0);
  CHECK(false_alarms < apart / 4);
  CHECK(bound_free > 0);
}

}  // namespace

TEST_CASE("advance: not one meeting of a point and a triangle is missed", "[contact]") {
  check_queries(Simplices::point_triangle, "vf.txt.gz");
}

TEST_CASE("advance: not one meeting of two edges is missed", "[contact]") {
  check_queries(Simplices::segment_segment, "ee.txt.gz");
}

TEST_CASE("advance: motions made to meet are stopped before they do, and not long before", "[contact]") {
  Random random(1);
  for (int n = 0; n < 2000; ++n) {
    // A triangle and a point that passes through one of its inner points at time `when`.
    Corners x, by;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = random.vector(1);
      by[i] = random.vector(1);
    }
    const double when = random(0.05, 1), v = random(0, 0.5), w = random(0, 0.5);
    const Vec3 target =
        (1 - v - w) * (x[1] + when * by[1]) + v * (x[2] + when * by[2]) + w * (x[3] + when * by[3]);
    x[0] = target - when * by[0];
    const double first = distance(Simplices::point_triangle, x);
    if (first < 0.02) continue;  // slides along at so small a distance take more steps than are allowed
    Corners end;
    for (std::size_t i = 0; i < 4; ++i) end[i] = x[i] + by[i];
    const double share = safe_fraction(Simplices::point_triangle, x, end, 0);
    REQUIRE(share < when);
    Corners there;
    for (std::size_t i = 0; i < 4; ++i) there[i] = x[i] + share * by[i];
    REQUIRE(distance(Simplices::point_triangle, there) > 0);
    REQUIRE(distance(Simplices::point_triangle, there) < 0.1 * first * (1 + 1e-9));
  }
}

TEST_CASE("advance: a least distance is kept, and a start nearer than it goes nowhere", "[contact]") {
  const Corners start = {Vec3(0.3, 0.3, 1), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Corners end = start;
  end[0].z() = -1;
  const double share = safe_fraction(Simplices::point_triangle, start, end, 0.2);
  CHECK(1 - 2 * share >= 0.2);
  CHECK(1 - 2 * share < 0.2 + 0.1 * 0.8);
  CHECK(safe_fraction(Simplices::point_triangle, start, end, 1) == 0);
  Corners drift = start;
  for (Vec3& x : drift) x += Vec3(5, -3, 2);
  CHECK(safe_fraction(Simplices::point_triangle, start, drift, 0.9) == 1);  // all move alike
}

TEST_CASE("intersect: an edge through a triangle, beside it, and short of it", "[contact]") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(cuts(Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, -1), a, b, c));
  CHECK(cuts(Vec3(0.5, 0, 1), Vec3(0.5, 0, -1), a, b, c));
  CHECK_FALSE(cuts(Vec3(0.6, 0.6, 1), Vec3(0.6, 0.6, -1), a, b, c));
  CHECK_FALSE(cuts(Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, 0.1), a, b, c));
  CHECK_FALSE(cuts(Vec3(-1, 0.2, 0.1), Vec3(1, 0.2, 0.1), a, b, c));
  const std::vector<Vec3> x = {a, b, c, Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, -1), Vec3(2, 2, 2)};
  const std::vector<Edge> edges = {{0, 3}, {3, 4}, {4, 5}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const auto found = intersections(x, edges, triangles);
  REQUIRE(found.size() == 1);
  CHECK(found[0] == std::pair<std::size_t, std::size_t>(1, 0));
}
