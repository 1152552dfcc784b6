// fabric.render: pictures of sheets, from .vtu files or from the present state of a run.
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>

#include "base/number.hpp"
#include "format/vtu.hpp"
#include "plot/picture.hpp"
#include "run/bodies.hpp"
#include "run/recovery.hpp"
#include "run/result_fields.hpp"
#include "run/vtk_frame.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"
#include "system/gate.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

namespace {

// Where a field is stored in the files of a:vtk, and how it is shown.
struct StoredField {
  std::string array, component;
  double factor = 1;
  std::string bar;
};

// The unit used in pictures in place of an SI unit, and the factor for it.
std::pair<std::string, double> picture_unit(const std::string& unit) {
  if (unit == "m") return {"mm", 1e3};
  if (unit == "Pa") return {"MPa", 1e-6};
  if (unit == "J/m^3") return {"MJ/m3", 1e-6};
  return {unit, 1};
}

StoredField shown_of(const std::string& name) {
  if (name == "none") return {};
  const run::FieldPart part = run::find_field(name);
  const auto [field, number] = std::pair(part.field, part.component);
  const auto [unit, factor] = picture_unit(field->unit);
  std::string title = number < 0 ? "|" + field->letter + "|" : name;
  std::replace(title.begin(), title.end(), '_', ' ');
  StoredField shown{part.array(), "", factor, unit.empty() ? title : title + ", " + unit};
  if (number >= 0 && field->size() > 1)
    shown.component = field->labels.empty() ? std::string(1, "xyz"[number]) : field->labels[number];
  return shown;
}

// Fields that can be shown: single numbers, and vectors by their length.
std::vector<std::string> field_words() {
  std::vector<std::string> words = {"none"};
  for (const auto& field : run::result_fields()) {
    if (!field.letter.empty()) words.push_back(field.name);
    words.insert(words.end(), field.components.begin(), field.components.end());
  }
  return words;
}

std::vector<std::string> word_list(const Call& call, const char* name) {
  return call.has(name) ? call.texts(name, "a list of texts") : std::vector<std::string>{};
}

struct NamedView {
  double azimuth = 0, elevation = 90;  // degrees
  std::string name = {};
};

const std::vector<std::string> view_words = {"above", "front", "side", "oblique"};

NamedView view_named(const std::string& word) {
  return {word == "side"      ? 90.0
          : word == "oblique" ? 30.0
                              : 0.0,
          word == "above"     ? 90.0
          : word == "oblique" ? 25.0
                              : 0.0,
          word};
}

NamedView view_at(const Call& call, const char* name, const std::vector<double>& angles) {
  if (angles.size() != 2 || std::abs(angles[1]) > 90)
    call.refuse(name, "expected {azimuth, elevation} in degrees, the elevation from -90 to 90");
  return {angles[0], angles[1],
          fabricsh::number(angles[0]) + ", " + fabricsh::number(angles[1]) + " degrees"};
}

// The view on top of the stack.
NamedView one_view(const Call& call) {
  lua_State* L = call.L();
  if (lua_type(L, -1) == LUA_TSTRING) {
    const std::string word = lua_tostring(L, -1);
    if (std::find(view_words.begin(), view_words.end(), word) == view_words.end())
      call.refuse("views", unknown("view", word, view_words));
    return view_named(word);
  }
  if (lua_type(L, -1) != LUA_TTABLE)
    call.refuse("views", "expected names of views or {azimuth, elevation}, got " + describe(L, -1));
  return view_at(call, "views", read_numbers(L, -1));
}

std::vector<NamedView> read_views(const Call& call) {
  if (call.has("view") && call.has("views")) call.refuse("views", "expected either view or views, got both");
  std::vector<NamedView> all;
  if (call.has("views")) {
    call.each("views", [&](lua_Integer) { all.push_back(one_view(call)); });
    if (all.empty()) call.refuse("views", "expected a list of views, got an empty table");
  } else {
    all.push_back(call.is("view", LUA_TTABLE) ? view_at(call, "view", call.numbers("view"))
                                              : view_named(call.text("view")));
  }
  return all;
}

// Size of a picture for paper, in pixels.
void read_size(const Call& call, plot::Picture& p) {
  if (!call.has("size")) {
    for (const char* name : {"dpi", "font_size"})
      if (call.has(name)) call.refuse(name, "goes with size, the width and height on paper");
    return;
  }
  for (const char* name : {"width", "height"})
    if (call.has(name)) call.refuse(name, "expected either size, on paper, or width and height in pixels");
  const auto size = call.numbers("size");
  if (size.size() != 2 || std::any_of(size.begin(), size.end(), [](double m) { return m < 0.02 || m > 1; }))
    call.refuse("size", "expected {width, height} in m, each from 0.02 to 1, such as {85*mm, 60*mm}");
  p.dpi = call.number("dpi"), p.font_size = call.number("font_size");
  p.width = static_cast<int>(std::lround(size[0] / 0.0254 * p.dpi));
  p.height = static_cast<int>(std::lround(size[1] / 0.0254 * p.dpi));
  if (std::max(p.width, p.height) > 8000 || std::min(p.width, p.height) < 100)
    call.refuse("size", "expected a picture of 100 to 8000 pixels either way, got " +
                            std::to_string(p.width) + " x " + std::to_string(p.height));
}

void read_range(const Call& call, plot::Picture& picture) {
  if (!call.has("range")) return;
  const std::vector<double> ends = call.numbers("range");
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    call.refuse("range", "expected {low, high} of the colour bar, low below high");
  picture.fixed_range = true;
  picture.low = ends[0], picture.high = ends[1];
}

plot::Picture read_picture(const Call& call) {
  plot::Picture p;
  p.png = call.text("file");
  if (std::filesystem::path(p.png).extension() != ".png")
    call.refuse("file", "expected a name that ends in .png");
  p.title = call.text("title");
  const StoredField shown = shown_of(call.text("field"));
  p.array = shown.array, p.component = shown.component, p.bar = shown.bar;
  p.factor = call.has("factor") ? call.number("factor") : shown.factor;
  if (call.has("bar")) p.bar = call.text("bar");
  read_range(call, p);
  if (call.has("columns")) p.columns = call.count("columns");
  p.width = call.count("width");
  p.height = call.count("height");
  read_size(call, p);
  p.fit = call.flag("fit");
  if (call.text("bodies") == "clear") p.bodies = 0.25;
  p.edges = call.flag("edges"), p.axes = call.flag("axes"), p.smooth = call.flag("smooth");
  return p;
}

// A file in a private folder with an unpredictable name, removed with the object. Other users
// can write to the folder of temporary files, and a link planted there would be written
// through.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::error_code trouble;
    path_ = (std::filesystem::temp_directory_path(trouble) / "fabricsh-XXXXXX").string();
    if (!trouble && mkdtemp(path_.data()) == nullptr) trouble = {errno, std::generic_category()};
    if (trouble)
      throw Error("render: no folder for a temporary file (TMPDIR, or /tmp): " + trouble.message());
  }
  ~PrivateFolder() {
    const system::Gate& gate = system::Gate::of_process();
    gate.discard(file());
    try {
      gate.remove(path_);
    } catch (const std::exception&) {  // the folder remains, empty
    }
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  std::string file() const { return path_ + "/frame.vtu"; }

 private:
  std::string path_;
};

