// The state of an object as plain bytes. One list of members serves for writing and for reading, so
// that the two cannot differ. Numbers are stored in the format of this machine; whoever stores the
// bytes records which machine that was.
//
//   void keep(Archive& archive) { archive(time_, steps_, names_); }
//
// A section is a part with a name and a hash of the kinds of its members in their order. Bytes from
// a build with other members are refused, naming the section that has changed, before any is used:
//
//   archive.section("motion", [&] { archive(v_, a_); });
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/hash.hpp"

namespace fabricsh {

class Archive {
 public:
  Archive() = default;  // writes
  explicit Archive(std::string bytes) : bytes_(std::move(bytes)), mode_(Mode::read) {}

  bool reading() const { return mode_ == Mode::read; }
  bool at_end() const { return at_ == bytes_.size(); }  // meaningful while reading
  const std::string& bytes() const { return bytes_; }

  // Accepts numbers, enums, strings, vectors and optionals of these, and any type
  // with a member keep(Archive&). Error when reading: the bytes end too early.
  template <class... T>
  void operator()(T&... values) {
    (one(values), ...);
  }

  // `members` archives the members of the section. For writing it is called once. For reading it is
  // called twice: first with reading() false, only to record the kinds of its members, then to
  // read. Error when reading: the next section has another name, or its members are of other kinds.
  template <class Members>
  void section(const std::string& name, Members members) {
    if (mode_ == Mode::learn) return members();
    const std::uint64_t outer = kinds_;
    if (mode_ == Mode::write)
      write_section(name, members);
    else
      read_section(name, members);
    kinds_ = outer;
  }

  // Numbers whose count is fixed by the caller. Error when reading: another count was written.
  void filled(std::span<double> values) {
    std::uint64_t count = values.size();
    learn("numbers");
    plain(count);
    if (count != values.size())
      throw Error("expected " + std::to_string(values.size()) + " numbers, got " + std::to_string(count));
    raw(values.data(), values.size_bytes());
  }

 private:
  enum class Mode { write, read, learn };

  template <class Members>
  void write_section(std::string name, Members& members) {
    text(name);
    const std::size_t place = bytes_.size();
    std::uint64_t kinds = 0, size = 0;
    plain(kinds);
    plain(size);
    kinds_ = 0;
    members();
    kinds = kinds_;
    size = bytes_.size() - place - sizeof kinds - sizeof size;
    bytes_.replace(place, sizeof kinds, reinterpret_cast<const char*>(&kinds), sizeof kinds);
    bytes_.replace(place + sizeof kinds, sizeof size, reinterpret_cast<const char*>(&size), sizeof size);
  }
  template <class Members>
  void read_section(const std::string& name, Members& members) {
    std::string there;
    text(there);
    if (there != name) throw Error("it has '" + there + "' where '" + name + "' is expected");
    std::uint64_t kinds = 0, size = 0;
    plain(kinds);
    plain(size);
    kinds_ = 0;
    mode_ = Mode::learn;
    members();
    mode_ = Mode::read;
    if (kinds != kinds_)
      throw Error("its part '" + name + "' was written by a build in which that part has other members");
    const std::size_t begin = at_;
    members();
    if (at_ - begin != size) throw Error("its part '" + name + "' has another size than its members");
  }

  // Adds the kind of a member to the hash of its section; the elements of a list are counted as one.
  void learn(const char* kind) {
    if (silent_ == 0) kinds_ = hash(kind, kinds_);
  }
  template <class T>
  void learn_element() {
    if (silent_ > 0) return;
    const Mode mode = mode_;
    mode_ = Mode::learn;
    T element{};
    one(element);
    mode_ = mode;
  }

  template <class T>
  static const char* kind_of() {
    constexpr const char* signed_kinds[] = {"i1", "i2", "i4", "i8"};
    constexpr const char* unsigned_kinds[] = {"u1", "u2", "u4", "u8"};
    if constexpr (std::is_floating_point_v<T>) return sizeof(T) == 8 ? "f8" : "f4";
    constexpr int place = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
    if constexpr (std::is_signed_v<T>) return signed_kinds[place];
    return std::is_enum_v<T> ? "enum" : unsigned_kinds[place];
  }

  template <class T>
  void one(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      learn("bool");
      plain(value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      learn(kind_of<T>());
      plain(value);
    } else {
      learn("{");
      value.keep(*this);
      learn("}");
    }
  }
  void one(std::string& value) {
    learn("text");
    text(value);
  }
  template <class T>
  void one(std::optional<T>& value) {
    learn("optional");
    learn_element<T>();
    bool there = value.has_value();
    plain(there);
    if (!there) {
      if (reading()) value.reset();
      return;
    }
    if (!value) value.emplace();
    quietly([&] { one(*value); });
  }
  template <class T>
  void one(std::vector<T>& values) {
    learn("list");
    learn_element<T>();
    if (mode_ == Mode::learn) return;
    if constexpr (std::is_arithmetic_v<T>) {
      const std::size_t bytes = resize(values, sizeof(T));
      raw(values.data(), bytes);
    } else {
      resize(values, 1);
      quietly([&] {
        for (T& value : values) one(value);
      });
    }
  }
  template <class Work>
  void quietly(Work work) {
    ++silent_;
    work();
    --silent_;
  }

  void plain(bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    raw(&byte, 1);
    value = byte != 0;
  }
  template <class T>
  void plain(T& value) {
    raw(&value, sizeof value);
  }
  void text(std::string& value) {
    if (mode_ == Mode::learn) return;
    const std::size_t bytes = resize(value, 1);  // before data(), because resizing moves the data
    raw(value.data(), bytes);
  }

  // Writes the number of items, or reads it and resizes. `least`: the smallest size of an item
  // in bytes, by which the count is checked against the bytes left. Returns count * least.
  template <class Items>
  std::size_t resize(Items& items, std::size_t least) {
    std::uint64_t count = items.size();
    plain(count);
    if (reading()) {
      if (count > (bytes_.size() - at_) / least) too_short();
      items.resize(count);
    }
    return items.size() * least;
  }

  void raw(void* data, std::size_t size) {
    if (mode_ == Mode::learn) return;
    if (mode_ == Mode::write) {
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
  Mode mode_ = Mode::write;
  std::uint64_t kinds_ = 0;  // hash of the kinds of the members so far, in the innermost section
  int silent_ = 0;           // above 0 inside a list, whose kind has been recorded already
};

}  // namespace fabricsh
