#include "render/draw.hpp"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetMapper.h>
#include <vtkDoubleArray.h>
#include <vtkGeometryFilter.h>
#include <vtkLookupTable.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "plot/colour_scale.hpp"
#include "render/layout.hpp"
#include "render/sheet.hpp"

namespace fabricsh::render {

namespace {

// --- Text, lines and colours in a part of a picture; positions in pixels from its lower left corner.

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

// Width and height of a text in the given font size.
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

// Uses a font smaller by up to a quarter if the room is too narrow; a text that is still too long is
// shortened and ends in three points. Returns whether the whole text was written.
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

// Fills the rectangle between these corners with the table's colours, from the lower end upwards.
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

// --- Colour scales that remain distinguishable in grey print and for most colour-blind readers.

// Dark violet to yellow; or blue, white at zero, and red if the range includes both signs.
vtkSmartPointer<vtkLookupTable> colours(double low, double high) {
  constexpr int count = 256;
  const auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(low, high);
  table->SetNanColor(0.72, 0.72, 0.72, 1);  // rigid bodies have no field
  for (int i = 0; i < count; ++i) {
    const double v = low + (i + 0.5) / count * (high - low);
    const auto c = plot::colour(v, low, high);
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  return table;
}

// --- The picture.

using plot::Picture;

struct DrawnScene {
  const Picture& picture;
  std::vector<ClothSurface> sheets = {};
  Ref<vtkLookupTable> table = nullptr;  // null: no field
  Bar bar = {};                         // only with a field
  std::string unit = {};                // unit of length
  double most = 1e300;                  // scale limit in pixels per unit of length, equal for all panels
  std::vector<std::string> complaints = {};
  Ref<vtkRenderWindow> window = Ref<vtkRenderWindow>::New();
};

// Font size in pixels. A point is 1/72 inch.
int font_size(const Picture& p) {
  if (p.dpi > 0) return std::max(7, static_cast<int>(std::lround(p.font_size * p.dpi / 72)));
  return std::max(10, static_cast<int>(std::sqrt(double(p.width) * p.height) / 52));
}

double points(const Picture& p, double width) { return std::max(1.0, width * p.dpi / 72); }

// Height of the title as a fraction of the picture.
double title_part(const Picture& p) { return p.title.empty() ? 0 : 2.2 * font_size(p) / p.height; }

Ref<vtkRenderer> viewport(DrawnScene& scene, double x0, double y0, double x1, double y1) {
  const auto renderer = Ref<vtkRenderer>::New();
  renderer->SetViewport(x0, y0, x1, y1);
  renderer->SetBackground(1, 1, 1);
  scene.window->AddRenderer(renderer);
  return renderer;
}

// Common bounds of all sheets, so that the panels can be compared.
Bounds common(const std::vector<ClothSurface>& sheets) {
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
bool from_above(const plot::PicturePanel& p) { return p.elevation > 89.9; }

// The surface with normals at its points, without which it is shaded facet by facet. Edges sharper than
// the angle stay edges.
Ref<vtkPolyData> shaded(vtkDataSet* surface, double sharpest_degrees) {
  const auto polygons = Ref<vtkGeometryFilter>::New();
  polygons->SetInputData(surface);
  const auto normals = Ref<vtkPolyDataNormals>::New();
  normals->SetInputConnection(polygons->GetOutputPort());
  normals->SetFeatureAngle(sharpest_degrees);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

Ref<vtkActor> actor(const DrawnScene& scene, const ClothSurface& sheet, bool lit) {
  const auto mapper = Ref<vtkDataSetMapper>::New();
  scene.picture.smooth ? mapper->SetInputData(shaded(sheet.grid, 70)) : mapper->SetInputData(sheet.grid);
  mapper->SetScalarVisibility(scene.table != nullptr);
  if (scene.table) {
    mapper->SetLookupTable(scene.table);
    mapper->UseLookupTableScalarRangeOn();
    mapper->SetColorModeToMapScalars();
    mapper->SetInterpolateScalarsBeforeMapping(
        sheet.of_points);  // colours between nodes are those of the bar
    sheet.of_cells ? mapper->SetScalarModeToUseCellData() : mapper->SetScalarModeToUsePointData();
  }
  const auto result = Ref<vtkActor>::New();
  result->SetMapper(mapper);
  vtkProperty* look = result->GetProperty();
  look->SetColor(0.82, 0.84, 0.88);
  scene.picture.smooth ? look->SetInterpolationToGouraud() : look->SetInterpolationToFlat();
  look->SetLighting(lit);
  look->SetAmbient(0.75);  // weak shading, so that colours can be compared with the bar
  look->SetDiffuse(0.28);
  look->SetSpecular(0);
  look->SetEdgeVisibility(scene.picture.edges);
  look->SetEdgeColor(0.25, 0.25, 0.25);
  look->SetLineWidth(static_cast<float>(points(scene.picture, 0.25)));
  return result;
}

Ref<vtkActor> body_actor(vtkPolyData* surface) {
  const auto mapper = Ref<vtkPolyDataMapper>::New();
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  const auto result = Ref<vtkActor>::New();
  result->SetMapper(mapper);
  return result;
}

// Grey, shaded more than the sheet, since no bar explains its colour.
void add_bodies(const DrawnScene& scene, const ClothSurface& sheet, vtkRenderer* renderer) {
  if (sheet.bodies.faces == nullptr) return;
  const bool smooth = scene.picture.smooth;
  const auto faces =
      body_actor(smooth ? shaded(sheet.bodies.faces, kSharpDegrees).Get() : sheet.bodies.faces.Get());
  const auto edges = body_actor(sheet.bodies.edges);
  vtkProperty* look = faces->GetProperty();
  look->SetColor(0.78, 0.78, 0.78);
  smooth ? look->SetInterpolationToGouraud() : look->SetInterpolationToFlat();
  look->SetAmbient(0.45);
  look->SetDiffuse(0.55);
  look->SetSpecular(0);
  look->SetOpacity(scene.picture.bodies);
  renderer->AddActor(faces);
  edges->GetProperty()->SetColor(0.25, 0.25, 0.25);
  edges->GetProperty()->SetLighting(false);
  edges->GetProperty()->SetLineWidth(static_cast<float>(points(scene.picture, 0.25)));
  edges->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -1);
  renderer->AddActor(edges);
}

// Sets a parallel projection that places the bounds as the layout states, seen from outside the bounds.
void set_camera(vtkRenderer* renderer, const Bounds& bounds, const View& view, const ViewLayout& l,
                const Point& size) {
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

double widest_number(const DrawnScene& scene) {
  double all = 0;
  for (const auto& [value, text] : scene.bar.numbers)
    all = std::max(all, text_size(text, font_size(scene.picture))[0]);
  return all;
}

// Width of the column for the colour bar: the bar with its widest label, or its title, within limits.
double bar_width(const DrawnScene& scene) {
  if (!scene.table) return 0;
  const int letter = font_size(scene.picture);
  const double title = text_size(scene.picture.bar, letter)[0];
  return std::min(0.4 * scene.picture.width,
                  std::max(4.2 * letter + widest_number(scene), 1.2 * letter + title));
}

// Writes a text and adds a warning if it had to be shortened.
void write_words(DrawnScene& scene, vtkRenderer* renderer, const std::string& text, int size,
                 const Point& centre, double room) {
  if (!write_fitted(renderer, text, size, centre, room))
    scene.complaints.push_back("'" + text +
                               "' is cut off, for which a wider picture or shorter words have room");
}

void add_bar(DrawnScene& scene) {
  const int letter = font_size(scene.picture);
  const double width = bar_width(scene), top = (1 - title_part(scene.picture)) * scene.picture.height,
               line = points(scene.picture, 0.5);
  const double high = top - 3 * letter, low = std::max(1.2 * letter, high - 26.0 * letter), left = letter,
               right = 2.3 * letter;
  const auto renderer = viewport(scene, 1 - width / scene.picture.width, 0, 1, 1 - title_part(scene.picture));
  add_colours(renderer, scene.table, {left, low}, {right, high});
  for (const auto& [from, to] : {std::pair{Point{left, low}, Point{right, low}},
                                 {Point{right, low}, Point{right, high}},
                                 {Point{right, high}, Point{left, high}},
                                 {Point{left, high}, Point{left, low}}})
    add_line(renderer, from, to, line);
  for (const auto& [value, text] : scene.bar.numbers) {
    const double y = low + (value - scene.bar.low) / (scene.bar.high - scene.bar.low) * (high - low);
    add_line(renderer, {right, y}, {right + 0.35 * letter, y}, line);
    write(renderer, text, letter, {right + 0.7 * letter + text_size(text, letter)[0] / 2, y});
  }
  write_words(scene, renderer, scene.picture.bar, letter, {width / 2, top - 1.3 * letter},
              width - 0.6 * letter);
}

struct Viewport {
  double x0, y0, x1, y1;  // fractions of the picture
};

// The place of panel i.
Viewport panel_place(const DrawnScene& scene, std::size_t number) {
  const int i = static_cast<int>(number), n = static_cast<int>(scene.sheets.size());
  const int columns = scene.picture.columns > 0 ? std::min(scene.picture.columns, n)
                      : n <= 3                  ? n
                                                : (n + 1) / 2;
  const int rows = (n + columns - 1) / columns, row = i / columns, column = i % columns;
  const double right = 1 - bar_width(scene) / scene.picture.width, top = 1 - title_part(scene.picture);
  return {right * column / columns, top * (rows - 1 - row) / rows, right * (column + 1) / columns,
          top * (rows - row) / rows};
}

Point panel_size(const DrawnScene& scene, std::size_t i) {
  const Viewport place = panel_place(scene, i);
  return {(place.x1 - place.x0) * scene.picture.width, (place.y1 - place.y0) * scene.picture.height};
}

// Space for labels, the same in all panels.
double above_panels(const Picture& p) {
  const bool labelled = std::any_of(p.panels.begin(), p.panels.end(),
                                    [](const plot::PicturePanel& panel) { return !panel.label.empty(); });
  return labelled ? 2 * font_size(p) : 0;
}

View view_of(const plot::PicturePanel& panel) { return view_from(panel.azimuth, panel.elevation); }

ViewLayout panel_layout(const DrawnScene& scene, std::size_t i, const Bounds& bounds) {
  const Picture& p = scene.picture;
  const int letter = font_size(p);
  const Point size = panel_size(scene, i);
  std::map<std::string, Point> known;
  const auto measure = [&](const std::string& text) {
    const auto [found, fresh] = known.try_emplace(text);
    if (fresh) found->second = text_size(text, letter);
    return found->second;
  };
  return layout(bounds, view_of(p.panels[i]), p.axes ? scene.unit : "",
                {size[0], size[1] - above_panels(p), double(letter), measure, scene.most});
}

void add_panel(DrawnScene& scene, std::size_t i, const Bounds& bounds) {
  const Picture& p = scene.picture;
  const plot::PicturePanel& panel = p.panels[i];
  const int letter = font_size(p);
  const Viewport place = panel_place(scene, i);
  const auto renderer = viewport(scene, place.x0, place.y0, place.x1, place.y1);
  const Point size = panel_size(scene, i);
  const ViewLayout l = panel_layout(scene, i, bounds);
  renderer->AddActor(actor(scene, scene.sheets[i], !from_above(panel)));
  add_bodies(scene, scene.sheets[i], renderer);
  set_camera(renderer, bounds, view_of(panel), l, size);
  for (const Segment& line : l.lines) add_line(renderer, line.from, line.to, points(p, 0.5));
  for (const Word& word : l.words) write(renderer, word.text, letter, word.centre);
  if (!panel.label.empty())
    write_words(scene, renderer, panel.label, letter, {size[0] / 2, size[1] - above_panels(p) / 2},
                size[0] - letter);
}

// The width in pixels that one panel needs at the height that it has: that of the thing, and room for the
// axes and the bar. Several panels share the width that was asked for.
int fitting_width(const DrawnScene& scene) {
  const Picture& p = scene.picture;
  if (!p.fit || scene.sheets.size() != 1) return p.width;
  const Bounds b = common(scene.sheets);
  const View view = view_of(p.panels[0]);
  double across = 0, up = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    across += std::abs(view.right[k]) * (b[2 * k + 1] - b[2 * k]);
    up += std::abs(view.up[k]) * (b[2 * k + 1] - b[2 * k]);
  }
  if (!(up > 0)) return p.width;
  const double letters = (p.axes ? 16 : 4) + (p.array.empty() ? 0 : 12);
  const double wanted = 0.85 * p.height * across / up + letters * font_size(p);
  return std::clamp(static_cast<int>(wanted), std::min(p.width, p.height / 3), p.width);
}

// All panels have the same scale, so that they can be compared.
void add_panels(DrawnScene& scene) {
  Bounds bounds = common(scene.sheets);
  const bool metres = extent(bounds) >= 1.5;
  scene.unit = metres ? "m" : "mm";
  if (!metres)
    for (const ClothSurface& sheet : scene.sheets) scale(sheet, 1000);
  bounds = common(scene.sheets);
  double most = scene.most;
  for (std::size_t i = 0; i < scene.sheets.size(); ++i)
    most = std::min(most, panel_layout(scene, i, bounds).scale);
  scene.most = most;
  for (std::size_t i = 0; i < scene.sheets.size(); ++i) add_panel(scene, i, bounds);
}

void make_table(DrawnScene& scene) {
  if (scene.picture.array.empty()) return;
  double low = scene.picture.low, high = scene.picture.high;
  if (!scene.picture.fixed_range) {
    low = scene.sheets[0].low, high = scene.sheets[0].high;
    for (const ClothSurface& sheet : scene.sheets)
      low = std::min(low, sheet.low), high = std::max(high, sheet.high);
  }
  if (!(low <= high)) throw Error("render: the field '" + scene.picture.array + "' holds no finite value");
  if (std::abs(low) < 1e-9 * high) low = 0;  // only rounding error compared with the range
  // A constant field gets one colour and a bar around
  // its value, instead of a scale for rounding errors.
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest == 0) low = -1, high = 1;
  if (high - low < 1e-6 * largest) low -= 0.05 * largest, high += 0.05 * largest;
  const double letters = (1 - title_part(scene.picture)) * scene.picture.height / font_size(scene.picture);
  scene.bar =
      round_bar(low, high, scene.picture.fixed_range, std::clamp(static_cast<int>(letters / 4), 2, 6));
  scene.table = colours(scene.bar.low, scene.bar.high);
}

void save(DrawnScene& scene) {
  const auto image = Ref<vtkWindowToImageFilter>::New();
  image->SetInput(scene.window);
  image->ReadFrontBufferOff();
  image->Update();
  const auto writer = Ref<vtkPNGWriter>::New();
  writer->SetFileName(scene.picture.png.c_str());
  writer->SetCompressionLevel(9);
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0) throw Error("render: cannot write '" + scene.picture.png + "'");
}

}  // namespace

std::vector<std::string> draw(const Picture& asked) {
  if (asked.panels.empty()) throw Error("render: expected at least one file");
  Picture picture = asked;
  DrawnScene scene{picture};
  for (const plot::PicturePanel& panel : picture.panels) {
    scene.sheets.push_back(read_sheet(panel.vtu, picture));
    if (picture.smooth) make_smooth(scene.sheets.back());
  }
  picture.width = fitting_width(scene);
  make_table(scene);
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();  // edges of bodies lie on their faces
  scene.window->SetOffScreenRendering(1);
  scene.window->SetMultiSamples(8);
  scene.window->SetSize(picture.width, picture.height);
  viewport(scene, 0, 0, 1, 1);  // white background
  add_panels(scene);
  if (scene.table) add_bar(scene);
  if (!picture.title.empty())
    write_words(scene, viewport(scene, 0, 1 - title_part(picture), 1, 1), picture.title, font_size(picture),
                {picture.width / 2.0, title_part(picture) * picture.height / 2},
                picture.width - font_size(picture));
  scene.window->Render();
  save(scene);
  return scene.complaints;
}

}  // namespace fabricsh::render
