// The input of a session, as a deck that does the same.
#pragma once
#include <lua.hpp>
#include <set>
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

// --- Globals of the library and of Lua that the user has overwritten.

// Names whose values are still those of Lua, fabric or fabric.units: "print", "model", "mm".
std::set<std::string> names_as_made(lua_State* L);

// For a name that has just been overwritten: what it was, and where that is still available.
std::string covered_words(lua_State* L, const std::string& name);

// Whether the global `name` is fabric.<name> itself.
bool is_of_fabric(lua_State* L, const std::string& name);

}  // namespace fabricsh::script
