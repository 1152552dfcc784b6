#include "repl/completion.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "repl/lexer.hpp"
#include "script/call/boundary.hpp"
#include "script/call/words.hpp"
#include "script/show/peek.hpp"

namespace fabricsh::repl {

namespace {

// --- The context of the cursor in Lua text: what is being typed, in which call, after which object. Uses
// only the text, not the Lua state.

// The steps of a path such as a.b["c"][2]:d(...).e; the first one is a global.
struct PathStep {
  std::string name;  // empty: the step is `number`
  long long number = 0;
  bool method = false;  // after a colon
  bool called = false;  // the result of calling it
};
using Path = std::vector<PathStep>;

// A bracket or block that is still open.
struct OpenBracket {
  std::string open;                // "(", "{", "[", or the keyword of a block
  std::optional<Path> callee;      // what is called by ( or {, or indexed by [; empty: not known, or nothing
  std::size_t argument = 0;        // number of commas so far
  std::string key;                 // inside {: `key =` of the entry being typed
  std::vector<std::string> given;  // inside {: the keys of all entries so far
};

struct CursorContext {
  enum class ContextKind {
    nothing,  // a comment, a number
    word,     // a name
    member,   // a name after `path.` or `path:`
    text,     // within quotes
  };
  ContextKind kind = ContextKind::nothing;
  std::size_t from = 0;                  // position where the word begins, without the quote
  std::string word = {};                 // the part typed so far
  char quote = '\0';                     // for a string
  std::optional<Path> path = {};         // for a member; empty: not known
  bool method = false;                   // after a colon
  bool behind_value = false;             // nothing typed yet, directly after a string or a closed bracket
  bool first = false;                    // the word may be the key of an entry in a table
  std::vector<OpenBracket> frames = {};  // outermost first
};

using Tokens = std::vector<Token>;
using TokenKind = Token::TokenKind;

bool ends_value(const Token& token) {
  return token.kind == TokenKind::name || token.kind == TokenKind::text || token.is(")") || token.is("]") ||
         token.is("}");
}

// The step given by ["c"] or [2] in the tokens before `end`.
std::optional<PathStep> bracket_step(const Tokens& tokens, std::size_t end) {
  if (end < 4 || !tokens[end - 3].is("[")) return {};
  const Token& inside = tokens[end - 2];
  if (inside.kind == TokenKind::text) return PathStep{inside.word};
  if (inside.kind == TokenKind::number) return PathStep{"", std::strtoll(inside.word.c_str(), nullptr, 10)};
  return {};
}

// The token with the bracket that is closed just before `end`; empty if there is none.
std::optional<std::size_t> opening(const Tokens& tokens, std::size_t end) {
  int depth = 0;
  for (std::size_t i = end; i-- > 0;) {
    depth -= nesting(tokens[i]);
    if (depth == 0) return i;
  }
  return {};
}

// Where the arguments begin of a call that ends before `end`: f(x), f{x}, f "x"; empty if it is no call.
std::optional<std::size_t> arguments_of(const Tokens& tokens, std::size_t end) {
  const Token& last = tokens[end - 1];
  const bool text = last.kind == TokenKind::text && !last.unfinished;
  const auto begin = text                           ? std::optional(end - 1)
                     : last.is(")") || last.is("}") ? opening(tokens, end)
                                                    : std::nullopt;
  return begin && *begin > 0 && tokens[*begin - 1].kind == TokenKind::name ? begin : std::nullopt;
}

// The path that ends before `end`; empty if it is an expression, or no value at all.
std::optional<Path> path_before(const Tokens& tokens, std::size_t end) {
  Path path;
  while (end > 0) {
    if (tokens[end - 1].is("]")) {
      const auto step = bracket_step(tokens, end);
      if (!step) return {};
      path.insert(path.begin(), *step);
      end -= 3;
      continue;
    }
    const auto arguments = arguments_of(tokens, end);
    if (arguments) end = *arguments;
    const Token& last = tokens[end - 1];
    if (last.kind != TokenKind::name) return {};
    const bool dot = end > 1 && tokens[end - 2].is("."), colon = end > 1 && tokens[end - 2].is(":");
    path.insert(path.begin(), PathStep{last.word, 0, colon, arguments.has_value()});
    if (!dot && !colon) return path;
    end -= 2;
  }
  return {};
}

bool at_key(const OpenBracket& frame) { return frame.open == "{" && frame.key.empty(); }

void open_frame(const Tokens& tokens, std::size_t i, std::vector<OpenBracket>& frames) {
  OpenBracket frame{tokens[i].word, {}, 0, {}, {}};
  const bool called =
      i > 0 && ends_value(tokens[i - 1]) && nesting(tokens[i]) > 0 && tokens[i].kind == TokenKind::symbol;
  if (called) frame.callee = path_before(tokens, i);
  frames.push_back(std::move(frame));
}

void follow(const Tokens& tokens, std::size_t i, std::vector<OpenBracket>& frames) {
  const Token& token = tokens[i];
  if (nesting(token) > 0) return open_frame(tokens, i, frames);
  if (frames.empty()) return;
  OpenBracket& top = frames.back();
  if (nesting(token) < 0) {
    frames.pop_back();
  } else if (token.is(",") || (token.is(";") && top.open == "{")) {
    ++top.argument;
    top.key.clear();
  } else if (token.is("=") && at_key(top) && i > 0 && tokens[i - 1].kind == TokenKind::name) {
    top.key = tokens[i - 1].word;
    top.given.push_back(top.key);
  }
}

// A string right after a value is the only argument of a call: fabric.card "
void text_place(const Tokens& tokens, CursorContext& place, std::string_view all) {
  const Token& text = tokens.back();
  place.kind = CursorContext::ContextKind::text;
  place.quote = all[text.begin];
  place.word = text.word;
  place.from = all.size() - text.word.size();
  if (tokens.size() < 2 || !ends_value(tokens[tokens.size() - 2])) return;
  OpenBracket frame{"(", path_before(tokens, tokens.size() - 1), 0, {}, {}};
  if (frame.callee) place.frames.push_back(std::move(frame));
}

// For a name, or the position right after a dot, a colon, or anything else.
void word_place(const Tokens& tokens, CursorContext& place, std::string_view all) {
  const bool typed = !tokens.empty() && tokens.back().end == all.size() &&
                     (tokens.back().kind == TokenKind::name || tokens.back().kind == TokenKind::keyword);
  const std::size_t before = tokens.size() - (typed ? 1 : 0);
  place.kind = CursorContext::ContextKind::word;
  place.from = typed ? tokens.back().begin : all.size();
  if (typed) place.word = tokens.back().word;
  if (before == 0) return;
  const Token& mark = tokens[before - 1];
  place.behind_value = !typed && ends_value(mark) && mark.end == place.from;
  place.first = mark.is("{") || mark.is(",") || mark.is(";");
  if ((!mark.is(".") && !mark.is(":")) || mark.end != place.from) return;
  place.kind = CursorContext::ContextKind::member;
  place.method = mark.is(":");
  place.path = path_before(tokens, before - 1);
}

CursorContext context_at_end(std::string_view text) {
  Tokens tokens = tokens_of(text);
  CursorContext place;
  const bool comment =
      !tokens.empty() && tokens.back().kind == TokenKind::comment && tokens.back().unfinished;
  const bool number =
      !tokens.empty() && tokens.back().kind == TokenKind::number && tokens.back().end == text.size();
  if (comment || number) return place;
  std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::comment; });
  for (std::size_t i = 0; i < tokens.size(); ++i) follow(tokens, i, place.frames);
  const bool quoted = !tokens.empty() && tokens.back().kind == TokenKind::text && tokens.back().unfinished;
  if (quoted && text[tokens.back().begin] != '[')
    text_place(tokens, place, text);
  else if (!quoted)
    word_place(tokens, place, text);
  place.first = place.first && !place.frames.empty() && at_key(place.frames.back());
  return place;
}

