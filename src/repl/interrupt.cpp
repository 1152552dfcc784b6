#include "repl/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <ctime>

#include "script/session/at_work.hpp"
#include "system/child.hpp"

namespace fabricsh::repl {

namespace {

// Signal handlers have no arguments, so these variables must be global.
script::Session* interruptible = nullptr;
Attended attended_now = Attended::no;
volatile std::sig_atomic_t running = 0, asked = 0;  // something is running; Ctrl-C came meanwhile
volatile std::sig_atomic_t between = 0;             // Ctrl-C came between two lines
volatile std::sig_atomic_t last = 0;                // the last signal not answered yet
volatile std::sig_atomic_t waited = 0;              // s, for its answer
volatile std::time_t since = 0;                     // s of a monotonic clock, at the first SIGTERM

constexpr int kPatience = 10'000'000;  // instructions after which a hook of a run is stopped
constexpr int answers_within = 10;     // s
constexpr std::time_t one_signal = 2;  // s, within which several signals count as one

void stop_late(lua_State* L, lua_Debug*);

// Stops Lua code at once; but in a hook of a run, the run answers after its step.
void stop(lua_State* L, bool late) {
  script::Session& session = script::Session::of(L);
  session.rest_hook(L);
  if (!session.interrupted()) return;
  if (session.drives() && !late) {
    if (session.limits() == nullptr) lua_sethook(L, stop_late, LUA_MASKCOUNT, kPatience);
    return;
  }
  session.take_interrupt();
  session.call_off();
  luaL_error(L, "interrupted");
}

void stop_lua(lua_State* L, lua_Debug*) { stop(L, false); }

void stop_late(lua_State* L, lua_Debug*) { stop(L, true); }

void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::time_t seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

// SIGTERM may arrive several times at once: each process of a job gets it, and a shell forwards it.
void ask_to_end(int signal) {
  if (running == 0) return end_by(signal);
  if (interruptible->terminated() == 0) {
    since = seconds_now();
    return interruptible->terminate(signal);
  }
  const bool at_last_outputs = script::run_is_at_work() && !interruptible->interrupted();
  if (seconds_now() - since >= one_signal && !at_last_outputs) end_by(signal);
}

// While C code runs, Lua calls no hooks, so an alarm ends the program if the signal is not answered. It comes
// each second, and interrupts a wait for a drawing program that began just after the signal.
extern "C" void on_no_answer(int) {
  if (interruptible == nullptr) return;
  if (running == 0 && between != 0) end_by(SIGINT);
  if (running == 0 || !interruptible->interrupted()) return;
  waited = waited + 1;
  if (script::run_is_at_work() || system::child_has_grace() || waited < answers_within)
    alarm(1);
  else if (attended_now == Attended::no || last != SIGINT)
    end_by(last);
}

// While a line is being typed, Ctrl-C only has to interrupt the reading.
extern "C" void on_interrupt_or_end(int signal) {
  if (interruptible == nullptr) return;
  const bool first = interruptible->terminated() == 0;
  if (signal != SIGINT) {
    ask_to_end(signal);
    if (!first || running == 0) return;
  } else {
    if (running == 0) {
      between = 1;  // for the loop of the prompt, which may be about to wait for input that never comes
      if (attended_now == Attended::no) alarm(1);
      return;
    }
    if (asked != 0) end_by(signal);
    interruptible->interrupt();
  }
  asked = 1;
  last = signal;
  waited = 0;
  alarm(1);
  lua_sethook(interruptible->active(), stop_lua, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT,
              1);
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART, so that reading at the prompt is interrupted too
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup remains effective
}

void set_watch(void (*handler)(int)) {
  alarm(0);
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
}

}  // namespace

Running::Running(script::Session& session) : session_(session) {
  session.begin_input();
  asked = 0;
  running = 1;
}

Running::~Running() {
  running = 0;
  alarm(0);
  session_.take_interrupt();
  session_.rest_hook(session_.lua());
}

InterruptGuard::InterruptGuard(script::Session& session, Attended attended) {
  interruptible = &session;
  attended_now = attended;
  set_watch(on_no_answer);
  set_handler(on_interrupt_or_end);
}

InterruptGuard::~InterruptGuard() {
  set_handler(SIG_DFL);
  std::signal(SIGINT, SIG_IGN);
  set_watch(SIG_DFL);
  interruptible = nullptr;
}

bool ctrl_c_between_lines() {
  const bool came = between != 0;
  between = 0;
  return came;
}

}  // namespace fabricsh::repl
