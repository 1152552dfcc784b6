#include "script/values/lua_table.hpp"

#include <map>
#include <set>

#include "base/archive.hpp"
#include "script/call/parts.hpp"
#include "script/call/words.hpp"
#include "script/values/card_rows.hpp"

namespace fabricsh::script {

namespace {

enum class Tag : std::uint8_t { number, integer, text, boolean, table, known };
constexpr int kDeepest = 150;  // largest depth of nested tables

// Does not call __tostring, because a function of the deck could change the table being traversed.
std::string name_of_entry(lua_State* L, int key) {
  if (lua_type(L, key) == LUA_TSTRING) return "." + std::string(lua_tostring(L, key));
  return "[" + describe(L, key) + "]";
}

class Packer {
 public:
  explicit Packer(lua_State* L) : L_(L) {}
  std::string bytes() const { return out_.bytes(); }

  void value(int index, const std::string& name) {
    index = lua_absindex(L_, index);
    switch (lua_type(L_, index)) {
      case LUA_TNUMBER:
        return lua_isinteger(L_, index) != 0 ? put(Tag::integer, lua_tointeger(L_, index))
                                             : put(Tag::number, lua_tonumber(L_, index));
      case LUA_TBOOLEAN:
        return put(Tag::boolean, lua_toboolean(L_, index) != 0);
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* text = lua_tolstring(L_, index, &size);
        return put(Tag::text, std::string(text, size));
      }
      case LUA_TTABLE:
        lua_pushvalue(L_, index);
        make_plain(L_);
        lua_pop(L_, 1);
        return table(index, name);
      default:
        throw Error("field '" + name +
                    "': expected a number, text, boolean or table, which can be kept, got " +
                    describe(L_, index));
    }
  }

 private:
  template <class T>
  void put(Tag tag, T content) {
    out_(tag, content);
  }
  // Curves and their columns (lua/fabric/columns.lua) are stored as plain lists.
  bool is_plain(int index) const {
    if (lua_getmetatable(L_, index) == 0) return true;
    const bool named = lua_getfield(L_, -1, "__name") == LUA_TSTRING;
    const std::string kind = named ? lua_tostring(L_, -1) : "";
    lua_pop(L_, 2);
    return kind == "fabric.curve" || kind == "fabric.column";
  }
  void table(int index, const std::string& name) {
    const auto [known, fresh] = ids_.try_emplace(lua_topointer(L_, index), ids_.size());
    if (!fresh) return put(Tag::known, known->second);
    if (!is_plain(index))
      throw Error("field '" + name + "': expected a plain table, got one with a metatable");
    if (++depth_ > kDeepest) throw Error("field '" + name + "': tables lie too deep in one another");
    luaL_checkstack(L_, 8, "keep");
    std::uint64_t count = 0;
    for (lua_pushnil(L_); lua_next(L_, index) != 0; lua_pop(L_, 1)) ++count;
    put(Tag::table, count);
    for (lua_pushnil(L_); lua_next(L_, index) != 0; lua_pop(L_, 1)) {
      const std::string entry = name + name_of_entry(L_, -2);
      if (lua_istable(L_, -2)) throw Error("field '" + entry + "': a table can't be kept as a key");
      value(-2, entry);
      value(-1, entry);
    }
    --depth_;
  }

  lua_State* L_;
  Archive out_;
  std::map<const void*, std::uint64_t> ids_;
  int depth_ = 0;
};

class Filler {
 public:
  Filler(lua_State* L, const std::string& bytes) : L_(L), in_(bytes) {
    lua_newtable(L_);  // the tables found so far, from 1
    tables_ = lua_gettop(L_);
  }

  void root(int index) {
    if (get<Tag>() != Tag::table) damaged();
    table(index);
    if (!in_.at_end()) damaged();
    lua_remove(L_, tables_);
  }

 private:
  template <class T>
  T get() {
    T value{};
    in_(value);
    return value;
  }
  [[noreturn]] static void damaged() { throw Error("the kept table is damaged"); }

  // Pushes a value; for a table, the one at `old` is reused if that is not yet in use.
  void value(int old) {
    switch (get<Tag>()) {
      case Tag::number:
        return lua_pushnumber(L_, get<lua_Number>());
      case Tag::integer:
        return lua_pushinteger(L_, get<lua_Integer>());
      case Tag::boolean:
        return lua_pushboolean(L_, get<bool>());
      case Tag::text: {
        const auto text = get<std::string>();
        lua_pushlstring(L_, text.data(), text.size());
        return;
      }
      case Tag::known: {
        const auto id = get<std::uint64_t>();
        if (id >= count_) damaged();
        lua_rawgeti(L_, tables_, static_cast<lua_Integer>(id + 1));
        return;
      }
      case Tag::table:
        if (old != 0 && lua_istable(L_, old) && used_.count(lua_topointer(L_, old)) == 0)
          lua_pushvalue(L_, old);
        else
          lua_newtable(L_);
        return table(lua_gettop(L_));
      default:
        damaged();
    }
  }

  // Empties and fills the table at index.
  void table(int index) {
    if (++depth_ > kDeepest) damaged();
    luaL_checkstack(L_, 8, "keep");
    used_.insert(lua_topointer(L_, index));
    lua_pushvalue(L_, index);
    lua_rawseti(L_, tables_, static_cast<lua_Integer>(++count_));
    lua_newtable(L_);
    const int old = lua_gettop(L_);
    move_entries(index, old);
    for (auto n = get<std::uint64_t>(); n > 0; --n) {
      value(0);
      if (lua_isnil(L_, -1) || lua_istable(L_, -1) || is_nan(-1)) damaged();
      lua_pushvalue(L_, -1);
      lua_rawget(L_, old);
      value(lua_gettop(L_));
      lua_remove(L_, -2);
      lua_rawset(L_, index);
    }
    lua_remove(L_, old);
    --depth_;
  }
  bool is_nan(int index) const {
    return lua_type(L_, index) == LUA_TNUMBER && lua_rawequal(L_, index, index) == 0;
  }
  void move_entries(int from, int to) {
    for (lua_pushnil(L_); lua_next(L_, from) != 0;) {
      lua_pushvalue(L_, -2);
      lua_insert(L_, -2);
      lua_rawset(L_, to);
      lua_pushvalue(L_, -1);
      lua_pushnil(L_);
      lua_rawset(L_, from);  // permitted during a traversal
    }
  }

  lua_State* L_;
  Archive in_;
  int tables_, depth_ = 0;
  std::uint64_t count_ = 0;
  std::set<const void*> used_;
};

}  // namespace

std::string pack_table(lua_State* L, int index, const std::string& name) {
  Packer packer(L);
  packer.value(index, name);
  return packer.bytes();
}

void fill_table(lua_State* L, int index, const std::string& bytes) {
  index = lua_absindex(L, index);
  const int top = lua_gettop(L);
  Filler(L, bytes).root(index);
  lua_settop(L, top);
}

}  // namespace fabricsh::script
