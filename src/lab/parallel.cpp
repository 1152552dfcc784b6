#include "lab/parallel.hpp"

#include <omp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <system_error>

#include "base/archive.hpp"
#include "base/error.hpp"
#include "system/computing_time.hpp"

namespace fabricsh::lab {

namespace {

using Work = std::function<std::vector<double>(std::size_t)>;

struct Worker {
  pid_t process = -1;
  CountedChild counted;
  int pipe = -1;  // from which its answer is read
  std::size_t item = 0;
  std::string bytes;
  int status = 0;  // its exit status
};

WorkerResult answer_of(const Work& work, std::size_t i, bool forked) {
  try {
    return {work(i), "", false};
  } catch (const std::exception& error) {
    return {{}, *error.what() == 0 ? "unknown error" : error.what(), false};
  } catch (...) {  // a Lua error has no C++ type known here; it must not let the copy continue
    if (!forked) throw;
    return {{}, "unknown error", false};
  }
}

// The first byte: a for an answer, x for a process that called exit(), which its words follow.
std::string encoded(WorkerResult answer) {
  Archive archive;
  archive(answer.values, answer.error, answer.attached);
  return "a" + archive.bytes();
}

WorkerResult decoded(const std::string& bytes, int status) {
  if (WIFSIGNALED(status))
    return {{},
            "the process was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                strsignal(WTERMSIG(status)) + ")",
            true};
  if (bytes.empty()) return {{}, "the process ended without an answer", true};
  if (bytes[0] == 'x') return {{}, bytes.substr(1), true};
  try {
    Archive archive(bytes.substr(1));
    WorkerResult answer;
    archive(answer.values, answer.error, answer.attached);
    return answer;
  } catch (const Error&) {
    return {{}, "the process ended within its answer", true};
  }
}

void write_all(int pipe, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const auto n = ::write(pipe, bytes.data() + at, bytes.size() - at);
    if (n < 0 && errno != EINTR) return;
    at += static_cast<std::size_t>(std::max<ssize_t>(0, n));
  }
}

int answers_to = -1;  // the pipe of this copy; global because a function called by exit() has no arguments

// Called by exit() in a copy, for example for os.exit.
void say_that_it_left() {
  write_all(answers_to, "xthe work called os.exit");
  std::fflush(nullptr);
  std::_Exit(0);
}

// Holds back the signals that end a program, so that a copy does not get one before it has set what they do.
class HeldSignals {
 public:
  HeldSignals() {
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ends, signal);
    pthread_sigmask(SIG_BLOCK, &ends, &before_);
  }
  ~HeldSignals() { release(); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  void release() const { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

// Ends a copy without destructors, because what they would close belongs to the parent. Files are flushed:
// the parent's own buffers were written before the fork.
[[noreturn]] void work_and_leave(int pipe, const Work& work, const std::function<std::string()>& attach,
                                 std::size_t i, double left, pid_t parent, const HeldSignals& held) {
  std::signal(SIGINT, SIG_DFL);   // Ctrl-C ends it at once
  std::signal(SIGTERM, SIG_DFL);  // as does its parent
  if (std::signal(SIGHUP, SIG_DFL) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  held.release();
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // and so does the end of the parent
  if (getppid() != parent) std::_Exit(1);
  limit_computing_time_of_copy(left);
  omp_set_num_threads(1);  // a forked copy has none of the other threads
  answers_to = pipe;
  std::atexit(say_that_it_left);
  WorkerResult answer = answer_of(work, i, true);
  if (attach) answer.attached = attach();
  write_all(pipe, encoded(std::move(answer)));
  std::fflush(nullptr);
  std::_Exit(0);
}

Worker started(const Work& work, const std::function<std::string()>& attach, std::size_t i) {
  int ends[2];
  const double left = computing_time_left();
  if (left <= 0) throw Error("no computing time is left for another process");
  std::fflush(nullptr);
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const HeldSignals held;
  const pid_t parent = ::getpid(), process = ::fork();
  if (process < 0) {
    const int reason = errno;
    for (const int end : ends) ::close(end);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  if (process == 0) {
    ::close(ends[0]);
    work_and_leave(ends[1], work, attach, i, left, parent, held);
  }
  ::close(ends[1]);
  return {process, CountedChild(process), ends[0], i, {}, 0};
}

// The running workers; the destructor ends those that are left.
class Crew {
 public:
  ~Crew() {
    for (Worker& w : workers_) {
      ::kill(w.process, SIGTERM);
      finish(w);
    }
  }
  std::size_t size() const { return workers_.size(); }
  void add(Worker worker) { workers_.push_back(std::move(worker)); }
  // Waits for the complete answer of a worker and removes it from the crew; empty: stop() returned true.
  std::optional<Worker> next(const std::function<bool()>& stop) {
    while (!stop || !stop()) {
      std::vector<pollfd> polled;
      for (const Worker& w : workers_) polled.push_back({w.pipe, POLLIN, 0});
      if (::poll(polled.data(), polled.size(), -1) < 0) continue;
      for (std::size_t k = 0; k < workers_.size(); ++k)
        if (polled[k].revents != 0 && ended(workers_[k])) {
          Worker done = std::move(workers_[k]);
          workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(k));
          finish(done);
          return done;
        }
    }
    return std::nullopt;
  }

 private:
  static bool ended(Worker& worker) {
    char buffer[65536];
    const auto n = ::read(worker.pipe, buffer, sizeof buffer);
    if (n > 0) worker.bytes.append(buffer, static_cast<std::size_t>(n));
    return n == 0 || (n < 0 && errno != EINTR);
  }
  static void finish(Worker& worker) {
    ::close(worker.pipe);
    while (::waitpid(worker.process, &worker.status, 0) < 0 && errno == EINTR) {
    }
  }
  std::vector<Worker> workers_;
};

}  // namespace

std::vector<WorkerResult> in_processes(std::size_t count, const Work& work, const Processes& how) {
  std::vector<WorkerResult> answers(count, WorkerResult{{}, "stopped", true});
  const bool forks = how.always || (how.at_a_time > 1 && count > 1);
  Crew crew;
  for (std::size_t next = 0, finished = 0; finished < count; ++finished) {
    std::size_t item = next;
    if (forks) {
      while (next < count && crew.size() < static_cast<std::size_t>(how.at_a_time))
        crew.add(started(work, how.attach, next++));
      const auto worker = crew.next(how.stop);
      if (!worker) break;
      item = worker->item;
      answers[item] = decoded(worker->bytes, worker->status);
    } else {
      answers[item] = answer_of(work, next++, false);
    }
    if (how.done) how.done(item, answers[item]);
  }
  return answers;
}

}  // namespace fabricsh::lab
