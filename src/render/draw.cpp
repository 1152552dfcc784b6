#include "render/draw.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCubeAxesActor.h>
#include <vtkDataSetMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkStringArray.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"
#include "render/colours.hpp"
#include "render/sheet.hpp"

namespace fabricsh::render {

namespace {

template <class T>
using Ref = vtkSmartPointer<T>;
using files::Picture;
using Bounds = std::array<double, 6>;  // x, x, y, y, z, z

constexpr double kTitlePart = 0.07;  // of the picture, on top

struct Scene {
  const Picture& picture;
  std::vector<Sheet> sheets;
  Ref<vtkLookupTable> table;  // none: no field
  std::string unit;           // of lengths
  Ref<vtkRenderWindow> window = Ref<vtkRenderWindow>::New();
};

int font_size(const Picture& p) {
  return std::max(10, static_cast<int>(std::sqrt(double(p.width) * p.height) / 52));
}

// Part of the width that the colour bar takes: ten letters at least.
double bar_part(const Picture& p) { return std::max(0.13, 8.0 * font_size(p) / p.width); }

void style(vtkTextProperty* text, int size) {
  text->SetColor(0, 0, 0);
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

Ref<vtkRenderer> viewport(Scene& scene, double x0, double y0, double x1, double y1) {
  const auto renderer = Ref<vtkRenderer>::New();
  renderer->SetViewport(x0, y0, x1, y1);
  renderer->SetBackground(1, 1, 1);
  scene.window->AddRenderer(renderer);
  return renderer;
}

void write_text(vtkRenderer* renderer, const std::string& words, int size, double x, double y) {
  const auto text = Ref<vtkTextActor>::New();
  text->SetInput(words.c_str());
  style(text->GetTextProperty(), size);
  text->GetTextProperty()->SetJustificationToCentered();
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(x, y);
  renderer->AddActor2D(text);
}

// Common bounds, so that panels can be compared.
Bounds common(const std::vector<Sheet>& sheets) {
  Bounds all{};
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    double b[6];
    sheets[i].grid->ComputeBounds();
    sheets[i].grid->GetBounds(b);
    for (std::size_t k = 0; k < 6; ++k)
      all[k] = i == 0 ? b[k] : k % 2 == 0 ? std::min(all[k], b[k]) : std::max(all[k], b[k]);
  }
  return all;
}

double extent(const Bounds& b) { return std::max({b[1] - b[0], b[3] - b[2], b[5] - b[4]}); }
bool from_above(const Picture& p) { return p.elevation > 89.9; }

Ref<vtkActor> actor(const Scene& scene, const Sheet& sheet) {
  const auto mapper = Ref<vtkDataSetMapper>::New();
  mapper->SetInputData(sheet.grid);
  mapper->SetScalarVisibility(scene.table != nullptr);
  if (scene.table) {
    mapper->SetLookupTable(scene.table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->SetColorModeToMapScalars();
    sheet.of_cells ? mapper->SetScalarModeToUseCellData() : mapper->SetScalarModeToUsePointData();
  }
  const auto result = Ref<vtkActor>::New();
  result->SetMapper(mapper);
  vtkProperty* look = result->GetProperty();
  look->SetColor(0.82, 0.84, 0.88);
  look->SetInterpolationToFlat();
  look->SetLighting(!from_above(scene.picture));
  look->SetAmbient(0.55);
  look->SetDiffuse(0.5);
  look->SetSpecular(0);
  look->SetEdgeVisibility(scene.picture.edges);
  look->SetEdgeColor(0.25, 0.25, 0.25);
  look->SetLineWidth(1);
  return result;
}

void aim(vtkRenderer* renderer, const Picture& p, const Bounds& bounds) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const double a = p.azimuth * M_PI / 180, e = p.elevation * M_PI / 180;
  const double centre[3] = {(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
                            (bounds[4] + bounds[5]) / 2};
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre);
  camera->SetPosition(centre[0] + std::sin(a) * std::cos(e), centre[1] - std::cos(a) * std::cos(e),
                      centre[2] + std::sin(e));
  camera->SetViewUp(from_above(p) ? -std::sin(a) : 0, from_above(p) ? std::cos(a) : 0, from_above(p) ? 0 : 1);
  renderer->ResetCamera(bounds.data());
}

// The largest magnification at which the corners of the bounds, and room for the axes, stay in the viewport.
void fit(vtkRenderer* renderer, const Scene& scene, const Bounds& bounds) {
  double half_x = 0, half_y = 0;
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* m = camera->GetViewTransformMatrix();
  for (int corner = 0; corner < 8; ++corner) {
    const double p[4] = {bounds[corner & 1 ? 1 : 0], bounds[corner & 2 ? 3 : 2], bounds[corner & 4 ? 5 : 4],
                         1};
    double q[4];
    m->MultiplyPoint(p, q);
    half_x = std::max(half_x, std::abs(q[0]));
    half_y = std::max(half_y, std::abs(q[1]));
  }
  double box[4];
  renderer->GetViewport(box);
  const double shape = (box[2] - box[0]) * scene.picture.width / ((box[3] - box[1]) * scene.picture.height);
  const double room = scene.picture.axes ? 1.32 : 1.08;
  camera->SetParallelScale(room * std::max({half_y, half_x / shape, 1e-12}));
  renderer->ResetCameraClippingRange();
}

// The two ends alone, for an axis too short for more labels.
Ref<vtkStringArray> ends(double low, double high) {
  const auto labels = Ref<vtkStringArray>::New();
  for (const double v : {low, high}) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", v);
    labels->InsertNextValue(text);
  }
  return labels;
}

void add_axes(vtkRenderer* renderer, const Scene& scene, Bounds bounds) {
  const auto axes = Ref<vtkCubeAxesActor>::New();
  axes->SetBounds(bounds.data());
  axes->SetCamera(renderer->GetActiveCamera());
  const char* const names[] = {"x", "y", "z"};
  axes->SetXTitle(names[0]), axes->SetYTitle(names[1]), axes->SetZTitle(names[2]);
  axes->SetXUnits(scene.unit.c_str()), axes->SetYUnits(scene.unit.c_str()),
      axes->SetZUnits(scene.unit.c_str());
  axes->SetXLabelFormat("%-.4g"), axes->SetYLabelFormat("%-.4g"), axes->SetZLabelFormat("%-.4g");
  for (int i = 0; i < 3; ++i) {
    style(axes->GetTitleTextProperty(i), font_size(scene.picture));
    style(axes->GetLabelTextProperty(i), font_size(scene.picture));
  }
  for (vtkProperty* line :
       {axes->GetXAxesLinesProperty(), axes->GetYAxesLinesProperty(), axes->GetZAxesLinesProperty()})
    line->SetColor(0.3, 0.3, 0.3);
  const bool flat = bounds[5] - bounds[4] < 0.02 * extent(bounds) || from_above(scene.picture);
  axes->SetZAxisVisibility(!flat);
  axes->SetXAxisMinorTickVisibility(false), axes->SetYAxisMinorTickVisibility(false),
      axes->SetZAxisMinorTickVisibility(false);
  if (bounds[5] - bounds[4] < 0.4 * extent(bounds)) axes->SetAxisLabels(2, ends(bounds[4], bounds[5]));
  axes->SetTickLocationToOutside();
  flat ? axes->SetFlyModeToStaticTriad() : axes->SetFlyModeToOuterEdges();
  axes->SetScreenSize(font_size(scene.picture) * 0.5);
  axes->SetLabelOffset(font_size(scene.picture) * 0.6);
  axes->SetTitleOffset(font_size(scene.picture) * 0.8);
  renderer->AddActor(axes);
}

// Digits enough to tell the labels of a narrow range apart.
std::string label_format(double low, double high) {
  const double largest = std::max(std::abs(low), std::abs(high));
  const int more = static_cast<int>(std::floor(std::log10(largest / (high - low))));
  return "%-." + std::to_string(3 + std::clamp(more, 0, 4)) + "g";
}

void add_bar(Scene& scene) {
  const auto renderer = viewport(scene, 1 - bar_part(scene.picture), 0, 1, 1 - kTitlePart);
  const auto bar = Ref<vtkScalarBarActor>::New();
  bar->SetLookupTable(scene.table);
  bar->SetTitle("");
  bar->SetNumberOfLabels(6);
  bar->SetMaximumNumberOfColors(256);
  bar->SetLabelFormat(label_format(*scene.table->GetTableRange(), scene.table->GetTableRange()[1]).c_str());
  bar->UnconstrainedFontSizeOn();
  style(bar->GetLabelTextProperty(), font_size(scene.picture));
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.12, 0.12);
  bar->SetWidth(0.75);
  bar->SetHeight(0.72);
  bar->SetBarRatio(0.3);
  renderer->AddActor2D(bar);
  write_text(renderer, scene.picture.bar, font_size(scene.picture), 0.5, 0.92);
}

