// fabricsh: options and exit codes. 0 success, 1 error in the deck, 2 usage error, 3 numerical failure, 130
// ended by Ctrl-C, 143 by SIGTERM, 129 by SIGHUP.
#include <omp.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "app/command_line.hpp"
#include "app/environment.hpp"
#include "app/progress.hpp"
#include "app/wall.hpp"
#include "repl/evaluator.hpp"
#include "repl/history.hpp"
#include "repl/interrupt.hpp"
#include "repl/prompt.hpp"
#include "script/open/open_session.hpp"
#include "script/runs/drive.hpp"

namespace {

using namespace fabricsh;
using repl::EvaluationOutcome;

// 0 if no signal has ended or stopped anything.
int code_of_signal(const script::Session& session) {
  if (session.terminated() != 0) return 128 + session.terminated();
  return session.stopped_by_interrupt() ? 128 + SIGINT : 0;
}

int exit_code(const script::Session& session, const repl::Result& result) {
  if (result.outcome != EvaluationOutcome::done) {
    std::fflush(stdout);
    std::cerr << "fabricsh: " << result.message << std::endl;
  }
  if (const int code = code_of_signal(session)) return code;
  if (result.outcome == EvaluationOutcome::done) return 0;
  return result.outcome == EvaluationOutcome::numerical_failure ? 3 : 1;
}

bool is_dumb() {
  const char* kind = std::getenv("TERM");
  return kind == nullptr || std::string(kind) == "dumb";
}

// Shows notices and progress, also while a line is being typed at the prompt.
class Speaker {
 public:
  void say(const std::string& text) {
    progress.clear();
    std::fflush(stdout);
    if (lines == nullptr || !lines->interject(style_.dress(repl::Tone::notice, text)))
      // in one write, because parallel copies of a run use the same terminal
      std::cerr << style_.dress(repl::Tone::notice, text) + "\n" << std::flush;
  }
  repl::Lines* lines = nullptr;
  app::ProgressLine progress{stderr, isatty(STDERR_FILENO) != 0 && !is_dumb()};

 private:
  repl::TerminalStyle style_ = repl::TerminalStyle::of(STDERR_FILENO);
};

script::SessionOptions session_options(const app::CommandLine& command, Speaker& speaker) {
  const auto say = [&speaker](const std::string& text) { speaker.say(text); };
  script::SessionOptions options;
  if (command.safe) options.safe = command.limits;
  options.check = command.check;
  options.quiet = command.quiet;
  options.strict = command.strict;
  options.study = command.study;
  options.threads = command.threads;
  options.command_line = command.line;
  options.deck = command.deck;
  options.arguments = command.arguments;
  options.notice = say;
  if (!command.quiet)
    options.progress = [&speaker](const script::RunProgress& p) { speaker.progress.show(p); };
  options.clear_progress = [&speaker] { speaker.progress.clear(); };
  return options;
}

// Reports a checkpoint from which no analysis of the deck has started.
repl::Result check_restart(const script::Session& session, repl::Result result) {
  const auto& from = session.restart();
  if (result.outcome != EvaluationOutcome::done || !from || from->number <= session.analyses()) return result;
  return {EvaluationOutcome::deck_error, "--restart: '" + from->path + "' was written by analysis " +
                                             std::to_string(from->number) + " of its deck; this one makes " +
                                             std::to_string(session.analyses())};
}

// Runs -e and -l in their order, then the deck. The first failure ends it.
repl::Result run_all(script::Session& session, const app::CommandLine& command) {
  repl::Result result;
  const bool spill = command.interactive || !command.has_deck || !command.before.empty();
  // arg[0] is the deck as it was found, so that it finds what lies beside it.
  auto line = command.line;
  if (command.has_deck && !command.deck.empty()) line[command.deck_place] = command.deck;
  repl::set_arguments(session, line, command.deck_place);
  if (spill) result = repl::spill_globals(session);
  for (const auto& [kind, text] : command.before) {
    if (result.outcome != EvaluationOutcome::done) return result;
    result = kind == 'e' ? repl::run_text(session, text, "=(command line)") : repl::run_module(session, text);
  }
  if (result.outcome == EvaluationOutcome::done && command.has_deck)
    result = repl::run_deck(session, command.deck, command.arguments);
  return check_restart(session, result);
}

// Without a user at the prompt, the session reads all input and then fails as a deck would; Ctrl-C ends it.
// -i says that there is one, behind a program that passes on the input.
int converse(script::Session& session, Speaker& speaker, bool interactive) {
  const bool terminal = isatty(STDIN_FILENO) != 0;
  const auto attended = terminal || interactive ? repl::Attended::yes : repl::Attended::no;
  const repl::InterruptGuard guard(session, attended);
  if (terminal) std::cout << app::headline() << "\n" << repl::greeting << "\n";
  const auto lines =
      terminal
          ? repl::terminal_lines({repl::history_path(), repl::TerminalStyle::of(STDOUT_FILENO),
                                  [&session](const auto& text) { return repl::complete(session, text); }})
          : repl::stream_lines(std::cin);
  speaker.lines = lines.get();
  const EvaluationOutcome first = repl::converse(
      session, *lines, {std::cout, std::cerr, repl::TerminalStyle::of(STDERR_FILENO)}, attended);
  speaker.lines = nullptr;
  if (session.terminated() != 0 || (attended == repl::Attended::no && session.stopped_by_interrupt()))
    return code_of_signal(session);
  if (terminal || first == EvaluationOutcome::done) return 0;
  return first == EvaluationOutcome::numerical_failure ? 3 : 1;
}

}  // namespace

int main(int count, char** words) {
  app::hold_standard_streams();
  app::watch_output();
  if (const std::string error = app::environment_error(); !error.empty())
    return std::cerr << "fabricsh: " << error << "\n", 2;
  app::settle_environment(words);
  app::keep_freed_memory();
  const app::CommandLine command = app::read_command_line(count, words);
  if (!command.error.empty()) {
    std::cerr << "fabricsh: " << command.error << "; fabricsh --help shows the options\n";
    return 2;
  }
  if (command.help) return std::cout << app::usage, 0;
  if (command.version) return std::cout << app::about(), 0;
  if (command.check && !command.has_deck) return std::cerr << "fabricsh: --check needs a deck\n", 2;
  if (!command.restart.empty() && !command.has_deck && command.before.empty())
    return std::cerr << "fabricsh: --restart needs the deck that wrote the checkpoint\n", 2;
  std::signal(SIGXFSZ, SIG_IGN);  // a file above the user's limit then gives an error, as does a full disk
  if (command.threads > 0) omp_set_num_threads(command.threads);
  try {
    if (command.safe) app::go_safe(command, words);
    Speaker speaker;
    script::OpenSession session(session_options(command, speaker));
    if (!command.restart.empty()) session.restart_from(script::load_checkpoint(command.restart));
    const int code = [&] {
      const repl::InterruptGuard guard(session);
      const repl::Running running(session);
      return exit_code(session, run_all(session, command));
    }();
    const bool prompt = command.interactive || (!command.has_deck && command.before.empty());
    if (!prompt || session.terminated() != 0) return code;
    return converse(session, speaker, command.interactive);
  } catch (const std::exception& error) {
    std::cerr << "fabricsh: " << error.what() << std::endl;
    return 1;
  }
}
