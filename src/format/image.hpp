// Photographs: PNG, JPEG, TIFF and BMP as brightness.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace fabricsh::format {

// Brightness from 0 (black) to 1 (white), row by row from the top; pixel (column, row) has its middle there.
struct Image {
  int width = 0, height = 0;
  std::vector<float> pixels;
  float& at(int column, int row) { return pixels[static_cast<std::size_t>(row) * width + column]; }
  float at(int column, int row) const { return pixels[static_cast<std::size_t>(row) * width + column]; }
};

// Colours are weighted as the eye does (Rec. 601), opacity is left out; 8 or 16 bits a channel. The ending of
// the name says the format (.png .jpg .jpeg .tif .tiff .bmp). Error: another ending, a file that is not of
// that format, one that is damaged or cut short.
Image read_image(const std::string& path);
// The same of bytes in memory; `name` stands for the path.
Image parse_image(const std::string& name, std::string_view bytes);
// 8 bits, grey; replaces the file.
void write_png(const std::string& path, const Image& image);

}  // namespace fabricsh::format