// --- Candidates.

using script::Argument;
using script::Entry;
using script::is_name;
using script::keywords;
using Words = std::vector<std::string>;

void add(Words& to, const Words& more) { to.insert(to.end(), more.begin(), more.end()); }

// Class of the object that a function, method or property returns; "self": the object on which the method was
// called; empty: not an object, or not fixed.
std::string result_class(std::string_view entry) {
  static const std::map<std::string_view, std::string_view> classes = {
      {"fabric.card", "card"},       {"fabric.woven", "card"},       {"fabric.svk", "card"},
      {"fabric.linear", "card"},     {"card:with", "card"},          {"fabric.point", "point"},
      {"fabric.history", "history"}, {"fabric.ramp", "history"},     {"fabric.model", "model"},
      {"fabric.static", "analysis"}, {"fabric.dynamic", "analysis"}, {"analysis:snapshot", "snapshot"},
      {"model.mesh", "mesh"},        {"model.card", "card"},         {"analysis.model", "model"},
      {"analysis.mesh", "mesh"},     {"analysis:solve", "self"},     {"analysis:advance", "self"},
      {"analysis:step", "self"},     {"analysis:every", "self"},     {"analysis:event", "self"},
      {"analysis:record", "self"},   {"analysis:vtk", "self"},       {"analysis:checkpoint", "self"},
      {"analysis:restore", "self"},  {"mesh:map", "self"},           {"mesh:wrap", "self"},
      {"model:fix", "self"},         {"model:move", "self"},         {"model:force", "self"},
      {"model:gravity", "self"},     {"model:moment", "self"},       {"model:traction", "self"},
      {"model:pressure", "self"},    {"model:spring", "self"},       {"model:turn", "self"},
      {"model:velocity", "self"},    {"model:symmetry", "self"},     {"model:tie", "self"},
      {"model:remove", "self"},      {"model:contact", "self"},      {"analysis:write", "self"},
      {"model:gas", "gas"},
  };
  if (entry.starts_with("fabric.mesh.")) return "mesh";
  if (entry.starts_with("fabric.rigid.")) return "body";
  const auto found = classes.find(entry);
  return found == classes.end() ? std::string() : std::string(found->second);
}

