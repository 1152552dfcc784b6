#include "photograph/image.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "base/error.hpp"
#include "photograph/image_decode.hpp"

namespace fabricsh::photograph {

namespace {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

struct Format {
  const char* word;  // in messages
  std::vector<std::string_view> endings, signatures;
  Image (*decode)(const Encoded& file);
};

const std::vector<Format>& formats() {
  using namespace std::string_view_literals;
  static const std::vector<Format> all = {
      {"png", {".png"}, {"\x89PNG\r\n\x1a\n"sv}, decode_png},
      {"jpg", {".jpg", ".jpeg"}, {"\xff\xd8"sv}, decode_jpeg},
      {"tif", {".tif", ".tiff"}, {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv}, decode_tiff},
      {"bmp", {".bmp"}, {"BM"sv}, decode_bmp},
  };
  return all;
}

const Format& format_of(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const Format& format : formats())
    if (std::find(format.endings.begin(), format.endings.end(), ending) != format.endings.end())
      return format;
  throw Error("image '" + path + "': expected a name ending in .png, .jpg, .jpeg, .tif, .tiff or .bmp");
}

// A pixel takes four bytes here, and whoever reads it makes copies. A photograph of a few million pixels may
// be of any content; a larger one takes at least a bit for eight pixels, or it is made to fill the memory.
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 27, any_content = std::uint64_t{1} << 24;
constexpr std::uint64_t pixels_per_byte = 64;
constexpr std::uint64_t tightest = 1040, small = std::uint64_t{1} << 20;

template <class Sample>
void fill(Image& image, int row, const std::uint8_t* samples, int channels, double white) {
  for (int column = 0; column < image.width; ++column) {
    const auto channel = [&](int c) {
      Sample value;
      std::memcpy(&value, samples + (std::size_t(column) * channels + c) * sizeof value, sizeof value);
      return static_cast<double>(value);
    };
    const double shown =
        channels < 3 ? channel(0) : 0.299 * channel(0) + 0.587 * channel(1) + 0.114 * channel(2);
    image.at(column, row) = static_cast<float>(shown / white);
  }
}

}  // namespace

void refused(const Encoded& file, const std::string& why) {
  throw Error("image '" + file.name + "': " + why);
}

void damaged(const Encoded& file, const std::string& why) {
  refused(file, "it is damaged or cut short (" + why + ")");
}

Image image_of_size(const Encoded& file, std::uint64_t width, std::uint64_t height,
                    std::uint64_t bytes_per_pixel) {
  if (width < 1 || height < 1) refused(file, "it holds no picture");
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  const std::uint64_t most = std::clamp(pixels_per_byte * file.bytes.size(), any_content, most_pixels);
  if (width > most / height)
    refused(file, "its header declares " + size + ", more than the " + std::to_string(most) +
                      " that are read from a file of " + std::to_string(file.bytes.size()) + " bytes");
  if (width * height * bytes_per_pixel > tightest * file.bytes.size() + small)
    damaged(file, std::to_string(file.bytes.size()) + " bytes can't hold " + size);
  return {static_cast<int>(width), static_cast<int>(height), std::vector<float>(width * height)};
}

void fill_row(Image& image, int row, const std::uint8_t* samples, int channels, int bits) {
  if (bits == 16)
    fill<std::uint16_t>(image, row, samples, channels, 65535);
  else
    fill<std::uint8_t>(image, row, samples, channels, 255);
}

Image parse_image(const std::string& name, std::string_view bytes) {
  const Format& format = format_of(name);
  const bool known = std::any_of(format.signatures.begin(), format.signatures.end(),
                                 [&](std::string_view signature) { return bytes.starts_with(signature); });
  if (!known)
    throw Error("image '" + name + "': expected a " + format.word + " file, its content is something else");
  return format.decode({name, bytes});
}

void check_ending(const std::string& name) { format_of(name); }

}  // namespace fabricsh::photograph
