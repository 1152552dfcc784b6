#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "lab/least_squares.hpp"
#include "lab/parallel.hpp"
#include "message_of.hpp"
#include "scratch.hpp"

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

TEST_CASE("parameters that data fix, and parameters that they cannot tell apart", "[lab]") {
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

namespace {

// Monomials 1, t, t^2, t^3 at 48 places, in units of a deviation of 1/50, minus data that lie `miss`
// deviations off the line 1 - 2 t + 3 t^2 - t^3 by turns; every residual jumps by `jump` where a sum of the
// parameters crosses multiples of 1/500, as a simulation does that cuts a step here and not there.
std::function<Points(const Points&)> cubic(double miss, double ripple) {
  return [=](const Points& points) {
    Points out;
    for (const auto& p : points) {
      out.emplace_back();
      const double wave = ripple * std::sin(2000 * (p[0] + 0.3 * p[1] - 0.2 * p[2]));
      for (int i = 0; i < 48; ++i) {
        const double t = i / 47.0, dp[] = {p[0] - 1, p[1] + 2, p[2] - 3, p[3] + 1};
        const double off = (i % 3 - 1) * miss;
        out.back().push_back(50 * (dp[0] + t * (dp[1] + t * (dp[2] + t * dp[3]))) + off + (i % 2) * wave);
      }
    }
    return out;
  };
}

}  // namespace

TEST_CASE(
    "the end of a search that is not quite smooth: where smooth least squares ends, with its deviations",
    "[lab]") {
  const std::vector<ParameterBounds> bounds{{0, 2}, {-8, 4}, {-9, 15}, {-5, 3}};
  const std::vector<double> width{2, 12, 24, 8}, start{1.3, -3, 4, -2};
  const auto smooth = least_squares(start, bounds, cubic(1, 0), {200, 1e-14, 1e-6});
  const auto reference = identifiability(smooth.jacobian, width);
  const auto rough = cubic(1, 0.05);
  const auto found = least_squares(start, bounds, rough, {50, 1e-8, 1e-4});
  const auto settled = settle(found, bounds, rough, 8);
  const auto known = identifiability(settled.jacobian, width);
  double before = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    INFO(i << ": " << found.x[i] << " " << settled.x[i] << " " << smooth.x[i] << " +- "
           << reference.deviation[i]);
    before = std::max(
        before, std::abs(identifiability(found.jacobian, width).deviation[i] / reference.deviation[i] - 1));
    CHECK(std::abs(settled.x[i] - smooth.x[i]) <
          0.3 * reference.deviation[i]);  // the ripple, and steps of a tenth
    CHECK(std::abs(known.deviation[i] / reference.deviation[i] - 1) < 0.1);
  }
  CHECK(before > 0.2);  // what the differences of single parameters said
  CHECK(settled.reason == "settled within a tenth of a standard deviation");
}

TEST_CASE("settling stays within the bounds and keeps what is exact", "[lab]") {
  const std::vector<ParameterBounds> bounds{
      {0, 1}, {-8, 4}, {-9, 15}, {-5, 3}};  // the best lies on the first one's bound
  const auto inside = [&](const Points& points) {
    for (const auto& p : points)
      for (std::size_t i = 0; i < p.size(); ++i) CHECK((p[i] >= bounds[i].low && p[i] <= bounds[i].high));
    return cubic(0, 0)(points);
  };
  const auto found = settle(least_squares({0.5, -1, 2, 0}, bounds, inside), bounds, inside, 5);
  const std::vector<double> want{1, -2, 3, -1};
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(std::abs(found.x[i] - want[i]) < 1e-3);  // the sine is flat at a bound
  for (std::size_t i = 0; i < 48; ++i)
    CHECK(std::abs(found.jacobian[4 * i + 3] - 50 * std::pow(static_cast<double>(i) / 47, 3)) < 1e-6);
}

TEST_CASE("processes answer in order, side by side, and say their trouble", "[lab]") {
  const auto own = static_cast<double>(getpid());
  const ScratchFolder scratch;
  // Waits for the others, which one after the other would never come.
  const auto meet = [&scratch](std::size_t i) {
    std::ofstream(scratch / std::to_string(i)) << i;
    for (int tries = 0; scratch.listing().size() < 4; ++tries) {
      if (tries == 60'000) throw Error("alone");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  std::size_t told = 0;
  const auto answers =
      in_processes(4,
                   [&meet](std::size_t i) {
                     meet(i);
                     if (i == 2) throw Error("no such cloth");
                     return std::vector<double>(10000 * i + 1, static_cast<double>(getpid()));
                   },
                   {4, false, [&](std::size_t, const WorkerResult&) { ++told; }, {}});
  CHECK(told == 4);
  for (const std::size_t i : {0u, 1u, 3u}) {
    CHECK(answers[i].values.size() == 10000 * i + 1);
    CHECK(answers[i].values[0] != own);
  }
  CHECK(answers[2].error == "no such cloth");
  const auto who = [](std::size_t) { return std::vector<double>{static_cast<double>(getpid())}; };
  CHECK(in_processes(2, who, {1, false, {}, {}})[1].values[0] == own);
  CHECK(in_processes(2, who, {1, true, {}, {}})[1].values[0] != own);
}

TEST_CASE("a process that is killed, one that throws no exception, and work that is told to stop", "[lab]") {
  const auto answers = in_processes(3,
                                    [](std::size_t i) {
                                      if (i == 0) std::raise(SIGKILL);
                                      if (i == 1) throw 7;
                                      return std::vector<double>{1};
                                    },
                                    {2, false, {}, {}});
  CHECK(answers[0].error == "the process was ended by signal 9 (Killed)");
  CHECK(answers[1].error == "unknown error");
  CHECK(answers[2].values == std::vector<double>{1});
  std::size_t finished = 0;
  const auto stopped = in_processes(
      6, [](std::size_t) { return std::vector<double>{1}; },
      {1, true, [&](std::size_t, const WorkerResult&) { ++finished; }, [&] { return finished == 2; }});
  CHECK(finished == 2);
  CHECK(stopped[1].error.empty());
  CHECK(stopped[2].error == "stopped");
}

TEST_CASE("an attachment is sent with values and with errors, of copies alone", "[lab]") {
  const auto work = [](std::size_t i) {
    if (i == 1) throw Error("no such cloth");
    return std::vector<double>(3 * i, 0.1);
  };
  Processes how{2, true};
  how.attach = [] { return std::string("with\0care", 9); };
  for (const WorkerResult& answer : in_processes(3, work, how)) {
    CHECK(answer.attached == std::string("with\0care", 9));
    CHECK_FALSE(answer.died);
  }
  const auto answers = in_processes(3, work, how);
  CHECK(answers[1].error == "no such cloth");
  CHECK(answers[2].values == std::vector<double>(6, 0.1));
  how.always = false;
  how.at_a_time = 1;
  CHECK(in_processes(1, work, how)[0].attached.empty());
}
