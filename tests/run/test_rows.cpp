// Rows of a table against the times that they must have, and what a failed step leaves behind.
#include <cmath>
#include <sstream>

#include "catch.hpp"
#include "run/dynamic.hpp"
#include "run/job.hpp"
#include "run/problems.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double kEvery = 1e-4, kLength = 1e-3;  // s

std::shared_ptr<model::Model> falling_sheet() {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 2, 3));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->gravity(model::steady({0, 0, -9.81}));
  return m;
}

std::shared_ptr<run::Run> falling(run::Scheme scheme) {
  run::DynamicOptions options;
  options.duration = kLength;
  options.scheme = scheme;
  if (scheme == run::Scheme::implicit_steps) options.step = kEvery / 4;
  return run::make_dynamic(falling_sheet(), options, quiet());
}

// The rows of a table: time and fall.
std::vector<std::pair<double, double>> rows_of(const std::string& path) {
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
  CHECK(line == "time (s),fall (m)");
  std::vector<std::pair<double, double>> rows;
  while (std::getline(lines, line)) {
    const auto comma = line.find(',');
    rows.emplace_back(std::stod(line.substr(0, comma)), std::stod(line.substr(comma + 1)));
  }
  return rows;
}

void record_fall(run::Job& job, const std::string& path) {
  job.record(path, {{"fall", [](const run::Run& r) { return -r.node(0).u.z(); }, "m"}}, kEvery);
}

// A row at every multiple of kEvery up to `last` and no other, each with the free fall of its time. The first
// half step of the scheme makes the fall g t^2 / 2 exact, so that only rounding is left.
void check_rows(const std::string& path, int last) {
  const auto rows = rows_of(path);
  REQUIRE(rows.size() == static_cast<std::size_t>(last + 1));
  for (int i = 0; i <= last; ++i) {
    const double t = i * kEvery;
    CHECK(std::abs(rows[i].first - t) < 1e-12 * kLength);
    CHECK(std::abs(rows[i].second - 9.81 * t * t / 2) < 1e-9 * 9.81 * kLength * kLength / 2);
  }
}

constexpr run::Scheme kSchemes[] = {run::Scheme::explicit_steps, run::Scheme::implicit_steps};

}  // namespace

TEST_CASE("a table after a restore has one row for each time, wherever the snapshot was taken") {
  for (const auto scheme : kSchemes)
    for (const double at : {0.0, 2e-4, 3.3e-4, 7e-4}) {
      INFO("snapshot at " << at);
      const ScratchFolder scratch;
      run::Job job(falling(scheme));
      record_fall(job, scratch / "fall.csv");
      job.advance(at);
      const auto snapshot = job.run().snapshot();
      const auto before = rows_of(scratch / "fall.csv");
      job.advance(9e-4);
      job.run().restore(*snapshot);
      CHECK(rows_of(scratch / "fall.csv") == before);
      CHECK(job.run().time() == Approx(at).margin(1e-18));
      job.advance(5.5e-4 > at ? 5.5e-4 : 8.5e-4);
      job.run().restore(*snapshot);  // once more
      job.solve();
      check_rows(scratch / "fall.csv", 10);
    }
}

TEST_CASE("the extra row of a failure goes when the run goes on, and no other row with it") {
  for (const auto scheme : kSchemes) {
    const ScratchFolder scratch;
    run::Job job(falling(scheme));
    record_fall(job, scratch / "fall.csv");
    job.run().every(3.5e-4, [](run::Run& r) {
      if (std::abs(r.time() - 3.5e-4) < 1e-9) throw Error("enough");
    });
    CHECK_THROWS_AS(job.solve(), Error);
    // Rows at 0, 1, 2, 3, and the extra one at 3.5.
    const auto failed = rows_of(scratch / "fall.csv");
    REQUIRE(failed.size() == 5);
    CHECK(std::abs(failed.back().first - 3.5e-4) < 1e-15);
    job.advance(5.2e-4);  // the extra row goes, those of 4 and 5 come
    check_rows(scratch / "fall.csv", 5);
    job.advance(6.4e-4);  // nothing goes
    check_rows(scratch / "fall.csv", 6);
    job.advance(6.6e-4);
    check_rows(scratch / "fall.csv", 6);
    job.solve();
    check_rows(scratch / "fall.csv", 10);
  }
}

namespace {

// Cannot be done with any step while it is not willing.
class Unwilling final : public mechanics::Term {
 public:
  explicit Unwilling(const bool& willing) : willing_(willing) {}
  const char* name() const override { return "unwilling"; }
  mechanics::Outcome add_forces(const law::Step&, const mechanics::Trial&, mechanics::Forces&) override {
    return willing_ ? mechanics::Outcome{} : mechanics::Outcome{Answer::cut, -1, "not willing"};
  }

 private:
  const bool& willing_;
};

}  // namespace

TEST_CASE("a step that failed in every size leaves the size that the steps had, in motion and at rest") {
  const double size = 7e-5;
  for (const bool moves : {true, false}) {
    INFO((moves ? "in motion" : "at rest"));
    bool willing = true;
    std::shared_ptr<run::Run> a;
    if (moves) {
      run::DynamicOptions options;
      options.duration = kLength;
      options.scheme = run::Scheme::implicit_steps;
      options.step = size;
      options.max_cuts = 5;
      a = run::make_dynamic(falling_sheet(), options, quiet());
    } else {
      run::StaticOptions options;
      options.duration = kLength;
      options.step = size;
      options.max_cuts = 5;
      const auto model = falling_sheet();
      model->fix("left", model::parse_freedoms("x y z rotation"));
      a = std::make_shared<run::Static>(model, options, quiet());
    }
    a->add(std::make_unique<Unwilling>(willing));
    a->step();
    const double usual = a->steps().back().step;
    a->step();
    willing = false;
    for (int again = 0; again < 2; ++again) {
      CHECK_THROWS_AS(a->step(), NumericalFailure);
      CHECK(a->steps().size() == 2);
    }
    willing = true;
    a->step();
    // The way to the end is divided into equal steps of at most `size`.
    CHECK(a->steps().back().step == Approx(usual).epsilon(1e-12));
    CHECK(a->steps().back().cuts == 0);
  }
}
