#include "app/safe.hpp"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/wall.hpp"
#include "base/error.hpp"
#include "system/gate.hpp"
#include "system/paths.hpp"

namespace fabricsh::app {

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
