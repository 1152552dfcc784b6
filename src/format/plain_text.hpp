// The bytes of a text file as UTF-8 or an older 8-bit alphabet, with lines that end with a line feed.
#pragma once
#include <string>
#include <string_view>

namespace fabricsh::format {

// Removes a byte-order mark, and converts UTF-16 that begins with one and lines that end with carriage
// returns alone; `made` keeps converted text. Error, with the file's name: a spreadsheet, an archive, an
// empty file, a line of more than 16 MiB, or other bytes that no text has.
std::string_view plain_text(const std::string& name, std::string_view bytes, std::string& made);

}  // namespace fabricsh::format