// Where panel i of the grid of panels stands.
Ref<vtkRenderer> panel_viewport(Scene& scene, int i) {
  const int n = static_cast<int>(scene.sheets.size());
  const int columns = scene.picture.columns > 0 ? std::min(scene.picture.columns, n)
                      : n <= 3                  ? n
                                                : (n + 1) / 2;
  const int rows = (n + columns - 1) / columns, row = i / columns, column = i % columns;
  const double right = scene.table ? 1 - bar_part(scene.picture) : 1,
               top = scene.picture.title.empty() ? 1 : 1 - kTitlePart;
  return viewport(scene, right * column / columns, top * (rows - 1 - row) / rows,
                  right * (column + 1) / columns, top * (rows - row) / rows);
}

void add_panels(Scene& scene) {
  Bounds bounds = common(scene.sheets);
  const bool metres = extent(bounds) >= 1.5;
  scene.unit = metres ? "m" : "mm";
  if (!metres)
    for (const Sheet& sheet : scene.sheets) scale(sheet, 1000);
  bounds = common(scene.sheets);
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) {
    const auto renderer = panel_viewport(scene, static_cast<int>(i));
    renderer->AddActor(actor(scene, scene.sheets[i]));
    aim(renderer, scene.picture, bounds);
    fit(renderer, scene, bounds);
    if (scene.picture.axes) add_axes(renderer, scene, bounds);
    const std::string& label = scene.picture.panels[i].label;
    if (!label.empty()) write_text(renderer, label, font_size(scene.picture), 0.5, 0.97);
  }
}

