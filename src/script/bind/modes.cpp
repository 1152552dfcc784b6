// fabric.modes and fabric.buckling, and the shapes that they find.
#include "run/modes.hpp"

#include <cmath>
#include <numbers>

#include "format/pvd.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"

namespace fabricsh::script {

template <>
struct ClassName<const run::Shape> {
  static constexpr const char* name = "shape";
};

namespace {

using run::Shape;

// --- finding them

void say_all(const Call& call, const std::vector<std::string>& words) {
  for (const std::string& line : words) call.session().notices().say(line);
}

// Under --check nothing is computed, but the deck goes on with as many shapes as it has asked for.
std::shared_ptr<const Shape> no_shape(const model::Model& model) {
  const mesh::Mesh& mesh = model.mesh();
  return std::make_shared<const Shape>(
      Shape{model.mesh_pointer(), mesh.nodes, std::vector<Vec3>(mesh.nodes.size(), Vec3::Zero())});
}

template <class M>
run::Modes<M> unchecked(const model::Model& model, int count) {
  run::Modes<M> none;
  M one;
  one.shape = no_shape(model);
  none.modes.assign(static_cast<std::size_t>(count), one);
  return none;
}

// The components by place and by name.
void set_vector(lua_State* L, const char* name, const Vec3& v) {
  push_numbers(L, {v.x(), v.y(), v.z()});
  for (int i = 0; i < 3; ++i) put(L, std::string(1, "xyz"[i]).c_str(), v[i]);
  lua_setfield(L, -2, name);
}

void push_mode(lua_State* L, const run::VibrationMode& mode) {
  push_record(L, "frequency", mode.frequency, "growth", mode.growth, "own_mass", mode.own_mass);
  set_vector(L, "mass", mode.mass);
  set_vector(L, "participation", mode.participation);
}

void push_mode(lua_State* L, const run::BucklingMode& mode) { push_record(L, "factor", mode.factor); }

template <class M>
int push_modes(const Call& call, const run::Modes<M>& found) {
  lua_State* L = call.L();
  say_all(call, found.words);
  push_list(L, found.modes, [&](const auto& one) {
    push_mode(L, one);
    put(L, "shape", [&] { push_object(L, one.shape); });
  });
  return 1;
}

int find_modes(Call& call) {
  call.want_one_of("from", "model", "expected an analysis, or in its place model=");
  run::ModesWanted wanted;
  wanted.count = call.count("count");
  if (call.has("below")) wanted.below = call.number("below");
  wanted.all_below = wanted.below && !call.has("count");
  const auto from = call.object<DeckRun>("from");
  const auto model = from ? from->analysis->shared_model() : call.object<model::Model>("model");
  if (call.session().options().check) {
    auto modes = unchecked<run::VibrationMode>(*model, wanted.count);
    for (std::size_t i = 0; i < modes.modes.size(); ++i) {  // decks divide by these, and take them as bounds
      modes.modes[i].frequency = static_cast<double>(i + 1);
      modes.modes[i].own_mass = 1;
    }
    push_modes(call, modes);
    set_vector(call.L(), "mass", Vec3::Ones());
    return 1;
  }
  const ChangeRefused still_model(call.session(), model.get()), still_mesh(call.session(), &model->mesh());
  const auto found =
      from ? run::vibration_modes(*from->analysis, wanted) : run::vibration_modes(model, wanted);
  push_modes(call, found);
  set_vector(call.L(), "mass", found.mass);
  return 1;
}

int find_buckling(Call& call) {
  const auto from = call.object<DeckRun>("from");
  const int count = call.count("count");
  const auto model = from->analysis->shared_model();
  if (call.session().options().check) return push_modes(call, unchecked<run::BucklingMode>(*model, count));
  const ChangeRefused still_model(call.session(), model.get()), still_mesh(call.session(), &model->mesh());
  if (!call.has("load")) return push_modes(call, run::buckling_modes(*from->analysis, count));
  const auto load = call.object<model::Model>("load");
  const ChangeRefused still_load(call.session(), load.get());
  return push_modes(call, run::buckling_modes(*from->analysis, load, count));
}

// --- shapes

std::vector<double> shape_along(const Shape& shape, int axis) {
  std::vector<double> values;
  for (const Vec3& way : shape.way) values.push_back(way[axis]);
  return values;
}

template <int axis>
int shape_component(Call& call) {
  return push_numbers(call.L(), shape_along(*call.self<const Shape>(), axis));
}

// Of a model with tearable zones, the mesh as it was made; of several bodies, that of one.
mesh::Mesh displaced_by(const Shape& shape, double amplitude, const std::string& body) {
  const mesh::Mesh& all = *shape.mesh;
  const mesh::Mesh& uncut = all.uncut();
  std::vector<Vec3> moved = uncut.nodes;
  for (std::size_t n = 0; n < shape.way.size(); ++n) {
    const auto place = static_cast<std::size_t>(all.place_of(static_cast<mesh::Index>(n)));
    moved[place] = uncut.nodes[place] + amplitude * shape.way[n];
  }
  mesh::Mesh made = uncut;
  if (!body.empty()) {
    const auto part = std::find_if(uncut.parts.begin(), uncut.parts.end(),
                                   [&](const auto& one) { return one.name == body; });
    if (part == uncut.parts.end()) throw Error("mesh: field 'body': unknown body '" + body + "'");
    made = *part->mesh;
    const auto first = moved.begin() + part->first_node;
    moved = {first, first + static_cast<std::ptrdiff_t>(made.nodes.size())};
  }
  if (made.flat && made.warp.empty()) made.warp.assign(made.elements.size(), Vec3::UnitX());
  made.nodes = std::move(moved);
  made.flat = made.in_use = false;
  made.origin += " with a shape";
  return made;
}

int moved_mesh(Call& call) {
  std::string body;
  if (call.has("options")) {
    const Fields options = call.fields("options");
    if (options.has("body")) body = options.text("body");
  }
  return push_object(call.L(), std::make_shared<mesh::Mesh>(
                                   displaced_by(*call.self<const Shape>(), call.number("amplitude"), body)));
}

// One swing of the shape about its state, frame by frame.
void write_series(const Shape& shape, const std::string& stem, double amplitude, int frames) {
  format::PvdSeries series(stem);
  format::Array way{"shape", 3, {}, {"x", "y", "z"}};
  for (const Vec3& w : shape.way) way.values.insert(way.values.end(), {w.x(), w.y(), w.z()});
  for (int i = 0; i < frames; ++i) {
    const double phase = static_cast<double>(i) / frames;
    const double swing = frames == 1 ? amplitude : amplitude * std::sin(2 * std::numbers::pi * phase);
    std::vector<Vec3> points = shape.from;
    for (std::size_t n = 0; n < points.size(); ++n) points[n] += swing * shape.way[n];
    format::VtuGrid grid{points, shape.mesh->elements, {way}};
    grid.time = phase;
    series.frame(phase, grid);
  }
}

int write_swing(Call& call) {
  const auto shape = call.self<const Shape>();
  const Fields* options = &call;
  std::optional<Fields> given;
  if (call.has("options")) options = &given.emplace(call.fields("options"));
  double size = 0;
  for (const Vec3& x : shape->from) size = std::max(size, (x - shape->from.front()).norm());
  const double amplitude = given && given->has("amplitude") ? options->number("amplitude") : size / 10;
  const int frames = given && given->has("frames") ? options->count("frames") : 24;
  if (!call.session().options().check) {
    system::make_folder_for(call.text("stem"));
    write_series(*shape, call.text("stem"), amplitude, frames);
  }
  return call.itself();
}

std::string modes_sample() {
  return "local mesh = fabric.mesh.rectangle{ width=0.2, height=0.05, nx=8, ny=2 }\n"
         "local card = fabric.svk{ density=1000, thickness=1e-3, warp=5e6, weft=5e6, shear=2e6, poisson=0,\n"
         "  bending={ warp=4e-4, weft=4e-4, twist=2e-4 } }\n"
         "local m = fabric.model{ mesh=mesh, card=card, warp=0 }:fix('left', 'x y z rotation')\n"
         "m:force('right', { x=fabric.ramp(-1e-3, 1) })\n"
         "local a = fabric.static{ model=m, duration=1, step=1 }:solve()\n";
}

std::vector<Entry> modes_entries() {
  const std::string found = modes_sample() + "local shape = fabric.buckling{ from=a, count=1 }[1].shape\n";
  return {
      {"fabric.modes{}",
       {object_("from?", "analysis", "the state about which the cloth swings"),
        object_("model?", "model", "in its place: the cloth as it is at time 0, without stress"),
        integer_("count", Range{1, 400}, "how many, from the lowest on").or_else(10),
        number_("below?", "Hz", positive, "those below this frequency alone; without count all of them")},
       "Natural frequencies of small swings about a state: a list of { frequency= (Hz), mass= {x=, y=, z=} "
       "(kg, effective), growth= (1/s, above 0 where the state is unstable), shape=, own_mass= (kg, that of "
       "the shape), participation= {x=, y=, z=} (of the shape in a motion of the supports by 1) }. The "
       "list's mass= {x=, y=, z=} (kg) is all that can move.",
       modes_sample() +
           "local modes = fabric.modes{ from=a, count=3 }\n"
           "assert(#modes == 3 and modes[1].frequency < modes[2].frequency and modes[1].mass.z > 0.005)",
       find_modes},
      {"fabric.buckling{}",
       {object_("from", "analysis", "a state under the loads, well below the critical ones or near them"),
        object_("load?", "model",
                "the loads and motions that are multiplied, beyond those of the state, which stay as they "
                "are: model:copy() with more of them, as they are at the time of the state; without it all "
                "of the state's"),
        integer_("count", Range{1, 400}, "how many, from the lowest on").or_else(1)},
       "Factors of the loads of a state at which cloth buckles, ascending: a list of { factor=, shape= }.",
       modes_sample() + "local first = fabric.buckling{ from=a }[1]\n"
                        "assert(first.factor > 1.22 and first.factor < 1.25)",
       find_buckling},
      without_arguments("shape.x", "Displacements along x, m, one for each node; the longest is 1 m.",
                        found + "assert(math.abs(shape.x[1]) < 1e-9)", shape_component<0>),
      without_arguments("shape.y", "Displacements along y, m, one for each node; the longest is 1 m.",
                        found + "assert(math.abs(shape.y[1]) < 1e-9)", shape_component<1>),
      without_arguments("shape.z", "Displacements along z, m, one for each node; the longest is 1 m.",
                        found + "assert(math.abs(shape.z[9] - 1) < 0.01)", shape_component<2>),
      {"shape:mesh()",
       {number_("amplitude", "m", everything, "of its longest displacement"),
        fields_("options?", {value_("body?", text, "of several bodies this one alone")}, "which part")},
       "The mesh of the model moved by the shape, without stress: a next model that begins imperfect.",
       found + "local bent = shape:mesh(1e-4)\n"
               "assert(#bent.nodes == #mesh.nodes and math.abs(bent.nodes[9][3] - 1e-4) < 1e-6)\n"
               "fabric.model{ mesh=bent, card=card }",
       moved_mesh},
      {"shape:vtk()",
       {value_("stem", text, "path of the files without ending"),
        fields_("options?",
                {number_("amplitude?", "m", everything,
                         "of its longest displacement; default a tenth of the cloth's length"),
                 integer_("frames?", from_one, "of one swing; 1: where it is farthest; default 24")},
                "how far, and in how many frames")},
       "Writes one swing of the shape about its state as a series for ParaView and fabric.render.",
       found + "local stem = os.tmpname()\nshape:vtk(stem, { frames=1 })\nassert(io.open(stem..'.pvd'))\n"
               "os.remove(stem..'.pvd')\nos.remove(stem..'_00000.vtu')\nos.remove(stem)",
       write_swing}};
}

int shape_text(lua_State* L) {
  const auto shape = to_object<const Shape>(L, 1);
  lua_pushfstring(L, "<shape of %d nodes>", static_cast<int>(shape->way.size()));
  return 1;
}

}  // namespace

void bind_modes(Session& session) {
  install(session, modes_entries());
  set_meta(session, "shape", "__tostring", shape_text);
}

}  // namespace fabricsh::script
