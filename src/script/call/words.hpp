// Words of messages: an unknown name with the nearest known one, a value as a person would say it.
#pragma once
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::script {

// "unknown field 'heigth', did you mean 'height'?", or the list of known names when none is near.
std::string unknown(const std::string& kind, std::string_view word, const std::vector<std::string>& known);

// The value at index for a message: -1, nil, "left", a table, a mesh.
std::string describe(lua_State* L, int index);

// "a mesh", "an analysis".
std::string with_article(const std::string& noun);

// "1 number", "3 numbers".
std::string counted(std::size_t count, const std::string& noun);

// The words of Lua that can't be names, sorted.
extern const std::vector<std::string> keywords;
// A name of Lua: table.word means something.
bool is_name(std::string_view word);

// "name" for fabric.mesh.rectangle, mesh:set -> rectangle, set.
std::string last_word(std::string_view dotted);

}  // namespace fabricsh::script
