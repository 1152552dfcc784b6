#include "system/paths.hpp"

#include <sys/auxv.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "fabricsh_config.hpp"

namespace fabricsh {

namespace fs = std::filesystem;

namespace {

// With links resolved, or as given if that fails.
fs::path resolved(const fs::path& path) {
  std::error_code code;
  const fs::path real = fs::weakly_canonical(path, code);
  return code ? path : real;
}

void add_folder(std::vector<std::string>& roots, const fs::path& folder) {
  std::error_code code;
  if (fs::is_directory(folder, code)) roots.push_back(resolved(folder).string());
}

}  // namespace

std::string program_path() {
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  if (!code) return program.string();
  // Without /proc (for example in a bare chroot): the path with which the program was started.
  const auto* started = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  return started == nullptr ? std::string() : resolved(fs::absolute(started, code)).string();
}

std::string module_file(const std::string& name) {
  const fs::path folder = fs::path(program_path()).parent_path();
  for (const fs::path& modules :
       {folder / config::modules_from_program, folder / "modules", folder.parent_path() / "modules"})
    if (std::error_code code; fs::exists(modules / name, code)) return resolved(modules / name).string();
  return {};
}

std::vector<std::string> data_roots() {
  std::vector<std::string> roots;
  const char* home = std::getenv("FABRICSH_HOME");
  if (home != nullptr && *home != '\0') add_folder(roots, home);
  const fs::path program = program_path();
  if (program.empty()) return roots;
  add_folder(roots, program.parent_path() / config::data_from_program);
  for (const fs::path& folder : {program.parent_path(), program.parent_path().parent_path()}) {
    std::ifstream marker(folder / "fabricsh.home");
    if (std::string source; std::getline(marker, source)) add_folder(roots, source);
  }
  return roots;
}

std::string data_file(const std::string& relative) {
  for (const std::string& root : data_roots()) {
    const fs::path file = fs::path(root) / relative;
    std::error_code code;
    if (fs::exists(file, code)) return file.string();
  }
  return {};
}

}  // namespace fabricsh
