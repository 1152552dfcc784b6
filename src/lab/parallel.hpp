// The same work for many items in processes of their own: a Lua function cannot run in two threads, but it
// can in two copies of the program.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace fabricsh::lab {

struct Answer {
  std::vector<double> values;
  std::string trouble;  // not empty: what the work threw
  bool died = false;    // ended or stopped without an answer (trouble says how): nothing is known of the item
};

struct Processes {
  int at_a_time = 2;
  bool always = false;  // a process of its own for each item even when they come one at a time
  // In this process, after each item.
  std::function<void(std::size_t, const Answer&)> done = {};
  // Asked when a signal came; true: the workers are stopped, and what is missing has trouble.
  std::function<bool()> stop = {};
};

// work(i) for i = 0 .. count-1, some at a time, each in a forked copy with one thread that ends with this
// process; the answers in order. One that is killed, or calls exit(), has trouble that says so. With one at a
// time nothing is forked unless `always`. A limit on computing time (system/computing_time.hpp) holds for all
// together. Error: nothing is left of it.
std::vector<Answer> in_processes(std::size_t count,
                                 const std::function<std::vector<double>(std::size_t)>& work,
                                 const Processes& how);

}  // namespace fabricsh::lab
