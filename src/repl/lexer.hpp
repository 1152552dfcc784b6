// Lua text as tokens, also while it is being typed: there are no errors, and the last token may be
// unfinished.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::repl {

struct Token {
  enum class TokenKind { name, keyword, number, text, symbol, comment };
  TokenKind kind = TokenKind::symbol;
  std::size_t begin = 0, end = 0;  // positions in the text; of a string, including the quotes
  std::string word = {};           // of a string: without the quotes
  bool unfinished = false;         // a string or comment that the end of the input cuts off

  bool is(std::string_view symbol_or_keyword) const {
    return (kind == TokenKind::symbol || kind == TokenKind::keyword) && word == symbol_or_keyword;
  }
};

std::vector<Token> tokens_of(std::string_view text);

// Names declared by `local` outside all blocks; their scope is the chunk.
std::vector<std::string> chunk_locals(const std::vector<Token>& tokens);

// Whether this keyword or symbol occurs outside all blocks and functions.
bool outermost(const std::vector<Token>& tokens, std::string_view word);

// +1 for the opening of a block, function or bracket, -1 for its closing, else 0.
int nesting(const Token& token);

}  // namespace fabricsh::repl