class Completer {
 public:
  Completer(script::Session& session, std::string_view text)
      : session_(session), L_(session.lua()), text_(text), place_(context_at_end(text)) {}

  Completion run() {
    if (place_.kind == CursorContext::ContextKind::word && !place_.behind_value) complete_word();
    if (place_.kind == CursorContext::ContextKind::member) complete_member();
    if (place_.kind == CursorContext::ContextKind::text) complete_text();
    return finish();
  }

 private:
  // Pushes the value at the first `steps` steps of a path without calling anything. For the result of a
  // function only its class is known; then nil is pushed and the class returned, except if the result is the
  // object on which the method was called.
  std::string push(const Path& path, std::size_t steps) {
    lua_pushglobaltable(L_);
    std::string known;
    for (std::size_t i = 0; i < steps; ++i) {
      known = known.empty() ? step_from_value(path[i]) : step_from_class(path[i], known);
    }
    return known;
  }

  // Replaces the value on top by the result of one step from it.
  std::string step_from_value(const PathStep& step) {
    if (step.name.empty())
      script::peek_item(L_, -1, step.number);
    else
      script::peek_field(L_, -1, step.name);
    if (step.called) return call(step);
    lua_remove(L_, -2);
    return {};
  }

  // A call of the function on top, which belongs to the value below it: replaces both by the result.
  std::string call(const PathStep& step) {
    const Entry* entry = script::entry_of(L_, -1);
    const std::string owner = script::class_of(L_, -2);
    if (entry == nullptr && step.method) entry = session_.registry().find(owner + ":" + step.name);
    const std::string result = entry == nullptr ? "" : result_class(entry->name);
    lua_pop(L_, 1);
    if (result == "self") return {};
    lua_pop(L_, 1);
    lua_pushnil(L_);
    return result;
  }

  // A step from a value of which only the class is known; the nil on top is kept.
  static std::string step_from_class(const PathStep& step, const std::string& owner) {
    const std::string result = result_class(owner + (step.called ? ":" : ".") + step.name);
    return result == "self" ? owner : result;
  }

  const Entry* callee(const OpenBracket& frame) {
    if (!frame.callee || frame.open == "[") return nullptr;
    push(*frame.callee, frame.callee->size());
    const Entry* entry = script::entry_of(L_, -1);
    lua_pop(L_, 1);
    if (entry != nullptr || !frame.callee->back().method) return entry;
    return method_of(frame);
  }

  // The method for a name that is both a property and a method (mesh.elements, mesh:elements), or for a
  // method of a call's result.
  const Entry* method_of(const OpenBracket& frame) {
    const std::string known = push(*frame.callee, frame.callee->size() - 1);
    const std::string owner = known.empty() ? script::class_of(L_, -1) : known;
    lua_pop(L_, 1);
    return session_.registry().find(owner + ":" + frame.callee->back().name);
  }

