// fabric.export.gltf: a series that a:vtk wrote, or the present state of a run, as a .glb for browsers and
// modellers.
#include "format/gltf.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "format/frame_file.hpp"
#include "format/source.hpp"
#include "plot/colour_scale.hpp"
#include "run/bodies.hpp"
#include "run/vtk_frame.hpp"
#include "script/bind/mesh.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

namespace {

using format::FrameArray;
using format::FrameFile;

// One time: the cloth first, then the bodies.
struct TimeFrame {
  double time = 0;
  std::vector<std::pair<std::string, FrameFile>> shapes;  // by name
  std::string file;                                       // of the cloth, for messages
};

struct Wanted {
  bool none = true;
  run::FieldPart part{nullptr, -1};
};

std::vector<std::string> gltf_fields() {
  std::vector<std::string> words = {"none"};
  for (const run::ResultField& field : run::result_fields()) {
    if (field.shape == run::FieldShape::vector) words.push_back(field.name);
    words.insert(words.end(), field.components.begin(), field.components.end());
  }
  return words;
}

Wanted wanted_field(const Call& call) {
  const std::string name = call.text("field");
  return name == "none" ? Wanted{} : Wanted{false, run::find_field(name)};
}

// Where the nodes are now, whichever way the file has them.
void deform(FrameFile& frame) {
  const FrameArray *X = frame.find("reference"), *u = frame.find("displacement");
  if (X == nullptr || u == nullptr || X->on_cells || u->on_cells || X->components != 3 || u->components != 3)
    return;
  for (std::size_t i = 0; i < frame.points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      frame.points[i][static_cast<Eigen::Index>(k)] = X->values[3 * i + k] + u->values[3 * i + k];
}

// "ball" of drape_ball_00012.vtu beside drape_00012.vtu.
std::string body_name(const std::string& file, const std::string& stem) {
  std::string name = std::filesystem::path(file).stem().string();
  if (name.starts_with(stem + "_")) name.erase(0, stem.size() + 1);
  if (const auto at = name.rfind('_'); at != name.npos) name.resize(at);
  return name;
}

std::vector<TimeFrame> read_series(const std::string& path, const Wanted& wanted, double every) {
  std::vector<std::string> arrays = {"reference", "displacement"};
  if (!wanted.none) arrays.push_back(wanted.part.array());
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string stem = std::filesystem::path(path).stem().string();
  const auto entries = format::read_pvd(path, format::read_file(path));
  const double last = entries.empty() ? 0 : entries.back().time;
  std::vector<TimeFrame> moments;
  bool taken = false;
  for (const format::SeriesEntry& entry : entries) {
    const bool fresh = moments.empty() || entry.time > moments.back().time;
    if (entry.part == 0) {
      const bool due =
          moments.empty() || entry.time >= moments.back().time + every * (1 - 1e-9) || entry.time >= last;
      taken = fresh && due;
      if (taken) moments.push_back({entry.time, {}, (folder / entry.file).string()});
    }
    if (!taken) continue;
    const std::string file = (folder / entry.file).string();
    FrameFile frame = format::read_vtu_frame(file, format::read_file(file), arrays);
    deform(frame);
    moments.back().shapes.emplace_back(entry.part == 0 ? "cloth" : body_name(entry.file, stem),
                                       std::move(frame));
  }
  if (moments.empty()) throw Error("gltf: '" + path + "' holds no frame");
  return moments;
}

std::vector<TimeFrame> moment_of(const run::Run& run, const Wanted& wanted) {
  run::VtkContents contents;
  contents.fields = {"displacement"};
  if (!wanted.none) contents.fields.push_back(wanted.part.array());
  const run::VtkFrame shown(run, contents);
  FrameFile cloth{shown.grid().points, shown.grid().cells, {}, {}};
  for (const bool on_cells : {false, true})
    for (const format::Array& a : on_cells ? shown.grid().cell_data : shown.grid().point_data) {
      if (a.flags) continue;
      cloth.arrays.push_back(
          {a.name, on_cells, static_cast<std::size_t>(a.components), a.component_names, a.values});
    }
  TimeFrame moment{run.time(), {{"cloth", std::move(cloth)}}, "the run"};
  for (const run::BodyShown& body : run::shown_bodies(run)) {
    FrameFile shape{body.vertices, {}, {}, {}};
    for (const auto& t : body.triangles) shape.cells.push_back({t[0], t[1], t[2], -1});
    moment.shapes.emplace_back(body.name, std::move(shape));
  }
  return {std::move(moment)};
}

// Place of the number among those of the array; -1: the length of the vector; -2: it has no such number.
int column_of(const FrameArray& array, const run::FieldPart& part) {
  const run::ResultField& field = *part.field;
  if (field.shape == run::FieldShape::vector) return array.components == 3 ? part.component : -2;
  if (field.shape == run::FieldShape::scalar) return array.components == 1 ? 0 : -2;
  const std::string& label = field.labels[static_cast<std::size_t>(part.component)];
  for (std::size_t c = 0; c < array.component_names.size(); ++c)
    if (array.component_names[c] == label) return static_cast<int>(c);
  return -2;
}

// Means of the cells that meet in a point, by their area as deformed.
std::vector<double> on_points(const FrameFile& frame, const std::vector<double>& of_cells) {
  std::vector<double> sum(frame.points.size(), 0.0), weight(frame.points.size(), 0.0);
  const auto at = [&frame](mesh::Index id) -> const Vec3& {
    return frame.points[static_cast<std::size_t>(id)];
  };
  for (std::size_t e = 0; e < frame.cells.size(); ++e) {
    const auto& c = frame.cells[e];
    const Vec3 across = c[3] < 0 ? Vec3((at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0])))
                                 : Vec3((at(c[2]) - at(c[0])).cross(at(c[3]) - at(c[1])));
    for (const mesh::Index id : c) {
      if (id < 0) continue;
      sum[static_cast<std::size_t>(id)] += across.norm() * of_cells[e];
      weight[static_cast<std::size_t>(id)] += across.norm();
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= weight[i];  // of a point in no cell: not a number
  return sum;
}

std::vector<double> values_of(const TimeFrame& moment, const Wanted& wanted, const std::string& name) {
  const FrameFile& frame = moment.shapes.front().second;
  const FrameArray* array = frame.find(wanted.part.array());
  const int column = array == nullptr ? -2 : column_of(*array, wanted.part);
  if (column == -2)
    throw Error("gltf: " + moment.file + " has no field '" + name + "'; arrays:" + frame.names);
  std::vector<double> values;
  for (std::size_t i = 0; i < array->values.size(); i += array->components) {
    const double* v = &array->values[i];
    values.push_back(column >= 0 ? v[column] : std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  }
  return array->on_cells ? on_points(frame, values) : values;
}

struct ValueRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

// The colours of the cloth at all times, by one scale; where none is given, by all that there is.
ValueRange colour(const std::vector<TimeFrame>& moments, const Wanted& wanted, const Call& call,
                  format::GltfSurface& cloth) {
  std::vector<std::vector<double>> all;
  ValueRange range;
  for (const TimeFrame& moment : moments) all.push_back(values_of(moment, wanted, call.text("field")));
  for (const auto& values : all)
    for (const double v : values)
      if (std::isfinite(v)) range.low = std::min(range.low, v), range.high = std::max(range.high, v);
  if (call.has("range")) {
    const auto ends = call.numbers("range");
    range.low = ends[0], range.high = ends[1];
  }
  for (const auto& values : all) {
    auto& colours = cloth.colours.emplace_back();
    for (const double v : values) {
      const auto c = plot::light(plot::colour(v, range.low, range.high));
      colours.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    }
  }
  return range;
}

// Shapes that exist at all times, with the same cells.
std::vector<format::GltfSurface> surfaces_of(const std::vector<TimeFrame>& moments) {
  std::vector<format::GltfSurface> surfaces;
  for (const auto& [name, first] : moments.front().shapes) {
    format::GltfSurface surface{name, first.cells, {}};
    if (!surfaces.empty()) surface.plain = {0.35f, 0.38f, 0.42f};
    for (const TimeFrame& moment : moments) {
      const std::size_t i = surfaces.size();
      const bool same = i < moment.shapes.size() && moment.shapes[i].second.cells == first.cells &&
                        moment.shapes[i].second.points.size() == first.points.size();
      if (!same)
        throw Error("gltf: " + moment.file + ": expected '" + name + "' with the same elements as at first");
      surface.frames.push_back(moment.shapes[i].second.points);
    }
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

void check_arguments(const Call& call) {
  call.want_one_of("series", "run", "expected either series or run");
  if (std::filesystem::path(call.text("file")).extension() != ".glb")
    call.refuse("file", "expected a name that ends in .glb, got '" + call.text("file") + "'");
  if (call.has("range")) {
    const auto ends = call.numbers("range");
    if (ends.size() != 2 || !(ends[0] < ends[1]))
      call.refuse("range", "expected {low, high}, low below high");
    if (call.text("field") == "none") call.refuse("range", "expected a field, whose range it is");
  }
}

void set_times(const Call& call, const std::vector<TimeFrame>& moments, format::GltfScene& scene) {
  const double first = moments.front().time, whole = moments.back().time - first;
  const double slower = call.has("duration") && whole > 0 ? call.number("duration") / whole : 1;
  for (const TimeFrame& moment : moments) scene.times.push_back((moment.time - first) * slower);
}

int gltf(Call& call) {
  check_arguments(call);
  const Wanted wanted = wanted_field(call);
  const std::string file = call.text("file");
  if (call.session().options().check) return 0;
  const std::vector<TimeFrame> moments =
      call.has("run")
          ? moment_of(*call.object<DeckRun>("run")->analysis, wanted)
          : read_series(call.text("series"), wanted, call.has("every") ? call.number("every") : 0);
  format::GltfScene scene;
  scene.morph = call.has("shapes") ? call.text("shapes") == "morph" : wanted.none;
  scene.z_up = call.text("up") == "z";
  set_times(call, moments, scene);
  scene.surfaces = surfaces_of(moments);
  ValueRange range;
  if (!wanted.none) range = colour(moments, wanted, call, scene.surfaces.front());
  const std::string bytes = format::glb(scene);
  system::make_folder_for(file);
  system::write_file(file, bytes);
  lua_State* L = call.L();
  push_record(L, "file", file, "frames", moments.size(), "duration", scene.times.back(), "bytes",
              bytes.size());
  if (!wanted.none) put(L, "low", range.low, "high", range.high);
  return 1;
}

}  // namespace

void bind_gltf(Session& session) {
  const std::string sample = sample_run() + "local name = os.tmpname()\nos.remove(name)\n";
  install(
      session,
      {{"fabric.export.gltf{}",
        {value_("file", text, "to write; ends in .glb"),
         value_("series?", text, "a .pvd that a:vtk wrote: every frame of it"),
         object_("run?", "analysis", "in place of a series: the run as it stands"),
         value_("field", text,
                "what the colours show, on the nodes: a number of a field, or a vector's length")
             .or_else("none")
             .one_of(gltf_fields())
             .owned(),
         value_("range?", numbers, "{low, high} of the colours; default: those of all frames"),
         number_("every?", "s", positive, "at least between two frames; default: all that there are"),
         number_("duration?", "s", positive, "of the animation; default: that of the series"),
         value_("shapes?", text,
                "frames: a mesh for each frame, shown by turns, as every program can; morph: one mesh that "
                "moves straight from frame to frame, with colours that few programs move. Default: frames "
                "where there is a field, else morph")
             .one_of({"morph", "frames"}),
         value_("up", text, "the axis that points up").one_of({"z", "y"}).or_else("z")},
        "Writes a series as a binary glTF file for the web: the cloth, and what stands beside it, with an "
        "animation. Returns {file, frames, duration, bytes, low, high}; low and high are those of the "
        "colours, which are as in pictures.",
        sample +
            "a:vtk(name..'/pull')\na:solve()\n"
            "local r = fabric.export.gltf{ series=name..'/pull.pvd', file=name..'/pull.glb', field='S11' }\n"
            "assert(r.frames == 5 and r.high > 0)\nfor i = 0, 4 do "
            "os.remove(name..('/pull_%05d.vtu'):format(i)) end\n"
            "for _, e in ipairs{ 'pull.pvd', 'pull.glb', 'run.json' } do os.remove(name..'/'..e) "
            "end\nos.remove(name)",
        gltf}});
}

}  // namespace fabricsh::script
