#include "repl/history.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "system/atomic.hpp"
#include "system/gate.hpp"

namespace fabricsh::repl {

std::string on_one_line(const std::string& input) {
  std::string line;
  for (const char c : input) {
    if (c == '\\')
      line += "\\\\";
    else if (c == '\n')
      line += "\\n";
    else
      line += c;
  }
  return line;
}

std::string from_one_line(const std::string& line) {
  std::string input;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\' || i + 1 == line.size()) {
      input += line[i];
      continue;
    }
    ++i;
    input += line[i] == 'n' ? '\n' : line[i];
  }
  return input;
}

namespace {

using system::Descriptor;

bool same_file(int opened, const std::string& path) {
  struct stat here {
  }, there{};
  return fstat(opened, &here) == 0 && stat(path.c_str(), &there) == 0 && here.st_ino == there.st_ino &&
         here.st_dev == there.st_dev;
}

// Opens and locks the file of that name; another session may have replaced it during the wait.
int open_locked(const std::string& path) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const int number = open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    if (number < 0) return -1;
    if (flock(number, LOCK_EX) == 0 && same_file(number, path)) return number;
    close(number);
  }
  return -1;
}

// A line left incomplete by a crash must not be joined with the next one.
bool ends_a_line(const Descriptor& file) {
  struct stat status {};
  char last = '\n';
  if (fstat(file.number(), &status) != 0 || status.st_size == 0) return true;
  return pread(file.number(), &last, 1, status.st_size - 1) != 1 || last == '\n';
}

std::vector<std::string> read_lines(const std::string& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && (lines.empty() || line != lines.back())) lines.push_back(line);
  return lines;
}

// Creates the folder if it is missing.
bool folder_exists(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code code;
  if (!folder.empty() && !std::filesystem::is_directory(folder, code))
    std::filesystem::create_directories(folder, code);
  return !code;
}

}  // namespace

std::vector<std::string> HistoryFile::load() const {
  if (path_.empty() || access(path_.c_str(), R_OK) != 0) return {};
  const Descriptor lock(open_locked(path_));
  std::vector<std::string> lines = read_lines(path_);
  const bool too_long = lines.size() > 2 * kept_;
  if (lines.size() > kept_) lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept_));
  if (too_long && lock.open()) {
    std::string whole;
    for (const std::string& line : lines) whole += line + "\n";
    try {
      system::write_file(path_, whole, system::Sync::no);
      chmod(path_.c_str(), 0600);
    } catch (const Error&) {
      // the file stays long; nothing is lost
    }
  }
  for (std::string& line : lines) line = from_one_line(line);
  return lines;
}

bool HistoryFile::add(const std::string& input) const {
  if (path_.empty() || input.empty() || !folder_exists(path_)) return false;
  const Descriptor file(open_locked(path_));
  if (!file.open()) return false;
  return file.write((ends_a_line(file) ? "" : "\n") + on_one_line(input) + "\n") == 0;
}

std::string history_path() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state != '\0')
    return std::string(state) + "/fabricsh_history";
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : std::string(home) + "/.fabricsh_history";
}

}  // namespace fabricsh::repl
