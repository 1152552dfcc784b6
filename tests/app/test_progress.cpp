// The look of progress, and when it is said.
#include <chrono>
#include <cstdlib>

#include "app/progress.hpp"
#include "catch.hpp"

using namespace fabricsh;
using namespace fabricsh::app;

namespace {

script::RunProgress at(double elapsed, int* asked = nullptr) {
  script::RunProgress p;
  p.run = 1;
  p.time = 0.32;
  p.duration = 1;
  p.steps = 16;
  p.iterations = 5;
  p.elapsed = elapsed;
  p.remaining = 200;
  p.ledger_error = [asked] {
    if (asked != nullptr) ++*asked;
    return 1.2e-6;
  };
  return p;
}

std::string shown(bool terminal, const std::vector<double>& times) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&text, &size);
  {
    ProgressLine line(stream, terminal);
    for (const double t : times) line.show(at(t));
    line.clear();
  }
  std::fclose(stream);
  std::string all(text, size);
  std::free(text);
  return all;
}

std::size_t count(const std::string& all, const std::string& part) {
  std::size_t n = 0;
  for (auto i = all.find(part); i != std::string::npos; i = all.find(part, i + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("durations and a line of progress") {
  CHECK(duration_text(0.4) == "0 s");
  CHECK(duration_text(59.4) == "59 s");
  CHECK(duration_text(200) == "3 min 20 s");
  CHECK(duration_text(7500) == "2 h 05 min");
  CHECK(progress_text(at(12), 1.2e-6) ==
        "t = 0.32 of 1 s, step 16, 5 iterations, ledger 1.2e-06, 12 s, 3 min 20 s left");
  auto explicit_run = at(12);
  explicit_run.iterations = 0;
  explicit_run.remaining = -1;
  CHECK(progress_text(explicit_run, 0) == "t = 0.32 of 1 s, step 16, ledger 0.0e+00, 12 s");
}

TEST_CASE("a bar has its width, from nothing to all") {
  CHECK(bar_text(0, 13) == "[>         ] ");
  CHECK(bar_text(0.5, 13) == "[=====>    ] ");
  CHECK(bar_text(1, 13) == "[==========] ");
  CHECK(bar_text(7, 13) == "[==========] ");
  CHECK(bar_text(0.5, 5).empty());
}

TEST_CASE("a log gets nothing in the first two seconds, then a line every ten") {
  CHECK(shown(false, {0.1, 0.5, 1.9}).empty());
  const std::string log = shown(false, {0.5, 1.9, 2.05, 2.5, 9, 12.1, 12.5, 22, 22.2});
  CHECK(count(log, "\n") == 3);
  CHECK(count(log, "\r") == 0);
  CHECK(count(log, "\033") == 0);
}

TEST_CASE("a terminal has one line, redrawn ten times a second and cleared at the end") {
  const std::string bar = shown(true, {0.1, 0.35, 0.4, 0.41, 0.46, 0.5});
  CHECK(count(bar, "\n") == 0);
  CHECK(count(bar, "t = 0.32") == 2);  // at 0.35 and 0.46
  CHECK(bar.ends_with("\r\033[K"));
}

TEST_CASE("the ledger is asked for no more often than it is cheap") {
  std::FILE* stream = std::fopen("/dev/null", "w");
  ProgressLine line(stream, true);
  int asked = 0;
  for (int i = 0; i < 40; ++i) {
    auto p = at(0.4 + 0.15 * i, &asked);
    const auto error = p.ledger_error;
    p.ledger_error = [error] {  // takes 20 ms: once in 2 s
      const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
      while (std::chrono::steady_clock::now() < until) {
      }
      return error();
    };
    line.show(p);
  }
  std::fclose(stream);
  CHECK(asked >= 1);
  CHECK(asked <= 4);
}
