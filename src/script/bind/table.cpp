// fabric.table and fabric.folder: the content of a file of numbers, and the files in a folder.
#include "format/table.hpp"

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
      push_raw(L, -1, name);
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

void push_column(lua_State* L, const format::TableColumn& column) {
  push_record(L, "name", column.name, "unit", column.unit, "values", column.values);
  if (!column.error.empty()) put(L, "trouble", column.error);
  if (!column.doubt.empty()) put(L, "doubt", column.doubt);
  if (!column.heads.empty()) put(L, "heads", column.heads);
  if (!column.words.empty()) put(L, "words", column.words);
}

void push_table(lua_State* L, const std::string& file, const format::Table& table) {
  lua_createtable(L, static_cast<int>(table.columns.size()), 6);
  put(L, "file", file, "name", table.name);
  if (!table.sheet.empty()) put(L, "sheet", table.sheet);
  put(L, "header", table.header);
  lua_Integer place = 0;
  for (const format::TableColumn& column : table.columns) {
    push_column(L, column);
    lua_rawseti(L, -2, ++place);
  }
  const auto push_left_out = [L](const format::LeftOut& one) {
    push_record(L, "text", one.text, "line", one.line, "numbers", one.numbers);
  };
  put(
      L, "preamble", table.preamble, "lines",
      [&] { push_list(L, table.lines, [L](const auto& one) { push_value(L, one); }); }, "left_out",
      [&] { push_list(L, table.left_out, push_left_out); });
  set_text_of(L, "fabricsh.table", table_text);
}

format::TableForm form_of(Call& call) {
  const std::string decimal = call.text("decimal"), thousands = call.text("thousands");
  return {separator_of(call.text("separator")), decimal == "auto" ? char{0} : decimal[0],
          call.flag("lenient"), thousands == "auto" ? char{0} : thousands[0]};  // 'n' of "none"
}

// Totals below the rows are reported, since a reader of the file sees numbers there.
void warn_left_out(Call& call, const format::Table& table) {
  for (const format::LeftOut& one : table.left_out)
    if (one.numbers) {
      const std::string words = "table: " + table.name + ":" + std::to_string(one.line) + ": '" + one.text +
                                "' is no row and is left out" +
                                (table.left_out.size() > 1 ? ", as are the lines below" : "");
      call.session().notices().once(words, "warning: " + words);
      return;
    }
}

// Further meanings of the numbers of a column. A lenient caller looks at the columns that it takes itself.
void warn_doubts(Call& call, const format::Table& table) {
  if (call.flag("lenient")) return;
  for (const format::TableColumn& column : table.columns)
    if (!column.doubt.empty()) {
      const std::string words = "table: " + table.name + ": column '" + column.name + "': " + column.doubt;
      call.session().notices().once(words, "warning: " + words);
    }
}

int table_of(Call& call) {
  lua_State* L = call.L();
  const std::string file = call.text("file");
  if (!call.flag("blocks")) {
    const format::Table table = format::read_table(file, form_of(call));
    warn_left_out(call, table);
    warn_doubts(call, table);
    push_table(L, file, table);
    return 1;
  }
  const auto tables = format::read_tables(file, form_of(call));
  push_list(L, tables, [&](const auto& one) {
    warn_left_out(call, one);
    warn_doubts(call, one);
    push_table(L, file, one);
  });
  return 1;
}

int folder(Call& call) { return push_texts(call.L(), system::Gate::of_process().names(call.text("path"))); }

std::vector<Entry> table_entries() {
  return {
      {"fabric.table{}",
       {value_("file", text, "of numbers in columns"),
        value_("separator", text, "between cells; auto: found from the file")
            .one_of({"auto", ",", ";", "tab", "blank"})
            .or_else("auto"),
        value_("decimal", text, "decimal sign; auto: found from the file")
            .one_of({"auto", ".", ","})
            .or_else("auto"),
        value_("thousands", text,
               "sign between thousands, wherever it occurs; auto: where it cannot be the decimal sign; none: "
               "no sign stands there")
            .one_of({"auto", ".", ",", "none"})
            .or_else("auto"),
        flag_("blocks",
              "a list of the tables in the file, one for each heading or sheet; false: there is one"),
        flag_("lenient", "a bad cell is no error but nan, and the column has trouble, the message")},
       "Reads a CSV or the like, with or without heading, units, comments, byte-order mark. Returns a list "
       "of columns {name, unit, values} with file, header (whether there is one) and preamble (lines above "
       "the numbers), lines (of the file, of each row) and left_out, the lines of words and totals below the "
       "rows. A column of text alone (dates, labels) has nan, words, and trouble, the message of its first "
       "cell. A spreadsheet (.xlsx) is read where openpyxl is installed.",
       "local path = os.tmpname()\nlocal f = io.open(path, 'w') f:write 'u (mm);P (N)\\n0;0\\n0,5;1,25\\n' "
       "f:close()\n"
       "local t = require 'fabric'.table{ file=path }\nos.remove(path)\n"
       "assert(#t == 2 and t[2].unit == 'N' and t[2].values[2] == 1.25)",
       table_of},
      {"fabric.folder()",
       {value_("path", text, "of a folder")},
       "Names in a folder, sorted.",
       "assert(#require 'fabric'.folder '.' >= 0)",
       folder},
  };
}

}  // namespace

void bind_table(Session& session) { install(session, table_entries()); }

}  // namespace fabricsh::script
