#include "script/show/show.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/number.hpp"
#include "script/call/boundary.hpp"
#include "script/call/object.hpp"
#include "script/call/parts.hpp"
#include "script/call/push.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

constexpr lua_Integer short_list = 12;  // lists with at most this many numbers are shown in full
constexpr std::size_t line_width = 100;
constexpr std::size_t most_fields = 60;
constexpr int most_depth = 2;
constexpr lua_Integer most_records = 40;

// The text at index with control characters written as in Lua: \27, \0.
std::string visible(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, index, &length);
  std::string out;
  for (std::size_t i = 0; i < length; ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const bool plain = (c >= 32 && c != 127) || c == '\n' || c == '\t';
    out += plain ? std::string(1, text[i]) : "\\" + std::to_string(c);
  }
  return out;
}

// Smallest and largest of the values, and the number of those that are NaN.
struct ValueSummary {
  double low = INFINITY, high = -INFINITY;
  lua_Integer lost = 0;
  void add(double x) {
    if (std::isnan(x)) ++lost;
    low = std::fmin(low, x);
    high = std::fmax(high, x);
  }
  std::string text() const {
    std::string words =
        low > high ? "" : ", " + fabricsh::number(low, 7) + " to " + fabricsh::number(high, 7);
    return words + (lost > 0 ? ", " + std::to_string(lost) + " of them nan" : "");
  }
};

bool has_text(lua_State* L, int index) {
  if (luaL_getmetafield(L, index, "__tostring") == LUA_TNIL) return false;
  lua_pop(L, 1);
  return true;
}

// Adds the numbers of the list at the absolute index; false if it has anything else.
bool spread_of(lua_State* L, int index, ValueSummary& spread) {
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= n; ++i) {
    const bool number = lua_rawgeti(L, index, i) == LUA_TNUMBER;
    if (number) spread.add(lua_tonumber(L, -1));
    lua_pop(L, 1);
    if (!number) return false;
  }
  return true;
}

// "<441 x 3 numbers, 0 to 2>"; empty unless every entry is a list of the same number of numbers.
std::string matrix_text(lua_State* L, int index, lua_Integer n) {
  lua_Integer width = 0;
  ValueSummary spread;
  for (lua_Integer i = 1; i <= n; ++i) {
    const bool row = lua_rawgeti(L, index, i) == LUA_TTABLE;
    const auto length = row ? static_cast<lua_Integer>(lua_rawlen(L, -1)) : 0;
    const bool fits = length > 0 && (i == 1 || length == width) && spread_of(L, lua_gettop(L), spread);
    lua_pop(L, 1);
    width = length;
    if (!fits) return "";
  }
  return "<" + std::to_string(n) + " x " + std::to_string(width) + " numbers" + spread.text() + ">";
}

// "<80 rows of E, S, time>"; empty unless every entry is a table with the names of the first.
std::string records_text(lua_State* L, int index, lua_Integer n) {
  std::vector<std::string> names;
  for (lua_Integer i = 1; i <= n; ++i) {
    const bool record = lua_rawgeti(L, index, i) == LUA_TTABLE && lua_rawlen(L, -1) == 0 && !has_text(L, -1);
    const auto own = record ? keys_of(L, lua_gettop(L)) : std::vector<std::string>{};
    lua_pop(L, 1);
    if (own.empty() || (i > 1 && own != names)) return "";
    names = own;
  }
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? "" : ", ") + name;
  return "<" + std::to_string(n) + " rows of " + words + ">";
}

// A short description of a long list; empty if the list should be shown entry by entry.
std::string list_text(lua_State* L, int index) {
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  if (n <= 3) return "";
  lua_rawgeti(L, index, n + 1);
  lua_pop(L, 1);
  ValueSummary spread;
  if (n > short_list && spread_of(L, index, spread))
    return "<" + std::to_string(n) + " numbers" + spread.text() + ">";
  std::string words = matrix_text(L, index, n);
  return words.empty() ? records_text(L, index, n) : words;
}

std::string value_text(lua_State* L, int index, int depth);

// The records of a list as a table; empty if a line would be too long.
std::string record_table(lua_State* L, int index) {
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  lua_rawgeti(L, index, 1);
  std::vector<std::vector<std::string>> rows{keys_of(L, lua_gettop(L))};
  lua_pop(L, 1);
  for (lua_Integer i = 1; i <= n && i <= most_records; ++i) {
    lua_rawgeti(L, index, i);
    rows.emplace_back();
    for (const std::string& name : rows.front()) {
      lua_getfield(L, -1, name.c_str());
      rows.back().push_back(lua_isnil(L, -1) ? "" : value_text(L, -1, most_depth));
      lua_pop(L, 1);
    }
    lua_pop(L, 1);
  }
  std::string text = columns_text(rows);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.size() > line_width) return "";
  if (n > most_records) text += "  ... and " + std::to_string(n - most_records) + " more\n";
  return text.substr(0, text.size() - 1);
}

struct FoundField {
  std::string name, value;
};

// Entries of the table at the absolute index: first the list, then the named ones alphabetically.
std::vector<FoundField> fields_of(lua_State* L, int index, int depth) {
  std::vector<FoundField> fields, named;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= n && fields.size() <= most_fields; ++i) {
    lua_rawgeti(L, index, i);
    fields.push_back({"", value_text(L, -1, depth + 1)});
    lua_pop(L, 1);
  }
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    const bool listed = lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= n;
    if (!listed) {
      const bool plain = lua_type(L, -2) == LUA_TSTRING && is_name(lua_tostring(L, -2));
      named.push_back({plain ? lua_tostring(L, -2) : "[" + value_text(L, -2, most_depth) + "]",
                       value_text(L, -1, depth + 1)});
    }
    lua_pop(L, 1);
  }
  std::sort(named.begin(), named.end(),
            [](const FoundField& a, const FoundField& b) { return a.name < b.name; });
  fields.insert(fields.end(), named.begin(), named.end());
  return fields;
}

