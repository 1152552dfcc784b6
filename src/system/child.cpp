#include "system/child.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "system/computing_time.hpp"

namespace fabricsh::system {

namespace {

// A file in memory. The child's streams are files, so that neither process blocks on a pipe.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void no_scratch(const std::string& who) {
  throw Error(who + ": no temporary file: " + std::generic_category().message(errno));
}

Scratch scratch(const std::string& who) {
  const int number = memfd_create("fabricsh", MFD_CLOEXEC);
  Scratch file(number < 0 ? nullptr : fdopen(number, "w+"), std::fclose);
  if (!file) no_scratch(who);
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text;
  char part[65536];
  for (std::size_t n = 0; (n = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, n);
  return text;
}

std::string words(std::FILE* file) {
  std::string text = content(file).substr(0, 2000);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

constexpr double kGrace = 5;  // s of its computing time, for a child after a signal to this program
constexpr std::chrono::seconds kIdle{5};  // in which it computes next to nothing
constexpr double kNothing = 0.05;         // s
std::atomic<int> graces{0};               // children that have grace

// Waits for the child's end; returns 0 or the system's reason. After a signal to this program the child may
// end by itself: it may draw for a hook whose run answers the signal after its step. A second Ctrl-C ends
// this program, and the child with it.
int wait_for(pid_t child, int& status) {
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> busy;  // when it last computed, since the signal
  double before = 0, seen = 0;            // s, computed at the signal, and at `busy`
  bool over = false;
  while (true) {
    const pid_t ended = waitpid(child, &status, busy ? WNOHANG : 0);
    const int reason = ended < 0 ? errno : 0;
    if (ended == child || (reason != 0 && reason != EINTR)) {
      if (busy && !over) --graces;
      return reason;
    }
    const double used = computing_time_of(child);
    if (!busy) {
      ++graces;
      before = used;
    }
    if (!busy || used - seen > kNothing) {
      busy = Clock::now();
      seen = used;
    }
    if (!over && (used - before > kGrace || Clock::now() - *busy > kIdle)) {
      over = true;
      --graces;
    }
    if (over) kill(-child, SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

// Data of the new process, made before it starts: it shares this program's memory until it runs another.
struct Prepared {
  char* const* arguments;
  int input, out, said;
  bool own_group;
  int ends_by;
  pid_t parent;
  sigset_t signals;
  volatile int reason;
};

[[noreturn]] void become(Prepared& p) {
  const auto give_up = [&p] {
    p.reason = errno;
    std::_Exit(127);
  };
  // A handler of this program must not run in the new process, which shares its memory; an ignored signal
  // stays ignored, as under nohup.
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = SIG_DFL;
    sigaction(number, &action, nullptr);
  }
  if (p.own_group && setpgid(0, 0) != 0) give_up();
  if (prctl(PR_SET_PDEATHSIG, p.ends_by) != 0) give_up();
  if (getppid() != p.parent) std::_Exit(127);
  const std::pair<int, int> streams[] = {{p.input, 0}, {p.out, 1}, {p.said, 2}};
  for (const auto& [from, to] : streams)
    if (from >= 0 && dup2(from, to) < 0) give_up();
  sigprocmask(SIG_SETMASK, &p.signals, nullptr);
  execvp(p.arguments[0], p.arguments);
  give_up();
  std::_Exit(127);
}

}  // namespace

bool child_has_grace() { return graces > 0; }

// vfork() as posix_spawn() has it inside, which offers no signal at the parent's end.
int spawn_bound(const Spawn& what, int& child) {
  std::vector<std::string> copies = what.arguments;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Prepared p{pointers.data(), what.input, what.out, what.said, what.own_group, what.ends_by, getpid(), {}, 0};
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &p.signals);
  const pid_t process = vfork();
  if (process == 0) become(p);
  const int failed = process < 0 ? errno : 0;
  pthread_sigmask(SIG_SETMASK, &p.signals, nullptr);
  if (failed != 0) return failed;
  if (p.reason != 0) {
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
    return p.reason;
  }
  child = process;
  return 0;
}

ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who) {
  const Scratch given = scratch(who), out = scratch(who), said = scratch(who);
  const bool written = std::fwrite(input.data(), 1, input.size(), given.get()) == input.size();
  if (!written || std::fflush(given.get()) != 0) no_scratch(who);
  std::rewind(given.get());
  pid_t child = 0;
  int status = 0;
  int reason = spawn_bound({arguments, fileno(given.get()), fileno(out.get()), fileno(said.get())}, child);
  if (reason == ENOENT) return {false, false, 0, {}, {}};
  if (reason == 0) {
    const CountedChild counted(child);
    reason = wait_for(child, status);
  }
  if (reason != 0)
    throw Error(who + ": " + arguments[0] + " does not start: " + std::generic_category().message(reason));
  return {true, WIFEXITED(status) && WEXITSTATUS(status) == 0, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
          content(out.get()), words(said.get())};
}

}  // namespace fabricsh::system
