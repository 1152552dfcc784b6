#include "app/environment.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <malloc.h>
#include <omp.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <system_error>

#include "base/version.hpp"
#include "format/vtu.hpp"
#include "linear/libraries.hpp"
#include "repl/editor.hpp"
#include "simd/isa.hpp"

namespace fabricsh::app {

namespace {

// Better kernels for OpenBLAS than those it would choose; null: its own choice is good, or the BLAS is
// another one.
const char* better_kernels() {
  using CoreName = char* (*)();
  const auto name = reinterpret_cast<CoreName>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  if (name == nullptr || std::strcmp(name(), "Prescott") != 0) return nullptr;
  const Isa isa = best_isa();
  return isa == Isa::avx512 ? "SkylakeX" : isa == Isa::avx2 ? "Haswell" : nullptr;
}

// Only on_exit() passes the exit code. `owner` is the process that called it: a copy of that process prints
// through the same file.
void look(int code, void* owner) {
  if (getpid() != static_cast<pid_t>(reinterpret_cast<std::intptr_t>(owner))) return;
  errno = 0;
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return;
  const std::string reason = flushed || errno == 0 ? "" : ": " + std::generic_category().message(errno);
  std::fprintf(stderr, "fabricsh: standard output is incomplete%s\n", reason.c_str());
  std::fflush(nullptr);
  _exit(code == 0 ? 1 : code);
}

}  // namespace

std::string environment_error() {
  const char* wish = std::getenv("FABRICSH_ISA");
  if (wish == nullptr || *wish == 0 || std::strcmp(wish, name(best_isa())) == 0) return {};
  std::string known;
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa <= best_isa()) known += (known.empty() ? "" : ", ") + std::string(name(isa));
  return "FABRICSH_ISA: expected one that this machine has (" + known + "), got '" + wish + "'";
}

// Factorisations allocate and free megabytes in each iteration. By default the C library returns them to the
// system each time, and the pages come back one by one, a quarter of the time of a small implicit run.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int mapped_apart = 4 << 20, kept = 16 << 20;  // bytes
  mallopt(M_MMAP_THRESHOLD, mapped_apart);
  mallopt(M_TRIM_THRESHOLD, kept);
#endif
}

void settle_environment(char** words) {
  bool anew = false;
  const auto set = [&](const char* name, const char* value) {
    if (value == nullptr || std::getenv(name) != nullptr) return;
    anew = setenv(name, value, 0) == 0 || anew;
  };
  if (std::getenv("OMP_WAIT_POLICY") == nullptr) set("GOMP_SPINCOUNT", "5000");
  set("OPENBLAS_CORETYPE", better_kernels());
  if (anew) execv("/proc/self/exe", words);
}

void watch_output() { on_exit(look, reinterpret_cast<void*>(static_cast<std::intptr_t>(getpid()))); }

// open() returns the smallest free number.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

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
