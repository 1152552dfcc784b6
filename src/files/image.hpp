// Photographs: PNG, JPEG and TIFF as brightness, by VTK.
#pragma once
#include <string>
#include <vector>

namespace fabricsh::files {

// Brightness from 0 (black) to 1 (white), row by row from the top; pixel (column, row) has its middle there.
struct Image {
  int width = 0, height = 0;
  std::vector<float> pixels;
  float& at(int column, int row) { return pixels[static_cast<std::size_t>(row) * width + column]; }
  float at(int column, int row) const { return pixels[static_cast<std::size_t>(row) * width + column]; }
};

// Colours are weighted as the eye does (Rec. 601); 8 or 16 bits a channel. The ending of the name says the
// format (.png .jpg .jpeg .tif .tiff). Error: another ending, or a file that is not of that format.
Image read_image(const std::string& path);
// 8 bits, grey; replaces the file.
void write_png(const std::string& path, const Image& image);

}  // namespace fabricsh::files
