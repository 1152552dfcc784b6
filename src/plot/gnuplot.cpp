#include "plot/gnuplot.hpp"

#include <algorithm>

#include "system/child.hpp"

namespace fabricsh::plot {

namespace {

// gnuplot repeats the line with the error, marks a place in it, and gives the reason in the last
// line, preceded by a position in a script that the user has never seen. This returns the reason.
std::string reason_in(const std::string& said) {
  const std::size_t start = said.find_last_of('\n');
  std::string last = start == std::string::npos ? said : said.substr(start + 1);
  if (const std::size_t place = last.find("line "); place != std::string::npos)
    if (const std::size_t colon = last.find(": ", place); colon != std::string::npos)
      last.erase(0, colon + 2);
  last.erase(0, std::min(last.find_first_not_of(' '), last.size()));
  return last.empty() ? "it gave no reason" : last;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const system::ChildResult result =
      system::run_child({"gnuplot", "-d"}, script, "figure");  // -d: ignore the user's start-up file
  if (!result.found)
    throw NoGnuplot("figure: gnuplot is needed to draw and is not installed (apt-get install gnuplot-nox)");
  if (!result.good) throw Error("figure: gnuplot failed: " + reason_in(result.said));
  if (result.out.empty()) throw Error("figure: gnuplot drew nothing: " + reason_in(result.said));
  return result.out;
}

}  // namespace fabricsh::plot
