// The formats of photographs, decoded from bytes in memory. A file may be damaged on purpose: what its head
// claims is checked against its length before memory is made for it, and whatever the libraries complain of
// becomes an Error.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "format/image.hpp"

namespace fabricsh::format {

// A name for errors and the bytes of the file.
struct Encoded {
  std::string name;
  std::string_view bytes;
};

Image decode_png(const Encoded& file);
Image decode_jpeg(const Encoded& file);
Image decode_tiff(const Encoded& file);
Image decode_bmp(const Encoded& file);

// Error "image 'x.png': it is damaged or cut short (why)".
[[noreturn]] void damaged(const Encoded& file, const std::string& why);
// Error "image 'x.png': why".
[[noreturn]] void refused(const Encoded& file, const std::string& why);

// An empty image of that size. Error: no pixels, or more than the file's bytes can hold, packed as tightly as
// any of the formats packs (1032 to one, the bound of deflate), or more than 2^28.
Image image_of_size(const Encoded& file, std::uint64_t width, std::uint64_t height,
                    std::uint64_t bytes_per_pixel);

// Fills one row from samples of one to four channels, 8 or 16 bits each in the order of the machine: grey,
// grey with opacity, colours, colours with opacity.
void fill_row(Image& image, int row, const std::uint8_t* samples, int channels, int bits);

}  // namespace fabricsh::format
