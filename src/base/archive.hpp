// Plain bytes of a state: one list of members serves to write them and to read them back, so that the two
// can't differ. Numbers as the machine has them; who stores the bytes says for which machine.
//
//   void keep(Archive& archive) { archive(time_, steps_, names_); }
#pragma once
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace fabricsh {

class Archive {
 public:
  Archive() = default;  // writes
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  bool reading() const { return reading_; }
  bool at_end() const { return at_ == bytes_.size(); }  // of reading
  const std::string& bytes() const { return bytes_; }

  // Numbers, enums, texts, vectors and optionals of them, and whatever has a member keep(Archive&). Error
  // when reading: the bytes end too early.
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }

  // Numbers whose count is known: as many as there are. Error when reading: another count was written.
  void filled(std::span<double> values) {
    std::uint64_t count = values.size();
    one(count);
    if (count != values.size())
      throw Error("expected " + std::to_string(values.size()) + " numbers, got " + std::to_string(count));
    raw(values.data(), values.size_bytes());
  }

 private:
  template <class T>
  void one(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = value ? 1 : 0;
      raw(&byte, 1);
      value = byte != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof value);
    } else {
      value.keep(*this);
    }
  }
  void one(std::string& text) {
    const std::size_t bytes = resize(text, 1);  // before data(), which it moves
    raw(text.data(), bytes);
  }
  template <class T>
  void one(std::optional<T>& value) {
    bool there = value.has_value();
    one(there);
    if (!there) return value.reset();
    if (!value) value.emplace();
    one(*value);
  }
  template <class T>
  void one(std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      const std::size_t bytes = resize(values, sizeof(T));
      raw(values.data(), bytes);
    } else {
      resize(values, 1);
      for (T& value : values) one(value);
    }
  }

  // Writes the count of items, or reads it and makes room; at least `least` bytes an item follow. Returns the
  // bytes.
  template <class Items>
  std::size_t resize(Items& items, std::size_t least) {
    std::uint64_t count = items.size();
    one(count);
    if (reading_) {
      if (count > (bytes_.size() - at_) / least) too_short();
      items.resize(count);
    }
    return items.size() * least;
  }

  void raw(void* data, std::size_t size) {
    if (!reading_) {
      bytes_.append(static_cast<const char*>(data), size);
      return;
    }
    if (size > bytes_.size() - at_) too_short();
    bytes_.copy(static_cast<char*>(data), size, at_);
    at_ += size;
  }
  [[noreturn]] static void too_short() { throw Error("the bytes end too early"); }

  std::string bytes_;
  std::size_t at_ = 0;
  bool reading_ = false;
};

}  // namespace fabricsh
