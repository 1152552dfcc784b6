// The inputs of this and earlier sessions in a file, one per line. Several sessions may use the same file:
// each appends under a lock.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::repl {

// Converts an input of several lines to one line, and back.
std::string on_one_line(const std::string& input);
std::string from_one_line(const std::string& line);

class HistoryFile {
 public:
  // Empty path: no file. Keeps the last `kept` inputs, at times up to twice as many.
  explicit HistoryFile(std::string path, std::size_t kept = 2000) : path_(std::move(path)), kept_(kept) {}

  // The oldest first; shortens a file that has become too long. Empty if the file cannot be read.
  std::vector<std::string> load() const;
  // False if the file cannot be written.
  bool add(const std::string& input) const;

 private:
  std::string path_;
  std::size_t kept_;
};

// $XDG_STATE_HOME/fabricsh_history, otherwise ~/.fabricsh_history, otherwise empty.
std::string history_path();

}  // namespace fabricsh::repl
