#include <vtkBMPWriter.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "message_of.hpp"
#include "photograph/image.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::photograph;

namespace {

Image ramp() {
  Image image{40, 20, std::vector<float>(800)};
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 40; ++c) image.at(c, r) = static_cast<float>(c * 3 + r * 5) / 255.0F;
  return image;
}

template <class Writer>
void write(const std::string& path, int channels, int type) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(40, 20, 1);
  data->AllocateScalars(type, channels);
  const double most = type == VTK_UNSIGNED_SHORT ? 257 : 1;
  for (int r = 0; r < 20; ++r)
    for (int c = 0; c < 40; ++c)
      for (int k = 0; k < channels; ++k)
        data->SetScalarComponentFromDouble(c, 19 - r, 0, k, most * (c * 3 + r * 5));
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->Write();
}

void check_ramp(const std::string& path, double error) {
  INFO(path);
  const Image got = parse_image(path, content_of(path)), want = ramp();
  REQUIRE(got.width == 40);
  REQUIRE(got.height == 20);
  for (std::size_t i = 0; i < want.pixels.size(); ++i)
    CHECK(std::abs(got.pixels[i] - want.pixels[i]) <= error);
}

}  // namespace

TEST_CASE("a picture is the same the right way up in every format", "[files]") {
  const ScratchFolder folder;
  std::ofstream(folder / "own.png", std::ios::binary) << png_of(ramp());
  check_ramp(folder / "own.png", 1e-6);  // single precision
  write<vtkPNGWriter>(folder / "colour.PNG", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "colour.PNG", 1e-6);
  write<vtkPNGWriter>(folder / "deep.png", 1, VTK_UNSIGNED_SHORT);
  check_ramp(folder / "deep.png", 1e-6);
  write<vtkTIFFWriter>(folder / "scan.tif", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "scan.tif", 1e-6);
  write<vtkJPEGWriter>(folder / "camera.jpg", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "camera.jpg", 0.02);  // JPEG loses
  write<vtkTIFFWriter>(folder / "deep.tiff", 1, VTK_UNSIGNED_SHORT);
  check_ramp(folder / "deep.tiff", 1e-6);
  write<vtkBMPWriter>(folder / "screen.bmp", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "screen.bmp", 1e-6);
}

TEST_CASE("a file that is no picture is said so", "[files]") {
  says(message_of([&] { parse_image("text.png", "not a picture"); }), "expected a png file");
  says(message_of([&] { check_ending("film.gif"); }), "expected a name ending in .png");
}

namespace {

// One picture in each format, by its name.
std::vector<std::pair<std::string, std::string>> pictures() {
  const ScratchFolder folder;
  write<vtkPNGWriter>(folder / "a.png", 3, VTK_UNSIGNED_CHAR);
  write<vtkPNGWriter>(folder / "b.png", 1, VTK_UNSIGNED_SHORT);
  write<vtkJPEGWriter>(folder / "c.jpg", 3, VTK_UNSIGNED_CHAR);
  write<vtkTIFFWriter>(folder / "d.tif", 3, VTK_UNSIGNED_CHAR);
  write<vtkBMPWriter>(folder / "e.bmp", 3, VTK_UNSIGNED_CHAR);
  std::vector<std::pair<std::string, std::string>> out;
  for (const char* name : {"a.png", "b.png", "c.jpg", "d.tif", "e.bmp"})
    out.emplace_back(name, content_of(folder / name));
  return out;
}

}  // namespace

TEST_CASE("a picture that was cut short is refused at every length", "[files]") {
  for (const auto& picture : pictures()) {
    const std::string &name = picture.first, &bytes = picture.second;
    REQUIRE(parse_image(name, bytes).width == 40);
    for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 200) {
      INFO(name << " cut to " << length << " of " << bytes.size() << " bytes");
      says(message_of([&] { parse_image(name, bytes.substr(0, length)); }), "image '" + name + "': ");
    }
    says(message_of([&] { parse_image(name, bytes.substr(0, bytes.size() / 2)); }), "damaged or cut short");
  }
}

TEST_CASE("a damaged picture is refused or read, and the program lives on", "[files]") {
  std::mt19937 random(20);
  for (const auto& [name, bytes] : pictures())
    for (int i = 0; i < 300; ++i) {
      std::string wrong = bytes;
      for (unsigned k = random() % 5 + 1; k-- > 0;)
        wrong[random() % wrong.size()] = static_cast<char>(random() % 256);
      INFO(name << ", damage " << i);
      try {
        const Image image = parse_image(name, wrong);
        CHECK(image.pixels.size() == static_cast<std::size_t>(image.width) * image.height);
        CHECK(
            std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return v >= 0 && v <= 1; }));
      } catch (const Error& error) {
        says(error.what(), "image '" + name + "': ");
      }
    }
}

TEST_CASE("the size that a picture gives is not believed", "[files]") {
  const auto all = pictures();
  std::string png = all[0].second;
  const auto claim = [&](char high) {
    png[16] = png[20] = high;  // width and height, the highest byte first
    unsigned long sum = crc32(0, reinterpret_cast<const unsigned char*>(&png[12]), 17);
    for (int i = 0; i < 4; ++i, sum >>= 8U)
      png[static_cast<std::size_t>(32 - i)] = static_cast<char>(sum & 0xffU);
    return message_of([&] { parse_image("large.png", png); });
  };
  says(claim(0x40), "damaged or cut short");  // libpng's own limit of a million rows
  png[16] = png[20] = 0;
  png[17] = png[21] = 0;
  png[18] = png[22] = 0x0f;
  says(claim(0), "bytes can't hold 3880 x 3860 pixels");
  // A file as small as this is not to fill the memory, whatever its packing could hold.
  png[18] = png[22] = 0x10;
  says(claim(0),
       "its header declares 4136 x 4116 pixels, more than the 16777216 that are read from a file of ");
  // A longer one may have 64 pixels for each byte, up to 2^27.
  const auto long_claim = [&](char middle, std::size_t bytes) {
    png[18] = png[22] = middle;
    claim(0);
    return message_of([&] { parse_image("large.png", png + std::string(bytes - png.size(), '\0')); });
  };
  says(long_claim(0x2f, 3'000'000), "more than the 134217728 that are read from a file of 3000000 bytes");
  says(long_claim(0x2f, 2'000'000), "more than the 128000000 that are read from a file of 2000000 bytes");
}
