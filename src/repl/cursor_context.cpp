#include "repl/cursor_context.hpp"

#include <cstdlib>

namespace fabricsh::repl {

namespace {

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

}  // namespace

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

}  // namespace fabricsh::repl
