#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>

#include <cmath>

#include "files/image.hpp"
#include "message_of.hpp"
#include "scratch.hpp"

using namespace fabricsh;
using namespace fabricsh::files;

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
  const Image got = read_image(path), want = ramp();
  REQUIRE(got.width == 40);
  REQUIRE(got.height == 20);
  for (std::size_t i = 0; i < want.pixels.size(); ++i)
    CHECK(std::abs(got.pixels[i] - want.pixels[i]) <= error);
}

}  // namespace

TEST_CASE("a picture is the same the right way up in every format", "[files]") {
  const ScratchFolder folder;
  write_png(folder / "own.png", ramp());
  check_ramp(folder / "own.png", 1e-6);  // single precision
  write<vtkPNGWriter>(folder / "colour.PNG", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "colour.PNG", 1e-6);
  write<vtkPNGWriter>(folder / "deep.png", 1, VTK_UNSIGNED_SHORT);
  check_ramp(folder / "deep.png", 1e-6);
  write<vtkTIFFWriter>(folder / "scan.tif", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "scan.tif", 1e-6);
  write<vtkJPEGWriter>(folder / "camera.jpg", 3, VTK_UNSIGNED_CHAR);
  check_ramp(folder / "camera.jpg", 0.02);  // JPEG loses
}

TEST_CASE("what is no picture is said so", "[files]") {
  const ScratchFolder folder;
  std::ofstream(folder / "text.png") << "not a picture";
  says(message_of([&] { read_image(folder / "text.png"); }), "expected a png file");
  says(message_of([&] { read_image(folder / "film.gif"); }), "expected a name ending in .png");
  says(message_of([&] { read_image(folder / "none.jpg"); }), "No such file");
}
