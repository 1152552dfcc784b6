#include "repl/evaluator.hpp"

#include <cstdlib>
#include <lua.hpp>

#include "repl/lexer.hpp"
#include "script/call/chain.hpp"
#include "script/call/words.hpp"
#include "script/sandbox/sandbox.hpp"
#include "script/show/show.hpp"
#include "script/show/transcript.hpp"

namespace fabricsh::repl {

namespace {

// --- Printing values at the prompt.

// A Lua function: all its arguments as one text, separated by tabs. Of tables the first entries are shown.
int present_all(lua_State* L) {
  const int count = lua_gettop(L);
  std::string out;
  for (int i = 1; i <= count; ++i) out += (i > 1 ? "\t" : "") + script::show(L, i);
  lua_pushlstring(L, out.data(), out.size());
  return 1;
}

// --- Errors and results.

bool is_numerical(lua_State* L, int index) {
  if (!lua_istable(L, index)) return false;
  const bool named =
      lua_getfield(L, index, "kind") == LUA_TSTRING && std::string(lua_tostring(L, -1)) == "numerical";
  lua_pop(L, 1);
  return named;
}

// The value given to error(): nothing, a table without a text, or something that has one.
int value_text(lua_State* L) {
  const bool plain = lua_istable(L, 1) && luaL_getmetafield(L, 1, "__tostring") == LUA_TNIL;
  if (lua_isnil(L, 1))
    lua_pushliteral(L, "error without a message (error() was called with nil)");
  else if (plain)
    lua_pushstring(L, ("error without a text: " + script::show(L, 1)).c_str());
  else
    luaL_tolstring(L, 1, nullptr);
  return 1;
}

// A string including zero bytes.
std::string text_at(lua_State* L, int index) {
  std::size_t length = 0;
  const char* text = lua_tolstring(L, index, &length);
  return {text, length};
}

// 12 for "prompt:12: unexpected symbol"; 0 if there is none.
long line_of(const std::string& message) {
  const auto colon = message.find(':');
  return colon == std::string::npos ? 0 : std::strtol(message.c_str() + colon + 1, nullptr, 10);
}

// Makes a result from the error on top of the stack, with the chain of calls, and pops it. A __tostring of
// the user may itself fail.
Result failed(lua_State* L, const std::vector<script::Caller>& callers = {}) {
  script::Session& session = script::Session::of(L);
  session.rest_hook(L);  // an interrupt already handled must not stop the following code
  Result result{is_numerical(L, -1) ? EvaluationOutcome::numerical_failure : EvaluationOutcome::deck_error};
  lua_pushcfunction(L, value_text);
  lua_insert(L, -2);
  lua_pcall(L, 1, 1, 0);
  result.message = lua_type(L, -1) == LUA_TSTRING ? text_at(L, -1) : "(error object without text)";
  if (session.limits() != nullptr) result.message = session.limits()->explained(result.message);
  result.message += script::chain_text(result.message, callers);
  lua_settop(L, 0);
  return result;
}

// Message handler: records the active calls where an error is raised; upvalue: where to store them. Returns
// the error.
int see_callers(lua_State* L) {
  *static_cast<std::vector<script::Caller>*>(lua_touserdata(L, lua_upvalueindex(1))) = script::callers(L);
  return 1;
}

// Calls the chunk below `arguments` values; all results stay on the stack.
Result call(lua_State* L, int arguments) {
  std::vector<script::Caller> callers;
  const int chunk = lua_gettop(L) - arguments;
  lua_pushlightuserdata(L, &callers);
  lua_pushcclosure(L, see_callers, 1);
  lua_insert(L, chunk);
  const int status = lua_pcall(L, arguments, LUA_MULTRET, chunk);
  lua_remove(L, chunk);
  return status == LUA_OK ? Result{} : failed(L, callers);
}

// Whether the error on top says that the input is incomplete; pops it, or the chunk.
bool ends_early(lua_State* L, int status) {
  const std::string message = status == LUA_ERRSYNTAX ? lua_tostring(L, -1) : "";
  lua_pop(L, 1);
  const std::string mark = "<eof>";
  return message.size() >= mark.size() &&
         message.compare(message.size() - mark.size(), mark.size(), mark) == 0;
}

int load(lua_State* L, const std::string& text, const std::string& name) {
  return luaL_loadbufferx(L, text.data(), text.size(), name.c_str(), "t");
}

// Whether a quoted string is unfinished. It cannot continue on the next line, whatever the parser says,
// unless the line ends with a backslash.
bool open_quote(const std::string& input) {
  const auto tokens = tokens_of(input);
  if (tokens.empty() || tokens.back().kind != Token::TokenKind::text || !tokens.back().unfinished)
    return false;
  return input[tokens.back().begin] != '[' && input.back() != '\\';
}

// leading: how many of the values are not the input's.
Result finish(script::Session& session, int leading = 0) {
  lua_State* L = session.lua();
  Result result = call(L, 0);
  if (result.outcome != EvaluationOutcome::done) return result;
  for (; leading > 0; --leading) lua_remove(L, 1);
  if (lua_gettop(L) > 0) {
    lua_pushcfunction(L, present_all);
    lua_insert(L, 1);
    if (lua_pcall(L, lua_gettop(L) - 1, 1, 0) != LUA_OK) return failed(L);
    result.shown = text_at(L, -1);
  }
  lua_settop(L, 0);
  return result;
}

int require_module(lua_State* L) {
  lua_getglobal(L, "require");
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  lua_setglobal(L, lua_tostring(L, 2));
  return 0;
}

int call_globals(lua_State* L) {
  lua_getglobal(L, "require");
  lua_pushliteral(L, "fabric");
  lua_call(L, 1, 1);
  lua_getfield(L, -1, "globals");
  lua_call(L, 0, 0);
  return 0;
}

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_free(lua_State* L, const std::string& name) {
  lua_pushglobaltable(L);
  lua_pushstring(L, name.c_str());
  const bool free = lua_rawget(L, -2) == LUA_TNIL;
  lua_pop(L, 2);
  return free;
}

// Whether the text is a help topic: shear, mesh:set, fabric.lab.fit, drape coefficient.
bool is_topic(const std::string& text) {
  std::string word;
  for (const char c : text + ".") {
    if ((c == ' ' || c == '\t') && word.empty()) continue;  // between words
    if (c != '.' && c != ':' && c != ' ' && c != '\t') {
      word += c;
      continue;
    }
    if (!script::is_name(word)) return false;
    word.clear();
  }
  return true;
}

}  // namespace

std::string without_equals(const std::string& input) {
  const std::size_t first = input.find_first_not_of(" \t");
  return first != std::string::npos && input[first] == '=' ? input.substr(first + 1) : input;
}

bool is_incomplete(script::Session& session, const std::string& input) {
  if (open_quote(input)) return false;
  lua_State* L = session.lua();
  const int expression = load(L, "return " + without_equals(input), "=prompt");
  const bool early = ends_early(L, expression);
  if (expression == LUA_OK) return false;
  return ends_early(L, load(L, input, "=prompt")) || early;
}

Result evaluate(script::Session& session, const std::string& input) {
  lua_State* L = session.lua();
  if (session.limits() != nullptr) session.limits()->renew();
  session.rest_hook(L);
  lua_settop(L, 0);
  if (load(L, "return " + without_equals(input), "=prompt") == LUA_OK) {
    // A call as the only value would be a tail call, which leaves no place in the input for messages.
    const bool placed = load(L, "return nil, " + without_equals(input), "=prompt") == LUA_OK;
    lua_remove(L, placed ? 1 : 2);
    Result result = finish(session, placed ? 1 : 0);
    result.expression = true;
    return result;
  }
  if (load(L, input, "=prompt") == LUA_OK) {
    lua_remove(L, 1);
    return finish(session);
  }
  // Neither an expression nor a statement: of the two errors the one further on is the better.
  if (line_of(text_at(L, 1)) > line_of(text_at(L, 2))) lua_pop(L, 1);
  return failed(L);
}

Result run_text(script::Session& session, const std::string& text, const std::string& name) {
  lua_State* L = session.lua();
  if (load(L, text, name) != LUA_OK) return failed(L);
  Result result = call(L, 0);
  lua_settop(L, 0);
  return result;
}

Result run_deck(script::Session& session, const std::string& path,
                const std::vector<std::string>& arguments) {
  lua_State* L = session.lua();
  if (script::load_file(L, path) != LUA_OK) return failed(L);
  luaL_checkstack(L, static_cast<int>(arguments.size()) + 1, "too many arguments");
  for (const std::string& argument : arguments) lua_pushlstring(L, argument.data(), argument.size());
  Result result = call(L, static_cast<int>(arguments.size()));
  lua_settop(L, 0);
  return result;
}

Result run_module(script::Session& session, const std::string& module) {
  lua_State* L = session.lua();
  const auto equals = module.find('=');
  const std::string global = module.substr(0, equals);
  const std::string name = equals == std::string::npos ? module : module.substr(equals + 1);
  lua_pushcfunction(L, require_module);
  lua_pushstring(L, name.c_str());
  lua_pushstring(L, global.c_str());
  return call(L, 2);
}

Result spill_globals(script::Session& session) {
  lua_pushcfunction(session.lua(), call_globals);
  return call(session.lua(), 0);
}

void set_arguments(script::Session& session, const std::vector<std::string>& line, std::size_t script) {
  lua_State* L = session.lua();
  lua_createtable(L, static_cast<int>(line.size()), 2);
  for (std::size_t i = 0; i < line.size(); ++i) {
    lua_pushlstring(L, line[i].data(), line[i].size());
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) - static_cast<lua_Integer>(script));
  }
  lua_setglobal(L, "arg");
}

bool is_exit_command(script::Session& session, const std::string& input) {
  std::string word = trimmed(input);
  if (word.ends_with("()")) word = trimmed(word.substr(0, word.size() - 2));
  return (word == "quit" || word == "exit") && is_free(session.lua(), word);
}

std::string command_as_lua(script::Session& session, const std::string& input) {
  const std::string text = trimmed(input);
  const bool own = script::is_of_fabric(session.lua(), "help"), mark = text.starts_with("?");
  const bool word =
      own && text.starts_with("help") && (text.size() == 4 || text[4] == ' ' || text[4] == '\t');
  if (!mark && !word) return input;
  const std::string topic = trimmed(text.substr(mark ? 1 : 4)),
                    call = own ? "help" : "require('fabric').help";
  if (topic.empty()) return call + "()";
  return is_topic(topic) ? call + "(\"" + topic + "\")" : mark ? call + "(" + topic + ")" : input;
}

}  // namespace fabricsh::repl
