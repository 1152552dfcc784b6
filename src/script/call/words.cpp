#include "script/call/words.hpp"

#include <algorithm>
#include <cctype>

#include "base/number.hpp"
#include "base/suggest.hpp"

namespace fabricsh::script {

std::string unknown(const std::string& kind, std::string_view word, const std::vector<std::string>& known) {
  std::string message = "unknown " + kind + " '" + std::string(word) + "'";
  const std::string guess = nearest(word, known);
  if (!guess.empty()) return message + ", did you mean '" + guess + "'?";
  if (known.empty()) return message;
  message += " (known:";
  // A name that is a method and a property stands twice in the list.
  for (std::size_t i = 0; i < known.size(); ++i)
    if (i == 0 || known[i] != known[i - 1]) message += " " + known[i];
  return message + ")";
}

std::string describe(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL:
      return "nil";
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) ? "true" : "false";
    case LUA_TNUMBER:
      return exact_number(lua_tonumber(L, index));
    case LUA_TSTRING:
      return "'" + std::string(lua_tostring(L, index)).substr(0, 60) + "'";
    default:
      break;
  }
  const int kind = luaL_getmetafield(L, index, "__name");
  const std::string name = kind == LUA_TSTRING ? lua_tostring(L, -1) : luaL_typename(L, index);
  if (kind != LUA_TNIL) lua_pop(L, 1);
  return with_article(name);
}

std::vector<std::string> keys_of(lua_State* L, int index) {
  std::vector<std::string> names;
  index = lua_absindex(L, index);
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pop(L, 1);
    if (lua_type(L, -1) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -1));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string with_article(const std::string& noun) {
  const bool vowel = !noun.empty() && std::string_view("aeiou").find(noun.front()) != std::string_view::npos;
  return (vowel ? "an " : "a ") + noun;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

const std::vector<std::string> keywords = {
    "and", "break", "do",  "else", "elseif", "end",    "false",  "for",  "function", "goto",  "if",
    "in",  "local", "nil", "not",  "or",     "repeat", "return", "then", "true",     "until", "while"};

bool is_name(std::string_view word) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !word.empty() && !std::isdigit(static_cast<unsigned char>(word[0])) &&
         std::all_of(word.begin(), word.end(), fits) &&
         std::find(keywords.begin(), keywords.end(), word) == keywords.end();
}

std::string last_word(std::string_view dotted) {
  const auto cut = dotted.find_last_of(".:");
  return std::string(cut == std::string_view::npos ? dotted : dotted.substr(cut + 1));
}

}  // namespace fabricsh::script
