#include "script/call/call.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "base/number.hpp"
#include "base/suggest.hpp"
#include "script/call/boundary.hpp"
#include "script/call/chain.hpp"
#include "script/call/parts.hpp"
#include "script/call/push.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

std::vector<std::string> names_of(const std::vector<Argument>& rows) {
  std::vector<std::string> names;
  for (const Argument& row : rows) names.push_back(row.name);
  return names;
}

std::string label(const std::string& path, const std::string& name, bool positional) {
  return (positional ? "argument '" : "field '") + path + name + "'";
}

// For example "{x, y, z}"; if there are many fields, only the first ones.
std::string field_words(const std::vector<Argument>& rows) {
  std::string words;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 6) return "{" + words + ", ...}";
    words += (i > 0 ? ", " : "") + rows[i].name;
  }
  return "{" + words + "}";
}

// For example " { {t, v}, ... }", if the row's sentence begins with the shape of its table.
std::string shape_words(const std::string& sentence) {
  if (sentence.empty() || sentence.front() != '{') return "";
  int depth = 0;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    depth += sentence[i] == '{' ? 1 : sentence[i] == '}' ? -1 : 0;
    if (depth == 0) return " " + sentence.substr(0, i + 1);
  }
  return "";
}

// A list of more names than this is shown by its size alone.
constexpr std::size_t kListed = 20;

std::string choice_words(const Argument& row) {
  if (row.choices.empty()) return "a string";
  if (row.choices.size() > kListed)
    return "one of " + std::to_string(row.choices.size()) + " names, '" + row.choices.front() + "' to '" +
           row.choices.back() + "' (help, or reference.md, lists them)";
  std::string words;
  for (const std::string& choice : row.choices) words += (words.empty() ? "'" : " or '") + choice + "'";
  return words;
}

bool finite_number(lua_State* L, int index, const Range& range) {
  const double x = lua_tonumber(L, index);
  return std::isfinite(x) && range.holds(x);
}

bool whole_number(lua_State* L, int index) {
  int whole = 0;
  lua_tointegerx(L, index, &whole);  // accepts 1e6 as an integer
  return whole != 0;
}

bool holds_numbers(lua_State* L, int index, const Range& range) {
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
  if (n == 0) return false;
  for (lua_Integer i = 1; i <= n; ++i) {
    const bool good = lua_rawgeti(L, index, i) == LUA_TNUMBER && finite_number(L, -1, range);
    lua_pop(L, 1);
    if (!good) return false;
  }
  return true;
}

// A string including zero bytes; empty if the value is not a string.
std::string text_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, index, &length);
  return text == nullptr ? std::string() : std::string(text, length);
}

bool chosen(lua_State* L, int index, const Argument& row) {
  if (row.choices.empty()) return true;
  std::string word = text_at(L, index);
  if (const auto dot = word.rfind('.'); row.with_owner && dot != word.npos && dot > 0) word.erase(0, dot + 1);
  return std::find(row.choices.begin(), row.choices.end(), word) != row.choices.end();
}

bool is_object(lua_State* L, int index, const std::string& of) {
  return luaL_testudata(L, index, class_key(of).c_str()) != nullptr;
}

// Whether the row accepts the value at the absolute index. A table may match several kinds.
bool accepts(lua_State* L, int index, const Argument& row) {
  const unsigned kinds = row.kinds;
  if (kinds & any) return true;
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      if ((kinds & number) != 0) return finite_number(L, index, row.range);
      return (kinds & integer) != 0 && whole_number(L, index) && finite_number(L, index, row.range);
    case LUA_TSTRING:
      return (kinds & text) != 0 && chosen(L, index, row);
    case LUA_TBOOLEAN:
      return (kinds & boolean) != 0;
    case LUA_TFUNCTION:
      return (kinds & function) != 0;
    case LUA_TTABLE:
      if (kinds & (fields | table)) return true;
      return (kinds & numbers) != 0 && holds_numbers(L, index, row.range);
    case LUA_TUSERDATA:
      return (kinds & object) != 0 && is_object(L, index, row.of);
    default:
      return false;
  }
}

