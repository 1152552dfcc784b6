// kill -9, SIGTERM and SIGINT at random moments of runs with all outputs on: each file opens, a restart goes
// on, and the results are those of the undisturbed run, bit for bit.
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <random>
#include <thread>

#include "app/program.hpp"
#include "catch.hpp"
#include "format/checkpoint.hpp"
#include "format/mesh_file.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
namespace fs = std::filesystem;

namespace {

// Checkpoints also hold how often the run was restarted, which its user's files do not.
bool is_checkpoint(const std::string& name) { return name.find(".ckpt") != std::string::npos; }

const std::string killed_deck = FABRICSH_SOURCE_DIR "/tests/app/decks/killed.lua";

// Each line has as many numbers as the header has names, and an end.
void check_csv(const std::string& text) {
  REQUIRE(!text.empty());
  REQUIRE(text.back() == '\n');
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto commas = std::count(line.begin(), line.end(), ',');
  REQUIRE(line.starts_with("time (s),"));
  while (std::getline(lines, line)) {
    REQUIRE(std::count(line.begin(), line.end(), ',') == commas);
    const char* at = line.c_str();
    for (long i = 0; i <= commas; ++i) {
      char* end = nullptr;
      REQUIRE(std::isfinite(std::strtod(at, &end)));
      REQUIRE(end != at);
      at = end + 1;
    }
  }
}

// The index is whole and every frame that it names can be read.
std::size_t check_series(const fs::path& folder, const std::string& text) {
  REQUIRE(text.starts_with("<?xml version=\"1.0\"?>\n<VTKFile"));
  REQUIRE(text.ends_with("  </Collection>\n</VTKFile>\n"));
  std::size_t frames = 0;
  const std::string mark = "file=\"";
  for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at), ++frames) {
    at += mark.size();
    const std::string name = text.substr(at, text.find('"', at) - at);
    REQUIRE(!format::read_mesh((folder / name).string()).nodes.empty());
  }
  return frames;
}

void check_json(const std::string& text) {
  REQUIRE(text.starts_with("{\n"));
  REQUIRE((text.ends_with("}\n") || text.ends_with("}")));
  REQUIRE(std::count(text.begin(), text.end(), '{') == std::count(text.begin(), text.end(), '}'));
  REQUIRE(text.find("\"status\": ") != std::string::npos);
}

void check_folder(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    INFO(name);
    const std::string text = content_of(entry.path());
    if (name.ends_with(".part")) continue;  // what was being written; the next run takes it away
    if (name.ends_with(".csv")) check_csv(text);
    if (name.ends_with(".pvd")) check_series(folder, text);
    if (name == "run.json") check_json(text);
    if (name == "run.ckpt") format::read_checkpoint(entry.path().string());
  }
}

std::vector<std::string> words_for(const fs::path& folder, int threads) {
  std::vector<std::string> words{"--quiet", "--threads", std::to_string(threads)};
  const std::string checkpoint = (folder / "run.ckpt").string();
  if (fs::exists(checkpoint)) words.insert(words.end(), {"--restart", checkpoint});
  words.insert(words.end(), {killed_deck, folder.string()});
  return words;
}

struct Tally {
  int kills = 0, asked = 0, restarts = 0, finished = 0;  // asked: ended by SIGTERM or SIGINT
};

