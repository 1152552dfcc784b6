// Inputs of this and earlier sessions in a file, one to a line. Several sessions may write the same file:
// each adds at its end, under a lock.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::repl {

// An input of several lines as one line, and back.
std::string on_one_line(const std::string& input);
std::string from_one_line(const std::string& line);

class HistoryFile {
 public:
  // Empty path: nothing is kept. Holds the last `kept` inputs, sometimes up to twice as many.
  explicit HistoryFile(std::string path, std::size_t kept = 2000) : path_(std::move(path)), kept_(kept) {}

  // Oldest first; shortens a file that has grown too long. A file that can't be read has none.
  std::vector<std::string> load() const;
  // False when it can't be written.
  bool add(const std::string& input) const;

 private:
  std::string path_;
  std::size_t kept_;
};

// $XDG_STATE_HOME/fabricsh_history, else ~/.fabricsh_history, else empty.
std::string history_path();

}  // namespace fabricsh::repl
