// Photographs: PNG, JPEG, TIFF and BMP as brightness.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::format {

// Brightness from 0 (black) to 1 (white), row by row from the top. The centre of a pixel is at (column, row).
struct Image {
  int width = 0, height = 0;
  std::vector<float> pixels;
  float& at(int column, int row) { return pixels[static_cast<std::size_t>(row) * width + column]; }
  float at(int column, int row) const { return pixels[static_cast<std::size_t>(row) * width + column]; }
};

// Colours are weighted by Rec. 601, opacity is ignored; 8 or 16 bits per channel. The
// extension determines the format (.png .jpg .jpeg .tif .tiff .bmp). Error: another
// extension, a file that does not have that format, or one that is damaged or truncated.
Image read_image(const std::string& path);
// Reads an image from bytes in memory; `name` is used in errors in place of the path.
Image parse_image(const std::string& name, std::string_view bytes);
// Writes 8-bit grey; replaces the file.
void write_png(const std::string& path, const Image& image);

}  // namespace fabricsh::format
