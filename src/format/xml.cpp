#include "format/xml.hpp"

#include <algorithm>

#include "format/table_line.hpp"

namespace fabricsh::format {

namespace {

constexpr std::string_view blanks = " \t\r\n";

// The position of the > that ends a tag; a > between quotes does not count.
std::size_t end_of_tag(std::string_view text) {
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0)
      quote = c == quote ? 0 : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return i;
  }
  return std::string_view::npos;
}

// An & that begins no entity is a literal one, because VTK writes names without escaping.
std::string unescaped(std::string_view text) {
  static const std::map<std::string_view, char> known = {
      {"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}};
  std::string plain;
  while (!text.empty()) {
    const auto at = std::min(text.find('&'), text.size());
    plain += text.substr(0, at);
    text.remove_prefix(at);
    if (text.empty()) break;
    const auto end = text.find(';');
    const auto word = text.substr(1, end == std::string_view::npos ? end : end - 1);
    const auto found = known.find(word);
    std::int64_t code = 0;
    const bool numbered = word.starts_with('#') && parse(word.substr(1), code) && code > 0 && code < 128;
    const bool is_entity = end != std::string_view::npos && (found != known.end() || numbered);
    plain += !is_entity ? '&' : numbered ? static_cast<char>(code) : found->second;
    text.remove_prefix(is_entity ? end + 1 : 1);
  }
  return plain;
}

}  // namespace

// Moves to the next tag, past comments and processing instructions.
bool XmlTags::find_tag() {
  for (;;) {
    const auto found = source_.rest().find('<');
    if (found == std::string_view::npos) return false;
    source_.move_to(source_.place() + found);
    const auto rest = source_.rest();
    const bool comment = rest.starts_with("<!--");
    if (!comment && !rest.starts_with("<?")) return true;
    const std::string_view stop = comment ? "-->" : "?>";
    const auto end = rest.find(stop, comment ? 4 : 2);
    if (end == std::string_view::npos) source_.fail("a comment or instruction has no end");
    source_.move_to(source_.place() + end + stop.size());
  }
}

bool XmlTags::next(XmlTag& tag) {
  if (pending_close_) open_.pop_back();
  pending_close_ = false;
  if (!find_tag()) {
    if (!open_.empty()) source_.fail("the file ends within <" + open_.back() + ">");
    return false;
  }
  const auto rest = source_.rest();
  const auto end = end_of_tag(rest);
  if (end == std::string_view::npos) source_.fail("a tag has no end: " + in_quotes(rest));
  tag = XmlTag();
  read(tag, rest.substr(1, end - 1));
  if (!tag.opens) close(tag.name);
  if (tag.opens) open_.push_back(tag.name);
  pending_close_ = tag.empty;
  source_.move_to(source_.place() + end + 1);
  tag.behind = source_.place();
  return true;
}

void XmlTags::close(const std::string& name) {
  if (open_.empty() || open_.back() != name)
    source_.fail("</" + name + "> closes nothing" +
                 (open_.empty() ? "" : ", expected </" + open_.back() + ">"));
  open_.pop_back();
}

void XmlTags::read(XmlTag& tag, std::string_view text) const {
  tag.opens = !text.starts_with('/');
  if (!tag.opens) text.remove_prefix(1);
  tag.empty = tag.opens && text.ends_with('/');
  if (tag.empty) text.remove_suffix(1);
  const auto end = std::min(text.find_first_of(blanks), text.size());
  tag.name = text.substr(0, end);
  if (tag.name.empty() || tag.name.size() > 100 || tag.name.find_first_of("!\"'=<&") != std::string::npos)
    source_.fail("expected a tag of XML, got " + in_quotes(text));
  text = trimmed(text.substr(end));
  while (!text.empty()) read_attribute(tag, text);
}

// Reads name="value" and removes it from the text.
void XmlTags::read_attribute(XmlTag& tag, std::string_view& text) const {
  const auto equals = text.find('=');
  const auto name = trimmed(text.substr(0, equals));
  auto value = equals == std::string_view::npos ? std::string_view() : trimmed(text.substr(equals + 1));
  const char quote = value.empty() ? 0 : value.front();
  const auto end = quote == '"' || quote == '\'' ? value.find(quote, 1) : std::string_view::npos;
  if (name.empty() || end == std::string_view::npos)
    source_.fail("expected name=\"value\", got " + in_quotes(text));
  tag.attributes[std::string(name)] = unescaped(value.substr(1, end - 1));
  text = trimmed(value.substr(end + 1));
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

}  // namespace fabricsh::format