std::string came(lua_State* L, int index, const Argument& row) {
  if (lua_isnoneornil(L, index)) return "nil (missing, or a misspelt variable)";
  if (lua_istable(L, index) && (row.kinds & numbers) != 0) {
    const auto n = static_cast<lua_Integer>(lua_rawlen(L, index));
    if (n == 0) return "an empty table";
    for (lua_Integer i = 1; i <= n; ++i) {
      lua_rawgeti(L, index, i);
      const std::string entry = describe(L, -1);
      const bool good = lua_type(L, -1) == LUA_TNUMBER && finite_number(L, -1, row.range);
      lua_pop(L, 1);
      if (!good) return entry + " at place " + std::to_string(i);
    }
  }
  if (lua_type(L, index) == LUA_TSTRING && (row.kinds & text) != 0 && !row.choices.empty())
    return describe(L, index) + did_you_mean(lua_tostring(L, index), row.choices);
  return describe(L, index);
}

// A number far outside the usual range of its row.
struct Unusual {
  std::string value, where, hint;  // "0.6 kg/m^3"; its label
};
using UnusualValues = std::vector<Unusual>;

void note_unusual(lua_State* L, int index, const Argument& row, const std::string& path, bool positional,
                  UnusualValues& found) {
  if (lua_type(L, index) != LUA_TNUMBER || row.hint.empty()) return;
  const double x = lua_tonumber(L, index);
  if (x == 0 || row.usual.holds(std::abs(x))) return;
  found.push_back({exact_number(x) + (row.unit.empty() ? "" : " " + row.unit),
                   label(path, row.name, positional), row.hint});
}

// Those of one call in one line: one unit that is wrong makes many of them.
void warn_unusual(lua_State* L, const UnusualValues& found) {
  if (found.empty()) return;
  const Unusual& first = found.front();
  std::string words =
      position(L) + first.where + ": " + first.value + " is far from what cloth is: " + first.hint;
  for (std::size_t i = 1; i < found.size(); ++i)
    words += (i == 1                  ? "; so are "
              : i + 1 == found.size() ? " and "
                                      : ", ") +
             found[i].where + ", " + found[i].value;
  Session::of(L).warn("units", words);
}

void check_one(lua_State* L, int index, const Argument& row, const std::string& path, bool positional,
               UnusualValues& unusual);

}  // namespace

std::string expected(const Argument& row) {
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : " or ") + more; };
  if (row.kinds & any) add("a value");
  if (row.kinds & number) add(number_words(row.range, row.unit));
  if (row.kinds & integer) add(number_words(row.range, row.unit, "integer"));
  if ((row.kinds & numbers) != 0 && (row.kinds & table) == 0)
    add("a table of numbers" + range_words(row.range) + (row.unit.empty() ? "" : " in " + row.unit));
  if (row.kinds & table)
    add("a table" + shape_words(row.sentence));
  else if (row.kinds & fields)
    add("a table " + field_words(row.rows));
  if (row.kinds & text) add(choice_words(row));
  if (row.kinds & boolean) add("true or false");
  if (row.kinds & function) add("a function");
  if (row.kinds & object) add(with_article(row.of));
  return words;
}

void check_value(lua_State* L, int index, const Argument& row, const std::string& path, bool positional) {
  UnusualValues unusual;
  check_one(L, index, row, path, positional, unusual);
  warn_unusual(L, unusual);
}

