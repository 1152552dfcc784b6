#include "format/plain_text.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace fabricsh::format {

namespace {

[[noreturn]] void refuse_text(const std::string& name, const std::string& got) {
  throw Error(name + ":1: expected plain text, got " + got);
}

void append_utf8(std::string& out, unsigned long code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr unsigned first[] = {0, 0xc0, 0xe0, 0xf0};
  out += static_cast<char>(first[more] | (code >> (6 * more)));
  for (int i = more; i-- > 0;) out += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3f));
}

// Half of a pair without its other half becomes the sign for an unknown character.
std::string from_utf16(std::string_view bytes, bool high_first) {
  const auto unit = [&](std::size_t at) {
    const auto a = static_cast<unsigned char>(bytes[at]), b = static_cast<unsigned char>(bytes[at + 1]);
    return high_first ? a * 256UL + b : b * 256UL + a;
  };
  std::string out;
  out.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    unsigned long code = unit(at);
    if (code >= 0xd800 && code < 0xdc00 && at + 3 < bytes.size() && unit(at + 2) >= 0xdc00 &&
        unit(at + 2) < 0xe000) {
      code = 0x10000 + ((code - 0xd800) << 10) + (unit(at + 2) - 0xdc00);
      at += 2;
    } else if (code >= 0xd800 && code < 0xe000) {
      code = 0xfffd;
    }
    append_utf8(out, code);
  }
  return out;
}

// A line is split into cells in several ways, which takes many times its own memory.
void refuse_long_lines(const std::string& name, std::string_view bytes) {
  constexpr std::size_t most = std::size_t{16} << 20U;
  std::size_t number = 1;
  for (std::size_t at = 0; at < bytes.size(); ++number) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    if (end - at > most)
      throw Error(name + ":" + std::to_string(number) + ": expected a line of at most " +
                  std::to_string(most) + " bytes, got one of " + std::to_string(end - at));
    at = end + 1;
  }
}

}  // namespace

std::string_view plain_text(const std::string& name, std::string_view bytes, std::string& made) {
  if (bytes.starts_with("PK\x03\x04"))
    refuse_text(name, "a spreadsheet (.xlsx, .ods) or another archive; save the sheet as CSV");
  if (bytes.starts_with("\xD0\xCF\x11\xE0")) refuse_text(name, "a spreadsheet (.xls); save the sheet as CSV");
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    bytes = made = from_utf16(bytes.substr(2), bytes[0] == '\xFE');
  const std::string_view start = bytes.substr(0, 4096);
  if (start.find('\0') != start.npos)
    refuse_text(name,
                "bytes of value zero: a binary file, or UTF-16 without its mark; save it as text, UTF-8");
  if (bytes.find_first_not_of(" \t\r\n\f\v") == bytes.npos) refuse_text(name, "an empty file");
  if (bytes.find('\n') == bytes.npos && bytes.find('\r') != bytes.npos) {
    std::string lines(bytes);
    std::replace(lines.begin(), lines.end(), '\r', '\n');
    bytes = made = std::move(lines);
  }
  refuse_long_lines(name, bytes);
  return bytes;
}

}  // namespace fabricsh::format
