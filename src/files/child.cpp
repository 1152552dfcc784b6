#include "files/child.hpp"

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

// A file without a name, gone when closed: input and complaints go through files, so nobody waits on a pipe.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void no_scratch(const std::string& who) {
  throw Error(who + ": no temporary file: " + std::generic_category().message(errno));
}

Scratch scratch(const std::string& who) {
  Scratch file(std::tmpfile(), std::fclose);
  if (!file) no_scratch(who);
  return file;
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text(20000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

// 0 or the system's reason; the child's number.
int spawn(const std::vector<std::string>& arguments, std::FILE* input, std::FILE* said, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(said), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(said), STDERR_FILENO);
  std::vector<std::string> words = arguments;
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int reason = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& arguments, const std::string& input,
                      const std::string& who) {
  const Scratch given = scratch(who), said = scratch(who);
  const bool written = std::fwrite(input.data(), 1, input.size(), given.get()) == input.size();
  if (!written || std::fflush(given.get()) != 0) no_scratch(who);
  std::rewind(given.get());
  pid_t child = 0;
  int reason = spawn(arguments, given.get(), said.get(), child), status = 0;
  if (reason == ENOENT) return {false, false, {}};
  if (reason == 0)
    while (waitpid(child, &status, 0) < 0)
      if (errno != EINTR) reason = errno;
  if (reason != 0)
    throw Error(who + ": " + arguments[0] + " does not start: " + std::generic_category().message(reason));
  return {true, WIFEXITED(status) && WEXITSTATUS(status) == 0, content(said.get())};
}

}  // namespace fabricsh::files
