#include "app/wall.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "system/computing_time.hpp"
#include "system/descriptor.hpp"
#include "system/paths.hpp"

namespace fabricsh::app {

namespace {

// The kernel's interface (linux/landlock.h), repeated here because older headers are incomplete.
constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;
constexpr int path_beneath = 1;
struct Ruleset {
  std::uint64_t files, network, scoped;
};
struct __attribute__((packed)) BeneathRule {
  std::uint64_t allowed;
  std::int32_t folder;
};
constexpr std::uint64_t execute = 1 << 0, write_file = 1 << 1, read_file = 1 << 2, read_folder = 1 << 3,
                        remove_folder = 1 << 4, remove_file = 1 << 5, make_folder = 1 << 7,
                        make_file = 1 << 8, refer = 1 << 13, truncate = 1 << 14;
constexpr std::uint64_t reads = read_file | read_folder;
constexpr std::uint64_t writes =
    reads | write_file | remove_folder | remove_file | make_folder | make_file | refer | truncate;
constexpr std::uint64_t of_files =
    execute | write_file | read_file | truncate;  // the rights that a rule for a file may contain

// Rights in each version of Landlock: 13 in the first, then refer, truncate and control of devices.
std::uint64_t known_to(long version) {
  const int bits = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
  return (1u << bits) - 1;
}

class Landlock {
 public:
  Landlock() : version_(syscall(create_ruleset, nullptr, 0, 1)) {
    if (version_ < 1) return;
    const Ruleset all{known_to(version_), version_ >= 4 ? 3u : 0u, version_ >= 6 ? 3u : 0u};
    const std::size_t size = version_ >= 6 ? 24 : version_ >= 4 ? 16 : 8;
    rules_ = system::Descriptor(static_cast<int>(syscall(create_ruleset, &all, size, 0)));
  }

  // A path that does not exist is skipped.
  void allow(const std::string& path, std::uint64_t rights) const {
    const system::Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat about {};
    if (!rules_.open() || !place.open() || fstat(place.number(), &about) != 0) return;
    if (!S_ISDIR(about.st_mode)) rights &= of_files;
    const BeneathRule rule{rights & known_to(version_), place.number()};
    syscall(add_rule, rules_.number(), path_beneath, &rule, 0);
  }

  void enforce() const {
    if (rules_.open()) syscall(restrict_self, rules_.number(), 0);
  }

 private:
  long version_;
  system::Descriptor rules_;
};

// Programs are searched as execvp does.
void allow_program(const Landlock& wall, const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string file = folder + "/" + name; access(file.c_str(), X_OK) == 0)
      return wall.allow(file, execute | read_file);
}

void allow_system(const Landlock& wall) {
  for (const char* folder :
       {"/usr", "/lib", "/lib64", "/lib32", "/bin", "/etc/fonts", "/etc/ld.so.cache", "/etc/ld.so.preload",
        "/etc/localtime", "/etc/alternatives", "/etc/OpenCL", "/var/cache/fontconfig", "/sys/devices/system",
        "/proc/cpuinfo", "/proc/meminfo", "/proc/self", "/dev/urandom"})
    wall.allow(folder, reads);
  for (const char* device : {"/dev/null", "/dev/tty"}) wall.allow(device, read_file | write_file);
  // The loader of shared libraries also needs the right to be executed.
  for (const char* loader : {"/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1",
                             "/lib/ld-linux-riscv64-lp64d.so.1", "/lib64/ld64.so.2"})
    wall.allow(loader, execute | read_file);
  const std::filesystem::path program = program_path();
  wall.allow(program, execute | read_file);
  for (const auto& folder : {program.parent_path(), program.parent_path().parent_path()})
    wall.allow(folder / "fabricsh.home", read_file);  // contains the location of the data (system/paths.hpp)
  allow_program(wall, "gnuplot");
}

void set_limit(int what, rlim_t soft, rlim_t margin) {
  rlimit limit{};
  if (getrlimit(static_cast<__rlimit_resource>(what), &limit) != 0) return;
  const rlim_t most = limit.rlim_max;
  limit.rlim_cur = std::min(soft, most);
  limit.rlim_max = std::min(soft + margin, most);
  setrlimit(static_cast<__rlimit_resource>(what), &limit);
}

// A signal handler may only write the message and end. Output files are complete at any moment.
[[noreturn]] void end_in_time() {
  constexpr char words[] =
      "fabricsh: limit of computing time under --safe is reached (option --limit-seconds); ended\n";
  [[maybe_unused]] const auto said = write(STDERR_FILENO, words, sizeof words - 1);
  _exit(1);
}

extern "C" void time_is_over(int) { end_in_time(); }

}  // namespace

void raise_wall(const std::vector<std::string>& readable, const std::string& writable) {
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const Landlock wall;
  allow_system(wall);
  for (const std::string& folder : readable) wall.allow(folder, reads);
  if (!writable.empty()) wall.allow(writable, writes);
  wall.enforce();
}

void limit_process(const script::SafeOptions& limits) {
  struct sigaction action {};
  action.sa_handler = time_is_over;
  sigaction(SIGXCPU, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);  // so that the write fails instead
  const rlim_t gigabyte = rlim_t{1} << 30;
  set_limit(RLIMIT_CPU, static_cast<rlim_t>(limits.seconds), 5);
  limit_computing_time(static_cast<double>(limits.seconds), end_in_time);
  set_limit(RLIMIT_FSIZE, 4 * gigabyte, 0);
  set_limit(RLIMIT_CORE, 0, 0);
#if !defined(__SANITIZE_ADDRESS__)  // whose shadow memory exceeds any limit
  const auto threads = static_cast<rlim_t>(sysconf(_SC_NPROCESSORS_ONLN));
  set_limit(RLIMIT_DATA, (static_cast<rlim_t>(limits.megabytes) << 20) + gigabyte + threads * (16 << 20), 0);
#endif
}

}  // namespace fabricsh::app

#if defined(__clang__)
// LLVM's OpenMP, which clang links, notes itself in shared memory named after the process, to notice a second
// copy of itself, and ends the program where it cannot: behind the wall, which gives no right to /dev/shm.
// The loader finds this function before the C library's. It gives the note memory of the process' own, so
// that nothing stays behind in /dev/shm either. GNU's OpenMP keeps no such note.
extern "C" int shm_open(const char* name, int flags, mode_t mode) {
  constexpr char note[] = "/__KMP_REGISTERED_LIB_";
  if (std::strncmp(name, note, sizeof note - 1) == 0) {
    if ((flags & O_CREAT) != 0) return memfd_create(name + 1, MFD_CLOEXEC);
    errno = ENOENT;  // at the end of the process, which looks for its note to remove it
    return -1;
  }
  using Function = int (*)(const char*, int, mode_t);
  const auto library = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "shm_open"));
  if (library != nullptr) return library(name, flags, mode);
  errno = ENOSYS;
  return -1;
}
#endif
