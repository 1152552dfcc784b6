// CPU time of this process and of its children, and a limit at which the process is ended.
#pragma once
#include <sys/types.h>

#include <cstddef>

namespace fabricsh {

// s: all threads of this process, the children that have ended, and the running children counted now.
double computing_time();
double computing_time_of(pid_t child);  // s; 0 if it has been waited for

// A running child whose time counts as time of this process. At most
// 4096 at once; further ones are counted only after they have ended.
class CountedChild {
 public:
  explicit CountedChild(pid_t child);
  ~CountedChild();
  CountedChild(CountedChild&& other) noexcept;
  CountedChild& operator=(CountedChild&& other) noexcept;

 private:
  std::size_t place_;
};

// Starts a thread that checks 20 times a second and calls `over`, which must end the
// process, when computing_time() has reached this many seconds. The limit belongs to
// the process and not to an object, like the limits of the operating system.
void limit_computing_time(double seconds, void (*over)());

// s; infinite without a limit.
double computing_time_left();

// For a copy made by fork(), whose time starts at zero: limits it to `left` seconds and one
// more, so that its parent reaches the limit and reports it first. Does nothing without a limit.
void limit_computing_time_of_copy(double left);

}  // namespace fabricsh
