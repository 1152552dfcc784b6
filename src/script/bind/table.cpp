// fabric.table and fabric.folder: the content of a file of numbers, and the files in a folder.
#include "format/table.hpp"

#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/show/show.hpp"
#include "system/gate.hpp"

namespace fabricsh::script {

namespace {

char separator_of(const std::string& word) {
  return word == "tab" ? '\t' : word == "blank" ? ' ' : word == "auto" ? char{0} : word[0];
}

// One line per column: its name, unit and range.
int table_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  std::vector<std::vector<std::string>> rows;
  for (lua_Integer i = 1; lua_rawgeti(L, 1, i) == LUA_TTABLE; ++i) {
    rows.emplace_back();
    for (const char* name : {"name", "unit", "values"}) {
      lua_pushstring(L, name);
      lua_rawget(L, -2);
      rows.back().push_back(show(L, -1));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  const std::string words = "<table " + raw_text(L, 1, "file") + ", " + std::to_string(rows.size()) +
                            " columns>\n" + columns_text(rows);
  lua_pushlstring(L, words.data(), words.size() - 1);
  return 1;
}

int table_of(Call& call) {
  lua_State* L = call.L();
  const std::string decimal = call.text("decimal");
  const format::Table table = format::read_table(
      call.text("file"),
      {separator_of(call.text("separator")), decimal == "auto" ? char{0} : decimal[0], call.flag("lenient")});
  lua_createtable(L, static_cast<int>(table.columns.size()), 3);
  set_text(L, "file", call.text("file"));
  lua_pushboolean(L, table.header);
  lua_setfield(L, -2, "header");
  lua_Integer place = 0;
  for (const format::TableColumn& column : table.columns) {
    lua_createtable(L, 0, 3);
    set_text(L, "name", column.name);
    set_text(L, "unit", column.unit);
    push_numbers(L, column.values);
    lua_setfield(L, -2, "values");
    if (!column.trouble.empty()) set_text(L, "trouble", column.trouble);
    lua_rawseti(L, -2, ++place);
  }
  lua_createtable(L, static_cast<int>(table.preamble.size()), 0);
  place = 0;
  for (const std::string& line : table.preamble) {
    lua_pushlstring(L, line.data(), line.size());
    lua_rawseti(L, -2, ++place);
  }
  lua_setfield(L, -2, "preamble");
  set_text_of(L, "fabricsh.table", table_text);
  return 1;
}

int folder(Call& call) {
  lua_State* L = call.L();
  const std::vector<std::string> names = system::Gate::of_process().names(call.text("path"));
  lua_createtable(L, static_cast<int>(names.size()), 0);
  lua_Integer place = 0;
  for (const std::string& name : names) {
    lua_pushlstring(L, name.data(), name.size());
    lua_rawseti(L, -2, ++place);
  }
  return 1;
}

std::vector<Entry> rows() {
  return {
      {"fabric.table",
       Style::fields,
       {value_("file", text, "of numbers in columns"),
        value_("separator", text, "between cells; auto: found from the file")
            .one_of({"auto", ",", ";", "tab", "blank"})
            .or_else("auto"),
        value_("decimal", text, "decimal sign; auto: found from the file")
            .one_of({"auto", ".", ","})
            .or_else("auto"),
        value_("lenient", boolean, "a bad cell is no error but nan, and the column has trouble, the message")
            .or_else(false)},
       "Reads a CSV or the like, with or without heading, units, comments, byte-order mark. Returns a list "
       "of columns {name, unit, values} with file, header (whether there is one) and preamble (lines above "
       "the "
       "numbers). A column of text alone (dates, labels) has nan and trouble, the message of its first cell.",
       "local path = os.tmpname()\nlocal f = io.open(path, 'w') f:write 'u (mm);P (N)\\n0;0\\n0,5;1,25\\n' "
       "f:close()\n"
       "local t = require 'fabric'.table{ file=path }\nos.remove(path)\n"
       "assert(#t == 2 and t[2].unit == 'N' and t[2].values[2] == 1.25)",
       table_of},
      {"fabric.folder",
       Style::positional,
       {value_("path", text, "of a folder")},
       "Names in a folder, sorted.",
       "assert(#require 'fabric'.folder '.' >= 0)",
       folder},
  };
}

}  // namespace

void bind_table(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
