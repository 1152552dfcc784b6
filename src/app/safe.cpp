#include "app/safe.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/wall.hpp"
#include "base/error.hpp"
#include "base/paths.hpp"
#include "files/gate.hpp"

namespace fabricsh::app {

namespace fs = std::filesystem;

namespace {

// Holds this process' number once its wall stands; a program that is started anew keeps its number.
constexpr const char* mark = "FABRICSH_WALL";

// The home folder or the root of the disk, which hold everything.
bool holds_everything(const fs::path& folder) {
  const char* home = std::getenv("HOME");
  return folder == folder.root_path() ||
         (home != nullptr && *home != '\0' && folder == fs::weakly_canonical(home));
}

// The deck's own folder.
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

// Empty under --check, which writes nothing.
std::string output_folder(const CommandLine& command) {
  if (command.check) return {};
  const std::string folder = command.output.empty() ? "out" : command.output;
  std::error_code trouble;
  fs::create_directories(folder, trouble);
  if (trouble) throw Error("--safe: cannot make the output folder '" + folder + "': " + trouble.message());
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
  files::Gate::close_process(files::Gate(readable, writable));
}

}  // namespace fabricsh::app
