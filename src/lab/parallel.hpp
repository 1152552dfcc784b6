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
};

// work(i) for i = 0 .. count-1, `processes` at a time, each in a forked copy with one thread; the answers in
// order. done(i) after each, in this process. With one process nothing is forked.
std::vector<Answer> in_processes(std::size_t count, int processes,
                                 const std::function<std::vector<double>(std::size_t)>& work,
                                 const std::function<void(std::size_t)>& done = {});

}  // namespace fabricsh::lab