// Adds the rigid bodies, and for each cell 0 or the number of its body. Bodies have no field values.
format::Array add_bodies(const run::Run& run, std::vector<Vec3>& points,
                         std::vector<std::array<mesh::Index, 4>>& cells) {
  format::Array numbers{"rigid_body", 1, std::vector<double>(cells.size(), 0)};
  for (const run::BodyShown& body : run::shown_bodies(run)) {
    const auto first = static_cast<mesh::Index>(points.size());
    points.insert(points.end(), body.vertices.begin(), body.vertices.end());
    for (const auto& t : body.triangles) cells.push_back({first + t[0], first + t[1], first + t[2], -1});
    numbers.values.resize(cells.size(), numbers.values.empty() ? 1 : numbers.values.back() + 1);
  }
  return numbers;
}

// A file with the state of a run, removed with the object.
class StateFile {
 public:
  StateFile(const DeckRun& run, const std::string& shown, bool with_bodies, bool smooth) {
    const auto& a = *run.analysis;
    const auto& mesh = a.model().mesh();
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      points.push_back(a.node(static_cast<mesh::Index>(i)).x);
    auto cells = mesh.elements;
    std::optional<format::Array> bodies;
    if (with_bodies) bodies = add_bodies(a, points, cells);
    format::VtuGrid grid{points, cells};
    if (bodies) grid.cell_data.push_back(std::move(*bodies));
    run::FieldPart part{nullptr, -1};
    if (shown != "none") part = run::find_field(a, shown);
    for (const auto& field : run::result_fields()) {
      const bool wanted = part.field == &field;
      if (!wanted && field.name != "displacement") continue;
      const bool of_nodes = field.place == run::FieldPlace::node;
      format::Array array = run::array_of(a, {&field, -1, wanted ? part.ply : ""});
      const auto put = [&](format::Array values, bool at_points) {
        // Bodies have no values.
        values.values.resize(
            (at_points ? points.size() : cells.size()) * static_cast<std::size_t>(values.components),
            std::numeric_limits<double>::quiet_NaN());
        (at_points ? grid.point_data : grid.cell_data).push_back(std::move(values));
      };
      if (smooth && !of_nodes && field.continuous) {
        format::Array recovered = array;
        recovered.values =
            run::Recovery(a).at_nodes(array.values, static_cast<std::size_t>(array.components));
        put(std::move(recovered), true);
      }
      put(std::move(array), of_nodes);
    }
    format::write_vtu(path(), grid, system::Sync::no);
  }
  std::string path() const { return folder_.file(); }

