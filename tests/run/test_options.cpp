// The rows of options: what each of them sets, what is out of range, and the settings of a checkpoint.
#include <set>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/settings.hpp"
#include "run/static.hpp"

using namespace fabricsh;
using field::FieldType;
using field::Value;

namespace {

// A value of the row that is not the initial one.
template <class Options>
Value other_value(const field::FieldOf<Options>& row) {
  const Value first = row.get(Options{});
  if (row.holds == FieldType::flag) return !std::get<bool>(first);
  if (row.holds == FieldType::text)
    return row.words.front() == (first == Value() ? "" : std::get<std::string>(first)) ? row.words.back()
                                                                                       : row.words.front();
  if (row.holds == FieldType::integer) return std::get<double>(first) + 3;
  return row.range.holds(0.75) ? 0.75 : row.range.low / 2;
}

template <class Options>
void check_rows(const std::string& call, const std::vector<field::FieldOf<Options>>& rows,
                const std::string& path = {}) {
  std::set<std::string> names;
  for (const auto& row : rows) {
    INFO(path + row.name);
    CHECK(names.insert(row.name).second);
    CHECK(!row.sentence.empty());
    if (row.holds == FieldType::group) {
      check_rows(call, row.rows, path + row.name + ".");
      continue;
    }
    Options options;
    const Value wanted = other_value(row), first = row.get(options);
    row.set(options, wanted);
    CHECK(row.get(options) == wanted);
    CHECK(wanted != first);
    for (const auto& another : rows)
      if (another.get && another.name != row.name) CHECK(another.get(options) == another.get(Options{}));
    if (row.holds != FieldType::number && row.holds != FieldType::integer) continue;
    row.set(options, row.range.low - 2);
    const std::string said = message_of([&] { field::require(call, rows, options, path); });
    CHECK(said == call + ": field '" + path + row.name + "': expected " + field::expected_number(row) +
                      ", got " + number(row.range.low - 2));
  }
}

template <class Options>
void check_settings(const std::vector<field::FieldOf<Options>>& rows) {
  const auto settings = run::settings_of(rows);
  for (std::size_t i = 0; i < settings.size(); ++i) CHECK(settings[i]->place == static_cast<int>(i) + 1);
  const Options given;
  Options now = run::with_settings(given, rows, {{"step", 0.125}, {"max_cuts", 7}, {"tolerance", 1e-5}});
  CHECK(now.step == 0.125);
  CHECK(now.max_cuts == 7);
  CHECK(now.tolerance == 1e-5);
  Archive out;
  run::keep_settings(out, rows, given, now);
  CHECK(out.bytes().size() == 2 * sizeof(double) + 4 * sizeof(int) + sizeof(double) + 2);
  const auto read = [&](const Options& made) {
    Archive in(out.bytes());
    Options then = made;
    run::keep_settings(in, rows, made, then);
    CHECK(in.at_end());
    return then;
  };
  CHECK(read(given).step == 0.125);
  CHECK(read(given).max_cuts == 7);
  Options another = given;  // made with another number, which stays
  another.max_cuts = 3;
  CHECK(read(another).max_cuts == 3);
  CHECK(read(another).tolerance == 1e-5);
  CHECK(message_of([&] {
          run::with_settings(given, rows, {{"duration", 2}});
        }) == "set: field 'duration': expected a setting that may change during a run");
}

}  // namespace

TEST_CASE("each row of options sets its own member, and says what is out of its range") {
  check_rows("static", run::static_options());
  check_rows("dynamic", run::dynamic_options());
}

TEST_CASE("a default is the initial value of the member, and what begins out of range must be given") {
  for (const auto& row : run::static_options()) {
    INFO(row.name);
    CHECK(row.required == (row.name == "duration"));
    if (!std::holds_alternative<std::monostate>(row.fallback))
      CHECK(row.fallback == row.get(run::StaticOptions{}));
  }
}

TEST_CASE(
    "a group that is not there has nothing out of range, and one that is may keep what it begins with") {
  struct Part {
    double size = 0;  // out of the range of its row
  };
  struct Whole {
    std::optional<Part> part = {};
  };
  const std::vector<field::FieldOf<Part>> rows{
      field::number("size", &Part::size, "m", positive, "of the part")};
  const std::vector<field::FieldOf<Whole>> whole{field::group("part", &Whole::part, rows, "a part")};
  const auto said = [&](const Whole& w) { return message_of([&] { field::require("call", whole, w); }); };
  CHECK(said({}) == said({Part{2}}));
  CHECK(said({}) == said({Part{}}));
  CHECK(said({Part{-2}}) == "call: field 'part.size': expected a positive number in m, got -2");
}

TEST_CASE("true, false and a word stand for numbers where a row has them") {
  for (const auto& row : run::static_options()) {
    if (row.name != "stabilise") continue;
    run::StaticOptions options;
    row.set(options, true);
    CHECK(options.stabilise == run::usual_stabilisation);
    row.set(options, false);
    CHECK(options.stabilise == 0);
  }
  for (const auto& row : run::dynamic_options()) {
    if (row.name != "step") continue;
    run::DynamicOptions options;
    row.set(options, std::string("auto"));
    CHECK(!options.step);
  }
}

TEST_CASE("settings are kept in the order of their places, and those of another run stay") {
  check_settings(run::static_options());
  check_settings(run::dynamic_options());
}
