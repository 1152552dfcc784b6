#include "render/plane.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <filesystem>

namespace fabricsh::render {

namespace {

template <class T>
using Ref = vtkSmartPointer<T>;

constexpr int kDotsPerInch = 72;  // assumed for the window

// A font of the system if there is one, because the built-in font of VTK has few characters.
const std::string& font_file() {
  static const std::string found = [] {
    for (const char* name : {"liberation/LiberationSans-Regular.ttf",
                             "liberation2/LiberationSans-Regular.ttf", "dejavu/DejaVuSans.ttf"})
      if (std::string path = std::string("/usr/share/fonts/truetype/") + name; std::filesystem::exists(path))
        return path;
    return std::string();
  }();
  return found;
}

void style(vtkTextProperty* text, int size) {
  text->SetColor(0, 0, 0);
  if (font_file().empty()) {
    text->SetFontFamilyToArial();
  } else {
    text->SetFontFamily(VTK_FONT_FILE);
    text->SetFontFile(font_file().c_str());
  }
  text->SetFontSize(size);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

// Removes the last character, with all its bytes in UTF-8.
void shorten(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
}

void add_flat(vtkRenderer* renderer, vtkPolyData* shape, vtkPolyDataMapper2D* mapper, double width) {
  mapper->SetInputData(shape);
  const auto actor = Ref<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.2, 0.2, 0.2);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  renderer->AddActor2D(actor);
}

}  // namespace

Point text_size(const std::string& text, int size) {
  if (text.empty()) return {0, double(size)};
  const auto look = Ref<vtkTextProperty>::New();
  style(look, size);
  int box[4] = {};
  vtkTextRenderer::GetInstance()->GetBoundingBox(look, text, box, kDotsPerInch);
  return {box[1] - box[0] + 1.0, box[3] - box[2] + 1.0};
}

void write(vtkRenderer* renderer, const std::string& text, int size, const Point& centre) {
  const auto actor = Ref<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  style(actor->GetTextProperty(), size);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  actor->SetPosition(centre[0], centre[1]);
  renderer->AddActor2D(actor);
}

bool write_fitted(vtkRenderer* renderer, const std::string& text, int size, const Point& centre,
                  double room) {
  const int smallest = std::max(7, 3 * size / 4);  // 7 pixels is the smallest readable font size
  while (size > smallest && text_size(text, size)[0] > room) --size;
  std::string begun = text, words = text;
  while (!begun.empty() && text_size(words, size)[0] > room) {
    shorten(begun);
    words = begun + "...";
  }
  write(renderer, words, size, centre);
  return words == text;
}

void add_line(vtkRenderer* renderer, const Point& from, const Point& to, double width) {
  const auto points = Ref<vtkPoints>::New();
  points->InsertNextPoint(from[0], from[1], 0);
  points->InsertNextPoint(to[0], to[1], 0);
  const auto lines = Ref<vtkCellArray>::New();
  const vtkIdType ends[] = {0, 1};
  lines->InsertNextCell(2, ends);
  const auto shape = Ref<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetLines(lines);
  add_flat(renderer, shape, Ref<vtkPolyDataMapper2D>::New(), width);
}

void add_colours(vtkRenderer* renderer, vtkLookupTable* table, const Point& low, const Point& high) {
  const auto points = Ref<vtkPoints>::New();
  const auto cells = Ref<vtkCellArray>::New();
  const auto values = Ref<vtkDoubleArray>::New();
  const vtkIdType count = table->GetNumberOfTableValues();
  const double* range = table->GetTableRange();
  for (vtkIdType i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    for (const double x : {low[0], high[0]})
      points->InsertNextPoint(x, low[1] + part * (high[1] - low[1]), 0);
    if (i == count) break;
    const vtkIdType corners[] = {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2};
    cells->InsertNextCell(4, corners);
    values->InsertNextValue(range[0] + (part + 0.5 / static_cast<double>(count)) * (range[1] - range[0]));
  }
  const auto shape = Ref<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetPolys(cells);
  shape->GetCellData()->SetScalars(values);
  const auto mapper = Ref<vtkPolyDataMapper2D>::New();
  mapper->SetLookupTable(table);
  mapper->SetScalarModeToUseCellData();
  mapper->SetScalarRange(range[0], range[1]);
  mapper->ScalarVisibilityOn();
  add_flat(renderer, shape, mapper, 1);
}

}  // namespace fabricsh::render
