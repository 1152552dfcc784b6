// BMP without compression: 8 bits with a palette, 24 or 32 bits per pixel.

#include "photograph/image_decode.hpp"

namespace fabricsh::photograph {

namespace {

std::int64_t little(const Encoded& file, std::size_t at, int bytes) {
  if (at + static_cast<std::size_t>(bytes) > file.bytes.size())
    damaged(file, "the file ends within its head");
  std::uint32_t value = 0;
  for (int i = bytes; i-- > 0;) value = value << 8U | static_cast<unsigned char>(file.bytes[at + i]);
  return bytes == 4 ? static_cast<std::int32_t>(value) : static_cast<std::int64_t>(value);
}

struct BmpHeader {
  std::int64_t pixels_at, size, width, height, bits, packing, colours;
};

BmpHeader head_of(const Encoded& file) {
  BmpHeader h{little(file, 10, 4), little(file, 14, 4), little(file, 18, 4), little(file, 22, 4),
              little(file, 28, 2), little(file, 30, 4), little(file, 46, 4)};
  if (h.size < 40) refused(file, "its form is not read: the head has " + std::to_string(h.size) + " bytes");
  constexpr int masks = 3;  // with 32 bits; taken in the usual order, as no other is in use
  if (h.packing != 0 && !(h.packing == masks && h.bits == 32))
    refused(file, "its compression is not read; save it uncompressed, or as PNG");
  if (h.bits != 8 && h.bits != 24 && h.bits != 32)
    refused(file, "expected 8, 24 or 32 bits a pixel, got " + std::to_string(h.bits));
  if (h.width < 1 || h.height == 0 || h.height == INT32_MIN) refused(file, "it holds no picture");
  return h;
}

}  // namespace

Image decode_bmp(const Encoded& file) {
  const BmpHeader h = head_of(file);
  const auto rows = static_cast<std::uint64_t>(h.height < 0 ? -h.height : h.height);
  const auto width = static_cast<std::uint64_t>(h.width), depth = static_cast<std::uint64_t>(h.bits / 8);
  const std::uint64_t line = (width * depth + 3) / 4 * 4;
  const auto at = static_cast<std::uint64_t>(h.pixels_at);
  if (h.pixels_at < 0 || at > file.bytes.size() || (file.bytes.size() - at) / line < rows)
    damaged(file, "the file ends within its pixels");
  Image image = image_of_size(file, width, rows, depth);
  const std::size_t palette = 14 + static_cast<std::size_t>(h.size);
  const std::size_t colours = h.bits > 8 ? 0 : h.colours > 0 && h.colours < 256 ? h.colours : 256;
  if (palette + 4 * colours > file.bytes.size()) damaged(file, "the file ends within its palette");
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.bytes.data());
  std::vector<std::uint8_t> samples(3 * width);
  for (std::uint64_t row = 0; row < rows; ++row) {
    const std::uint8_t* from = bytes + at + row * line;
    for (std::uint64_t column = 0; column < width; ++column, from += depth) {
      if (depth == 1 && *from >= colours) damaged(file, "a pixel has a colour beyond the palette");
      const std::uint8_t* blue = depth == 1 ? bytes + palette + 4U * *from : from;
      for (int c = 0; c < 3; ++c) samples[3 * column + c] = blue[2 - c];
    }
    fill_row(image, static_cast<int>(h.height < 0 ? row : rows - 1 - row), samples.data(), 3, 8);
  }
  return image;
}

}  // namespace fabricsh::photograph
