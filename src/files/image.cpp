#include "files/image.hpp"

#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "files/atomic.hpp"
#include "files/gate.hpp"

namespace fabricsh::files {

namespace {

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

vtkSmartPointer<vtkImageReader2> reader_for(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == ".png") return vtkSmartPointer<vtkPNGReader>::New();
  if (ending == ".jpg" || ending == ".jpeg") return vtkSmartPointer<vtkJPEGReader>::New();
  if (ending != ".tif" && ending != ".tiff")
    throw Error("image '" + path + "': expected a name ending in .png, .jpg, .jpeg, .tif or .tiff");
  return vtkSmartPointer<vtkTIFFReader>::New();
}

// Brightness of a pixel of one, two (with opacity), three or four channels.
double brightness(vtkImageData& data, int column, int row) {
  const auto channel = [&](int c) { return data.GetScalarComponentAsDouble(column, row, 0, c); };
  if (data.GetNumberOfScalarComponents() < 3) return channel(0);
  return 0.299 * channel(0) + 0.587 * channel(1) + 0.114 * channel(2);
}

}  // namespace

Image read_image(const std::string& path) {
  const auto reader = reader_for(path);
  // Opened through the gate; the readers take nothing but a path, and this one means the opened file.
  const Descriptor file = Gate::of_process().open(path);
  const std::string opened = "/proc/self/fd/" + std::to_string(file.number());
  if (reader->CanReadFile(opened.c_str()) == 0)
    throw Error("image '" + path + "': expected a " + ending_of(path).substr(1) +
                " file, its content is something else");
  reader->SetFileName(opened.c_str());
  reader->Update();
  vtkImageData& data = *reader->GetOutput();
  int size[3];
  data.GetDimensions(size);
  if (size[0] < 1 || size[1] < 1) throw Error("image '" + path + "': it holds no picture");
  const double white = data.GetScalarType() == VTK_UNSIGNED_SHORT ? 65535 : 255;
  // VTK counts rows from the bottom, but its TIFF reader hands them out from the top.
  const bool from_top = ending_of(path).starts_with(".tif");
  Image image{size[0], size[1],
              std::vector<float>(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]))};
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image.at(column, row) =
          static_cast<float>(brightness(data, column, from_top ? row : image.height - 1 - row) / white);
  return image;
}

void write_png(const std::string& path, const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const double grey = std::clamp(std::round(255.0 * image.at(column, row)), 0.0, 255.0);
      data->SetScalarComponentFromDouble(column, image.height - 1 - row, 0, 0, grey);
    }
  make_folder_for(path);
  AtomicFile file(path);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.temporary().c_str());
  writer->SetInputData(data);
  writer->Write();
  if (writer->GetErrorCode() != 0) throw Error("cannot write '" + path + "'");
  file.commit(Sync::no);
}

}  // namespace fabricsh::files
