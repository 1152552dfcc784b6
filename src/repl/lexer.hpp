// Lua text as tokens, for text that is still being typed: nothing is an error, the last token may be
// unfinished.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::repl {

struct Token {
  enum class Kind { name, keyword, number, text, symbol, comment };
  Kind kind = Kind::symbol;
  std::size_t begin = 0, end = 0;  // places in the text; of a text, its quotes included
  std::string word = {};           // of a text: what stands between its quotes
  bool unfinished = false;         // a text or comment that the end of the input cuts off

  bool is(std::string_view symbol_or_keyword) const {
    return (kind == Kind::symbol || kind == Kind::keyword) && word == symbol_or_keyword;
  }
};

std::vector<Token> tokens_of(std::string_view text);

// Names declared by `local` outside of every block: they end with the chunk.
std::vector<std::string> chunk_locals(const std::vector<Token>& tokens);

// Is there this keyword or symbol outside of every block and function?
bool outermost(const std::vector<Token>& tokens, std::string_view word);

// +1 where a block, function or bracket opens, -1 where it closes, else 0.
int nesting(const Token& token);

}  // namespace fabricsh::repl
