#include "lab/parallel.hpp"

#include <omp.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <system_error>

namespace fabricsh::lab {

namespace {

struct Worker {
  pid_t process = -1;
  int pipe = -1;  // what it answers
  std::size_t item = 0;
  std::string bytes;
};

Answer answer_of(const std::function<std::vector<double>(std::size_t)>& work, std::size_t i) {
  try {
    return {work(i), ""};
  } catch (const std::exception& error) {
    return {{}, *error.what() == 0 ? "unknown trouble" : error.what()};
  }
}

// First byte: v for values, t for trouble.
std::string encoded(const Answer& answer) {
  if (!answer.trouble.empty()) return "t" + answer.trouble;
  std::string bytes(1 + answer.values.size() * sizeof(double), 'v');
  std::memcpy(bytes.data() + 1, answer.values.data(), bytes.size() - 1);
  return bytes;
}

Answer decoded(const std::string& bytes) {
  if (bytes.empty()) return {{}, "the process ended without an answer"};
  if (bytes[0] == 't') return {{}, bytes.substr(1)};
  Answer answer;
  answer.values.resize((bytes.size() - 1) / sizeof(double));
  std::memcpy(answer.values.data(), bytes.data() + 1, bytes.size() - 1);
  return answer;
}

void write_all(int pipe, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const auto n = ::write(pipe, bytes.data() + at, bytes.size() - at);
    if (n < 0 && errno != EINTR) return;
    at += static_cast<std::size_t>(std::max<ssize_t>(0, n));
  }
}

// Leaves without destructors or flushing: what they would close and write belongs to the parent.
[[noreturn]] void work_and_leave(int pipe, const std::function<std::vector<double>(std::size_t)>& work,
                                 std::size_t i) {
  omp_set_num_threads(1);  // a forked copy has none of the other threads
  write_all(pipe, encoded(answer_of(work, i)));
  std::_Exit(0);
}

Worker started(const std::function<std::vector<double>(std::size_t)>& work, std::size_t i) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process == 0) {
    ::close(ends[0]);
    work_and_leave(ends[1], work, i);
  }
  ::close(ends[1]);
  return {process, ends[0], i, {}};
}

// The running workers; whoever is left when this goes away is stopped.
class Crew {
 public:
  ~Crew() {
    for (const Worker& w : workers_) {
      ::kill(w.process, SIGTERM);
      finish(w);
    }
  }
  std::size_t size() const { return workers_.size(); }
  void add(Worker worker) { workers_.push_back(std::move(worker)); }
  // Waits until a worker has answered in full and takes it out.
  Worker next() {
    while (true) {
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
  }

 private:
  static bool ended(Worker& worker) {
    char buffer[65536];
    const auto n = ::read(worker.pipe, buffer, sizeof buffer);
    if (n > 0) worker.bytes.append(buffer, static_cast<std::size_t>(n));
    return n == 0 || (n < 0 && errno != EINTR);
  }
  static void finish(const Worker& worker) {
    ::close(worker.pipe);
    while (::waitpid(worker.process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  std::vector<Worker> workers_;
};

}  // namespace

std::vector<Answer> in_processes(std::size_t count, int processes,
                                 const std::function<std::vector<double>(std::size_t)>& work,
                                 const std::function<void(std::size_t)>& done) {
  std::vector<Answer> answers(count);
  Crew crew;
  std::size_t next = 0, finished = 0;
  while (finished < count) {
    std::size_t item = next;
    if (processes > 1 && count > 1) {
      while (next < count && crew.size() < static_cast<std::size_t>(processes))
        crew.add(started(work, next++));
      const Worker worker = crew.next();
      item = worker.item;
      answers[item] = decoded(worker.bytes);
    } else {
      answers[item] = answer_of(work, next++);
    }
    ++finished;
    if (done) done(item);
  }
  return answers;
}

}  // namespace fabricsh::lab
