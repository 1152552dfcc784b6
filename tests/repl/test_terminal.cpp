// The prompt on a terminal: a written session, colours, signals, notices while typing.
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "play.hpp"
#include "repl/editor.hpp"

using namespace fabricsh;

namespace {

using Variables = std::map<std::string, std::string>;

// The program in a folder, which is its home too.
std::function<int()> program(const std::string& folder, const Variables& more = {}) {
  return [folder, more] {
    std::filesystem::create_directories(folder);
    std::filesystem::current_path(folder);
    Variables variables{
        {"HOME", "."}, {"XDG_STATE_HOME", ""}, {"TERM", "vt100"}, {"LC_ALL", "C.UTF-8"}, {"NO_COLOR", ""}};
    for (const auto& [name, value] : more) variables[name] = value;
    return become(FABRICSH_PROGRAM, variables);
  };
}

bool shows(const Terminal& terminal, const std::string& text) {
  for (const std::string& line : terminal.screen.lines())
    if (line.find(text) != std::string::npos) return true;
  return false;
}

// Types keys once the prompt is there, then waits for a text.
bool answers(Terminal& terminal, const std::string& keys, const std::string& text) {
  const auto at_prompt = [&] { return terminal.screen.lines().back() == ">"; };
  if (!terminal.wait_for(at_prompt)) return false;
  terminal.type(keys);
  return terminal.wait_for([&] { return shows(terminal, text); });
}

}  // namespace

TEST_CASE("a session as it is written down") {
  std::filesystem::remove_all("written");
  const std::string folder = std::string(FABRICSH_SOURCE_DIR) + "/tests/repl/";
  for (const char* part : {"session.txt", "session_again.txt"}) {
    Terminal terminal(program("written"));
    CHECK(Player(terminal).play(folder + part) == "");
    CHECK(terminal.end() == 0);
  }
  CHECK(std::system("'" FABRICSH_PROGRAM "' written/session.lua > written/again.txt 2>&1") == 0);
}

TEST_CASE("colours on a terminal, and none where nobody wants them") {
  const std::string red = "\033[31m", blue = "\033[1;34m", yellow = "\033[33m";
  {
    Terminal plain(program("colours"));
    CHECK(answers(plain, "error 'no'\r", "prompt:1: no"));
    CHECK(answers(plain, "fabric.warn 'mind'\r", "warning: prompt:1: mind"));
    CHECK(answers(plain, "\4", "> "));
    for (const std::string& colour : {red, blue, yellow})
      CHECK(plain.bytes.find(colour) != std::string::npos);
  }
  for (const Variables& wish : {Variables{{"NO_COLOR", "1"}}, Variables{{"TERM", "dumb"}}}) {
    Terminal terminal(program("colours", wish));
    CHECK(answers(terminal, "error 'no'\r", "prompt:1: no"));
    for (const std::string& colour : {red, blue, yellow})
      CHECK(terminal.bytes.find(colour) == std::string::npos);
    CHECK(terminal.bytes.find("\033[0m") == std::string::npos);
  }
}

TEST_CASE("a second Ctrl-C quits, a first one never does at the prompt") {
  std::filesystem::remove_all("quits");
  Terminal terminal(program("quits"));
  for (int i = 0; i < 3; ++i) {
    CHECK(answers(terminal, "half " + std::to_string(i), "half " + std::to_string(i)));
    const std::size_t lines = terminal.screen.lines().size();
    terminal.type("\3");
    CHECK(terminal.wait_for([&] { return terminal.screen.lines().size() > lines; }));
  }
  // said within the protected call, so that the first Ctrl-C finds it there
  const std::string forever =
      "while true do pcall(function() io.write('bu', 'sy\\n') while true do end end) io.write('ag', "
      "'ain\\n') end";
  CHECK(answers(terminal, forever + "\r", "busy"));
  terminal.type("\3");
  // only when the first has been answered: two signals that wait are one
  CHECK(terminal.wait_for([&] { return shows(terminal, "again"); }));
  terminal.type("\3");
  CHECK(terminal.end() == 128 + SIGINT);
  std::ifstream history("quits/.fabricsh_history");  // what quit the program is in it
  std::string line;
  CHECK(std::getline(history, line));
  CHECK(line.find("while true") != std::string::npos);
}

TEST_CASE("Ctrl-C while a key is being answered drops the line, without another key") {
  Terminal terminal([] {
    setenv("TERM", "vt100", 1);
    repl::TerminalOptions options;
    options.complete = [](const std::string& text) {
      std::raise(SIGINT);
      return repl::Completion{text.size()};
    };
    std::string line;
    const bool dropped =
        repl::terminal_lines(options)->next("", line) == repl::Lines::InputState::interrupted;
    return dropped ? 0 : 1;
  });
  CHECK(terminal.wait_for([&] { return terminal.screen.lines().back() == ">"; }));
  terminal.type("ab\t");
  CHECK(terminal.end() == 0);
}

TEST_CASE("a notice while a line is typed leaves the line whole") {
  Terminal terminal([] {
    setenv("TERM", "vt100", 1);
    std::unique_ptr<repl::Lines> talking;
    repl::TerminalOptions options;
    options.complete = [&talking](const std::string& text) {
      talking->interject("warning: heard");
      return repl::Completion{text.size()};
    };
    talking = repl::terminal_lines(options);
    std::string line;
    talking->next("", line);
    std::printf("got [%s]\n", line.c_str());
    std::fflush(stdout);
    return talking->interject("no line is typed now") ? 1 : 0;
  });
  CHECK(terminal.wait_for([&] { return terminal.screen.lines().back() == ">"; }));
  terminal.type("ab\tc\r");
  CHECK(terminal.wait_for([&] { return shows(terminal, "got [abc]"); }));
  const auto lines = terminal.screen.lines();
  CHECK(lines[1] == "warning: heard");
  CHECK(lines[2] == "> abc");
  CHECK(terminal.end() == 0);
}