// If the list is described by its size, only the named entries are shown besides.
void keep_named(std::vector<FoundField>& fields, const std::string& list) {
  std::erase_if(fields, [](const FoundField& field) { return field.name.empty(); });
  if (!fields.empty()) fields.insert(fields.begin(), FoundField{"", list});
}

std::string one_line(const std::vector<FoundField>& fields) {
  std::string out;
  for (const FoundField& field : fields) {
    out += (out.empty() ? "" : ", ") + (field.name.empty() ? "" : field.name + " = ") + field.value;
    if (out.size() > line_width) return "";
  }
  return "{" + out + "}";
}

std::string many_lines(std::vector<FoundField> fields) {
  const std::size_t more = fields.size() > most_fields ? fields.size() - most_fields : 0;
  fields.resize(fields.size() - more);
  std::vector<std::vector<std::string>> rows;
  const bool named =
      std::any_of(fields.begin(), fields.end(), [](const FoundField& f) { return !f.name.empty(); });
  for (FoundField& field : fields)
    rows.push_back(named ? std::vector{field.name, field.value} : std::vector{field.value});
  return "{\n" + columns_text(rows) + (more > 0 ? "  ... and " + std::to_string(more) + " more\n" : "") + "}";
}

std::string table_text(lua_State* L, int index, int depth) {
  index = lua_absindex(L, index);
  luaL_checkstack(L, 10, "table");
  const std::string list = list_text(L, index);
  if (depth >= most_depth) return list.empty() ? "{...}" : list;
  auto fields = fields_of(L, index, depth);
  if (!list.empty()) keep_named(fields, list);
  if (fields.empty() && !list.empty()) {
    const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
    const std::string rows = depth == 0 && records_text(L, index, n) == list ? record_table(L, index) : "";
    return rows.empty() ? list : rows;
  }
  const std::string line = one_line(fields);
  if (!line.empty()) return line;
  return depth == 0 ? many_lines(std::move(fields)) : "{...}";
}

std::string value_text(lua_State* L, int index, int depth) {
  if (lua_istable(L, index) && !has_text(L, index)) {
    load_members(L, index);
    lua_pushvalue(L, index);
    make_plain(L);
    std::string words = table_text(L, -1, depth);
    lua_pop(L, 1);
    return words;
  }
  if (lua_type(L, index) == LUA_TSTRING && depth > 0) {
    std::string words = visible(L, index);
    std::replace(words.begin(), words.end(), '\n', ' ');
    return "\"" + (words.size() > 60 ? words.substr(0, 57) + "..." : words) + "\"";
  }
  if (depth > 0 && lua_type(L, index) == LUA_TNUMBER && !lua_isinteger(L, index))
    return fabricsh::number(lua_tonumber(L, index), 7);
  luaL_tolstring(L, index, nullptr);
  const std::string words = visible(L, -1);
  lua_pop(L, 1);
  return words.substr(0, depth > 0 ? words.find('\n') : words.find_last_not_of('\n') + 1);
}

constexpr const char* result_name = "__result";

int result_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const bool named = luaL_getmetafield(L, 1, result_name) == LUA_TSTRING;
  const std::string name = named ? lua_tostring(L, -1) : "table", text = table_text(L, 1, 0);
  const bool rows = text.starts_with(" ");  // of records, which start new lines
  return push_text(L, "<" + name + ">" + (rows ? "\n" : " ") + text);
}

}  // namespace

std::string show(lua_State* L, int index) { return value_text(L, lua_absindex(L, index), 0); }

std::string columns_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      if (widths.size() <= i) widths.push_back(0);
      widths[i] = std::max(widths[i], row[i].size());
    }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += "  " + row[i];
      if (i + 1 < row.size()) line.append(widths[i] - row[i].size(), ' ');
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

std::string rows_text(lua_State* L, int index, const std::vector<const char*>& fields, const char* none) {
  std::vector<std::vector<std::string>> rows;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  for (lua_Integer i = 1; i <= n; ++i) {
    if (lua_rawgeti(L, index, i) == LUA_TTABLE) {
      rows.emplace_back();
      for (const char* field : fields) rows.back().push_back(raw_text(L, -1, field));
    }
    lua_pop(L, 1);
  }
  const std::string words = columns_text(rows);
  return words.empty() ? none : words.substr(0, words.size() - 1);
}

std::string lengths_text(const std::vector<double>& lengths, const char* between) {
  double largest = 0;
  for (const double x : lengths) largest = std::max(largest, std::abs(x));
  const bool small = largest < 1;
  std::string out;
  for (const double x : lengths) {
    char text[40];
    std::snprintf(text, sizeof text, x == 0 ? "%.0f" : "%#.3g", small ? 1e3 * x : x);
    std::string word = text;
    if (word.back() == '.') word.pop_back();
    out += (out.empty() ? "" : between) + word;
  }
  return out + (small ? " mm" : " m");
}

void name_result(lua_State* L, const std::string& name) {
  if (lua_getmetatable(L, -1) != 0) {
    lua_pop(L, 1);
    return;
  }
  luaL_getsubtable(L, LUA_REGISTRYINDEX, "fabricsh.results");
  if (lua_getfield(L, -1, name.c_str()) == LUA_TNIL) {
    lua_pop(L, 1);
    push_record(L, result_name, name);
    put(L, "__tostring", result_text, "__metatable", false);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, name.c_str());
  }
  lua_setmetatable(L, -3);
  lua_pop(L, 1);
}

}  // namespace fabricsh::script
