#include "repl/prompt.hpp"

#include <csignal>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "repl/commands.hpp"
#include "repl/deck_text.hpp"
#include "repl/lexer.hpp"
#include "script/called_off.hpp"
#include "script/covered.hpp"
#include "script/transcript.hpp"

namespace fabricsh::repl {

namespace {

// A signal handler can be given nothing: what it needs has to be here.
script::Session* interruptible = nullptr;
volatile std::sig_atomic_t running = 0, asked = 0;  // is something running; Ctrl-C came while it did
volatile std::sig_atomic_t between = 0;             // Ctrl-C came between two lines

constexpr int kPatience = 10'000'000;  // instructions that a hook of a run may take to come to its end

void stop_late(lua_State* L, lua_Debug*);

// Lua code stops at once, but in a hook of a run, which answers after its step.
void stop(lua_State* L, bool late) {
  script::Session& session = script::Session::of(L);
  session.rest_hook(L);
  if (!session.interrupted()) return;
  if (session.drives() && !late) {
    if (session.limits() == nullptr) lua_sethook(L, stop_late, LUA_MASKCOUNT, kPatience);
    return;
  }
  session.take_interrupt();
  script::call_off(session);
  luaL_error(L, "interrupted");
}

void stop_lua(lua_State* L, lua_Debug*) { stop(L, false); }

void stop_late(lua_State* L, lua_Debug*) { stop(L, true); }

void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// While a line is being typed Ctrl-C need only wake the reader. SIGTERM may come several times (to each
// process of a job, and handed on by its shell): the first counts.
extern "C" void on_interrupt_or_end(int signal) {
  if (interruptible == nullptr) return;
  if (signal != SIGINT) {
    if (running == 0) return end_by(signal);
    if (interruptible->terminated() != 0) return;
    interruptible->terminate(signal);
  } else {
    if (running == 0) {
      between = 1;
      return;
    }
    if (asked != 0) end_by(signal);
    interruptible->interrupt();
  }
  asked = 1;
  lua_sethook(interruptible->active(), stop_lua, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT,
              1);
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART: a read at the prompt is interrupted too
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup stays what it is
}

void show(const Result& result, const Voice& voice) {
  std::fflush(stdout);
  if (!result.message.empty()) voice.err << voice.style.dress(Tone::error, result.message) << std::endl;
  if (!result.shown.empty()) voice.out << result.shown << std::endl;
}

// An input that was done is kept, whatever happens to the transcript's file.
void keep(script::Session& session, const std::string& text, const Voice& voice) {
  try {
    script::transcript_of(session.lua()).add(text);
  } catch (const Error& trouble) {
    voice.err << voice.style.dress(Tone::notice, std::string("warning: transcript: ") + trouble.what())
              << std::endl;
  }
}

Outcome run(script::Session& session, const std::string& input, const Voice& voice) {
  const std::string words = advice(input);
  if (!words.empty()) voice.err << voice.style.dress(Tone::notice, words) << std::endl;
  const int changes = script::transcript_of(session.lua()).changes();
  Result result;
  {
    const Running guard(session);
    result = evaluate(session, input);
  }
  show(result, voice);
  if (script::transcript_of(session.lua()).changes() == changes)
    keep(session, deck_text(input, result), voice);
  return result.outcome;
}

// Names of the library's and of Lua's that stand for what they did when the session began.
class OwnNames {
 public:
  explicit OwnNames(script::Session& session) : L_(session.lua()), names_(script::names_as_made(L_)) {}
  // Says once of each name that it has been assigned over.
  void look(const Voice& voice) {
    const auto now = script::names_as_made(L_);
    for (const std::string& name : names_)
      if (now.count(name) == 0)
        voice.err << voice.style.dress(Tone::notice, script::covered_words(L_, name)) << std::endl;
    std::erase_if(names_, [&now](const std::string& name) { return now.count(name) == 0; });
  }

 private:
  lua_State* L_;
  std::set<std::string> names_;
};

// Does an input that goes on end, since Ctrl-C came while no line was being typed?
bool drop_between(const std::string& input) {
  const bool came = between != 0;
  between = 0;
  return came && !input.empty();
}

bool blank(const std::string& text) { return text.find_first_not_of(" \t\n\r") == std::string::npos; }

}  // namespace

Running::Running(script::Session& session) : session_(session) {
  script::begin_input(session);
  asked = 0;
  running = 1;
}

Running::~Running() {
  running = 0;
  session_.take_interrupt();
  session_.rest_hook(session_.lua());
}

InterruptGuard::InterruptGuard(script::Session& session) {
  interruptible = &session;
  set_handler(on_interrupt_or_end);
}

InterruptGuard::~InterruptGuard() {
  set_handler(SIG_DFL);
  interruptible = nullptr;
}

std::string advice(const std::string& input) {
  const auto names = chunk_locals(tokens_of(input));
  if (names.empty()) return {};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return "warning: local " + list + (names.size() > 1 ? " are" : " is") + " gone on the next line; to keep " +
         (names.size() > 1 ? "them" : "it") + " leave 'local' out";
}

Outcome converse(script::Session& session, Lines& lines, const Voice& voice) {
  if (!session.options().deck.empty()) keep(session, deck_call(session.options().deck), voice);
  Outcome first = Outcome::done;
  OwnNames own(session);
  const auto evaluated = [&](const std::string& text) {
    const Outcome outcome = run(session, text, voice);
    own.look(voice);
    if (first == Outcome::done) first = outcome;
  };
  std::string input, line;
  while (session.terminated() == 0) {
    const auto state = drop_between(input) ? Lines::State::interrupted : lines.next(input, line);
    if (state == Lines::State::end && input.empty()) break;
    if (state == Lines::State::interrupted) {
      input.clear();
      voice.out << std::endl;
      continue;
    }
    if (state ==
        Lines::State::end) {  // Ctrl-D, or the text ends: what is not whole says so, the session goes on
      evaluated(std::exchange(input, {}));
      continue;
    }
    if (input.empty() && asks_to_leave(session, line)) break;
    const std::string typed = line;
    input = input.empty() ? meant(session, line) : input + "\n" + line;
    if (!blank(input) && wants_more(session, input)) continue;
    if (!blank(input)) {
      lines.remember(input == meant(session, typed) ? typed : input);
      evaluated(input);
    }
    input.clear();
  }
  return first;
}

}  // namespace fabricsh::repl
