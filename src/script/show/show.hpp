// Values as a person reads them at the prompt: objects as physics, long lists by their size and range.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

namespace fabricsh::script {

// The value at index. A table that fits goes on one line, a longer one has a line per field; of a list of
// numbers, or of equal rows of numbers, only its size and range are shown where it is long. A list of records
// is a table under their names, inside another table its size and names.
std::string show(lua_State* L, int index);

// Columns set below each other; the last one is not padded. Each line starts with two blanks.
std::string columns_text(const std::vector<std::vector<std::string>>& rows);

// The named fields of the records in the list at index, in columns without the last line end; `none` for an
// empty list.
std::string rows_text(lua_State* L, int index, const std::vector<const char*>& fields, const char* none);

// "25.4 x 76.2 mm", "2.00 x 2.00 m": lengths in m, three digits, in the unit that suits the largest.
std::string lengths_text(const std::vector<double>& lengths, const char* between = " x ");

// Makes show() the __tostring of the table on top of the stack, under the name in `name`, unless it has a
// metatable.
void name_result(lua_State* L, const std::string& name);

}  // namespace fabricsh::script
