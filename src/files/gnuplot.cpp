#include "files/gnuplot.hpp"

#include "base/error.hpp"
#include "files/child.hpp"

namespace fabricsh::files {

std::string run_gnuplot(const std::string& script) {
  const ChildResult result =
      run_child({"gnuplot", "-d"}, script, "figure");  // -d: no start-up file of the user's
  if (!result.found)
    throw Error("figure: gnuplot is needed to draw and is not installed (apt-get install gnuplot-nox)");
  if (!result.good) throw Error("figure: gnuplot failed: " + result.said);
  if (result.out.empty()) throw Error("figure: gnuplot drew nothing: " + result.said);
  return result.out;
}

}  // namespace fabricsh::files
