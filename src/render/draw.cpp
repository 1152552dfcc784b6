#include "render/draw.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkPNGWriter.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "render/colours.hpp"
#include "render/layout.hpp"
#include "render/plane.hpp"
#include "render/sheet.hpp"

namespace fabricsh::render {

namespace {

template <class T>
using Ref = vtkSmartPointer<T>;
using plot::Picture;

constexpr double kTitlePart = 0.07;  // height of the title as a share of the picture

struct Scene {
  const Picture& picture;
  std::vector<Sheet> sheets;
  Ref<vtkLookupTable> table;  // null: no field
  std::string unit;           // unit of length
  Ref<vtkRenderWindow> window = Ref<vtkRenderWindow>::New();
};

int font_size(const Picture& p) {
  return std::max(10, static_cast<int>(std::sqrt(double(p.width) * p.height) / 52));
}

Ref<vtkRenderer> viewport(Scene& scene, double x0, double y0, double x1, double y1) {
  const auto renderer = Ref<vtkRenderer>::New();
  renderer->SetViewport(x0, y0, x1, y1);
  renderer->SetBackground(1, 1, 1);
  scene.window->AddRenderer(renderer);
  return renderer;
}

// Common bounds of all sheets, so that the panels can be compared.
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

// Sets a parallel projection that places the bounds as the layout states, seen from outside the bounds.
void aim(vtkRenderer* renderer, const Bounds& bounds, const View& view, const Layout& l, const Point& size) {
  double focus[3], eye[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double to_right = (size[0] / 2 - l.centre[0]) / l.scale,
                 to_top = (size[1] / 2 - l.centre[1]) / l.scale;
    focus[k] = (bounds[2 * k] + bounds[2 * k + 1]) / 2 + to_right * view.right[k] + to_top * view.up[k];
    eye[k] = focus[k] + 10 * extent(bounds) * (view.right[i] * view.up[j] - view.right[j] * view.up[i]);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus);
  camera->SetPosition(eye);
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(size[1] / 2 / l.scale);
  renderer->ResetCameraClippingRange();
}

std::vector<std::string> bar_labels(const Scene& scene) {
  const double* range = scene.table->GetTableRange();
  return even_labels(range[0], range[1], 6);
}

// Width of the column for the colour bar: the bar with its widest label, or its title, within limits.
double bar_width(const Scene& scene) {
  if (!scene.table) return 0;
  const int letter = font_size(scene.picture);
  double labels = 0;
  for (const std::string& label : bar_labels(scene)) labels = std::max(labels, text_size(label, letter)[0]);
  const double title = text_size(scene.picture.bar, letter)[0];
  return std::min(0.4 * scene.picture.width, std::max(4.5 * letter + labels, 2 * letter + title));
}

void add_bar(Scene& scene) {
  const int letter = font_size(scene.picture);
  const double width = bar_width(scene), top = (1 - kTitlePart) * scene.picture.height;
  const double low = 0.12 * top, high = 0.84 * top;
  const auto renderer = viewport(scene, 1 - width / scene.picture.width, 0, 1, 1 - kTitlePart);
  add_colours(renderer, scene.table, {1.0 * letter, low}, {2.5 * letter, high});
  const auto labels = bar_labels(scene);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(labels.size() - 1);
    write(renderer, labels[i], letter,
          {3 * letter + text_size(labels[i], letter)[0] / 2, low + part * (high - low)});
  }
  write_fitted(renderer, scene.picture.bar, letter, {width / 2, 0.92 * top}, width - letter);
}

struct Place {
  double x0, y0, x1, y1;  // shares of the picture
};

// The place of panel i.
Place panel_place(const Scene& scene, int i) {
  const int n = static_cast<int>(scene.sheets.size());
  const int columns = scene.picture.columns > 0 ? std::min(scene.picture.columns, n)
                      : n <= 3                  ? n
                                                : (n + 1) / 2;
  const int rows = (n + columns - 1) / columns, row = i / columns, column = i % columns;
  const double right = 1 - bar_width(scene) / scene.picture.width,
               top = scene.picture.title.empty() ? 1 : 1 - kTitlePart;
  return {right * column / columns, top * (rows - 1 - row) / rows, right * (column + 1) / columns,
          top * (rows - row) / rows};
}

void add_panel(Scene& scene, int i, const Bounds& bounds) {
  const Picture& p = scene.picture;
  const int letter = font_size(p);
  const Place place = panel_place(scene, i);
  const auto renderer = viewport(scene, place.x0, place.y0, place.x1, place.y1);
  const Point size{(place.x1 - place.x0) * p.width, (place.y1 - place.y0) * p.height};
  const std::string& label = p.panels[static_cast<std::size_t>(i)].label;
  const bool labelled = std::any_of(p.panels.begin(), p.panels.end(),
                                    [](const plot::Panel& panel) { return !panel.label.empty(); });
  const double above = labelled ? 2 * letter : 0;  // space for labels, the same in all panels
  std::map<std::string, Point> known;
  const auto measure = [&](const std::string& text) {
    const auto [found, fresh] = known.try_emplace(text);
    if (fresh) found->second = text_size(text, letter);
    return found->second;
  };
  const View view = view_from(p.azimuth, p.elevation);
  const Layout l =
      layout(bounds, view, p.axes ? scene.unit : "", {size[0], size[1] - above, double(letter), measure});
  renderer->AddActor(actor(scene, scene.sheets[static_cast<std::size_t>(i)]));
  aim(renderer, bounds, view, l, size);
  for (const Line& line : l.lines) add_line(renderer, line.from, line.to);
  for (const Word& word : l.words) write(renderer, word.text, letter, word.centre);
  if (!label.empty())
    write_fitted(renderer, label, letter, {size[0] / 2, size[1] - above / 2}, size[0] - letter);
}

void add_panels(Scene& scene) {
  Bounds bounds = common(scene.sheets);
  const bool metres = extent(bounds) >= 1.5;
  scene.unit = metres ? "m" : "mm";
  if (!metres)
    for (const Sheet& sheet : scene.sheets) scale(sheet, 1000);
  bounds = common(scene.sheets);
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) add_panel(scene, static_cast<int>(i), bounds);
}