// Goes on until there were as many kills, and as many restarts from a checkpoint.
Tally kill_often(int kills, int restarts, unsigned seed) {
  fs::remove_all("whole");
  fs::remove_all("killed");
  const auto start = std::chrono::steady_clock::now();
  REQUIRE(Program(words_for("whole", 1)).wait() == 0);
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
  const auto wanted = files_of("whole");
  REQUIRE(wanted.count("explicit.txt") == 1);
  REQUIRE(wanted.size() > 40);
  std::mt19937 random(seed);
  Tally tally;
  const auto finish = [&] {
    REQUIRE(Program(words_for("killed", 1 + tally.kills % 2)).wait() == 0);
    check_folder("killed");
    const auto got = files_of("killed");
    for (const auto& [name, text] : wanted) {
      INFO(name);
      REQUIRE(got.count(name) == 1);
      if (!is_checkpoint(name)) CHECK((got.at(name) == text));
    }
    CHECK(got.size() == wanted.size());
    ++tally.finished;
    fs::remove_all("killed");
  };
  while (tally.kills < kills || tally.restarts < restarts) {
    // Up to half of what the whole run takes, with luck in each of its parts.
    const double wait = whole.count() / 2 * static_cast<double>(random()) / 4294967296.0;
    const auto words = words_for("killed", 1 + tally.kills % 2);
    if (words.size() > 5) ++tally.restarts;
    Program program(words, "killed.log");
    std::this_thread::sleep_for(std::chrono::duration<double>(wait));
    const int signals[] = {SIGKILL, SIGTERM, SIGKILL, SIGINT};
    const int signal = signals[random() % 4];
    const int code = program.end(signal);
    INFO(signal << ": " << content_of("killed.log"));
    REQUIRE((code == 128 + signal || code == 0));
    check_folder("killed");
    if (code != 0) ++tally.kills;
    if (code != 0 && signal != SIGKILL) ++tally.asked;
    if (code == 0 || tally.kills % 9 == 8) finish();
  }
  finish();
  return tally;
}

}  // namespace

TEST_CASE("killed five times, all files open and the results are the same bits") { kill_often(5, 2, 1); }

TEST_CASE("killed two hundred times, all files open and the results are the same bits", "[long]") {
  const Tally tally = kill_often(200, 100, 8);
  WARN(tally.kills << " kills, " << tally.asked << " of them by SIGTERM or SIGINT, " << tally.restarts
                   << " restarts from a checkpoint, " << tally.finished
                   << " runs finished, all with the bits of the undisturbed run");
}

namespace {

// So many as files_of() reads, without reading them.
std::size_t files_in(const fs::path& folder) {
  if (!fs::exists(folder)) return 0;
  return static_cast<std::size_t>(std::count_if(
      fs::directory_iterator(folder), fs::directory_iterator(), [](const fs::directory_entry& entry) {
        return entry.path().filename() != "run.json" && entry.path().filename() != "run.ckpt";
      }));
}

}  // namespace

TEST_CASE("Ctrl-C ends a script with its outputs whole, and a restart gives the same bits") {
  fs::remove_all("whole");
  fs::remove_all("stopped");
  REQUIRE(Program(words_for("whole", 1)).wait() == 0);
  const auto wanted = files_of("whole");
  int stopped = 0;
  // When it has written another fifth of its files, whatever time that takes.
  for (std::size_t fifth = 1; fifth < 4; ++fifth) {
    Program program(words_for("stopped", 1), "stopped.log");
    while (files_in("stopped") < fifth * wanted.size() / 5 && program.runs()) usleep(1000);
    const int code = program.end(SIGINT);
    const std::string said = content_of("stopped.log");
    INFO(said);
    REQUIRE((code == 130 || code == 0));
    if (code == 0) break;
    CHECK(said.find("interrupted") != std::string::npos);
    check_folder("stopped");
    if (fs::exists("stopped/run.json") && said.find("the run is kept") != std::string::npos) {
      CHECK(content_of("stopped/run.json").find("\"status\": \"interrupted\"") != std::string::npos);
      ++stopped;
    }
  }
  CHECK(stopped >= 1);
  REQUIRE(Program(words_for("stopped", 2)).wait() == 0);
  const auto got = files_of("stopped");
  for (const auto& [name, text] : wanted) {
    INFO(name);
    REQUIRE(got.count(name) == 1);
    if (!is_checkpoint(name)) CHECK((got.at(name) == text));
  }
  CHECK(got.size() == wanted.size());
}

