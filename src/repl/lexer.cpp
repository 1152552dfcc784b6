#include "repl/lexer.hpp"

#include <algorithm>
#include <cctype>

#include "script/call/words.hpp"

namespace fabricsh::repl {

namespace {

using script::keywords;

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class LexerCursor {
 public:
  explicit LexerCursor(std::string_view text) : text_(text) {}

  std::vector<Token> read() {
    while (at_ < text_.size()) {
      if (std::isspace(static_cast<unsigned char>(text_[at_])))
        ++at_;
      else
        token();
    }
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool starts(std::string_view part) const { return text_.substr(at_).starts_with(part); }

  void token() {
    const char c = text_[at_];
    if (letter(c)) return word();
    if (digit(c) || (c == '.' && digit(peek(1)))) return number();
    if (c == '"' || c == '\'') return quoted(c);
    if (starts("--")) return comment();
    if (c == '[' && long_level(at_) >= 0) return long_text(Token::TokenKind::text, at_);
    symbol();
  }

  void add(Token::TokenKind kind, std::size_t end, std::string word, bool unfinished = false) {
    tokens_.push_back({kind, at_, end, std::move(word), unfinished});
    at_ = end;
  }

  void word() {
    std::size_t end = at_;
    while (end < text_.size() && (letter(text_[end]) || digit(text_[end]))) ++end;
    const std::string name(text_.substr(at_, end - at_));
    const bool known = std::find(keywords.begin(), keywords.end(), name) != keywords.end();
    add(known ? Token::TokenKind::keyword : Token::TokenKind::name, end, name);
  }

  void number() {
    std::size_t end = at_;
    const auto sign = [this](std::size_t i) {
      return (text_[i] == '+' || text_[i] == '-') && i > at_ && std::tolower(text_[i - 1]) == 'e';
    };
    while (end < text_.size() && (letter(text_[end]) || digit(text_[end]) || text_[end] == '.' || sign(end)))
      ++end;
    add(Token::TokenKind::number, end, std::string(text_.substr(at_, end - at_)));
  }

  void quoted(char quote) {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != quote && text_[end] != '\n')
      end += text_[end] == '\\' && end + 1 < text_.size() ? 2 : 1;
    const bool closed = end < text_.size() && text_[end] == quote;
    const std::size_t stop = std::min(end, text_.size());
    add(Token::TokenKind::text, closed ? end + 1 : stop, std::string(text_.substr(at_ + 1, stop - at_ - 1)),
        !closed && stop == text_.size());
  }

  // Level of the long bracket that opens at a position: 0 for [[, 1 for [=[; -1 if there is none.
  int long_level(std::size_t place) const {
    int level = 0;
    for (std::size_t i = place + 1; i < text_.size(); ++i, ++level) {
      if (text_[i] == '[') return level;
      if (text_[i] != '=') return -1;
    }
    return -1;
  }

  // Reads from at_ a long text or comment whose long bracket is at `open`.
  void long_text(Token::TokenKind kind, std::size_t open) {
    const auto level = static_cast<std::size_t>(long_level(open));
    const std::string close = "]" + std::string(level, '=') + "]";
    const std::size_t inside = open + level + 2;
    const std::size_t end = text_.find(close, inside);
    const bool closed = end != std::string_view::npos;
    const std::size_t stop = closed ? end : text_.size();
    add(kind, closed ? end + close.size() : stop, std::string(text_.substr(inside, stop - inside)), !closed);
  }

  void comment() {
    if (peek(2) == '[' && long_level(at_ + 2) >= 0) return long_text(Token::TokenKind::comment, at_ + 2);
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    add(Token::TokenKind::comment, end, std::string(text_.substr(at_, end - at_)), end == text_.size());
  }

  void symbol() {
    for (const std::string_view known : {"...", "..", "==", "~=", "<=", ">=", "//", "<<", ">>", "::"})
      if (starts(known)) return add(Token::TokenKind::symbol, at_ + known.size(), std::string(known));
    add(Token::TokenKind::symbol, at_ + 1, std::string(1, text_[at_]));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) { return LexerCursor(text).read(); }

int nesting(const Token& token) {
  for (const char* word : {"(", "{", "[", "function", "do", "if", "repeat"})
    if (token.is(word)) return 1;
  for (const char* word : {")", "}", "]", "end", "until"})
    if (token.is(word)) return -1;
  return 0;
}

std::vector<std::string> chunk_locals(const std::vector<Token>& tokens) {
  std::vector<std::string> names;
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    depth += nesting(tokens[i]);
    if (depth != 0 || !tokens[i].is("local")) continue;
    std::size_t at = i + 1;
    if (at < tokens.size() && tokens[at].is("function")) ++at;
    for (; at < tokens.size() && tokens[at].kind == Token::TokenKind::name; at += 2) {
      names.push_back(tokens[at].word);
      if (at + 3 < tokens.size() && tokens[at + 1].is("<")) at += 3;  // local x <const>
      if (at + 1 >= tokens.size() || !tokens[at + 1].is(",")) break;
    }
  }
  return names;
}

bool outermost(const std::vector<Token>& tokens, std::string_view word) {
  int depth = 0;
  for (const Token& token : tokens) {
    depth += nesting(token);
    if (depth == 0 && token.is(word)) return true;
  }
  return false;
}

}  // namespace fabricsh::repl
