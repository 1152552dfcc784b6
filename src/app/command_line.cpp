#include "app/command_line.hpp"

#include <charconv>
#include <filesystem>
#include <sstream>

#include "base/number.hpp"
#include "base/suggest.hpp"
#include "system/paths.hpp"

namespace fabricsh::app {

const char* const usage =
    "usage: fabricsh [options] [deck.lua [arguments]]\n"
    "  fabricsh                 an interactive session\n"
    "  fabricsh deck.lua a b    runs a deck; it sees its arguments in `arg`\n"
    "  fabricsh scripts/...     a deck that came with the program is found from any folder\n"
    "options\n"
    "  -e 'chunk'    runs Lua text (the fields of fabric and fabric.units are globals there)\n"
    "  -i            interactive after the deck; with a pipe, Ctrl-C ends a statement, not the session\n"
    "  -l module     requires a Lua module\n"
    "  -             runs standard input as a deck\n"
    "  --check       validates everything, runs no analysis, writes no file\n"
    "  --strict      serious warnings of runs (ledger, inverted elements, ...) end them as failures do\n"
    "  --threads N   threads to use; else OMP_NUM_THREADS, else all cores\n"
    "  --safe        for decks from elsewhere: reads only the deck's folder, writes only --output\n"
    "  --output DIR  with --safe: the folder that is written (out)\n"
    "  --limit-memory MB        with --safe: memory of Lua (4096)\n"
    "  --limit-seconds S        with --safe: computing time of all threads (86400)\n"
    "  --limit-instructions N   with --safe: instructions of Lua (1e10)\n"
    "  --restart F   runs the deck; the analysis that wrote the checkpoint F begins where it was\n"
    "  --cases       lists the cases of the deck's fabric.study and computes none of them\n"
    "  --case K      computes case K of the deck's fabric.study, for a queue that starts each case by "
    "itself\n"
    "  --quiet       no progress and no remarks on standard error, only warnings\n"
    "  --version     versions of the program and of what it stands on\n"
    "  --help        this text\n"
    "exit codes: 0 done, 1 error in the deck, 2 wrong use, 3 numerical failure, 130 ended by Ctrl-C, 143 by "
    "SIGTERM, 129 by SIGHUP\n";

namespace {

constexpr double least_megabytes = 4;  // of which the library takes one and a half

// The long options in the usage text.
std::vector<std::string> long_options() {
  std::vector<std::string> words;
  std::istringstream lines(usage);
  for (std::string word; lines >> word;)
    if (word.starts_with("--") && word.size() > 2) words.push_back(word);
  return words;
}

// Reads options one by one up to the deck.
class OptionReader {
 public:
  OptionReader(CommandLine& command, int count) : c_(command), count_(static_cast<std::size_t>(count)) {}

  void read() {
    while (at_ < count_ && c_.error.empty() && !c_.has_deck && !closed_) option(c_.line[at_]);
    if (!c_.has_deck && at_ < count_ && c_.error.empty()) take_deck(c_.line[at_]);
    if (c_.error.empty() && !c_.safe && !only_safe_.empty())
      c_.error = "'" + only_safe_ + "' goes with --safe";
  }

 private:
  // A deck that came with the program is found from any folder by its name in the manual:
  // scripts/lab/characterise.lua.
  static std::string found(const std::string& name) {
    std::error_code error;
    if (!name.starts_with("scripts/") || std::filesystem::exists(name, error)) return name;
    const std::string own = data_file(name);
    return own.empty() ? name : own;
  }

  void take_deck(const std::string& name) {
    if (name.empty()) {  // for example from an unset variable of the shell
      c_.error = "the name of the deck is empty (- is standard input)";
      return;
    }
    c_.has_deck = true;
    c_.deck = name == "-" ? "" : found(name);
    c_.deck_place = at_;
    c_.arguments.assign(c_.line.begin() + static_cast<std::ptrdiff_t>(at_) + 1, c_.line.end());
  }

