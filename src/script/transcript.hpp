// What was typed in a session, as a deck that does the same again.
#pragma once
#include <string>

namespace fabricsh::script {

class Transcript {
 public:
  // From now on the file holds all that was typed so far, and what will be. Errors: it can't be written.
  void start(const std::string& path);
  void end() { path_.clear(); }
  const std::string& path() const { return path_; }  // empty: not kept

  // A whole statement, or a comment, with its newline. While a file is kept it is written anew at once.
  void add(const std::string& text);
  // Counts start() and end(): an input that called one of them has no place in the deck.
  int changes() const { return changes_; }

  std::string deck() const;

 private:
  void write() const;
  std::string path_, body_;
  int changes_ = 0;
};

}  // namespace fabricsh::script
