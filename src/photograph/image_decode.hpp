// Decoders of image formats, from bytes in memory. A file may be damaged on
// purpose: the size stated in its header is checked against its length before
// memory is allocated, and every complaint of the image libraries becomes an Error.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "photograph/image.hpp"

namespace fabricsh::photograph {

// The bytes of a file, and its name for errors.
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

// An image of that size, not yet filled. Error: no pixels; more than 2^27, or than 2^24 and 64 for each byte
// of the file; or more than these bytes can hold at the highest compression of any of the formats (1032 to
// one, the bound of deflate).
Image image_of_size(const Encoded& file, std::uint64_t width, std::uint64_t height,
                    std::uint64_t bytes_per_pixel);

// Fills one row from samples of one to four channels: grey, grey with opacity, colours,
// colours with opacity. Each sample has 8 or 16 bits in the machine's byte order.
void fill_row(Image& image, int row, const std::uint8_t* samples, int channels, int bits);

}  // namespace fabricsh::photograph
