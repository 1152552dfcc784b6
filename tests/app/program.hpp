// The program as a child that can be killed, and what lies in the folder of its outputs.
#pragma once
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "scratch.hpp"

namespace fabricsh::test {

class Program {
 public:
  // Its output goes to the file `log`, its input comes from the file `in` (from that of the test if it is
  // empty).
  explicit Program(std::vector<std::string> words, const std::string& log = "/dev/null",
                   const std::string& in = "") {
    // A signal that comes before the program has begun ends the child, and not by the test's own handler.
    sigset_t all, before;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    process_ = fork();
    if (process_ == 0)
      for (const int number : {SIGINT, SIGTERM, SIGHUP}) ::signal(number, SIG_DFL);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (process_ != 0) return;
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    if (!in.empty()) dup2(open(in.c_str(), O_RDWR), STDIN_FILENO);  // a pipe so stays open
    std::string program = FABRICSH_PROGRAM;
    std::vector<char*> arguments{program.data()};
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(FABRICSH_PROGRAM, arguments.data());
    _exit(127);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (process_ > 0) end(SIGKILL);
  }
  void signal(int number) const { kill(process_, number); }
  bool runs() const {
    siginfo_t about{};
    return waitid(P_PID, static_cast<id_t>(process_), &about, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           about.si_pid == 0;
  }
  // Exit code; 128 and the signal's number where one ended it.
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  int end(int number) {
    signal(number);
    return wait();
  }

 private:
  pid_t process_ = 0;
};

// Names and contents of all files of a folder, but for what names times and arguments.
inline std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != "run.json" && name != "run.ckpt") all[name] = content_of(entry.path());
  }
  return all;
}

}  // namespace fabricsh::test
