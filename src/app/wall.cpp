#include "app/wall.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <pwd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "base/error.hpp"
#include "system/computing_time.hpp"
#include "system/gate.hpp"
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
  wall.allow(module_file("photographs.so"), read_file);
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

namespace fs = std::filesystem;

namespace {

// Contains the process number once the wall is raised; a restarted program keeps its number.
constexpr const char* mark = "FABRICSH_WALL";

// HOME, and the home folder in the system's user database.
std::vector<fs::path> homes() {
  std::vector<fs::path> folders;
  const auto add = [&folders](const char* path) {
    if (path != nullptr && *path == '/') folders.push_back(fs::weakly_canonical(path));
  };
  add(std::getenv("HOME"));
  const passwd* user = getpwuid(getuid());
  if (user != nullptr) add(user->pw_dir);
  return folders;
}

// Whether `inner` is the folder or lies in it. Both paths are canonical.
bool holds(const fs::path& folder, const fs::path& inner) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), inner.begin(), inner.end());
  return end == folder.end();
}

// Whether the folder is or contains the home folder, or is the root. A home folder that is the root or does
// not exist (of a service account) is ignored.
bool holds_everything(const fs::path& folder) {
  if (folder == folder.root_path()) return true;
  const auto all = homes();
  return std::any_of(all.begin(), all.end(), [&](const fs::path& home) { return holds(folder, home); });
}

// The folder of the deck.
std::string folder_of_deck(const std::string& deck) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(deck).parent_path());
  if (holds_everything(folder))
    throw Error("--safe: the deck lies in '" + folder.string() +
                "', all of which it could read; put it into a folder of its own");
  return fs::absolute(deck).parent_path().string();
}

std::vector<std::string> readable_folders(const CommandLine& command) {
  std::vector<std::string> folders;
  if (command.has_deck && !command.deck.empty()) folders.push_back(folder_of_deck(command.deck));
  for (const std::string& root : data_roots())
    for (const char* part : {"lua", "share", "scripts", "meshes"})
      if (const std::string folder = root + "/" + part; fs::is_directory(folder)) folders.push_back(folder);
  return folders;
}

// Empty with --check, which writes nothing.
std::string output_folder(const CommandLine& command) {
  if (command.check) return {};
  const std::string folder = command.output.empty() ? "out" : command.output;
  try {
    system::plain_folder(folder, true);
  } catch (const Error& error) {
    throw Error(std::string("--safe: the output folder: ") + error.what() +
                (fs::is_symlink(folder) ? "; --output names a folder that is none" : ""));
  }
  if (const fs::path real = fs::canonical(folder); holds_everything(real))
    throw Error("--safe: the output folder is '" + real.string() +
                "', all of which the deck could change; give it a folder of its own");
  return folder;
}

}  // namespace

void go_safe(const CommandLine& command, char** words) {
  const std::string own = std::to_string(getpid());
  const char* said = std::getenv(mark);
  const std::vector<std::string> readable = readable_folders(command);
  const std::string writable = output_folder(command);
  if (said == nullptr || own != said) {
    raise_wall(readable, writable);
    setenv(mark, own.c_str(), 1);
    execv(program_path().c_str(), words);
    throw Error("--safe: the program cannot start itself anew");
  }
  limit_process(command.limits);
  system::Gate::close_process(system::Gate(readable, writable));
}

}  // namespace fabricsh::app
