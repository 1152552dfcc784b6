// Photographs: PNG, JPEG, TIFF and BMP as brightness.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::photograph {

// Brightness from 0 (black) to 1 (white), row by row from the top. The centre of a pixel is at (column, row).
struct Image {
  int width = 0, height = 0;
  std::vector<float> pixels;
  float& at(int column, int row) { return pixels[static_cast<std::size_t>(row) * width + column]; }
  float at(int column, int row) const { return pixels[static_cast<std::size_t>(row) * width + column]; }
};

// Error: a name with another ending than .png, .jpg, .jpeg, .tif, .tiff or .bmp.
void check_ending(const std::string& name);
// Reads an image from the bytes of a file, whose name's ending determines the format. Colours are weighted by
// Rec. 601, opacity is ignored; 8 or 16 bits per channel. Error: another ending, bytes that do not have that
// format, or that are damaged or truncated.
Image parse_image(const std::string& name, std::string_view bytes);
// The bytes of a PNG file, 8-bit grey.
std::string png_of(const Image& image);

}  // namespace fabricsh::photograph