namespace {

// Replaces the table with a metatable at index by a plain one: its own entries, and for the rows also what
// the metatable provides.
void flatten(lua_State* L, int index, const std::vector<Argument>& rows) {
  if (lua_getmetatable(L, index) == 0) return;
  lua_pop(L, 1);
  copy_entries(L, index);
  for (const Argument& row : rows) {
    lua_pushstring(L, row.name.c_str());
    lua_getfield(L, index, row.name.c_str());
    lua_rawset(L, -3);
  }
  lua_replace(L, index);
}

// Checks the table at index, which becomes a plain one.
void check_rows(lua_State* L, int index, const std::vector<Argument>& rows, const std::string& path,
                bool positional, UnusualValues& unusual) {
  luaL_checkstack(L, 10, "fields");
  flatten(L, index, rows);
  // The first in the alphabet: Lua's own order differs from one start to the next.
  std::optional<std::string> wrong;
  lua_pushnil(L);
  while (lua_next(L, index) != 0) {
    lua_pop(L, 1);
    if (lua_type(L, -1) != LUA_TSTRING)
      throw Error(path.empty()
                      ? "expected named fields, got an entry without a name at " + describe(L, -1)
                      : "field '" + path.substr(0, path.size() - 1) +
                            "': expected named fields, got an entry without a name at " + describe(L, -1));
    const std::string name = lua_tostring(L, -1);
    bool found = false;
    for (const Argument& row : rows) found = found || row.name == name;
    if (!found && (!wrong || name < *wrong)) wrong = name;
  }
  if (wrong) {
    auto names = names_of(rows);
    for (auto& known : names) known = path + known;
    throw Error(unknown("field", path + *wrong, names));
  }
  for (const Argument& row : rows) {
    lua_getfield(L, index, row.name.c_str());
    make_plain(L);
    check_one(L, -1, row, path, positional, unusual);
    lua_pop(L, 1);
  }
}

// The nearest of many names comes first, then how to see them all.
[[noreturn]] void refuse_value(lua_State* L, int index, const Argument& row, const std::string& where) {
  const bool many = row.choices.size() > kListed && lua_type(L, index) == LUA_TSTRING;
  const std::string guess = many ? did_you_mean(lua_tostring(L, index), row.choices) : "";
  if (!guess.empty())
    throw Error(where + ": got " + describe(L, index) + guess + " Expected " + expected(row));
  throw Error(where + ": expected " + expected(row) + ", got " + came(L, index, row));
}

void check_one(lua_State* L, int index, const Argument& row, const std::string& path, bool positional,
               UnusualValues& unusual) {
  index = lua_absindex(L, index);
  if (lua_isnoneornil(L, index) && !row.required) return;
  if (lua_isnoneornil(L, index) || !accepts(L, index, row))
    refuse_value(L, index, row, label(path, row.name, positional));
  note_unusual(L, index, row, path, positional, unusual);
  if (lua_istable(L, index) && (row.kinds & fields) != 0 && (row.kinds & table) == 0 &&
      !((row.kinds & numbers) != 0 && lua_rawlen(L, index) > 0))
    check_rows(L, index, row.rows, path + row.name + ".", false, unusual);
}

}  // namespace

Fields::Fields(lua_State* L, int index, const std::vector<Argument>& rows, std::string path, bool positional)
    : L_(L), index_(lua_absindex(L, index)), rows_(&rows), path_(std::move(path)), positional_(positional) {
  UnusualValues unusual;
  check_rows(L, index_, rows, path_, positional, unusual);
  if (path_.empty()) warn_unusual(L, unusual);  // those of a table within it have been found before
}

const Argument& Fields::row(std::string_view name) const {
  for (const Argument& row : *rows_)
    if (row.name == name) return row;
  throw std::logic_error("no argument row '" + std::string(name) + "'");
}

int Fields::push(std::string_view name) const {
  luaL_checkstack(L_, 10, "fields");
  const int type = lua_getfield(L_, index_, std::string(name).c_str());
  if (type == LUA_TTABLE) make_plain(L_);
  return type;
}

bool Fields::is(std::string_view name, int lua_type) const {
  const bool same = lua_getfield(L_, index_, std::string(name).c_str()) == lua_type;
  lua_pop(L_, 1);
  return same;
}

bool Fields::has(std::string_view name) const { return !is(name, LUA_TNIL); }

double Fields::number(std::string_view name) const {
  const bool given = push(name) != LUA_TNIL;
  const double value = lua_tonumber(L_, -1);
  lua_pop(L_, 1);
  return given ? value : std::get<double>(row(name).fallback);
}

std::int64_t Fields::integer(std::string_view name) const {
  const double value = number(name);
  if (!(std::abs(value) < 0x1p63)) refuse(name, "expected a smaller integer, got " + exact_number(value));
  return static_cast<std::int64_t>(value);
}

int Fields::count(std::string_view name) const {
  const std::int64_t value = integer(name);
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (value > most || value < -most)
    refuse(name, "expected an integer of at most " + std::to_string(most) + ", got " + std::to_string(value));
  return static_cast<int>(value);
}

