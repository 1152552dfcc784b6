#include "system/computing_time.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <limits>
#include <thread>
#include <utility>

namespace fabricsh {

namespace {

constexpr std::size_t no_place = 4096;
std::array<std::atomic<pid_t>, no_place> children{};  // 0: free slot
std::atomic<double> most{std::numeric_limits<double>::infinity()};
void (*at_the_end)() = nullptr;

double seconds_of(const rusage& used) {
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

// Signals are blocked in this thread, so that Ctrl-C interrupts the thread that waits for input.
void start_watch() {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::thread([] {
    while (computing_time() < most) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    at_the_end();
  }).detach();
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace

// The time of a child that has been waited for is included in that of the ended children.
double computing_time_of(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double computing_time() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    seconds += seconds_of(used);
  }
  for (const auto& child : children)
    if (const pid_t number = child; number != 0) seconds += computing_time_of(number);
  return seconds;
}

CountedChild::CountedChild(pid_t child) : place_(0) {
  for (pid_t free = 0; place_ < no_place && !children[place_].compare_exchange_strong(free, child); free = 0)
    ++place_;
}

CountedChild::~CountedChild() {
  if (place_ < no_place) children[place_] = 0;
}

CountedChild::CountedChild(CountedChild&& other) noexcept : place_(std::exchange(other.place_, no_place)) {}

CountedChild& CountedChild::operator=(CountedChild&& other) noexcept {
  std::swap(place_, other.place_);
  return *this;
}

void limit_computing_time(double seconds, void (*over)()) {
  most = seconds;
  at_the_end = over;
  start_watch();
}

double computing_time_left() { return std::isfinite(most) ? most - computing_time() : double{most}; }

void limit_computing_time_of_copy(double left) {
  if (!std::isfinite(most)) return;
  for (auto& child : children) child = 0;
  const double seconds = std::max(0.0, left) + 1;
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(std::ceil(seconds)));
  setrlimit(RLIMIT_CPU, &limit);
  limit_computing_time(seconds, at_the_end);
}

}  // namespace fabricsh
