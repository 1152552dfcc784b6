// What was typed in a session, as a deck that does the same again.
#pragma once
#include <lua.hpp>
#include <string>

namespace fabricsh::script {

class Session;

class Transcript {
 public:
  // From now on the file holds all that was typed so far, and what will be. Errors: it exists and is not of
  // this session; it can't be written.
  void start(const std::string& path);
  void end();
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

// The session's own.
Transcript& transcript_of(lua_State* L);

// Key of the registry: the globals before any code of the user's.
inline constexpr const char* own_globals_key = "fabricsh.globals";

// fabric.who, fabric.transcript.
void bind_prompt(Session& session);

}  // namespace fabricsh::script
