#include "files/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "base/error.hpp"

extern char** environ;

namespace fabricsh::files {

namespace {

// A file without a name, gone when closed: script and complaints go through files, so nobody waits on a pipe.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void cannot_start(int reason) {
  if (reason == ENOENT)
    throw Error("figure: gnuplot is needed to draw and is not installed (apt-get install gnuplot-nox)");
  throw Error("figure: gnuplot does not start: " + std::generic_category().message(reason));
}

Scratch scratch() {
  Scratch file(std::tmpfile(), std::fclose);
  if (!file) throw Error("figure: no temporary file: " + std::generic_category().message(errno));
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text(2000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

// The exit status of gnuplot -d (no start-up file of the user's), its input and complaints in these files.
int spawn(std::FILE* script, std::FILE* complaints) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaints), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaints), STDERR_FILENO);
  char program[] = "gnuplot", option[] = "-d";
  char* arguments[] = {program, option, nullptr};
  pid_t child = 0;
  const int reason = posix_spawnp(&child, program, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (reason != 0) cannot_start(reason);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) cannot_start(errno);
  return status;
}

}  // namespace

void run_gnuplot(const std::string& script) {
  const Scratch input = scratch(), complaints = scratch();
  const bool written = std::fwrite(script.data(), 1, script.size(), input.get()) == script.size();
  if (!written || std::fflush(input.get()) != 0)
    throw Error("figure: no temporary file: " + std::generic_category().message(errno));
  std::rewind(input.get());
  const int status = spawn(input.get(), complaints.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw Error("figure: gnuplot failed: " + content(complaints.get()));
}

}  // namespace fabricsh::files
