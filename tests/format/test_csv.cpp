#include <clocale>
#include <cmath>
#include <limits>

#include "format/csv.hpp"
#include "message_of.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::format;

namespace {

void add(CsvWriter& table, std::vector<double> values) { table.row(values); }

}  // namespace

TEST_CASE("a table is whole after each row", "[files]") {
  const ScratchFolder folder;
  CsvWriter table(folder / "out/curve.csv", {"time", "force"});
  CHECK(content_of(folder / "out/curve.csv") == "time,force\n");
  add(table, {0, -1.5});
  CHECK(content_of(folder / "out/curve.csv") == "time,force\n0,-1.5\n");
  add(table, {0.1, 1e300});
  CHECK(content_of(folder / "out/curve.csv") ==
        "time,force\n0,-1.5\n0.10000000000000001,1.0000000000000001e+300\n");
  CHECK(table.columns() == 2);
}

TEST_CASE("numbers read back to the same double", "[files]") {
  const ScratchFolder folder;
  const std::vector<double> values = {1.0 / 3.0, std::nextafter(1.0, 2.0), -0.0, 5e-324,
                                      std::numeric_limits<double>::max()};
  CsvWriter table(folder / "x.csv", {"v"});
  for (const double v : values) add(table, {v});
  std::istringstream text(content_of(folder / "x.csv"));
  std::string line;
  std::getline(text, line);
  for (const double v : values) {
    std::getline(text, line);
    CHECK(std::strtod(line.c_str(), nullptr) == v);
  }
}

TEST_CASE("a value that is no number is written by its word", "[files]") {
  const ScratchFolder folder;
  CsvWriter table(folder / "x.csv", {"a", "b", "c"});
  const double infinity = std::numeric_limits<double>::infinity();
  add(table, {-std::numeric_limits<double>::quiet_NaN(), infinity, -infinity});
  CHECK(content_of(folder / "x.csv") == "a,b,c\nnan,inf,-inf\n");
}

TEST_CASE("names with commas and quotes are quoted", "[files]") {
  const ScratchFolder folder;
  const CsvWriter table(folder / "x.csv", {"E, -", "the \"S\"", "plain"});
  CHECK(content_of(folder / "x.csv") == "\"E, -\",\"the \"\"S\"\"\",plain\n");
}

TEST_CASE("bad tables are refused and leave no file", "[files]") {
  const ScratchFolder folder;
  says(message_of([&] { CsvWriter(folder / "x.csv", {}); }), "at least one column");
  says(message_of([&] { CsvWriter(folder / "x.csv", {"a", "b", "a"}); }), "two columns are named 'a'");
  says(message_of([&] { CsvWriter(folder / "x.csv", {""}); }), "no name");
  CHECK(folder.listing().empty());
  CsvWriter table(folder / "x.csv", {"a", "b"});
  says(message_of([&] { add(table, {1}); }), "expected 2 values in a row, got 1");
}

TEST_CASE("a table that cannot be written says the path and the reason", "[files]") {
  const ScratchFolder folder;
  std::ofstream(folder / "plain") << "x";
  says(message_of([&] { CsvWriter(folder / "plain/x.csv", {"a"}); }), "Not a directory");
  says(message_of([&] { CsvWriter(folder.path, {"a"}); }), "Is a directory");
  says(message_of([] { CsvWriter("/dev/full", {"a"}); }),
       "cannot write '/dev/full': No space left on device");
}
