// The history file: inputs of several lines, several sessions at once.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "catch.hpp"
#include "repl/history.hpp"

using fabricsh::repl::HistoryFile;
using Inputs = std::vector<std::string>;

namespace {

std::string fresh(const std::string& name) {
  std::remove(name.c_str());
  return name;
}

}  // namespace

TEST_CASE("an input of several lines is one line of the file") {
  for (const std::string input : {"x", "for i = 1, 2 do\n  print '\\n'\nend", "a\\", "\\\\n", "\n\n", ""}) {
    const std::string line = fabricsh::repl::on_one_line(input);
    CHECK(line.find('\n') == std::string::npos);
    CHECK(fabricsh::repl::from_one_line(line) == input);
  }
}

TEST_CASE("inputs come back in their order, repeated ones once") {
  const HistoryFile file(fresh("folder/history"));
  CHECK(file.load().empty());
  CHECK(file.add("one"));
  CHECK(file.add("two\nlines"));
  CHECK(file.add("two\nlines"));
  CHECK(file.add("one"));
  CHECK_FALSE(file.add(""));
  CHECK(file.load() == Inputs{"one", "two\nlines", "one"});
  struct stat status {};
  REQUIRE(stat("folder/history", &status) == 0);
  CHECK((status.st_mode & 0777) == 0600);
  CHECK_FALSE(HistoryFile("").add("x"));
  CHECK_FALSE(HistoryFile("/dev/null/x").add("x"));
  CHECK(HistoryFile("/dev/null/x").load().empty());
}

TEST_CASE("a line that a crash cut off does not swallow the next") {
  std::ofstream(fresh("cut")) << "whole\nhal";
  const HistoryFile file("cut");
  CHECK(file.add("next"));
  CHECK(file.load() == Inputs{"whole", "hal", "next"});
}

TEST_CASE("a long history is shortened at its old end") {
  const HistoryFile file(fresh("long"), 3);
  for (int i = 1; i <= 7; ++i) file.add(std::to_string(i));
  CHECK(file.load() == Inputs{"5", "6", "7"});
  std::ifstream in("long");
  CHECK(std::count(std::istreambuf_iterator<char>(in), {}, '\n') == 3);
  CHECK(file.add("8"));
  CHECK(file.load() == Inputs{"6", "7", "8"});
}

TEST_CASE("sessions at the same time lose nothing of each other's") {
  constexpr int sessions = 4, inputs = 100;
  fresh("shared");
  for (int s = 0; s < sessions; ++s) {
    if (fork() != 0) continue;
    const HistoryFile file("shared", 10000);
    for (int i = 0; i < inputs; ++i) file.add(std::to_string(s) + "\n" + std::to_string(i));
    _exit(0);
  }
  while (wait(nullptr) > 0) continue;
  Inputs kept = HistoryFile("shared", 10000).load();
  CHECK(kept.size() == sessions * inputs);
  std::sort(kept.begin(), kept.end());
  CHECK(std::unique(kept.begin(), kept.end()) == kept.end());
}

TEST_CASE("an input added while another session shortens the file is kept") {
  const HistoryFile file(fresh("both"), 5);
  const pid_t other = fork();
  if (other == 0) {
    for (int i = 0; i < 300; ++i) file.load();
    _exit(0);
  }
  for (int i = 0; i < 300; ++i) {
    file.add(std::to_string(i));
    const Inputs kept = file.load();
    REQUIRE_FALSE(kept.empty());
    CHECK(kept.back() == std::to_string(i));
  }
  waitpid(other, nullptr, 0);
}
