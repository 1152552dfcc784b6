// File names as candidates for completion, and the listing of candidates in columns.
#include <algorithm>
#include <filesystem>

#include "repl/completion.hpp"

namespace fabricsh::repl {

std::vector<std::string> files_like(const std::string& path) {
  namespace fs = std::filesystem;
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const std::string word = path.substr(folder.size());
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, code), end; !code && at != end;
       at.increment(code)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(word) || (name[0] == '.' && word.empty())) continue;
    std::error_code unknown;
    names.push_back(folder + name + (at->is_directory(unknown) ? "/" : ""));
  }
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::string last_part(const std::string& path) {
  if (path.size() < 2) return path;
  const std::size_t slash = path.find_last_of('/', path.size() - 2);
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

std::string in_columns(const std::vector<std::string>& words, std::size_t width, std::size_t most) {
  const std::size_t shown = std::min(words.size(), most);
  std::size_t widest = 0;
  for (std::size_t i = 0; i < shown; ++i) widest = std::max(widest, last_part(words[i]).size());
  const std::size_t columns = std::max<std::size_t>(1, (width + 2) / (widest + 2));
  const std::size_t rows = (shown + columns - 1) / columns;
  std::string out;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = row; i < shown; i += rows) {
      const std::string word = last_part(words[i]);
      out += word;
      if (i + rows < shown) out += std::string(widest + 2 - word.size(), ' ');
    }
    out += '\n';
  }
  if (words.size() > shown) out += "... and " + std::to_string(words.size() - shown) + " more\n";
  return out;
}

}  // namespace fabricsh::repl
