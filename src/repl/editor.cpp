#include "repl/editor.hpp"

#include <histedit.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace fabricsh::repl {

namespace {

constexpr int kept_lines = 2000;

class Stream : public Lines {
 public:
  explicit Stream(std::istream& in) : in_(in) {}
  State next(const std::string&, std::string& line) override {
    return std::getline(in_, line) ? State::line : State::end;
  }

 private:
  std::istream& in_;
};

class Terminal : public Lines {
 public:
  explicit Terminal(std::string file)
      : file_(std::move(file)), edit_(el_init("fabricsh", stdin, stdout, stderr)) {
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(edit_, EL_PROMPT, &Terminal::prompt_of);
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_SIGNAL, 0);
    history_ = history_init();
    HistEvent event;
    history(history_, &event, H_SETSIZE, kept_lines);
    history(history_, &event, H_SETUNIQUE, 1);
    if (!file_.empty()) history(history_, &event, H_LOAD, file_.c_str());
    el_set(edit_, EL_HIST, history, history_);
    el_source(edit_, nullptr);
  }
  ~Terminal() override {
    el_end(edit_);
    history_end(history_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  State next(const std::string& prompt, std::string& line) override {
    prompt_ = prompt;
    int count = 0;
    errno = 0;
    const char* text = el_gets(edit_, &count);
    if (text == nullptr || count <= 0) {
      if (errno != EINTR) {
        std::fputc('\n', stdout);
        return State::end;
      }
      el_reset(edit_);
      return State::interrupted;
    }
    line.assign(text, static_cast<std::size_t>(count));
    if (!line.empty() && line.back() == '\n') line.pop_back();
    return State::line;
  }

  void remember(const std::string& input) override {
    HistEvent event;
    if (input.empty()) return;
    history(history_, &event, H_ENTER, input.c_str());
    if (!file_.empty()) history(history_, &event, H_SAVE, file_.c_str());
  }

 private:
  static char* prompt_of(EditLine* edit) {
    void* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return static_cast<Terminal*>(self)->prompt_.data();
  }

  std::string file_, prompt_;
  EditLine* edit_;
  History* history_ = nullptr;
};

}  // namespace

std::unique_ptr<Lines> stream_lines(std::istream& in) { return std::make_unique<Stream>(in); }

std::unique_ptr<Lines> terminal_lines(const std::string& file) { return std::make_unique<Terminal>(file); }

std::string history_file() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return std::string(state) + "/fabricsh_history";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : std::string(home) + "/.fabricsh_history";
}

}  // namespace fabricsh::repl
