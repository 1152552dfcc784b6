// Values as shown at the prompt: objects with their physical data, long lists by size and range.
#pragma once
#include <lua.hpp>
#include <string>
#include <vector>

#include "card/card.hpp"

namespace fabricsh::script {

// Shows the value at index. A table that fits is shown on one line, a longer one with a line per field. Of a
// long list of numbers, or of equal rows of numbers, only size and range are shown. A list of records is
// shown as a table with their names; inside another table only its size and names are shown.
std::string show(lua_State* L, int index);

// The card as a table with units.
std::string card_words(const card::Card& card);

// Aligns columns; the last one is not padded. Each line begins with two blanks.
std::string columns_text(const std::vector<std::vector<std::string>>& rows);

// The given fields of the records in the list at index, in columns, without a newline at the end; `none` for
// an empty list.
std::string rows_text(lua_State* L, int index, const std::vector<const char*>& fields, const char* none);

// "25.4 x 76.2 mm", "2.00 x 2.00 m": lengths in m, three digits, in a unit that suits the largest.
std::string lengths_text(const std::vector<double>& lengths, const char* between = " x ");

// Makes show() the __tostring of the table on top of the stack, with `name` as its name, unless it has a
// metatable.
void name_result(lua_State* L, const std::string& name);

}  // namespace fabricsh::script
