// A program on a terminal of its own, from the side of the person who sits at it.
#pragma once
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include "screen.hpp"

class Terminal {
 public:
  static constexpr unsigned short width = 100, height = 500;

  // Runs `child` at the other end; it returns the exit code.
  explicit Terminal(const std::function<int()>& child) : screen(width) {
    const winsize size{height, width, 0, 0};
    std::fflush(nullptr);  // or both sides would write what waits
    process_ = forkpty(&master_, nullptr, nullptr, &size);
    if (process_ == 0) _exit(child());
  }
  ~Terminal() {
    if (!ended_) reap(SIGKILL);
    close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(const std::string& keys) const {
    for (std::size_t at = 0; at < keys.size();) {
      const ssize_t done = write(master_, keys.data() + at, keys.size() - at);
      if (done <= 0) return;
      at += static_cast<std::size_t>(done);
    }
  }

  // How long the program may take over an answer, ms.
  static int patience() {
    const char* asked = std::getenv("FABRICSH_TEST_PATIENCE");
    return asked == nullptr ? 60000 : std::atoi(asked);
  }

  // Reads until the condition holds; false when it doesn't come in time, or the program has ended.
  bool wait_for(const std::function<bool()>& holds, int milliseconds = patience()) {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::milliseconds(milliseconds);
    while (!holds()) {
      pollfd input{master_, POLLIN, 0};
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      if (left <= 0 || poll(&input, 1, static_cast<int>(left)) <= 0) return false;
      char buffer[4096];
      const ssize_t count = read(master_, buffer, sizeof buffer);
      if (count <= 0) {
        bytes_end_ = true;
        return holds();
      }
      bytes.append(buffer, static_cast<std::size_t>(count));
      screen.take(std::string(buffer, static_cast<std::size_t>(count)));
    }
    return true;
  }

  // The exit code, or 128 + the signal's number: of the program's end, or of its being killed when it goes
  // on.
  int end() {
    wait_for([] { return false; });
    return reap(bytes_end_ ? 0 : SIGKILL);
  }

  Screen screen;
  std::string bytes;  // all that came

 private:
  int reap(int signal) {
    if (signal != 0) kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    ended_ = true;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  int master_ = -1;
  pid_t process_ = -1;
  bool ended_ = false, bytes_end_ = false;
};

// Becomes the program, with these variables set (empty: unset). A program that a shell starts in the
// background has Ctrl-C ignored, which programs inherit.
inline int become(const std::string& program, const std::map<std::string, std::string>& variables) {
  signal(SIGINT, SIG_DFL);
  for (const auto& [name, value] : variables)
    value.empty() ? unsetenv(name.c_str()) : setenv(name.c_str(), value.c_str(), 1);
  execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
  return 127;
}
