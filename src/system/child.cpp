#include "system/child.hpp"

#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>

#include "base/error.hpp"
#include "system/computing_time.hpp"

extern char** environ;

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

// Returns 0 or the system's reason, and sets the child's number. The child leads its own process
// group, so that Ctrl-C at the terminal reaches this program only, which then gives it time to end.
int spawn(const std::vector<std::string>& arguments, std::FILE* input, std::FILE* out, std::FILE* said,
          pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(said), STDERR_FILENO);
  std::vector<std::string> copies = arguments;
  std::vector<char*> pointers;
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawnattr_t group;
  posix_spawnattr_init(&group);
  posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
  const int reason = posix_spawnp(&child, pointers[0], &actions, &group, pointers.data(), environ);
  posix_spawnattr_destroy(&group);
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

constexpr std::chrono::seconds kGrace{5};

// Waits for the child's end; returns 0 or the system's reason. After a signal to this program the child has
// kGrace to end by itself: it may draw for a hook whose run answers the signal after its step.
int wait_for(pid_t child, int& status) {
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> signalled;
  while (true) {
    const pid_t ended = waitpid(child, &status, signalled ? WNOHANG : 0);
    if (ended == child) return 0;
    if (ended < 0 && errno != EINTR) return errno;
    if (!signalled) signalled = Clock::now();
    if (Clock::now() - *signalled > kGrace) kill(-child, SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who) {
  const Scratch given = scratch(who), out = scratch(who), said = scratch(who);
  const bool written = std::fwrite(input.data(), 1, input.size(), given.get()) == input.size();
  if (!written || std::fflush(given.get()) != 0) no_scratch(who);
  std::rewind(given.get());
  pid_t child = 0;
  int reason = spawn(arguments, given.get(), out.get(), said.get(), child), status = 0;
  if (reason == ENOENT) return {false, false, {}, {}};
  if (reason == 0) {
    const CountedChild counted(child);
    reason = wait_for(child, status);
  }
  if (reason != 0)
    throw Error(who + ": " + arguments[0] + " does not start: " + std::generic_category().message(reason));
  return {true, WIFEXITED(status) && WEXITSTATUS(status) == 0, content(out.get()), words(said.get())};
}

}  // namespace fabricsh::system
