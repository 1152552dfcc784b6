// Words for messages: an unknown name with the nearest known one, and descriptions of values.
#pragma once
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::script {

// "unknown field 'heigth', did you mean 'height'?"; with the list of known names if none is near.
std::string unknown(const std::string& kind, std::string_view word, const std::vector<std::string>& known);

// The value at index in words: -1, nil, "left", a table, a mesh.
std::string describe(lua_State* L, int index);

// The keys of a table that are strings, in alphabetical order: Lua's own order differs from one start of the
// program to the next.
std::vector<std::string> keys_of(lua_State* L, int index);

// "a mesh", "an analysis".
std::string with_article(const std::string& noun);

// "1 number", "3 numbers".
std::string counted(std::size_t count, const std::string& noun);

// The reserved words of Lua, sorted.
extern const std::vector<std::string> keywords;
// Whether the word is a valid Lua name, so that table.word can be written.
bool is_name(std::string_view word);

// The last part of a name: rectangle of fabric.mesh.rectangle, set of mesh:set.
std::string last_word(std::string_view dotted);

}  // namespace fabricsh::script