  static const Argument* named(const std::vector<Argument>& rows, const std::string& name) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Argument& r) { return r.name == name; });
    return row == rows.end() ? nullptr : &*row;
  }

  // Rows of the entries in the table that frame `level` opens; null if not known.
  const std::vector<Argument>* rows_inside(std::size_t level) {
    const OpenBracket& frame = place_.frames[level];
    if (frame.open != "{") return nullptr;
    if (const Entry* entry = callee(frame)) {
      if (entry->style == script::Style::fields) return &entry->arguments;
      return entry->arguments.empty() ? nullptr : &entry->arguments[0].rows;
    }
    if (frame.callee || level == 0) return nullptr;
    const Entry* outer = place_.frames[level - 1].open == "(" ? callee(place_.frames[level - 1]) : nullptr;
    if (outer != nullptr && outer->style == script::Style::fields) return &outer->arguments;
    const Argument* row = row_inside(level - 1);
    return row == nullptr ? nullptr : &row->rows;
  }

  // The row of the value being typed inside frame `level`; inside a list, the row of the list.
  const Argument* row_inside(std::size_t level) {
    const OpenBracket& frame = place_.frames[level];
    if (frame.open == "(") {
      const Entry* entry = callee(frame);
      const bool known = entry != nullptr && entry->style != script::Style::fields;
      return known && frame.argument < entry->arguments.size() ? &entry->arguments[frame.argument] : nullptr;
    }
    if (!frame.key.empty()) {
      const auto* rows = rows_inside(level);
      return rows == nullptr ? nullptr : named(*rows, frame.key);
    }
    const bool list = frame.open == "{" && !frame.callee && level > 0;
    return list ? row_inside(level - 1) : nullptr;
  }

  const Argument* row() { return place_.frames.empty() ? nullptr : row_inside(place_.frames.size() - 1); }

  // Adds the names of arguments not given yet; true if any of them matches.
  bool argument_names() {
    const auto* rows = place_.first ? rows_inside(place_.frames.size() - 1) : nullptr;
    if (rows == nullptr) return false;
    const Words& given = place_.frames.back().given;
    for (const Argument& argument : *rows)
      if (std::find(given.begin(), given.end(), argument.name) == given.end() &&
          argument.name.starts_with(place_.word))
        found_.push_back(argument.name + "=");
    return !found_.empty();
  }

  // Adds values that the row accepts: its words, in quotes, and global objects of its class.
  bool values_of_row() {
    const Argument* wanted = row();
    if (wanted == nullptr) return false;
    if (place_.word.empty())
      for (const std::string& choice : wanted->choices) found_.push_back("\"" + choice + "\"");
    if (wanted->kinds & script::object) objects(wanted->of);
    return !found_.empty();
  }

  void objects(const std::string& cls) {
    lua_pushglobaltable(L_);
    for (const std::string& name : script::names_in(L_, -1, false).names) {
      script::peek_field(L_, -1, name);
      if (script::class_of(L_, -1) == cls && name.starts_with(place_.word)) found_.push_back(name);
      lua_pop(L_, 1);
    }
    lua_pop(L_, 1);
  }

  void complete_word() {
    if (argument_names() || values_of_row()) return;
    add(found_, keywords);
    lua_pushglobaltable(L_);
    add_names(false);
    lua_pop(L_, 1);
    const auto tokens = tokens_of(text_.substr(0, place_.from));
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i)
      if ((tokens[i].is("local") || tokens[i].is("for")) && tokens[i + 1].kind == Token::TokenKind::name)
        found_.push_back(tokens[i + 1].word);
  }

  void complete_member() {
    if (!place_.path) return;
    const std::string known = push(*place_.path, place_.path->size());
    if (known.empty())
      add_names(place_.method);
    else
      found_ = names_of(known);
    lua_pop(L_, 1);
  }

  // Adds the names in the value on top that begin as the word does.
  void add_names(bool methods) {
    const script::NamesIn in = script::names_in(L_, -1, methods, place_.word);
    add(found_, in.names);
    whole_ = whole_ && in.whole;
  }

  // The methods, or properties, of a class.
  Words names_of(const std::string& cls) const {
    Words names;
    for (const Entry& entry : session_.registry().entries())
      if (entry.owner() == cls && entry.method() == place_.method)
        names.push_back(script::last_word(entry.name));
    return names;
  }

  void complete_text() {
    close_ = std::string(1, place_.quote);
    const bool in_index = !place_.frames.empty() && place_.frames.back().open == "[";
    if (in_index) return keys();
    const Argument* wanted = row();
    if (wanted != nullptr && !wanted->choices.empty()) {
      found_ = wanted->choices;
    } else if (wanted == nullptr || !special(*wanted)) {
      add(found_, files_like(place_.word));
    }
  }

  // Adds texts that name something: a set of the present object, a degree of freedom, a card.
  bool special(const Argument& wanted) {
    const Entry* entry = callee(place_.frames.back());
    const bool of_sets = wanted.name == "set" || (entry != nullptr && entry->name == "mesh:set");
    if (of_sets && sets()) return true;
    if (wanted.name == "freedoms") return freedoms(), true;
    if (entry != nullptr && entry->name == "fabric.card") cards();
    if (entry != nullptr && entry->name == "fabric.help") return topics(), true;
    return false;
  }

  bool sets() {
    for (auto frame = place_.frames.rbegin(); frame != place_.frames.rend(); ++frame) {
      if (!frame->callee) continue;
      push(*frame->callee, frame->callee->size() - 1);
      found_ = script::sets_of(L_, -1);
      lua_pop(L_, 1);
      return !found_.empty();
    }
    return false;
  }

  // A text may have several of them, separated by blanks; the last one is being typed.
  void freedoms() {
    const std::size_t blank = place_.word.find_last_of(' ');
    if (blank != std::string::npos) {
      place_.from += blank + 1;
      place_.word.erase(0, blank + 1);
    }
    close_.clear();
    found_ = {"x", "y", "z", "rx", "ry", "rz", "rotation"};
  }

  // Adds the topics of help, as they are written at the prompt.
  void topics() {
    for (const Entry& entry : session_.registry().entries())
      found_.push_back(entry.name.starts_with("fabric.") ? entry.name.substr(7) : entry.name);
  }

  void cards() {
    lua_getfield(L_, LUA_REGISTRYINDEX, "fabric");
    script::peek_field(L_, -1, "cards");
    if (script::entry_of(L_, -1) != nullptr && lua_pcall(L_, 0, 1, 0) == LUA_OK)
      for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) == LUA_TSTRING || (lua_pop(L_, 1), false); ++i) {
        found_.emplace_back(lua_tostring(L_, -1));
        lua_pop(L_, 1);
      }
    lua_pop(L_, 2);
  }

  // Adds the keys of the table that is indexed.
  void keys() {
    const auto& path = place_.frames.back().callee;
    if (!path) return;
    push(*path, path->size());
    add_names(false);
    lua_pop(L_, 1);
  }

  bool fits(const std::string& word) const {
    if (!word.starts_with(place_.word)) return false;
    return place_.kind == CursorContext::ContextKind::text ||
           place_.kind == CursorContext::ContextKind::word || is_name(word);
  }

  Completion finish() {
    Completion result{place_.from};
    for (const std::string& word : found_)
      if (fits(word)) result.candidates.push_back(word);
    auto& words = result.candidates;
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    if (words.empty()) return result;
    result.common = place_.word;
    if (!whole_) return result;
    const std::string &first = words.front(), &last = words.back();
    const auto differ = std::mismatch(first.begin(), first.end(), last.begin(), last.end());
    result.common.assign(first.begin(), differ.first);
    if (words.size() == 1 && first.back() != '/') result.common += close_;
    return result;
  }

  script::Session& session_;
  lua_State* L_;
  std::string_view text_;
  CursorContext place_;
  Words found_;
  bool whole_ = true;  // whether found_ has all names that there are
  std::string close_;  // appended after the word if it is the only candidate
};