  // The value of -eX or of -e X.
  bool value(const std::string& word, std::string& out) {
    out = word.substr(2);
    ++at_;
    if (!out.empty()) return true;
    if (at_ >= count_) {
      c_.error = "'" + word + "' needs an argument";
      return false;
    }
    out = c_.line[at_++];
    return true;
  }

  void threads(const std::string& text) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, c_.threads);
    if (error != std::errc() || stop != end || c_.threads < 1 || c_.threads > 4096)
      c_.error = "--threads: expected an integer from 1 to 4096, got '" + text + "'";
  }

  // The value of --name=X or of --name X; false: another option, or no value.
  bool long_value(const std::string& word, const std::string& name, std::string& out) {
    if (word.rfind(name + "=", 0) == 0) {
      out = word.substr(name.size() + 1);
      ++at_;
      return true;
    }
    if (word != name) return false;
    if (++at_ < count_) return out = c_.line[at_++], true;
    c_.error = "'" + name + "' needs an argument";
    return false;
  }

  bool study_case(const std::string& word) {
    std::string text;
    if (!long_value(word, "--case", text)) return false;
    const auto end = text.data() + text.size();
    const auto [stop, wrong] = std::from_chars(text.data(), end, c_.study.only);
    if (wrong != std::errc() || stop != end || c_.study.only < 1)
      c_.error = "--case: expected the number of a case, from 1 on, got '" + text + "'";
    return true;
  }

  template <class Number>
  bool limit(const std::string& word, const std::string& name, double least, double most, Number& out) {
    std::string text;
    if (!long_value(word, name, text)) return !c_.error.empty();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !(value >= least) || value > most)
      c_.error = name + ": expected a number from " + fabricsh::number(least) + " to " +
                 fabricsh::number(most) + ", got '" + text + "'";
    else
      out = static_cast<Number>(value);
    return only_safe_ = name, true;
  }

  bool safe_option(const std::string& word) {
    if (word == "--safe") return ++at_, c_.safe = true;
    if (long_value(word, "--output", c_.output)) return only_safe_ = "--output", true;
    return limit(word, "--limit-memory", least_megabytes, 1e9, c_.limits.megabytes) ||
           limit(word, "--limit-seconds", 1, 1e9, c_.limits.seconds) ||
           limit(word, "--limit-instructions", 1, 1e18, c_.limits.instructions);
  }

  bool long_option(const std::string& word) {
    if (word == "--check") return c_.check = true;
    if (word == "--cases") return c_.study.list = true;
    if (word == "--quiet") return c_.quiet = true;
    if (word == "--strict") return c_.strict = true;
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
    } else if (safe_option(word) || study_case(word)) {
    } else if (word == "-i") {
      c_.interactive = true;
      ++at_;
    } else if (long_value(word, "--restart", c_.restart)) {
      if (c_.restart.empty()) c_.error = "'--restart' needs an argument";
    } else if (!c_.error.empty()) {
    } else if (word.rfind("--threads=", 0) == 0) {
      threads(word.substr(10));
      ++at_;
    } else if (word == "--threads") {
      if (++at_ < count_)
        threads(c_.line[at_++]);
      else
        c_.error = "'--threads' needs an argument";
    } else if (word[1] == 'e' || word[1] == 'l') {
      if (value(word, text)) c_.before.emplace_back(word[1], text);
    } else {
      c_.error = "unknown option '" + word + "'" + did_you_mean(word, long_options());
    }
  }

  CommandLine& c_;
  std::size_t count_;
  std::size_t at_ = 1;
  bool closed_ = false;
  std::string only_safe_;  // the last option that is valid only with --safe
};

}  // namespace

CommandLine read_command_line(int count, char** words) {
  CommandLine command;
  command.line.assign(words, words + count);
  OptionReader(command, count).read();
  return command;
}

}  // namespace fabricsh::app
