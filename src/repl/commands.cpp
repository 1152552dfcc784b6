#include "repl/commands.hpp"

#include "script/call/words.hpp"
#include "script/show/covered.hpp"

namespace fabricsh::repl {

namespace {

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_free(lua_State* L, const std::string& name) {
  lua_pushglobaltable(L);
  lua_pushstring(L, name.c_str());
  const bool free = lua_rawget(L, -2) == LUA_TNIL;
  lua_pop(L, 2);
  return free;
}

// Whether the text is a help topic: shear, mesh:set, fabric.lab.fit, drape coefficient.
bool is_topic(const std::string& text) {
  std::string word;
  for (const char c : text + ".") {
    if ((c == ' ' || c == '\t') && word.empty()) continue;  // between words
    if (c != '.' && c != ':' && c != ' ' && c != '\t') {
      word += c;
      continue;
    }
    if (!script::is_name(word)) return false;
    word.clear();
  }
  return true;
}

}  // namespace

bool is_exit_command(script::Session& session, const std::string& input) {
  std::string word = trimmed(input);
  if (word.ends_with("()")) word = trimmed(word.substr(0, word.size() - 2));
  return (word == "quit" || word == "exit") && is_free(session.lua(), word);
}

std::string command_as_lua(script::Session& session, const std::string& input) {
  const std::string text = trimmed(input);
  const bool own = script::is_of_fabric(session.lua(), "help"), mark = text.starts_with("?");
  const bool word =
      own && text.starts_with("help") && (text.size() == 4 || text[4] == ' ' || text[4] == '\t');
  if (!mark && !word) return input;
  const std::string topic = trimmed(text.substr(mark ? 1 : 4)),
                    call = own ? "help" : "require('fabric').help";
  if (topic.empty()) return call + "()";
  return is_topic(topic) ? call + "(\"" + topic + "\")" : mark ? call + "(" + topic + ")" : input;
}

}  // namespace fabricsh::repl