struct Request {
  std::string_view text;
  Completion result;
};

int complete_protected(lua_State* L) {
  auto& request = *static_cast<Request*>(lua_touserdata(L, 1));
  luaL_checkstack(L, 20, "completion");
  script::load_defined_later(L);
  request.result = Completer(script::Session::of(L), request.text).run();
  return 0;
}

}  // namespace

Completion complete(script::Session& session, std::string_view text) {
  lua_State* L = session.lua();
  const script::NoFinalisers none(L);
  Request request{text, {text.size()}};
  lua_pushcfunction(L, complete_protected);
  lua_pushlightuserdata(L, &request);
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) lua_pop(L, 1);
  return request.result;
}

std::vector<std::string> files_like(const std::string& path) {
  namespace fs = std::filesystem;
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const std::string word = path.substr(folder.size());
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, code), end; !code && at != end;
       at.increment(code)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(word) || (name[0] == '.' && word.empty())) continue;
    std::error_code unknown;
    names.push_back(folder + name + (at->is_directory(unknown) ? "/" : ""));
  }
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::string last_part(const std::string& path) {
  if (path.size() < 2) return path;
  const std::size_t slash = path.find_last_of('/', path.size() - 2);
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

std::string in_columns(const std::vector<std::string>& words, std::size_t width, std::size_t most) {
  const std::size_t shown = std::min(words.size(), most);
  std::size_t widest = 0;
  for (std::size_t i = 0; i < shown; ++i) widest = std::max(widest, last_part(words[i]).size());
  const std::size_t columns = std::max<std::size_t>(1, (width + 2) / (widest + 2));
  const std::size_t rows = (shown + columns - 1) / columns;
  std::string out;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = row; i < shown; i += rows) {
      const std::string word = last_part(words[i]);
      out += word;
      if (i + rows < shown) out += std::string(widest + 2 - word.size(), ' ');
    }
    out += '\n';
  }
  if (words.size() > shown) out += "... and " + std::to_string(words.size() - shown) + " more\n";
  return out;
}

}  // namespace fabricsh::repl
