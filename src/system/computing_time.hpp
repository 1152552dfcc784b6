// Computing time of this process and of the children it waits for, and an end when a limit is reached.
#pragma once
#include <sys/types.h>

#include <cstddef>

namespace fabricsh {

// s: of all threads of this process, of its children that have ended, and of those that are counted now.
double computing_time();

// A child that runs: its time counts as this process' own. At most 4096 at once, further ones count when they
// have ended.
class CountedChild {
 public:
  explicit CountedChild(pid_t child);
  ~CountedChild();
  CountedChild(CountedChild&& other) noexcept;
  CountedChild& operator=(CountedChild&& other) noexcept;

 private:
  std::size_t place_;
};

// From now on a thread looks 20 times a second and calls `over`, which has to end the process, once
// computing_time() has reached this many seconds. As the system's own limits it is the process' and no
// object's.
void limit_computing_time(double seconds, void (*over)());

// s; infinite without a limit.
double computing_time_left();

// In a copy made by fork(), which has none of the other threads and whose time starts at zero: `left` seconds
// and a second more, so that its parent is the first to say it. Nothing without a limit.
void limit_computing_time_of_copy(double left);

}  // namespace fabricsh
