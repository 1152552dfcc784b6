#include "app/about.hpp"

#include <omp.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "base/version.hpp"
#include "format/libraries.hpp"
#include "linear/libraries.hpp"
#include "repl/libraries.hpp"
#include "simd/isa.hpp"

namespace fabricsh::app {

namespace {

// The location of a program in PATH; empty: not found.
std::string found(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string file = (folder.empty() ? "." : folder) + "/" + program;
    if (access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

}  // namespace

std::string headline() { return "fabricsh " + version() + " (" + build_kind() + ", " + compiler() + ")"; }

std::string about() {
  std::ostringstream out;
  out << headline() << "\n";
  const char* between = "";
  for (const auto& list : {repl::libraries(), linear::libraries(), format::libraries()})
    for (const Library& library : list) {
      out << between << library.name << " " << library.version;
      between = ", ";
    }
  out << "\nkernels for " << name(best_isa()) << ", " << omp_get_max_threads() << " threads (OpenMP "
      << _OPENMP << ")\n";
  for (const auto& [program, use] : {std::pair{"gnuplot", "figures"}, {"Xvfb", "rendered pictures"}}) {
    const std::string file = found(program);
    out << program << ": " << (file.empty() ? "not found, needed for " + std::string(use) : file) << "\n";
  }
  return out.str();
}

}  // namespace fabricsh::app
