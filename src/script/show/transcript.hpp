// The input of a session, as a deck that does the same.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

class Transcript {
 public:
  // Writes all previous input to the file, and all later input. Errors: the file exists and is not of this
  // session; it cannot be written.
  void start(const std::string& path);
  void end();
  const std::string& path() const { return path_; }  // empty: no file

  // Adds a whole statement or comment, with its newline. The file, if any, is rewritten at once.
  void add(const std::string& text);
  // Counts start() and end(): an input that calls one of them is left out of the deck.
  int changes() const { return changes_; }

  std::string deck() const;

 private:
  void write() const;
  std::string path_, body_;
  int changes_ = 0;
};

// The transcript of the session.
Transcript& transcript_of(lua_State* L);

// Registry key of the globals before any code of the user has run.
inline constexpr const char* own_globals_key = "fabricsh.globals";

}  // namespace fabricsh::script