void make_table(Scene& scene) {
  if (scene.picture.array.empty()) return;
  double low = scene.picture.low, high = scene.picture.high;
  if (!scene.picture.fixed_range) {
    low = scene.sheets[0].low, high = scene.sheets[0].high;
    for (const Sheet& sheet : scene.sheets) low = std::min(low, sheet.low), high = std::max(high, sheet.high);
  }
  if (!(low <= high)) throw Error("render: the field '" + scene.picture.array + "' holds no finite value");
  if (std::abs(low) < 1e-9 * high) low = 0;  // only rounding error compared with the range
  // A constant field gets one colour and a bar around
  // its value, instead of a scale for rounding errors.
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest == 0) low = -1, high = 1;
  if (high - low < 1e-6 * largest) low -= 0.05 * largest, high += 0.05 * largest;
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
  for (const plot::Panel& panel : picture.panels) scene.sheets.push_back(read_sheet(panel.vtu, picture));
  make_table(scene);
  scene.window->SetOffScreenRendering(1);
  scene.window->SetMultiSamples(8);
  scene.window->SetSize(picture.width, picture.height);
  viewport(scene, 0, 0, 1, 1);  // white background
  add_panels(scene);
  if (scene.table) add_bar(scene);
  if (!picture.title.empty())
    write_fitted(viewport(scene, 0, 1 - kTitlePart, 1, 1), picture.title, font_size(picture) * 5 / 4,
                 {picture.width / 2.0, kTitlePart * picture.height / 2}, picture.width - font_size(picture));
  scene.window->Render();
  save(scene);
}

}  // namespace fabricsh::render
