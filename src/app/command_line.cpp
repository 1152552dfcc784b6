#include "app/command_line.hpp"

#include <charconv>

namespace fabricsh::app {

const char* const usage =
    "usage: fabricsh [options] [deck.lua [arguments]]\n"
    "  fabricsh                 an interactive session\n"
    "  fabricsh deck.lua a b    runs a deck; it sees its arguments in `arg`\n"
    "options\n"
    "  -e 'chunk'    runs Lua text (the fields of fabric and fabric.units are globals there)\n"
    "  -i            interactive after the deck\n"
    "  -l module     requires a Lua module\n"
    "  -             runs standard input as a deck\n"
    "  --check       validates everything, runs no analysis, writes no file\n"
    "  --threads N   threads to use; else OMP_NUM_THREADS, else all cores\n"
    "  --quiet       no progress on standard error\n"
    "  --version     versions of the program and of what it stands on\n"
    "  --help        this text\n"
    "exit codes: 0 done, 1 error in the deck, 2 wrong use, 3 numerical failure\n";

namespace {

// Reads options one by one; stops at the deck.
class Reader {
 public:
  Reader(CommandLine& command, int count) : c_(command), count_(static_cast<std::size_t>(count)) {}

  void read() {
    while (at_ < count_ && c_.trouble.empty() && !c_.has_deck && !closed_) option(c_.line[at_]);
    if (c_.has_deck || at_ >= count_ || !c_.trouble.empty()) return;
    take_deck(c_.line[at_]);
  }

 private:
  void take_deck(const std::string& name) {
    c_.has_deck = true;
    c_.deck = name == "-" ? "" : name;
    c_.deck_place = at_;
    c_.arguments.assign(c_.line.begin() + static_cast<std::ptrdiff_t>(at_) + 1, c_.line.end());
  }

  // The value of -eX, or of -e X.
  bool value(const std::string& word, std::string& out) {
    out = word.substr(2);
    ++at_;
    if (!out.empty()) return true;
    if (at_ >= count_) {
      c_.trouble = "'" + word + "' needs an argument";
      return false;
    }
    out = c_.line[at_++];
    return true;
  }

  void threads(const std::string& text) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, c_.threads);
    if (error != std::errc() || stop != end || c_.threads < 1 || c_.threads > 4096)
      c_.trouble = "--threads: expected an integer of at least 1, got '" + text + "'";
  }

  bool long_option(const std::string& word) {
    if (word == "--check") return c_.check = true;
    if (word == "--quiet") return c_.quiet = true;
    if (word == "--version" || word == "-v") return c_.version = true;
    if (word == "--help" || word == "-h") return c_.help = true;
    return false;
  }

  void option(const std::string& word) {
    std::string text;
    if (word == "-" || word.empty() || word[0] != '-') return take_deck(word);
    if (word == "--") {
      ++at_;
      closed_ = true;
    } else if (long_option(word)) {
      ++at_;
    } else if (word == "-i") {
      c_.interactive = true;
      ++at_;
    } else if (word.rfind("--threads=", 0) == 0) {
      threads(word.substr(10));
      ++at_;
    } else if (word == "--threads") {
      if (++at_ < count_)
        threads(c_.line[at_++]);
      else
        c_.trouble = "'--threads' needs an argument";
    } else if (word[1] == 'e' || word[1] == 'l') {
      if (value(word, text)) c_.before.emplace_back(word[1], text);
    } else {
      c_.trouble = "unknown option '" + word + "'";
    }
  }

  CommandLine& c_;
  std::size_t count_;
  std::size_t at_ = 1;
  bool closed_ = false;
};

}  // namespace

CommandLine read_command_line(int count, char** words) {
  CommandLine command;
  command.line.assign(words, words + count);
  Reader(command, count).read();
  return command;
}

}  // namespace fabricsh::app
