#include "format/checkpoint.hpp"

#include <cstring>

#include "base/archive.hpp"
#include "format/source.hpp"
#include "system/atomic.hpp"

namespace fabricsh::format {

namespace {

const std::string first_words = "fabricsh checkpoint ";
const std::string first_line = first_words + "2\n";
constexpr std::size_t size_bytes = 8, checksum_bytes = 4;

[[noreturn]] void refuse_checkpoint(const std::string& path, const std::string& why) {
  throw Error("checkpoint '" + path + "': " + why);
}

std::uint32_t seal_of(std::uint64_t size, std::string_view content) {
  const std::string_view digits(reinterpret_cast<const char*>(&size), size_bytes);
  return checksum(content, checksum(digits));
}

// Refuses a file that has another version or is no checkpoint.
[[noreturn]] void refuse_kind(const std::string& path, const std::string& bytes) {
  const auto end = bytes.find('\n');
  if (!bytes.starts_with(first_words) || end > 40) refuse_checkpoint(path, "it is no checkpoint of fabricsh");
  const std::string version = bytes.substr(first_words.size(), end - first_words.size());
  refuse_checkpoint(
      path,
      "its format has version " + version + ", this program reads version 2" +
          (version == "1" ? ": it was written by an earlier fabricsh, which can still go on from it" : ""));
}

}  // namespace

void write_checkpoint(const std::string& path, const std::string& content) {
  Archive head;
  std::uint64_t size = content.size();
  std::uint32_t seal = seal_of(size, content);
  head(size, seal);
  system::write_file(path, first_line + head.bytes() + content, system::Sync::yes, system::Folder::expect);
}

std::string read_checkpoint(const std::string& path) {
  std::string bytes = read_file(path);
  const std::size_t begin = first_line.size() + size_bytes + checksum_bytes;
  if (first_line.starts_with(bytes)) refuse_checkpoint(path, "it is cut short");
  if (!bytes.starts_with(first_line)) refuse_kind(path, bytes);
  if (bytes.size() < begin) refuse_checkpoint(path, "it is cut short");
  std::uint64_t size = 0;
  std::uint32_t seal = 0;
  std::memcpy(&size, bytes.data() + first_line.size(), size_bytes);
  std::memcpy(&seal, bytes.data() + first_line.size() + size_bytes, checksum_bytes);
  bytes.erase(0, begin);
  if (bytes.size() < size)
    refuse_checkpoint(
        path, "it is cut short: " + std::to_string(bytes.size()) + " of " + std::to_string(size) + " bytes");
  if (bytes.size() > size || seal_of(size, bytes) != seal)
    refuse_checkpoint(path, "it is damaged: its checksum does not fit");
  return bytes;
}

}  // namespace fabricsh::format