void make_table(Scene& scene) {
  if (scene.picture.array.empty()) return;
  double low = scene.picture.low, high = scene.picture.high;
  if (!scene.picture.fixed_range) {
    low = scene.sheets[0].low, high = scene.sheets[0].high;
    for (const Sheet& sheet : scene.sheets) low = std::min(low, sheet.low), high = std::max(high, sheet.high);
  }
  if (!(low <= high)) throw Error("render: the field '" + scene.picture.array + "' holds no finite value");
  if (std::abs(low) < 1e-9 * high) low = 0;  // rounding beside the rest
  // A field that is the same everywhere gets one colour, not the noise of its last digits.
  const double least = 1e-6 * std::max({std::abs(low), std::abs(high), 1e-30});
  if (high - low < least) low -= least, high += least;
  scene.table = colours(low, high);
}

void save(Scene& scene) {
  const auto image = Ref<vtkWindowToImageFilter>::New();
  image->SetInput(scene.window);
  image->ReadFrontBufferOff();
  image->Update();
  const auto writer = Ref<vtkPNGWriter>::New();
  writer->SetFileName(scene.picture.png.c_str());
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0) throw Error("render: cannot write '" + scene.picture.png + "'");
}

}  // namespace

void draw(const Picture& picture) {
  if (picture.panels.empty()) throw Error("render: expected at least one file");
  Scene scene{picture, {}, nullptr, {}};
  for (const files::Panel& panel : picture.panels) scene.sheets.push_back(read_sheet(panel.vtu, picture));
  make_table(scene);
  scene.window->SetOffScreenRendering(1);
  scene.window->SetMultiSamples(8);
  scene.window->SetSize(picture.width, picture.height);
  viewport(scene, 0, 0, 1, 1);  // white behind everything
  add_panels(scene);
  if (scene.table) add_bar(scene);
  if (!picture.title.empty()) {
    const auto renderer = viewport(scene, 0, 1 - kTitlePart, 1, 1);
    write_text(renderer, picture.title, font_size(picture) * 5 / 4, 0.5, 0.5);
  }
  scene.window->Render();
  save(scene);
}

}  // namespace fabricsh::render
