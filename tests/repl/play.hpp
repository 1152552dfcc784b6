// Plays a written session on a terminal. Its lines:
//   > text, >> text   waits for that prompt, types the text and Enter
//   ~ keys            types keys as they are: <tab> <up> <enter> <ctrl-c> ..., <see text> waits for a text on
//   the screen | text            the screen shows this line next; so does any other line # text nothing
// Three dots in a shown line stand for anything, a line of three dots for any lines.
#pragma once
#include <fstream>
#include <string>
#include <vector>

#include "terminal.hpp"

class Player {
 public:
  explicit Player(Terminal& terminal) : terminal_(terminal) {}

  // Empty, or what went wrong.
  std::string play(const std::string& file) {
    std::ifstream in(file);
    if (!in) return "no " + file;
    for (std::string line; std::getline(in, line) && trouble_.empty(); ++number_) act(line);
    if (trouble_.empty()) expect_shown();
    return trouble_.empty() ? "" : file + ":" + std::to_string(number_) + ": " + trouble_;
  }

 private:
  void act(const std::string& line) {
    if (line.empty() || line.starts_with("#")) return;
    const bool fresh = line.starts_with("> "), more = line.starts_with(">> ");
    if (!fresh && !more && !line.starts_with("~ ")) {
      shown_.push_back(line.starts_with("|") ? line.substr(std::min<std::size_t>(line.size(), 2)) : line);
      return;
    }
    expect_shown();
    if (!trouble_.empty()) return;
    if (line.starts_with("~ ")) return press(line.substr(2));
    await_prompt(fresh ? ">" : ">>");
    terminal_.type(line.substr(fresh ? 2 : 3) + "\r");
    shown_ = {line};
    typing_ = false;
  }

  void await_prompt(const std::string& prompt) {
    typing_ = true;
    shown_ = {prompt};
    expect_shown();
  }

  void press(const std::string& keys) {
    if (!typing_ && !keys.starts_with("<see ")) await_prompt(">...");
    typing_ = true;
    for (std::size_t i = 0; i < keys.size() && trouble_.empty(); ++i) {
      const std::size_t close = keys.find('>', i);
      const bool named = keys[i] == '<' && close != std::string::npos;
      if (!named) {
        terminal_.type(keys.substr(i, 1));
        continue;
      }
      named_key(keys.substr(i + 1, close - i - 1));
      i = close;
    }
  }

  void named_key(const std::string& name) {
    static const std::map<std::string, std::string> keys = {
        {"tab", "\t"},    {"enter", "\r"},  {"up", "\033[A"}, {"down", "\033[B"}, {"left", "\033[D"},
        {"ctrl-a", "\1"}, {"ctrl-c", "\3"}, {"ctrl-d", "\4"}, {"ctrl-r", "\22"},  {"space", " "}};
    if (name.starts_with("see ")) {
      const std::string text = name.substr(4);
      const bool seen = terminal_.wait_for([&] {
        const auto lines = terminal_.screen.lines();
        return std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(at_), lines.end(),
                           [&](const std::string& line) { return line.find(text) != std::string::npos; });
      });
      if (!seen) fail("'" + text + "' is not seen");
      return;
    }
    if (!keys.contains(name)) return fail("no key <" + name + ">");
    typing_ = name != "enter" && name != "ctrl-c" && name != "ctrl-d";
    terminal_.type(keys.at(name));
  }

  // Waits until the lines that are to be shown are on the screen; while typing goes on, the last one stays
  // open.
  void expect_shown() {
    if (shown_.empty()) return;
    std::size_t end = 0;
    const bool there = terminal_.wait_for([&] {
      const auto lines = terminal_.screen.lines();
      return match(lines, at_, 0, end) &&
             (typing_ || end < lines.size());  // a finished line, unless it is typed
    });
    if (!there) return fail("the screen is not as expected");
    at_ = typing_ ? end - 1 : end;
    shown_.clear();
  }

  bool match(const std::vector<std::string>& lines, std::size_t line, std::size_t wanted,
             std::size_t& end) const {
    if (wanted == shown_.size()) return end = line, true;
    if (shown_[wanted] == "..." && wanted + 1 == shown_.size()) {  // up to the prompt
      for (end = line; end < lines.size(); ++end)
        if (lines[end].starts_with(">")) return true;
      return false;
    }
    if (shown_[wanted] == "...")
      for (std::size_t skip = line; skip <= lines.size(); ++skip)
        if (match(lines, skip, wanted + 1, end)) return true;
    return line < lines.size() && alike(shown_[wanted], lines[line]) &&
           match(lines, line + 1, wanted + 1, end);
  }

  static bool alike(const std::string& pattern, const std::string& text) {
    const std::size_t dots = pattern.find("...");
    if (dots == std::string::npos) return pattern == text;
    if (text.compare(0, dots, pattern, 0, dots) != 0) return false;
    const std::string rest = pattern.substr(dots + 3);
    for (std::size_t from = dots; from <= text.size(); ++from)
      if (alike(rest, text.substr(from))) return true;
    return false;
  }

  void fail(const std::string& why) {
    trouble_ = why + "\nexpected next:\n";
    for (const std::string& line : shown_) trouble_ += "| " + line + "\n";
    trouble_ += "the screen from there:\n";
    const auto lines = terminal_.screen.lines();
    for (std::size_t i = at_; i < lines.size(); ++i) trouble_ += "| " + lines[i] + "\n";
  }

  Terminal& terminal_;
  std::size_t at_ = 0;              // lines of the screen that have been compared
  std::vector<std::string> shown_;  // lines that must come next
  bool typing_ = false;
  std::size_t number_ = 1;
  std::string trouble_;
};
