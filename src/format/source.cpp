#include "format/source.hpp"

#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "base/error.hpp"
#include "system/gate.hpp"

namespace fabricsh::format {

namespace {

constexpr bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// The limit for a file's size, since a sparse file can claim any size.
std::uint64_t half_of_memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 2;
}

[[noreturn]] void cannot_read(const std::string& path, const std::string& why) {
  throw Error("cannot read '" + path + "': " + why);
}

}  // namespace

std::string read_file(const std::string& path) {
  const system::Descriptor file = system::Gate::of_process().open(path);
  struct stat about {};
  if (fstat(file.number(), &about) != 0) cannot_read(path, std::generic_category().message(errno));
  const auto size = static_cast<std::uint64_t>(about.st_size);
  if (size > half_of_memory()) cannot_read(path, "it is larger than half of this machine's memory");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t n = ::read(file.number(), bytes.data() + at, bytes.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) cannot_read(path, std::generic_category().message(errno));
    if (n == 0) bytes.resize(at);
    at += static_cast<std::size_t>(n);
  }
  return bytes;
}

std::string in_quotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 40 ? "...'" : "'");
}

bool parse(std::string_view word, std::int64_t& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

// A number below the range of a double is zero; one above the range is an error.
bool parse(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || word.empty()) return false;
  if (error == std::errc::result_out_of_range && word.find("e-") != word.npos) {
    value = 0;
    return true;
  }
  return error == std::errc();
}

bool Source::next_line(std::string_view& line) {
  said_ = at_;
  if (ended()) return false;
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  line = bytes_.substr(at_, end - at_);
  if (line.ends_with('\r')) line.remove_suffix(1);
  at_ = std::min(end + 1, bytes_.size());
  return true;
}

std::string_view Source::line(const char* what) {
  std::string_view line;
  if (!next_line(line)) fail(std::string("the file ends where ") + what + " should be");
  return line;
}

void Source::skip_blanks() {
  while (at_ < bytes_.size() && blank(bytes_[at_])) ++at_;
}

std::string_view Source::word_or_none() {
  skip_blanks();
  said_ = at_;
  std::size_t end = at_;
  while (end < bytes_.size() && !blank(bytes_[end])) ++end;
  const auto word = bytes_.substr(at_, end - at_);
  at_ = end;
  return word;
}

std::string_view Source::word(const char* what) {
  const auto word = word_or_none();
  if (word.empty()) fail(std::string("the file ends where ") + what + " should be");
  return word;
}

std::int64_t Source::integer(const char* what) {
  std::int64_t value = 0;
  const auto text = word(what);
  if (!parse(text, value)) fail(std::string("expected ") + what + ", a whole number, got " + in_quotes(text));
  return value;
}

double Source::real(const char* what) {
  double value = 0;
  const auto text = word(what);
  if (!parse(text, value)) fail(std::string("expected ") + what + ", a number, got " + in_quotes(text));
  return value;
}

std::int64_t Source::count(const char* what, std::size_t bytes_each) {
  return checked(what, integer(what), bytes_each);
}

// The last item may end with the file, without a blank after it.
std::int64_t Source::checked(const char* what, std::int64_t count, std::size_t bytes_each) const {
  const std::size_t most = bytes_each == 0 ? left() : (left() + 1) / bytes_each;
  if (count < 0 || static_cast<std::uint64_t>(count) > most)
    fail(std::string("expected ") + what + " from 0 to " + std::to_string(most) +
         " (no more fit into the rest of the file), got " + std::to_string(count));
  return count;
}

std::string_view Source::take(std::size_t bytes, const char* what) {
  said_ = at_;
  if (bytes > left()) fail(std::string("the file ends within ") + what);
  const auto taken = bytes_.substr(at_, bytes);
  at_ += bytes;
  return taken;
}

std::string Source::at_place(const std::string& why) const {
  if (binary_) return name_ + ": byte " + std::to_string(said_ + 1) + ": " + why;
  const auto lines = std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(said_), '\n');
  return name_ + ":" + std::to_string(lines + 1) + ": " + why;
}

void Source::fail(const std::string& why) const { throw Error(at_place(why)); }

std::uint32_t checksum(std::string_view bytes, std::uint32_t so_far) {
  return static_cast<std::uint32_t>(
      crc32_z(so_far, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace fabricsh::format