namespace {

// A deck that says "busy" and then stays within one function of Lua's for hours.
const std::string endless = "io.stderr:write 'busy' ; (('a'):rep(40)):find(('.-'):rep(20) .. 'b')\n";

void write_deck(const std::string& name, const std::string& text) { std::ofstream(name) << text; }

// Waits until the log has the word.
bool shows(const std::string& log, const std::string& word) {
  for (int i = 0; i < 1200 && content_of(log).find(word) == std::string::npos; ++i) usleep(50'000);
  return content_of(log).find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("a signal ends what does not come to an answer, with its exit code and whole files") {
  write_deck("endless.lua", endless);
  const std::string hook =
      "local fabric = require 'fabric'\n"
      "local m = fabric.model{ mesh=fabric.mesh.rectangle{ width=0.1, height=0.1, nx=1, ny=1 },"
      " card=fabric.card 'blend' }\n"
      "m:fix('bottom', 'x y z'):move('top', { y=fabric.ramp(1e-4, 1), z=0 })\n"
      "local a = fabric.static{ model=m, duration=1, step=0.5 }\n"
      "a:record('endless/curve.csv', { every='step', columns={ t=function(a) return a.time end } })\n"
      "a:every('step', function() " +
      endless + " end)\na:solve()\n";
  write_deck("endless_hook.lua", hook);
  write_deck("endless_caught.lua",
             "while true do pcall(function() io.stderr:write 'busy' while true do end end)"
             " io.stderr:write 'caught' end\n");
  // Each takes the ten seconds that the program gives a deck to come to an answer, so that they run at once.
  struct Case {
    std::string deck, log;
    int signal;
  };
  const Case cases[] = {{"endless.lua", "endless_1.log", SIGINT},
                        {"endless.lua", "endless_2.log", SIGHUP},
                        {"endless_hook.lua", "endless_3.log", SIGTERM}};
  fs::remove_all("endless");
  for (const char* log : {"endless_1.log", "endless_2.log", "endless_3.log", "endless_caught.log"})
    fs::remove(log);
  std::vector<std::unique_ptr<Program>> programs;
  for (const Case& c : cases)
    programs.push_back(std::make_unique<Program>(std::vector<std::string>{"--quiet", c.deck}, c.log));
  Program caught({"--quiet", "endless_caught.lua"}, "endless_caught.log");
  for (std::size_t i = 0; i < programs.size(); ++i) {
    REQUIRE(shows(cases[i].log, "busy"));
    programs[i]->signal(cases[i].signal);
  }
  REQUIRE(shows("endless_caught.log", "busy"));
  caught.signal(SIGTERM);
  REQUIRE(shows("endless_caught.log", "caught"));
  caught.signal(SIGTERM);  // as a shell hands on what came to its job
  sleep(3);
  CHECK(caught.end(SIGTERM) == 128 + SIGTERM);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    INFO(cases[i].deck << ", " << cases[i].signal);
    CHECK(programs[i]->wait() == 128 + cases[i].signal);
  }
  check_folder("endless");
}

TEST_CASE("Ctrl-C while statements come from a pipe ends the session as it ends a deck") {
  write_deck("piped.lua",
             "io.stderr:write 'busy' while true do end\nio.stderr:write 'next'\nio.stderr:write 'last'\n");
  fs::remove("piped.log");
  Program running({"--quiet"}, "piped.log", "piped.lua");
  REQUIRE(shows("piped.log", "busy"));
  CHECK(running.end(SIGINT) == 128 + SIGINT);
  CHECK(content_of("piped.log").find("interrupted") != std::string::npos);
  CHECK(content_of("piped.log").find("next") == std::string::npos);
  // also where a pcall has caught it
  write_deck("piped.lua",
             "pcall(function() io.stderr:write 'busy' while true do end end)\nio.stderr:write 'next'\n");
  fs::remove("piped.log");
  Program caught({"--quiet"}, "piped.log", "piped.lua");
  REQUIRE(shows("piped.log", "busy"));
  CHECK(caught.end(SIGINT) == 128 + SIGINT);
  CHECK(content_of("piped.log").find("next") == std::string::npos);
  // and while it waits for the next statement
  fs::remove("piped");
  REQUIRE(mkfifo("piped", 0600) == 0);
  fs::remove("piped.log");
  Program waiting({"--quiet"}, "piped.log", "piped");
  std::ofstream("piped") << "io.stderr:write 'ready'" << std::endl;
  REQUIRE(shows("piped.log", "ready"));
  // most likely; where it is not yet waiting, the end is the same
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  CHECK(waiting.end(SIGINT) == 128 + SIGINT);
  for (int i = 0; i < 5; ++i) {  // a signal at any moment after a statement
    fs::remove("piped.log");
    Program soon({"--quiet"}, "piped.log", "piped");
    std::ofstream("piped") << "io.stderr:write 'ready'" << std::endl;
    REQUIRE(shows("piped.log", "ready"));
    usleep(200 * i);
    CHECK(soon.end(SIGINT) == 128 + SIGINT);
  }
}