// A file being read: all its bytes, a position, and errors that name the position. Nothing that the
// file states is trusted: a count is checked against the bytes left before memory is allocated for it.
#pragma once
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace fabricsh::format {

// Reads a regular file. Error: "cannot read 'disc.msh': No such file or directory".
std::string read_file(const std::string& path);

// How a binary file stores a number.
enum class StoredNumber { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };
constexpr std::size_t bytes_of(StoredNumber type) {
  constexpr std::size_t bytes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[static_cast<std::size_t>(type)];
}
// The one of this name in a table of names; empty: none.
template <class Names>
std::optional<StoredNumber> stored_number(const Names& names, std::string_view name) {
  for (const auto& [known, type] : names)
    if (name == known) return type;
  return {};
}

class Source {
 public:
  Source(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {}

  const std::string& name() const { return name_; }
  std::size_t place() const { return at_; }
  void move_to(std::size_t place) { at_ = said_ = place; }
  std::size_t size() const { return bytes_.size(); }
  std::string_view bytes(std::size_t begin, std::size_t end) const {
    return bytes_.substr(begin, end - begin);
  }
  std::size_t left() const { return bytes_.size() - at_; }
  bool ended() const { return at_ == bytes_.size(); }
  std::string_view rest() const { return bytes_.substr(at_); }

  // Text: words between blanks, whole lines, numbers. Errors name the line.
  bool next_line(std::string_view& line);   // without its end; false at the end of the file
  std::string_view line(const char* what);  // error at the end of the file
  std::string_view word(const char* what);
  std::string_view word_or_none();
  void skip_blanks();
  std::int64_t integer(const char* what);
  double real(const char* what);
  // Reads the number of items that follow, each of at least bytes_each bytes, and checks it against the rest.
  std::int64_t count(const char* what, std::size_t bytes_each);
  std::int64_t checked(const char* what, std::int64_t count, std::size_t bytes_each) const;

  // Binary: a value as stored. Errors name the byte.
  template <class T>
  T raw(const char* what) {
    T value;
    std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
    return swapped_ ? reversed(value) : value;
  }
  template <class T>
  T stored(StoredNumber type, const char* what) {
    if (type == StoredNumber::i8) return static_cast<T>(raw<std::int8_t>(what));
    if (type == StoredNumber::u8) return static_cast<T>(raw<std::uint8_t>(what));
    if (type == StoredNumber::i16) return static_cast<T>(raw<std::int16_t>(what));
    if (type == StoredNumber::u16) return static_cast<T>(raw<std::uint16_t>(what));
    if (type == StoredNumber::i32) return static_cast<T>(raw<std::int32_t>(what));
    if (type == StoredNumber::u32) return static_cast<T>(raw<std::uint32_t>(what));
    if (type == StoredNumber::i64) return static_cast<T>(raw<std::int64_t>(what));
    if (type == StoredNumber::u64) return static_cast<T>(raw<std::uint64_t>(what));
    if (type == StoredNumber::f32) return static_cast<T>(raw<float>(what));
    return static_cast<T>(raw<double>(what));
  }
  std::string_view take(std::size_t bytes, const char* what);
  void swap_bytes(bool swapped) { swapped_ = swapped; }
  void set_binary(bool binary) { binary_ = binary; }

  // Whether the line that begins there has no end: the last one of many a file, and of one that was cut
  // short.
  bool endless(std::size_t line) const { return bytes_.find('\n', line) == bytes_.npos; }

  // "disc.msh:12: ...", or "disc.msh: byte 120: ..." while binary; as an error.
  std::string at_place(const std::string& why) const;
  [[noreturn]] void fail(const std::string& why) const;

 private:
  template <class T>
  static T reversed(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (std::size_t i = 0; i < sizeof value / 2; ++i) std::swap(bytes[i], bytes[sizeof value - 1 - i]);
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  std::string name_;
  std::string_view bytes_;
  std::size_t at_ = 0, said_ = 0;  // the position, and the position that an error names
  bool swapped_ = false, binary_ = false;
};

// A word from a file for an error message: shortened, printable characters only.
std::string in_quotes(std::string_view word);

// Reads a whole word as a number; false if it is not one.
bool parse(std::string_view word, std::int64_t& value);
bool parse(std::string_view word, double& value);

// --- CRC-32 as in zip, PNG and gzip, computed by zlib. It finds every error of up to 32
// consecutive bits and all but one in 4e9 of the others: against accidents, not against intent.

std::uint32_t checksum(std::string_view bytes, std::uint32_t so_far = 0);

}  // namespace fabricsh::format
