#include "repl/deck_text.hpp"

#include <algorithm>

#include "repl/lexer.hpp"

namespace fabricsh::repl {

namespace {

std::string commented(const std::string& text, const std::string& mark) {
  std::string out = mark;
  for (const char c : text) out += c == '\n' ? "\n" + mark : std::string(1, c);
  return out + "\n";
}

// Ends a comment at the end of the input, which would otherwise include the text appended to it.
std::string closed(const std::string& input) {
  const auto tokens = tokens_of(input);
  return !tokens.empty() && tokens.back().kind == Token::TokenKind::comment ? input + "\n" : input;
}

std::string statements(const std::string& input) {
  const auto tokens = tokens_of(input);
  if (outermost(tokens, "return")) return "_show((function(...)\n" + input + "\nend)(...))\n";
  if (!chunk_locals(tokens).empty() || outermost(tokens, "::")) return "do\n" + input + "\nend\n";
  // otherwise a bracket at the beginning would call the preceding value
  return (!tokens.empty() && tokens.front().is("(") ? ";" : "") + input + "\n";
}

}  // namespace

std::string deck_text(const std::string& input, const Result& result) {
  const auto tokens = tokens_of(input);
  const auto is_blank = [](const Token& t) { return t.is(";") || t.kind == Token::TokenKind::comment; };
  if (std::all_of(tokens.begin(), tokens.end(), is_blank)) return input + "\n";
  if (result.outcome != EvaluationOutcome::done)
    return commented(input, "-- ") +
           commented(result.message.substr(0, result.message.find('\n')), "--   failed: ");
  return result.expression ? "_show(" + closed(without_equals(input)) + ")\n" : statements(input);
}

std::string deck_call(const std::string& path) {
  std::string quoted;
  for (const char c : path) quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return "dofile \"" + quoted + "\"\n";
}

}  // namespace fabricsh::repl
