#include "repl/prompt.hpp"

#include <csignal>

#include "repl/evaluator.hpp"

namespace fabricsh::repl {

namespace {

// A signal handler can be given nothing: the session it is to interrupt is the one thing that has to be here.
script::Session* interruptible = nullptr;

void stop_lua(lua_State* L, lua_Debug*) {
  lua_sethook(L, nullptr, 0, 0);
  script::Session::of(L).take_interrupt();
  luaL_error(L, "interrupted");
}

// The first Ctrl-C asks; a second one, while the first is unanswered (a coroutine that never returns), quits.
extern "C" void on_interrupt(int) {
  if (interruptible == nullptr) return;
  if (interruptible->interrupted()) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  interruptible->interrupt();
  lua_sethook(interruptible->active(), stop_lua, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT,
              1);
}

void set_handler(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;  // without SA_RESTART: a read at the prompt is interrupted too
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

void forget_interrupt(script::Session& session) {
  session.take_interrupt();
  lua_sethook(session.lua(), nullptr, 0, 0);
}

void show(const Result& result, std::ostream& out, std::ostream& err) {
  std::fflush(stdout);
  if (!result.message.empty()) err << result.message << std::endl;
  if (!result.shown.empty()) out << result.shown << std::endl;
}

}  // namespace

InterruptGuard::InterruptGuard(script::Session& session) {
  interruptible = &session;
  set_handler(on_interrupt);
}

InterruptGuard::~InterruptGuard() {
  set_handler(SIG_DFL);
  interruptible = nullptr;
}

void converse(script::Session& session, Lines& lines, std::ostream& out, std::ostream& err) {
  std::string input, line;
  while (true) {
    const auto state = lines.next(input.empty() ? "> " : ">> ", line);
    if (state == Lines::State::interrupted) {
      input.clear();
      out << std::endl;
      forget_interrupt(session);
      continue;
    }
    if (state == Lines::State::end) break;
    input += (input.empty() ? "" : "\n") + line;
    if (input.find_first_not_of(" \t\n\r") == std::string::npos) {
      input.clear();
      continue;
    }
    const Result result = evaluate(session, input);
    if (result.outcome == Outcome::incomplete) continue;
    forget_interrupt(session);
    show(result, out, err);
    lines.remember(input);
    input.clear();
  }
  if (!input.empty()) show(run_text(session, input, "=prompt"), out, err);
}

}  // namespace fabricsh::repl
