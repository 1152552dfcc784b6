// A JSON value to be written. The members of an object keep the order in which they were set.
#pragma once
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fabricsh::format {

class Json {
 public:
  Json() = default;  // null
  Json(bool value) : value_(value) {}
  template <std::floating_point T>
  Json(T value) : value_(static_cast<double>(value)) {}  // written as null if not finite
  template <std::integral T>
  Json(T value) : value_(static_cast<std::int64_t>(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  template <class T>
  Json(const std::vector<T>& items) : value_(Items(items.begin(), items.end())) {}
  static Json object();
  static Json array();

  // Sets a member of an object; an existing name keeps its position and gets the new value.
  Json& set(std::string name, Json value);
  // Appends an item to an array.
  Json& push(Json value);
  // Indentation of two spaces; lists of plain values on one line. Bytes that are not UTF-8 become U+FFFD.
  std::string text() const;

 private:
  using Items = std::vector<Json>;
  using Members = std::vector<std::pair<std::string, Json>>;
  bool plain() const {
    return !std::holds_alternative<Items>(value_) && !std::holds_alternative<Members>(value_);
  }
  void write(std::string& out, std::size_t depth) const;
  static void write_items(std::string& out, const Items& items, std::size_t depth);
  static void write_members(std::string& out, const Members& members, std::size_t depth);

  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Items, Members> value_;
};

}  // namespace fabricsh::format
