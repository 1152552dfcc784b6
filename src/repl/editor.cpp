#include "repl/editor.hpp"

#include <histedit.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <iterator>
#include <lua.hpp>
#include <string_view>

#include "repl/history.hpp"

namespace fabricsh::repl {

namespace {

constexpr int kept_inputs = 2000;
constexpr char literal = '\1';  // encloses characters without width on the screen

// Set by signals: Ctrl-C, change of the window's size, continuation after a stop.
volatile std::sig_atomic_t interrupted = 0, resized = 0, resumed = 0;
extern "C" void on_signal(int signal) {
  if (signal == SIGINT) interrupted = 1;
  if (signal == SIGWINCH) resized = 1;
  if (signal == SIGCONT) resumed = 1;
}

// While an object of this class exists, the editor handles these signals.
class Signals {
 public:
  Signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < std::size(numbers); ++i) sigaction(numbers[i], &action, &before_[i]);
  }
  ~Signals() {
    for (std::size_t i = 0; i < std::size(numbers); ++i) sigaction(numbers[i], &before_[i], nullptr);
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  // Waits for input or a signal, including one that came since the last key.
  static void wait_for_input() {
    sigset_t ours, usual;
    sigemptyset(&ours);
    for (const int number : numbers) sigaddset(&ours, number);
    sigprocmask(SIG_BLOCK, &ours, &usual);
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (interrupted == 0 && resized == 0 && resumed == 0) ppoll(&input, 1, nullptr, &usual);
    sigprocmask(SIG_SETMASK, &usual, nullptr);
  }

 private:
  static constexpr int numbers[] = {SIGINT, SIGWINCH, SIGCONT};
  struct sigaction before_[std::size(numbers)];
};

class Stream : public Lines {
 public:
  explicit Stream(std::istream& in) : in_(in) {}
  InputState next(const std::string&, std::string& line) override {
    return std::getline(in_, line) ? InputState::line : InputState::end;
  }

