
#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "format/source.hpp"
#include "script/call/chain.hpp"
#include "script/session/session.hpp"

namespace fabricsh::script {

namespace {

bool is_part_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string_view without_space_behind(std::string_view text) {
  const auto last = text.find_last_not_of(" \t");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

std::string_view without_space_before(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return text.substr(first == std::string_view::npos ? text.size() : first);
}

bool ends_with_word(std::string_view text, std::string_view word) {
  return text.ends_with(word) &&
         (text.size() == word.size() || !is_part_of_name(text[text.size() - word.size() - 1]));
}

bool begins_with_word(std::string_view text, std::string_view word) {
  return text.starts_with(word) && (text.size() == word.size() || !is_part_of_name(text[word.size()]));
}

// Leaves the code of a line: a comment behind it is cut off.
std::string_view without_comment(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == '\\') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '-' && text[i + 1] == '-') {
      return text.substr(0, i);
    }
  }
  return text;
}

// Takes off the parentheses around a name that are not those of a call.
void leave_parentheses(std::string_view& before, std::string_view& after) {
  while (before.ends_with('(') && after.starts_with(')')) {
    const std::string_view outside = without_space_behind(before.substr(0, before.size() - 1));
    const bool is_word = !outside.empty() && is_part_of_name(outside.back());
    const bool is_call = is_word || outside.ends_with(')') || outside.ends_with(']');
    bool is_keyword = false;
    for (const char* word : {"if", "elseif", "while", "until", "not", "and", "or", "return"})
      is_keyword = is_keyword || ends_with_word(outside, word);
    if (is_call && !is_keyword) return;
    before = outside;
    after = without_space_before(after.substr(1));
  }
}

// Whether what is around a name asks for its value, so that its author expects that there may be none.
bool is_asked(std::string_view before, std::string_view after) {
  before = without_space_behind(before);
  after = without_space_before(after);
  leave_parentheses(before, after);
  for (const char* word : {"if", "elseif", "while", "until", "not", "and", "or"})
    if (ends_with_word(before, word)) return true;
  if (ends_with_word(before, "type(") || before.ends_with("==") || before.ends_with("~=")) return true;
  for (const char* word : {"or", "and", "then"})
    if (begins_with_word(after, word)) return true;
  return after.starts_with("==") || after.starts_with("~=");
}

enum class Reading { none, asked, used };

// How a line of code, between those beside it, reads a global variable.
Reading reading_of(std::string_view last, std::string_view line, std::string_view next,
                   std::string_view name) {
  Reading found = Reading::none;
  for (auto at = line.find(name); at != std::string::npos; at = line.find(name, at + 1)) {
    const auto end = at + name.size();
    const std::string_view before = line.substr(0, at);
    if (at > 0 && (is_part_of_name(line[at - 1]) || line[at - 1] == '.' || line[at - 1] == ':')) continue;
    if (before.ends_with('"') || before.ends_with('\'')) continue;  // its name, in _G["name"]
    if (end < line.size() && is_part_of_name(line[end])) continue;
    const std::string_view after = without_space_before(line.substr(end));
    if (after.starts_with('=') && !after.starts_with("==")) continue;  // is given a value
    if (!is_asked(without_space_behind(before).empty() ? last : before, after.empty() ? next : after))
      return Reading::used;
    found = Reading::asked;
  }
  return found;
}

// Whether the code at a line of the file uses the variable. Lua counts a name at the end of a line to the
// next.
bool uses(const std::string& file, int number, std::string_view name) {
  std::array<std::string, 4> lines;  // two before it, itself, the next
  try {
    std::istringstream in(format::read_file(file));
    std::string line;
    for (int i = 0; i <= number; ++i) {
      if (!std::getline(in, line)) line.clear();
      std::rotate(lines.begin(), lines.begin() + 1, lines.end());
      lines.back() = without_comment(line);
    }
  } catch (const Error&) {
    return true;  // the deck was moved since it was loaded
  }
  const Reading here = reading_of(lines[1], lines[2], lines[3], name);
  return (here == Reading::none ? reading_of(lines[0], lines[1], lines[2], name) : here) == Reading::used;
}

// _G.name without a value. Its place: where the code of a file reads it.
int read_unset(lua_State* L) {
  lua_Debug reader;
  if (lua_type(L, 2) != LUA_TSTRING || lua_getstack(L, 1, &reader) == 0) return 0;
  lua_getinfo(L, "Sl", &reader);
  if (reader.source[0] != '@' || reader.currentline <= 0) return 0;
  const std::string name = lua_tostring(L, 2);
  // Each place is looked at once: what is read in a loop does not read its file in a loop.
  const std::string place = reader.source + (":" + std::to_string(reader.currentline) + ":" + name);
  if (lua_getfield(L, lua_upvalueindex(1), place.c_str()) != LUA_TNIL) return 0;
  lua_pushboolean(L, 1);
  lua_setfield(L, lua_upvalueindex(1), place.c_str());
  if (own_module(reader.source)) return 0;
  if (uses(reader.source + 1, reader.currentline, name))
    Session::of(L).warn("deck", std::string(reader.source + 1) + ":" + std::to_string(reader.currentline) +
                                    ": the variable '" + name +
                                    "' has no value (misspelt? where none is meant, write " + name +
                                    " or nil)");
  return 0;
}

}  // namespace

void watch_globals(lua_State* L) {
  lua_pushglobaltable(L);
  lua_newtable(L);
  lua_newtable(L);  // the places
  lua_pushcclosure(L, read_unset, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

}  // namespace fabricsh::script