 private:
  PrivateFolder folder_;
};

// One panel for each view of each file; the views of a file are side by side.
void add_panels(const Call& call, const std::vector<std::string>& paths, plot::Picture& picture) {
  const std::vector<std::string> labels = word_list(call, "labels");
  const std::vector<NamedView> views = read_views(call);
  if (labels.size() > paths.size() * views.size())
    call.refuse("labels", call.has("views")
                              ? "expected no more labels than panels, one for each view of each file"
                              : "expected no more labels than files");
  for (const std::string& path : paths)
    for (const NamedView& view : views) {
      const std::size_t i = picture.panels.size();
      const std::string own = views.size() > 1 && labels.empty() ? view.name : "";
      picture.panels.push_back({path, i < labels.size() ? labels[i] : own, view.azimuth, view.elevation});
    }
  if (views.size() > 1 && paths.size() > 1 && picture.columns == 0)
    picture.columns = static_cast<int>(views.size());
}

// Drawing starts a program with a display of its own, which needs more rights than a deck under --safe has.
// This gives only a warning, so that the results of the deck are not lost.
int no_picture(Call& call) {
  const std::string words = "render: no picture '" + call.text("file") +
                            "': not available under --safe; draw from the .vtu files afterwards";
  call.session().notices().once(words, "warning: " + words);
  return push_value(call.L(), false);
}

// The run of the call, or the runs of a list.
std::vector<std::shared_ptr<DeckRun>> runs_of(const Call& call) {
  if (!call.has("run")) return {};
  if (auto one = call.object<DeckRun>("run")) return {std::move(one)};
  std::vector<std::shared_ptr<DeckRun>> runs;
  call.each("run", [&](lua_Integer i) {
    runs.push_back(to_object<DeckRun>(call.L(), -1));
    if (runs.back() == nullptr)
      call.refuse("run",
                  "expected an analysis at place " + std::to_string(i) + ", got " + describe(call.L(), -1));
    if (runs.back()->passes_over())
      call.refuse("run",
                  "a list of runs is not drawn in a part of the deck that a restart passes over: draw them "
                  "in a hook, or run the deck without --restart");
  });
  if (runs.empty()) call.refuse("run", "expected an analysis or a list of them, got an empty list");
  return runs;
}