std::string Fields::text(std::string_view name) const {
  const bool given = push(name) != LUA_TNIL;
  const std::string value = text_at(L_, -1);
  lua_pop(L_, 1);
  if (given) return value;
  const auto* fallback = std::get_if<std::string>(&row(name).fallback);
  return fallback == nullptr ? "" : *fallback;
}

bool Fields::flag(std::string_view name) const {
  const bool given = push(name) != LUA_TNIL;
  const bool value = lua_toboolean(L_, -1) != 0;
  lua_pop(L_, 1);
  if (given) return value;
  const auto* fallback = std::get_if<bool>(&row(name).fallback);
  return fallback != nullptr && *fallback;
}

void want_table(lua_State* L, int index, const std::string& what) {
  if (!lua_istable(L, index)) throw Error(what + ": expected a table, got " + describe(L, index));
}

std::vector<double> read_numbers(lua_State* L, int index) {
  index = lua_absindex(L, index);
  std::vector<double> values(lua_rawlen(L, index));
  for (std::size_t i = 0; i < values.size(); ++i) {
    lua_rawgeti(L, index, static_cast<lua_Integer>(i + 1));
    values[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return values;
}

std::vector<double> Fields::numbers(std::string_view name) const {
  std::vector<double> values;
  if (push(name) == LUA_TTABLE) {
    const Argument& known = row(name);
    // A function of the deck may have changed the list since it was checked.
    if ((known.kinds & (ValueKind::table | ValueKind::fields)) == 0)
      check_value(L_, -1, known, path_, positional_);
    values = read_numbers(L_, -1);
  }
  lua_pop(L_, 1);
  return values;
}

std::vector<std::string> Fields::texts(std::string_view name, const std::string& expected) const {
  std::vector<std::string> out;
  if (is(name, LUA_TSTRING)) return {text(name)};
  each(name, [&](lua_Integer) {
    if (lua_type(L_, -1) != LUA_TSTRING)
      refuse(name, "expected " + expected + ", got " + script::describe(L_, -1));
    out.emplace_back(lua_tostring(L_, -1));
  });
  return out;
}

Fields Fields::fields(std::string_view name) const {
  push(name);
  return Fields(L_, -1, row(name).rows, path_ + std::string(name) + ".");
}

Function Fields::function(std::string_view name) const {
  push(name);
  Function result;
  if (lua_isfunction(L_, -1)) result = Function(Session::of(L_), L_, -1);
  lua_pop(L_, 1);
  return result;
}

void Fields::refuse(std::string_view name, const std::string& why) const {
  throw Error(label(path_, std::string(name), positional_) + ": " + why);
}

void Fields::want_one_of(std::string_view name, std::string_view other, const std::string& expected) const {
  if (has(name) == has(other)) refuse(name, expected + ", got " + (has(name) ? "both" : "neither"));
}

namespace {

// A function with named fields accepts the first three without names if they are rows, x and y.
int leading(const Entry& entry) {
  const auto& all = entry.arguments;
  return all.size() > 3 && all[0].name == "rows" && all[1].name == "x" && all[2].name == "y" ? 3 : 0;
}

// f(a, b, { c = ... }): the first arguments are positional, and a table with named fields follows.
int gather_led(lua_State* L, const Entry& entry, int first) {
  const int given = lua_gettop(L) - first + 1, most = leading(entry), table = first + most;
  if (given > most + 1)
    throw Error("expected at most " + std::to_string(most + 1) + " arguments, got " + std::to_string(given));
  if (given <= most)
    lua_newtable(L);
  else if (!lua_istable(L, table))
    throw Error("argument " + std::to_string(most + 1) + ": expected a table with named fields, got " +
                describe(L, table));
  else
    lua_pushvalue(L, table);
  make_plain(L);
  const int all = lua_gettop(L);
  copy_entries(L, all);  // the deck's own table stays as it is
  for (int i = 0; i < most; ++i) {
    const std::string& name = entry.arguments[static_cast<std::size_t>(i)].name;
    if (push_raw(L, all, name) != LUA_TNIL)
      throw Error("field '" + name + "': given twice, as argument " + std::to_string(i + 1) +
                  " and by its name");
    lua_pop(L, 1);
    if (i >= given) continue;
    lua_pushstring(L, name.c_str());
    lua_pushvalue(L, first + i);
    lua_rawset(L, -3);
  }
  return lua_gettop(L);
}

// Takes the arguments of earlier releases out of the table on top of the stack, which is replaced by a copy.
void drop_retired(lua_State* L, const Entry& entry) {
  for (const std::string& name : entry.retired) {
    const bool given = lua_getfield(L, -1, name.c_str()) != LUA_TNIL;
    lua_pop(L, 1);
    if (!given) continue;
    Session::of(L).warn("retired", last_word(entry.name) + ": field '" + name +
                                       "' has no effect any more, and will be an error in the next release");
    copy_entries(L, lua_gettop(L));
    lua_pushnil(L);
    lua_setfield(L, -2, name.c_str());
    lua_remove(L, -2);
  }
}

// A function of a file and of what to do with it accepts both by name, as f{ file=, ... }.
bool takes_a_table(lua_State* L, const Entry& entry, int first, int given) {
  return entry.style == Style::positional && !entry.method() && given == 1 && lua_istable(L, first) &&
         entry.arguments.size() > 1 && entry.arguments.front().name == "file" &&
         entry.arguments.front().kinds == text;
}

// To Lua a misspelt variable is nil, and as the last argument the same as none. Where a body, a set or
// another thing is named, what is then meant is something else: no body, or the whole sheet.
void watch_last(lua_State* L, int index, const Entry& entry, const Argument& row) {
  lua_Debug caller;
  if (row.required || !lua_isnil(L, index) || (row.kinds & (object | text)) == 0) return;
  if (lua_getstack(L, 1, &caller) == 0) return;
  lua_getinfo(L, "S", &caller);
  if (own_module(caller.source)) return;
  const std::string where = "argument '" + row.name + "': ";
  if ((row.kinds & object) != 0)
    throw Error(where + "expected " + expected(row) + ", or no value, got nil (a misspelt variable?)");
  Session::of(L).warn("deck", position(L) + last_word(entry.name) + ": " + where +
                                  "nil stands for none (or is it a misspelt variable?); leave it out");
}

// Leaves the table of named arguments on the stack and returns its index.
int gather(lua_State* L, const Entry& entry) {
  const int first = entry.method() || entry.style == Style::property ? 2 : 1;
  const int given = lua_gettop(L) - first + 1;
  if (entry.style == Style::fields && given > 1 && leading(entry) > 0) return gather_led(L, entry, first);
  if (entry.style == Style::fields) {
    if (given > 1)
      throw Error("expected one table with named fields, got " + std::to_string(given) + " values");
    if (!lua_istable(L, first)) {
      throw Error("expected a table with named fields, got " + describe(L, first));
    }
    lua_pushvalue(L, first);
    make_plain(L);
    drop_retired(L, entry);
    return lua_gettop(L);
  }
  if (takes_a_table(L, entry, first, given)) {
    lua_pushvalue(L, first);
    make_plain(L);
    return lua_gettop(L);
  }
  const int most = static_cast<int>(entry.arguments.size());
  if (entry.style == Style::positional && given > most)
    throw Error("expected at most " + std::to_string(most) + " argument" + (most == 1 ? "" : "s") + ", got " +
                std::to_string(given));
  if (given > 0 && given <= most)
    watch_last(L, first + given - 1, entry, entry.arguments[static_cast<std::size_t>(given - 1)]);
  lua_createtable(L, 0, most);
  for (int i = 0; i < most && i < given; ++i) {
    lua_pushvalue(L, first + i);
    lua_setfield(L, -2, entry.arguments[static_cast<std::size_t>(i)].name.c_str());
  }
  return lua_gettop(L);
}

int gathered(lua_State* L, const Entry& entry) {
  const std::string owner = entry.owner();
  if (!owner.empty() && !is_object(L, 1, owner))
    throw Error("called without its " + owner + " (write x:" + last_word(entry.name) +
                "(...), with a colon), got " + describe(L, 1));
  return gather(L, entry);
}

}  // namespace

Call::Call(lua_State* L, const Entry& entry)
    : Fields(L, gathered(L, entry), entry.arguments, {}, entry.style != Style::fields), entry_(entry) {}

}  // namespace fabricsh::script