 private:
  std::istream& in_;
};

class Terminal : public Lines {
 public:
  explicit Terminal(TerminalOptions options)
      : options_(std::move(options)), file_(options_.history_file, kept_inputs) {
    const char* locale = std::setlocale(LC_CTYPE, "");  // for letters beyond ASCII
    if (locale == nullptr || std::string(locale) == "C") std::setlocale(LC_CTYPE, "C.UTF-8");
    edit_ = el_init("fabricsh", stdin, stdout, stderr);
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(edit_, EL_PROMPT_ESC, &Terminal::prompt_of, literal);
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_SIGNAL, 0);
    el_set(edit_, EL_GETCFN, &Terminal::get);
    el_set(edit_, EL_ADDFN, "fabricsh-complete", "completes the word before the cursor", &Terminal::tab);
    el_set(edit_, EL_BIND, "^I", "fabricsh-complete", nullptr);
    el_set(edit_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    load_history();
    el_source(edit_, nullptr);
  }
  ~Terminal() override {
    el_end(edit_);
    history_end(history_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  InputState next(const std::string& before, std::string& line) override {
    before_ = before;
    prompt_ = options_.style.dress(Tone::prompt, before.empty() ? ">" : ">>", std::string(1, literal)) + " ";
    el_resize(edit_);
    interrupted = 0;
    int count = 0;
    const char* text = get_line(count);
    if (text == nullptr || count <= 0) return stopped();
    line.assign(text, static_cast<std::size_t>(count));
    if (!line.empty() && line.back() == '\n') line.pop_back();
    return InputState::line;
  }

  void remember(const std::string& input) override {
    if (input.empty()) return;
    enter(input);
    file_.add(input);
  }

  bool interject(const std::string& text) override {
    if (!typing_) return false;
    std::fprintf(stdout, "\n%s\n", text.c_str());
    el_set(edit_, EL_REFRESH);
    return true;
  }

 private:
  static Terminal& of(EditLine* edit) {
    void* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return *static_cast<Terminal*>(self);
  }
  static char* prompt_of(EditLine* edit) { return of(edit).prompt_.data(); }
  static unsigned char tab(EditLine* edit, int) { return of(edit).complete(); }
  static int get(EditLine* edit, wchar_t* letter) { return of(edit).read_letter(*letter); }

  const char* get_line(int& count) {
    const Signals signals;
    typing_ = true;
    el_set(edit_, EL_PREP_TERM,
           1);  // before the prompt: input typed meanwhile would otherwise be echoed twice
    const char* text = el_gets(edit_, &count);
    typing_ = false;
    return text;
  }

  void load_history() {
    HistEvent event;
    history_ = history_init();
    history(history_, &event, H_SETSIZE, kept_inputs);
    history(history_, &event, H_SETUNIQUE, 1);
    for (const std::string& input : file_.load()) enter(input);
    el_set(edit_, EL_HIST, history, history_);
  }

  void enter(const std::string& input) {
    HistEvent event;
    history(history_, &event, H_ENTER, input.c_str());
  }

  InputState stopped() {
    el_reset(edit_);
    if (interrupted != 0) return InputState::interrupted;
    std::fputc('\n', stdout);
    return InputState::end;
  }

  // Returns 1 with a letter, 0 at the end, -1 if a signal or an error ends the reading.
  int read_letter(wchar_t& letter) {
    std::mbstate_t state{};
    while (true) {
      char byte = 0;
      Signals::wait_for_input();
      if (interrupted != 0) return -1;
      if (resized != 0 || resumed != 0) {
        redraw();
        continue;
      }
      const ssize_t count = read(STDIN_FILENO, &byte, 1);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return static_cast<int>(count);
      const std::size_t used = std::mbrtowc(&letter, &byte, 1, &state);
      if (used == static_cast<std::size_t>(-2)) continue;  // the letter has more bytes
      if (used == static_cast<std::size_t>(-1)) {
        state = {};
        continue;  // not a letter in this encoding
      }
      return 1;
    }
  }

  // After a change of the window's size, or of the terminal's mode while the program was stopped.
  void redraw() {
    if (resumed != 0) {
      el_set(edit_, EL_PREP_TERM, 0);
      el_set(edit_, EL_PREP_TERM, 1);
    }
    resized = 0;
    resumed = 0;
    const LineInfo* line = el_line(edit_);
    const auto above = std::count(line->buffer, line->cursor, '\n');
    if (above > 0) std::fprintf(stdout, "\033[%dA", static_cast<int>(above));
    std::fputs("\r\033[J", stdout);
    el_resize(edit_);
    el_set(edit_, EL_REFRESH);
  }

  // Tab inserts what all candidates begin with; a second Tab lists them. Without a word it inserts blanks.
  unsigned char complete() {
    const LineInfo* line = el_line(edit_);
    const std::string typed(line->buffer, line->cursor);
    if (typed.find_first_not_of(" \t") == std::string::npos) return insert("  ");
    if (!options_.complete) return CC_ERROR;
    const std::string text = before_.empty() ? typed : before_ + "\n" + typed;
    const Completion found = options_.complete(text);
    const std::size_t length = text.size() - found.from;
    if (found.candidates.empty()) return CC_REFRESH_BEEP;
    if (found.common.size() > length) return insert(found.common.substr(length));
    if (text != listed_) {
      listed_ = text;
      return found.candidates.size() > 1 ? CC_REFRESH_BEEP : CC_REFRESH;
    }
    std::fprintf(stdout, "\n%s", in_columns(found.candidates, width()).c_str());
    return CC_REDISPLAY;
  }

  unsigned char insert(const std::string& more) {
    listed_.clear();
    el_insertstr(edit_, more.c_str());
    return CC_REFRESH;
  }

  static std::size_t width() {
    winsize size{};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  }

  TerminalOptions options_;
  HistoryFile file_;
  std::string prompt_, before_;
  std::string listed_;  // the text at the previous Tab, if that had nothing to insert
  bool typing_ = false;
  EditLine* edit_ = nullptr;
  History* history_ = nullptr;
};

}  // namespace

std::unique_ptr<Lines> stream_lines(std::istream& in) { return std::make_unique<Stream>(in); }

std::unique_ptr<Lines> terminal_lines(TerminalOptions options) {
  return std::make_unique<Terminal>(std::move(options));
}

bool colours_wanted(bool terminal, const char* no_color, const char* term) {
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool able = term != nullptr && *term != '\0' && std::string_view(term) != "dumb";
  return terminal && !refused && able;
}

TerminalStyle TerminalStyle::of(int descriptor) {
  return TerminalStyle(colours_wanted(isatty(descriptor) != 0, std::getenv("NO_COLOR"), std::getenv("TERM")));
}

std::string TerminalStyle::dress(Tone tone, const std::string& text, const std::string& mark) const {
  if (!colours_ || text.empty()) return text;
  const char* code = tone == Tone::prompt ? "1;34" : tone == Tone::error ? "31" : "33";
  return mark + "\033[" + code + "m" + mark + text + mark + "\033[0m" + mark;
}

std::vector<Library> libraries() {
  return {{"Lua", LUA_VERSION_MAJOR "." LUA_VERSION_MINOR "." LUA_VERSION_RELEASE},
          {"libedit", std::to_string(LIBEDIT_MAJOR) + "." + std::to_string(LIBEDIT_MINOR)}};
}

}  // namespace fabricsh::repl
