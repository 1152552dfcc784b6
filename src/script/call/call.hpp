// Reading of arguments: checks a call against its row, then returns the values.
#pragma once
#include <cstdint>
#include <lua.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "script/call/object.hpp"
#include "script/session/entry.hpp"
#include "script/session/session.hpp"

namespace fabricsh::script {

// Named values in a Lua table, which the constructor checks against their rows.
class Fields {
 public:
  // path: precedes field names in messages, for example "warp." inside the table warp. A table with a
  // metatable is replaced on the stack by a plain copy of the values for the rows: then later reads return
  // what was checked here, whatever __index returns the next time.
  Fields(lua_State* L, int index, const std::vector<Argument>& rows, std::string path = {},
         bool positional = false);

  lua_State* L() const { return L_; }
  bool has(std::string_view name) const;
  // Pushes the value (nil if absent, whatever the default is) and returns its type.
  int push(std::string_view name) const;
  double number(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  int count(std::string_view name) const;  // as integer(); Error: the value does not fit into an int
  std::string text(std::string_view name) const;
  bool flag(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
  Fields fields(std::string_view name) const;  // leaves its table on the stack
  Function function(std::string_view name) const;
  template <class T>
  std::shared_ptr<T> object(std::string_view name) const {
    push(name);
    auto value = to_object<T>(L_, -1);
    lua_pop(L_, 1);
    return value;
  }
  bool is(std::string_view name, int lua_type) const;
  // look(i) for each entry of the table, from 1, with its value on top of the stack, where it may leave more.
  // Returns how many there are.
  template <class Look>
  lua_Integer each(std::string_view name, Look look) const {
    push(name);
    const int list = lua_gettop(L_);
    const auto count = static_cast<lua_Integer>(lua_rawlen(L_, list));
    for (lua_Integer i = 1; i <= count; ++i) {
      lua_rawgeti(L_, list, i);
      look(i);
      lua_settop(L_, list);
    }
    lua_settop(L_, list - 1);
    return count;
  }
  // The texts in the table, or the one in its place; `expected` of each, as "names of sets".
  std::vector<std::string> texts(std::string_view name, const std::string& expected) const;
  // Throws an error that names the field.
  [[noreturn]] void refuse(std::string_view name, const std::string& why) const;
  // Error in the name of the first unless one of the two is given: "expected either x or y, got both".
  void want_one_of(std::string_view name, std::string_view other, const std::string& expected) const;
  const Argument& row(std::string_view name) const;

 protected:
  lua_State* L_;
  int index_;
  const std::vector<Argument>* rows_;
  std::string path_;
  bool positional_;
};

// A call of a registered function.
class Call : public Fields {
 public:
  Call(lua_State* L, const Entry& entry);
  const Entry& entry() const { return entry_; }
  Session& session() const { return Session::of(L_); }
  template <class T>
  std::shared_ptr<T> self() const {
    return to_object<T>(L_, 1);
  }
  // The result of a method that returns its object.
  int itself() const {
    lua_pushvalue(L_, 1);
    return 1;
  }

 private:
  const Entry& entry_;
};

// Throws Error unless the value at index matches the row; warns of an unusual number.
void check_value(lua_State* L, int index, const Argument& row, const std::string& path, bool positional);

// The numbers in the table at index, which must have been checked.
std::vector<double> read_numbers(lua_State* L, int index);

// Error if the value at index is not a table: "what: expected a table, got 5".
void want_table(lua_State* L, int index, const std::string& what);

}  // namespace fabricsh::script