int render(Call& call) {
  call.want_one_of("vtu", "run", "expected either vtu or run");
  plot::Picture picture = read_picture(call);
  const auto runs = runs_of(call);
  add_panels(call, call.has("run") ? std::vector<std::string>(runs.size()) : word_list(call, "vtu"), picture);
  if (call.session().options().check) return 0;
  if (system::Gate::of_process().closed()) return no_picture(call);
  std::deque<StateFile> frames;
  for (const auto& run : runs)
    frames.emplace_back(*run, call.text("field"), call.text("bodies") != "none", call.flag("smooth"));
  for (std::size_t i = 0; i < picture.panels.size() && !frames.empty(); ++i)
    picture.panels[i].vtu = frames[i * frames.size() / picture.panels.size()].path();
  system::make_folder_for(picture.png);
  const auto program = std::filesystem::path(program_path()).parent_path() / "fabricsh-render";
  for (const std::string& message : plot::render(picture, program.string())) {
    const std::string words = "render: picture '" + picture.png + "': " + message;
    call.session().notices().once(words, "warning: " + words);
  }
  return push_value(call.L(), true);
}

Argument many(std::string name, unsigned kinds, std::string sentence) {
  return value_(std::move(name), kinds, std::move(sentence)).optional();
}

std::vector<Argument> render_rows() {
  const Range pixels{100, 8000};
  return {
      value_("file", text, "to write; ends in .png"),
      many("vtu", text | table, "file of a:vtk, or a list of them: panels of one scale"),
      object_("run?", "analysis",
              "in place of files: the run as it stands, with its rigid bodies, or a list of runs", table),
      value_("field", text, "what the colours show").or_else("none").one_of(field_words()).owned(),
      value_("title", text, "on top").or_else(""),
      many("labels", text | table, "above the panels"),
      many("bar", text, "title of the colour bar; default: the field with its unit (MPa, mm)"),
      number_("factor?", "", everything, "the bar shows that much times the SI value; default: to the unit"),
      many("range", numbers, "{low, high} of the bar; default: those of all panels"),
      many("view", text | numbers,
           "above (from +z, y up), front (along +y), side (along -x), oblique, or {azimuth, elevation} in "
           "degrees")
          .or_else("above")
          .one_of(view_words),
      many("views", table,
           "{ 'front', 'side', 'above', 'oblique', {30, 25}, ... }: several views in one picture, in one "
           "scale"),
      integer_("columns?", from_one, "of panels"),
      integer_("width", pixels, "pixels").or_else(1200),
      integer_("height", pixels, "pixels").or_else(900),
      Argument{"size", numbers, "m", everything,
               "{width, height} on paper, in the place of pixels: {85*mm, 60*mm} for a column of a journal"}
          .optional(),
      number_("dpi", "", Range{50, 1200}, "with size: pixels per inch").or_else(300.0),
      number_("font_size", "points", Range{4, 40}, "with size: of all letters").or_else(7.0),
      flag_("smooth",
            "colours and shading that change evenly between the nodes; else each element has its own"),
      value_("edges", boolean, "of the elements").or_else(true),
      flag_("fit", "the picture is no wider than its one panel needs: for tall things"),
      value_("bodies", text,
             "rigid bodies of a run: clear lets the cloth behind them be seen, none leaves them out, and the "
             "picture is as large as the cloth")
          .or_else("shown")
          .one_of({"shown", "clear", "none"}),
      value_("axes", boolean, "with a scale, in mm (m from 1.5 m on)").or_else(true),
  };
}

}  // namespace

void bind_render(Session& session) {
  install(
      session,
      {{"fabric.render{}", render_rows(),
        "Draws deformed sheets with a field and its colour bar into a PNG, off-screen: on the virtual "
        "display Xvfb, or where that is not installed on the display of DISPLAY. Returns whether it was "
        "drawn: false, with a warning, under --safe.",
        "local name = os.tmpname()\n"
        "local test = fabric.lab.bias{ card=fabric.card 'blend', grips='clamped', unload=false, steps=4 }\n"
        "pcall(fabric.render, { file=name..'.png', run=test.analysis, field='E12', title='bias, 20 mm' })\n"
        "os.remove(name..'.png') os.remove(name)",
        render}});
}

}  // namespace fabricsh::script
