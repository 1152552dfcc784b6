#include "format/json.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "base/number.hpp"
#include "base/utf8.hpp"

namespace fabricsh::format {

namespace {

std::string escaped(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      break;
  }
  if (static_cast<unsigned char>(c) >= 0x20) return std::string(1, c);
  char buffer[8];
  std::snprintf(buffer, sizeof buffer, "\\u%04x", static_cast<unsigned>(c));
  return buffer;
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0)
      out += "\xEF\xBF\xBD";
    else
      out += length == 1 ? escaped(text[0]) : std::string(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + "\"";
}

void new_line(std::string& out, std::size_t depth) { out += "\n" + std::string(2 * depth, ' '); }

}  // namespace

Json Json::object() {
  Json json;
  json.value_ = Members();
  return json;
}

Json Json::array() {
  Json json;
  json.value_ = Items();
  return json;
}

Json& Json::set(std::string name, Json value) {
  assert(std::holds_alternative<Members>(value_));
  auto& members = std::get<Members>(value_);
  const auto same = [&](const auto& member) { return member.first == name; };
  const auto found = std::find_if(members.begin(), members.end(), same);
  if (found != members.end())
    found->second = std::move(value);
  else
    members.emplace_back(std::move(name), std::move(value));
  return *this;
}

Json& Json::push(Json value) {
  assert(std::holds_alternative<Items>(value_));
  std::get<Items>(value_).push_back(std::move(value));
  return *this;
}

std::string Json::text() const {
  std::string out;
  write(out, 0);
  return out + "\n";
}

void Json::write(std::string& out, std::size_t depth) const {
  if (const auto* flag = std::get_if<bool>(&value_))
    out += *flag ? "true" : "false";
  else if (const auto* whole = std::get_if<std::int64_t>(&value_))
    out += std::to_string(*whole);
  else if (const auto* real = std::get_if<double>(&value_))
    out += std::isfinite(*real) ? exact_number(*real) : "null";
  else if (const auto* string = std::get_if<std::string>(&value_))
    out += json_string(*string);
  else if (const auto* items = std::get_if<Items>(&value_))
    write_items(out, *items, depth);
  else if (const auto* members = std::get_if<Members>(&value_))
    write_members(out, *members, depth);
  else
    out += "null";
}

void Json::write_items(std::string& out, const Items& items, std::size_t depth) {
  const bool one_line =
      std::all_of(items.begin(), items.end(), [](const Json& item) { return item.plain(); });
  out += "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += one_line ? ", " : ",";
    if (!one_line) new_line(out, depth + 1);
    items[i].write(out, depth + 1);
  }
  if (!one_line) new_line(out, depth);
  out += "]";
}

void Json::write_members(std::string& out, const Members& members, std::size_t depth) {
  out += "{";
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i > 0) out += ",";
    new_line(out, depth + 1);
    out += json_string(members[i].first) + ": ";
    members[i].second.write(out, depth + 1);
  }
  if (!members.empty()) new_line(out, depth);
  out += "}";
}

}  // namespace fabricsh::format
