// Reading a table of three columns as a load frame writes it, beside the C++ library's own reading of the
// same numbers, which looks for nothing that may be wrong: bench_table [rows]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "format/table.hpp"

using Clock = std::chrono::steady_clock;

namespace {

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string record(int rows) {
  std::ostringstream text;
  for (int i = 0; i < rows; ++i) text << i * 0.001 << ',' << i * 1.25e-5 << ',' << i * 3.1e-4 << '\n';
  return text.str();
}

double plain_sum(const std::string& text) {
  std::istringstream in(text);
  double x = 0, sum = 0;
  char separator = 0;
  while (in >> x) {
    sum += x;
    if (in.peek() == ',') in >> separator;
  }
  return sum;
}

}  // namespace

int main(int count, char** words) {
  const int rows = count > 1 ? std::atoi(words[1]) : 1000000;
  const std::string text = record(rows);
  auto begin = Clock::now();
  const auto table = fabricsh::format::parse_table("record", "time (s),displacement (mm),force (N)\n" + text);
  const double ours = seconds_since(begin);
  begin = Clock::now();
  const double sum = plain_sum(text);
  const double plain = seconds_since(begin);
  std::printf("%zu rows of 3 columns: %.3f s; the library's >> alone %.3f s (sum %.6g): ratio %.2f\n",
              table.columns[0].values.size(), ours, plain, sum, ours / plain);
  return 0;
}
