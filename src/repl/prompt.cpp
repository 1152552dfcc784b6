#include "repl/prompt.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "repl/evaluator.hpp"
#include "repl/lexer.hpp"
#include "script/show/transcript.hpp"

namespace fabricsh::repl {

namespace {

void show(const Result& result, const Voice& voice) {
  std::fflush(stdout);
  if (!result.message.empty()) voice.err << voice.style.dress(Tone::error, result.message) << std::endl;
  if (!result.shown.empty()) voice.out << result.shown << std::endl;
}

// Adds an executed input to the history and the transcript, even if the transcript's file fails.
void keep(script::Session& session, const std::string& text, const Voice& voice) {
  try {
    script::transcript_of(session.lua()).add(text);
  } catch (const Error& trouble) {
    voice.err << voice.style.dress(Tone::notice, std::string("warning: transcript: ") + trouble.what())
              << std::endl;
  }
}

EvaluationOutcome run(script::Session& session, const std::string& input, const Voice& voice) {
  const std::string words = advice(input);
  if (!words.empty()) voice.err << voice.style.dress(Tone::notice, words) << std::endl;
  const int changes = script::transcript_of(session.lua()).changes();
  Result result;
  {
    const Running guard(session);
    result = evaluate(session, input);
  }
  show(result, voice);
  if (script::transcript_of(session.lua()).changes() == changes)
    keep(session, deck_text(input, result), voice);
  return result.outcome;
}

// The names of the library and of Lua that still have their original meaning in this session.
class OwnNames {
 public:
  explicit OwnNames(script::Session& session) : L_(session.lua()), names_(script::names_as_made(L_)) {}
  // Reports each name that has been overwritten, once.
  void look(const Voice& voice) {
    const auto now = script::names_as_made(L_);
    for (const std::string& name : names_)
      if (now.count(name) == 0)
        voice.err << voice.style.dress(Tone::notice, script::covered_words(L_, name)) << std::endl;
    std::erase_if(names_, [&now](const std::string& name) { return now.count(name) == 0; });
  }

 private:
  lua_State* L_;
  std::set<std::string> names_;
};

bool blank(const std::string& text) { return text.find_first_not_of(" \t\n\r") == std::string::npos; }

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

std::string advice(const std::string& input) {
  const auto names = chunk_locals(tokens_of(input));
  if (names.empty()) return {};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return "warning: local " + list + (names.size() > 1 ? " are" : " is") + " gone on the next line; to keep " +
         (names.size() > 1 ? "them" : "it") + " leave 'local' out";
}

EvaluationOutcome converse(script::Session& session, Lines& lines, const Voice& voice, Attended attended) {
  if (!session.options().deck.empty()) keep(session, deck_call(session.options().deck), voice);
  EvaluationOutcome first = EvaluationOutcome::done;
  OwnNames own(session);
  const auto evaluated = [&](const std::string& text) {
    const EvaluationOutcome outcome = run(session, text, voice);
    own.look(voice);
    if (first == EvaluationOutcome::done) first = outcome;
  };
  const auto called_off = [&] {
    if (attended == Attended::no && ctrl_c_between_lines()) session.call_off();
    return attended == Attended::no && session.stopped_by_interrupt();
  };
  std::string input, line;
  while (session.terminated() == 0 && !called_off()) {
    const auto state = (attended == Attended::yes && ctrl_c_between_lines() && !input.empty())
                           ? Lines::InputState::interrupted
                           : lines.next(input, line);
    if (called_off()) break;
    if (state == Lines::InputState::end && input.empty()) break;
    if (state == Lines::InputState::interrupted) {
      input.clear();
      voice.out << std::endl;
      continue;
    }
    if (state == Lines::InputState::end) {  // Ctrl-D or end of text: incomplete input is an error, the
                                            // session continues
      evaluated(std::exchange(input, {}));
      continue;
    }
    if (input.empty() && is_exit_command(session, line)) break;
    const std::string typed = line;
    input = input.empty() ? command_as_lua(session, line) : input + "\n" + line;
    if (!blank(input) && is_incomplete(session, input)) continue;
    if (!blank(input)) {
      lines.remember(input == command_as_lua(session, typed) ? typed : input);
      evaluated(input);
    }
    input.clear();
  }
  return first;
}

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
