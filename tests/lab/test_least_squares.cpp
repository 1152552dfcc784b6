#include <unistd.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "lab/least_squares.hpp"
#include "lab/parallel.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::lab;

namespace {

Points rosenbrock(const Points& points) {
  Points out;
  for (const auto& p : points) out.push_back({10 * (p[1] - p[0] * p[0]), 1 - p[0]});
  return out;
}

}  // namespace

TEST_CASE("Rosenbrock's valley, free and with a bound across it", "[lab]") {
  const auto free = least_squares({-1.2, 1}, {{-3, 3}, {-3, 3}}, rosenbrock, {200, 1e-12, 1e-6});
  CHECK(free.converged);
  CHECK(std::abs(free.x[0] - 1) < 1e-6);  // forward differences
  CHECK(std::abs(free.x[1] - 1) < 1e-6);
  // with x <= 0.5 the best is x = 0.5, y = 0.25
  const auto bounded = least_squares({-1.2, 1}, {{-3, 0.5}, {-3, 3}}, rosenbrock, {500, 1e-12, 1e-6});
  CHECK(bounded.x[0] <= 0.5);
  CHECK(std::abs(bounded.x[0] - 0.5) < 1e-4);
  CHECK(std::abs(bounded.x[1] - 0.25) < 2e-4);
  says(message_of([] { least_squares({4, 0}, {{-3, 3}, {-3, 3}}, rosenbrock); }), "parameter 1");
  says(message_of([] {
         least_squares({0, 0}, {{-3, 3}, {-3, 3}}, [](const Points& p) { return Points(p.size(), {1.0}); });
       }),
       "at least as many residuals");
}

TEST_CASE("the Jacobian is that of the parameters, within the bounds", "[lab]") {
  const auto found = least_squares({1, 2}, {{0, 2}, {1, 4}}, [](const Points& points) {
    Points out;
    for (const auto& p : points) {
      CHECK((p[0] >= 0 && p[0] <= 2 && p[1] >= 1 && p[1] <= 4));
      out.push_back({3 * p[0] + p[1] - 5, p[0] - 2 * p[1] + 3, 0.5 * p[0]});
    }
    return out;
  });
  const std::vector<double> want{3, 1, 1, -2, 0.5, 0};
  for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(found.jacobian[i] - want[i]) < 1e-9);
}

TEST_CASE("what data fix and what they cannot tell apart", "[lab]") {
  const auto good = identifiability({2, 0, 0, 4}, {1, 1});
  CHECK(std::abs(good.deviation[0] - 0.5) < 1e-14);
  CHECK(std::abs(good.deviation[1] - 0.25) < 1e-14);
  CHECK(std::abs(good.weakest_deviation - 0.5) < 1e-14);
  // only the sum is seen, but for a little
  const auto bad = identifiability({1, 1, 1, 1.001, 1, 1}, {1, 1});
  CHECK(bad.correlation[1] < -0.999);
  CHECK(std::abs(std::abs(bad.weakest[0]) - std::sqrt(0.5)) < 1e-3);
  CHECK(bad.weakest[0] * bad.weakest[1] < 0);
  const auto blind = identifiability({1, 0, 1, 0}, {1, 10});
  CHECK(blind.deviation[1] > 1e10);
}

TEST_CASE("processes answer in order, side by side, and say their trouble", "[lab]") {
  const auto own = static_cast<double>(getpid());
  const auto begin = std::chrono::steady_clock::now();
  std::size_t told = 0;
  const auto answers = in_processes(
      4, 4,
      [](std::size_t i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        if (i == 2) throw Error("no such cloth");
        return std::vector<double>(10000 * i + 1, static_cast<double>(getpid()));
      },
      [&](std::size_t) { ++told; });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  CHECK(told == 4);
  CHECK(spent.count() < 1.9);  // one after the other takes 2
  for (const std::size_t i : {0u, 1u, 3u}) {
    CHECK(answers[i].values.size() == 10000 * i + 1);
    CHECK(answers[i].values[0] != own);
  }
  CHECK(answers[2].trouble == "no such cloth");
  const auto here =
      in_processes(2, 1, [](std::size_t) { return std::vector<double>{static_cast<double>(getpid())}; });
  CHECK(here[1].values[0] == own);
}
