// fabric.who, fabric.transcript: information on the session for users of the prompt.
#include <algorithm>

#include "script/bind/run.hpp"
#include "script/show/peek.hpp"
#include "script/show/show.hpp"
#include "script/show/transcript.hpp"

namespace fabricsh::script {

template <>
struct ClassName<Transcript> {
  static constexpr const char* name = "transcript";
};

namespace {

constexpr const char* transcript_key = "fabricsh.kept";  // registry
constexpr std::size_t longest_words = 78;

// Whether globals[name] (on top of the stack) is the value that the table at index has under that name.
bool same_in(lua_State* L, int index, const char* name) {
  if (!lua_istable(L, index)) return false;
  push_raw(L, index, name);
  const bool same = lua_rawequal(L, -1, -2) != 0;
  lua_pop(L, 1);
  return same;
}

// Whether the global on top of the stack is Lua's or fabric's own.
bool is_own(lua_State* L, const std::string& name) {
  const int value = lua_gettop(L);
  lua_getfield(L, LUA_REGISTRYINDEX, own_globals_key);
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  peek_field(L, -1, "units");
  const bool module = lua_rawequal(L, value, value + 2) != 0;
  bool own = module || name == "arg";
  for (int table = value + 1; table <= value + 3 && !own; ++table) {
    lua_pushvalue(L, value);
    own = same_in(L, table, name.c_str());
    lua_pop(L, 1);
  }
  lua_settop(L, value);
  return own;
}

int push_words(lua_State* L) { return push_text(L, show(L, 1)); }

// One line describing the value on top of the stack.
std::string one_line(lua_State* L) {
  lua_pushcfunction(L, push_words);
  lua_pushvalue(L, -2);
  const bool said = lua_pcall(L, 1, 1, 0) == LUA_OK;
  std::string words = said ? lua_tostring(L, -1) : "(does not say)";
  lua_pop(L, 1);
  const std::size_t line = words.find('\n');
  if (line != std::string::npos) words = words.substr(0, line) + " ...";
  if (words.size() > longest_words) words = words.substr(0, longest_words - 4) + " ...";
  return words;
}

struct GlobalValue {
  std::string name, cls, words;
  bool object;
};

std::vector<GlobalValue> held_by_globals(lua_State* L) {
  std::vector<GlobalValue> all;
  lua_pushglobaltable(L);
  for (const std::string& name : names_in(L, -1, false).names) {
    if (push_raw(L, -1, name) != LUA_TNIL && !is_own(L, name)) {
      const std::string cls = class_of(L, -1);
      all.push_back({name, cls.empty() ? luaL_typename(L, -1) : cls, one_line(L), !cls.empty()});
    }
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  std::stable_partition(all.begin(), all.end(), [](const GlobalValue& held) { return held.object; });
  return all;
}

int who_text(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  return push_text(L, rows_text(L, 1, {"name", "class", "text"}, "nothing yet"));
}

int who(Call& call) {
  lua_State* L = call.L();
  push_list(L, held_by_globals(L), [&](const GlobalValue& held) {
    push_record(L, "name", held.name, "class", held.cls, "text", held.words);
  });
  set_text_of(L, "fabricsh.who", who_text);
  return 1;
}

int transcript(Call& call) {
  Transcript& kept = transcript_of(call.L());
  if (call.is("file", LUA_TSTRING) && !call.session().options().check) {
    kept.start(call.text("file"));
    call.session().notices().say("this session, from its start, is kept in '" + kept.path() + "'");
  } else if (call.is("file", LUA_TBOOLEAN)) {
    if (call.flag("file")) call.refuse("file", "expected the name of a file, or false to end it, got true");
    kept.end();
  }
  if (call.has("file")) return 0;
  return kept.path().empty() ? push_value(call.L(), false) : push_value(call.L(), kept.path());
}

std::vector<Entry> prompt_entries() {
  return {
      {"fabric.who()",
       {},
       "The global variables that were set at the prompt or by the deck, objects first: rows of name, class "
       "and text, which print as a table.",
       "sheet = require 'fabric'.mesh.rectangle{ width=1, height=1, nx=2, ny=2 }\n"
       "local rows = require 'fabric'.who()\nassert(rows[1].name == 'sheet' and rows[1].class == 'mesh')",
       who},
      {"fabric.transcript()",
       {value_("file?", text | boolean,
               "a new Lua file that holds all input at the prompt, from the start of the session on; false "
               "ends it")},
       "Writes the session as a deck that can be run; without an argument returns the file's name or false. "
       "The file is complete at any moment; inputs that failed are comments in it.",
       "local name = os.tmpname()..'.lua'\nfabric.transcript(name)\n"
       "assert(fabric.transcript() == name and loadfile(name))\nfabric.transcript(false)\nos.remove(name)",
       transcript},
  };
}

void keep_own_globals(lua_State* L) {
  lua_pushglobaltable(L);
  copy_entries(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, own_globals_key);
  lua_pop(L, 1);
}

}  // namespace

Transcript& transcript_of(lua_State* L) {
  lua_getfield(L, LUA_REGISTRYINDEX, transcript_key);
  Transcript& kept = *to_object<Transcript>(L, -1);
  lua_pop(L, 1);
  return kept;
}

void bind_prompt(Session& session) {
  push_object(session.lua(), std::make_shared<Transcript>());
  lua_setfield(session.lua(), LUA_REGISTRYINDEX, transcript_key);
  keep_own_globals(session.lua());
  install(session, prompt_entries());
}

}  // namespace fabricsh::script
