// Two processes that write the same outputs: the second is told, the first goes on.
#include "app/program.hpp"
#include "catch.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
namespace fs = std::filesystem;

namespace {

// A run with all outputs in the folder `both`, which waits in its hook until there is a file `go`.
const std::string waiting_deck =
    "local fabric = require 'fabric'\n"
    "local m = fabric.model{ mesh=fabric.mesh.rectangle{ width=0.2, height=0.1, nx=2, ny=1 },"
    " card=fabric.card 'blend' }\n"
    "m:fix('left', 'x y z'):fix('all', 'z rotation'):move('right', { x=fabric.ramp(1e-3, 1), y=0 })\n"
    "local a = fabric.static{ model=m, duration=1, step=0.25 }\n"
    "a:record('both/curve.csv', { columns={ t=function(a) return a.time end } })\n"
    "a:vtk('both/pull')\n"
    "a:checkpoint('both/run.ckpt', { every=0.25 })\n"
    "a:every('step', function() io.stderr:write 'busy' while not io.open 'go' do end end)\n"
    "a:solve()\n";

void begin() {
  fs::remove_all("both");
  fs::remove("go");
  fs::remove("first.log");
  std::ofstream("both.lua") << waiting_deck;
}

// Waits until the program says that it is within its run.
void await(const Program& program) {
  while (content_of("first.log").find("busy") == std::string::npos && program.runs()) usleep(5000);
  REQUIRE(program.runs());
}

}  // namespace

TEST_CASE("a second process is told who writes, and the first loses nothing") {
  begin();
  std::ofstream("go") << "go";
  REQUIRE(Program({"--quiet", "both.lua"}).wait() == 0);
  const auto wanted = files_of("both");
  CHECK(wanted.count(".fabricsh.lock") == 0);
  begin();
  Program first({"--quiet", "both.lua"}, "first.log");
  await(first);
  const auto before = files_of("both");
  for (int i = 0; i < 3; ++i) {
    CHECK(Program({"--quiet", "both.lua"}, "second.log").wait() == 1);
    CHECK(content_of("second.log")
              .find("both.lua:5: record: 'both/curve.csv' is being written by another process") !=
          std::string::npos);
  }
  CHECK(files_of("both") == before);
  std::ofstream("go") << "go";
  CHECK(first.wait() == 0);
  CHECK(files_of("both") == wanted);
  CHECK(Program({"--quiet", "both.lua"}).wait() == 0);
}

TEST_CASE("outputs of a process that was killed are free") {
  begin();
  Program first({"--quiet", "both.lua"}, "first.log");
  await(first);
  CHECK(first.end(SIGKILL) == 128 + SIGKILL);
  CHECK(fs::exists("both/.fabricsh.lock"));
  std::ofstream("go") << "go";
  CHECK(Program({"--quiet", "both.lua"}).wait() == 0);
  CHECK_FALSE(fs::exists("both/.fabricsh.lock"));
}

TEST_CASE("other outputs in the same folder are none of its business") {
  begin();
  Program first({"--quiet", "both.lua"}, "first.log");
  await(first);
  std::string other = waiting_deck;
  for (const std::string name : {"curve", "pull", "run.ckpt"})
    other.replace(other.find("both/" + name), 5, "both/other-");
  std::ofstream("other.lua") << other.substr(0, other.find("a:every")) << "a:solve()\n";
  CHECK(Program({"--quiet", "other.lua"}).wait() == 0);
  std::ofstream("go") << "go";
  CHECK(first.wait() == 0);
}
