// The list of a model's loads: each kind is checked, told, copied and removed in the same way.
#include <algorithm>

#include "catch.hpp"
#include "message_of.hpp"
#include "model/fingerprint.hpp"
#include "model/model.hpp"
#include "model/sheet.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using model::Model;

namespace {

model::Components up(double value, double end) {
  return {std::nullopt, history::History::ramp(value, end), std::nullopt};
}

// One of each kind, which ends at a time of its own.
void load(Model& m) {
  m.force("top", up(1, 0.25));
  m.add<model::MomentLoad>({"top", up(2, 0.5)});
  m.add<model::TractionLoad>({"right", up(3, 0.75)});
  m.pressure("all", history::History::ramp(4, 1.25));
  m.add<model::GroundSpring>({"left", {5, 0, 6}});
}

// The names and units that the loads tell.
struct Told : model::DeclarationVisitor {
  std::string words;
  template <class Load>
  void about(const Load& load) {
    words += load.call();
  }
  void set(const std::string& name, auto...) { words += " " + name + ":"; }
  void components(const model::Components&, const char* unit, auto...) {
    words += std::string(" ") + unit + ";";
  }
  void history(const char* name, const std::optional<history::History>&, const char* unit, auto...) {
    words += std::string(" ") + name + " " + unit + ";";
  }
  void frame(const Mat3&) { words += " frame;"; }
};

std::string told(const Model& m) {
  Told words;
  tell_loads(m.declarations(), words);
  return words.words;
}

std::uint64_t hash_of_loads(const Model& m) {
  for (const auto& part : fingerprint(m, 1.0))
    if (part.name == "loads") return part.hash;
  return 0;
}

}  // namespace

TEST_CASE("each kind of load is told with its members, copied and removed") {
  Model m = make_model();
  load(m);
  CHECK(told(m) ==
        "force top: N; frame;moment top: N m; frame;traction right: N/m^2 or N/m; frame;"
        "pressure all: value Pa;");
  const auto copied = m.copy();
  CHECK(told(*copied) == told(m));
  CHECK(hash_of_loads(*copied) == hash_of_loads(m));
  const auto kinks = m.kinks();
  for (const double kink : {0.25, 0.5, 0.75, 1.25})
    CHECK(std::find(kinks.begin(), kinks.end(), kink) != kinks.end());
  m.remove<model::TractionLoad>(0);
  CHECK(m.all<model::TractionLoad>().empty());
  CHECK(m.all<model::PressureLoad>().size() == 1);
  CHECK(copied->all<model::TractionLoad>().size() == 1);
  CHECK(hash_of_loads(*copied) != hash_of_loads(m));
  CHECK(message_of([&] { m.remove<model::TractionLoad>(0); }) == "remove: there is no such support or load");
}

TEST_CASE("loads that cannot be say so by the name of their call") {
  Model m = make_model();
  CHECK(message_of([&] {
          m.add<model::MomentLoad>({"top", {}});
        }) == "moment: expected at least one of x, y, z, got none");
  CHECK(message_of([&] { m.pressure("top", history::History::ramp(1, 1)); }) ==
        "pressure: set 'top' holds no whole element");
  CHECK(message_of([&] {
          m.add<model::GroundSpring>({"top", {1, -2, 0}});
        }) == "spring: expected stiffnesses of 0 or more in N/m, got -2");
  CHECK(message_of([&] { m.force("toop", up(1, 1)); }).find("toop") != std::string::npos);
  m.seal();
  CHECK(message_of([&] {
          m.add<model::TractionLoad>({"top", up(1, 1)});
        }) == "traction: the model is in use by an analysis and can't be changed any more");
}

TEST_CASE("what is shared by area or length is refused on sets whose other nodes would get nothing") {
  auto sheet = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.06, 2, 3));  // nodes 1 to 12, 3 in a row
  sheet->define("area and edge", {0, 1, 3, 4, 9, 10, 11});
  sheet->define("area and corner", {0, 1, 3, 4, 11});  // as of a region whose border cuts through elements
  sheet->define("edge and node", {0, 1, 2, 10});
  Model m(sheet, blend(), model::Options{});
  const std::string edge =
      ": set 'area and edge' is shared by the area of its elements, and beside them it has edges, which "
      "would "
      "get nothing (nodes 10, 11, 12): expected a call of their own";
  CHECK(message_of([&] { m.force("area and edge", up(1, 1)); }) == "force" + edge);
  CHECK(message_of([&] { m.add<model::MomentLoad>({"area and edge", up(1, 1)}); }) == "moment" + edge);
  CHECK(message_of([&] { m.add<model::TractionLoad>({"area and edge", up(1, 1)}); }) == "traction" + edge);
  CHECK(message_of([&] { m.add<model::GroundSpring>({"area and edge", {1, 0, 0}}); }) == "spring" + edge);
  CHECK(
      message_of([&] { m.force("edge and node", up(1, 1)); }) ==
      "force: set 'edge and node' is shared by the length of its edges, and beside them it has single nodes, "
      "which would get nothing (node 11): expected a call of their own");
  m.force("area and corner", up(1, 1));
  m.pressure("area and edge", history::History::ramp(1, 1));  // which acts on elements alone
}
