// From exec to the first prompt on a terminal: bench_prompt build/fabricsh [times]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "repl/terminal.hpp"

namespace {

double milliseconds_to_prompt(const std::string& program) {
  const auto start = std::chrono::steady_clock::now();
  Terminal terminal([&program] { return become(program, {{"TERM", "vt100"}, {"HOME", "/nonexistent"}}); });
  if (!terminal.wait_for([&] { return terminal.screen.lines().back() == ">"; })) return -1;
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  terminal.type("\4");
  terminal.end();
  return taken.count();
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) return std::fprintf(stderr, "usage: bench_prompt program [times]\n"), 2;
  const int times = count > 2 ? std::max(1, std::atoi(words[2])) : 20;
  std::vector<double> taken;
  for (int i = 0; i < times; ++i) taken.push_back(milliseconds_to_prompt(words[1]));
  std::sort(taken.begin(), taken.end());
  if (taken.front() < 0) return std::fprintf(stderr, "no prompt came\n"), 1;
  std::printf("prompt ready: best %.1f, median %.1f, worst %.1f ms of %d\n", taken.front(),
              taken[taken.size() / 2], taken.back(), times);
  return 0;
}
