// The same work for many items in separate processes, because a Lua function cannot run in two threads at
// once, but it can in two copies of the program.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace fabricsh::lab {

struct WorkerResult {
  std::vector<double> values;
  std::string error;          // not empty: the error of the work
  bool died = false;          // ended without an answer (error describes how); the item has no result
  std::string attached = {};  // see Processes
};

struct Processes {
  int at_a_time = 2;
  bool always = false;  // use a separate process for each item even if only one runs at a time
  // Called in this process after each item.
  std::function<void(std::size_t, const WorkerResult&)> done = {};
  // Called after a signal; true: the workers are ended, and the missing items get an error.
  std::function<bool()> stop = {};
  // Called in the copy after its work, successful or not: returns what is attached to the answer.
  std::function<std::string()> attach = {};
};

// Calls work(i) for i = 0 .. count-1, several at a time, each in a forked copy with one thread that ends with
// this process. Returns the answers in order. A copy that is killed or calls exit() gives an error that says
// so. With one process at a time nothing is forked unless `always`. A limit of computing time
// (system/computing_time.hpp) applies to all of them together. Error: no computing time is left.
std::vector<WorkerResult> in_processes(std::size_t count,
                                       const std::function<std::vector<double>(std::size_t)>& work,
                                       const Processes& how);

}  // namespace fabricsh::lab
