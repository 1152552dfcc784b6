// fabric.mesh.read, mesh:write, mesh:check, mesh:orient.
#include "format/mesh_file.hpp"
#include "mesh/check.hpp"
#include "mesh/generators.hpp"
#include "model/outlook.hpp"
#include "script/bind/mesh.hpp"
#include "script/bind/model.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"
#include "system/gate.hpp"
#include "system/paths.hpp"

namespace fabricsh::script {

using mesh::Mesh;

namespace {

// A bare name that is not a file here refers to a mesh supplied with the program.
std::string file_of(const std::string& path) {
  const bool bare = path.find('/') == std::string::npos;
  if (!bare || system::Gate::of_process().exists(path)) return path;
  const std::string shipped = data_file("meshes/" + path);
  return shipped.empty() ? path : shipped;
}

double metres_of(const std::string& units) {
  return units == "inch" ? 0.0254 : units == "mm" ? 1e-3 : units == "cm" ? 0.01 : 1.0;
}

int read(Call& call) {
  const double unit = call.has("units") ? metres_of(call.text("units")) : 0;
  auto mesh =
      std::make_shared<Mesh>(read_mesh_file(call, file_of(call.text("file")), call.flag("reference"), unit));
  if (call.has("join") && call.flag("join")) mesh::join_nodes(*mesh);
  return push_object(call.L(), std::move(mesh));
}

int write_mesh(Call& call) {
  if (!call.session().options().check) {
    system::make_folder_for(call.text("file"));
    format::write_mesh(call.text("file"), *call.self<Mesh>());
  }
  return call.itself();
}

// Nodes, elements and sets of nodes as lines of a deck, for the writers of whole decks in lua/fabric/export.
// length: what a metre is in the deck, 1000 for mm; membrane: M3D4R and M3D3 in the place of S4 and S3;
// elements: name of the set of all elements.
int deck_lines(Call& call) {
  const std::string format = call.text("format");
  const format::DeckForm form{call.number("length"), call.flag("membrane"), call.text("elements")};
  const mesh::Mesh& mesh = *call.object<Mesh>("mesh");
  return push_text(call.L(), format == "inp" ? format::abaqus_lines(mesh, form)
                             : format == "k" ? format::dyna_lines(mesh, form)
                                             : format::radioss_lines(mesh, form));
}

void push_finding(lua_State* L, const mesh::Finding& item) {
  push_record(L, "key", item.key, "severity", name(item.severity), "text", item.text, "elements",
              item.elements, "nodes", item.nodes);
}

void set_measures(lua_State* L, const mesh::Measures& m) {
  put(L, "area", m.area, "shortest", m.shortest, "longest", m.longest, "aspect", m.aspect, "warping",
      m.warping, "least_angle", m.least_angle, "triangles", m.triangles, "quadrilaterals", m.quadrilaterals,
      "parts", m.parts, "borders", m.borders);
}

// A model of the mesh alone, for its outlook.
model::Model model_of(const Call& call) {
  model::Options options;
  if (call.has("warp")) {
    call.push("warp");
    model::Direction direction = lua_tonumber(call.L(), -1);
    if (lua_istable(call.L(), -1)) direction = read_vector(read_numbers(call.L(), -1), "check: field 'warp'");
    lua_pop(call.L(), 1);
    options.warp = [direction](const Vec3&) { return direction; };
  }
  return {call.self<Mesh>(), *call.object<card::Card>("card"), options};
}

void set_outlook(lua_State* L, const model::Outlook& o) {
  push_record(L, "degrees", o.yarns.degrees, "most", o.yarns.most, "stiffness", o.yarns.stiffness, "locking",
              o.yarns.locking, "across", o.yarns.across);
  lua_setfield(L, -2, "yarns");
  push_record(L, "length", o.folds.length, "flesh", o.folds.flesh, "element", o.folds.element);
  lua_setfield(L, -2, "folds");
}

// Pushes { {statement=, line=, count=}, ... }.
void push_passed_over(lua_State* L, const std::vector<Mesh::PassedOver>& all) {
  push_list(L, all, [&](const auto& one) {
    push_record(L, "statement", one.statement, "line", static_cast<double>(one.line), "count",
                static_cast<double>(one.count));
  });
}

int check_file(Call& call) {
  lua_State* L = call.L();
  const mesh::Report report = mesh::check(*call.self<Mesh>());
  std::string text = report.text();
  lua_newtable(L);
  if (call.has("card") && report.ok()) {
    const auto flesh = call.has("flesh") ? std::optional(call.number("flesh")) : std::nullopt;
    const model::Outlook outlook = model::outlook(model_of(call), flesh).front();
    for (const std::string& line : model::words(outlook)) text += (text.ends_with('\n') ? "" : "\n") + line;
    set_outlook(L, outlook);
  }
  put(L, "mesh", report.mesh, "text", text, "ok", report.ok());
  set_measures(L, report.measures);
  put(
      L, "items", [&] { push_list(L, report.items, [&](const auto& one) { push_finding(L, one); }); },
      "passed_over", [&] { push_passed_over(L, call.self<Mesh>()->passed_over); });
  set_text_of(L, "fabricsh.mesh_check", report_text);
  return 1;
}

int pair(Call& call) { return push_value(call.L(), mesh::pair_triangles(*call.self<Mesh>())); }

int refine(Call& call) {
  mesh::refine(*call.self<Mesh>());
  return 0;
}

int orient(Call& call) {
  Vec3 direction = Vec3::Zero();
  if (call.has("direction")) {
    const auto numbers = call.numbers("direction");
    if (numbers.size() != 3)
      call.refuse("direction", "expected {x, y, z}, got " + counted(numbers.size(), "number"));
    direction = {numbers[0], numbers[1], numbers[2]};
    if (direction.norm() == 0) call.refuse("direction", "expected a direction, got {0, 0, 0}");
  }
  return push_value(call.L(), mesh::orient(*call.self<Mesh>(), direction));
}

constexpr const char* disk_sample = "local mesh = fabric.mesh.disk{ radius=0.05, cells=4 }\n";

Entry read_row() {
  return {
      "fabric.mesh.read()",
      {value_("file", text,
              "ends in " + format::read_endings() + "; a bare name may be a mesh shipped with the program"),
       join_(),
       flag_("reference",
             "the same mesh in the stress-free shape that an .inp, a .k or a .rad has beside it, for "
             "reference= of a model"),
       value_("units?", text,
              "of the file's lengths; default m, with a warning where that would be odd; none for a .rad "
              "whose /BEGIN states them")
           .one_of({"m", "cm", "mm", "inch"})},
      "Reads a mesh of triangles and quadrilaterals; its lengths are m afterwards: Gmsh 2 and 4.1, VTK's "
      ".vtu and legacy .vtk, Wavefront .obj, .stl and .ply (text and binary; equal vertices of an .stl are "
      "joined), .inp of Abaqus and CalculiX, .k of LS-DYNA, .rad of OpenRadioss' starter. Physical groups "
      "and groups become node sets, sets of elements those of their nodes; so do integer arrays: those of 0 "
      "and 1 by their name, others as name_value; parts and solids where there are several. Nodes in no "
      "element are left out; the sets all and boundary are added. Also with named fields: fabric.mesh.read{ "
      "file=, join=true }.",
      "local mesh = fabric.mesh.read 'disc.msh'\n"
      "assert(#mesh:set 'centre' == 1 and mesh:check().ok)",
      read};
}

Entry write_row() {
  return {"mesh:write()",
          {value_("file", text, "ends in " + format::written_endings())},
          "Writes the mesh, lengths in m. With its sets: .vtu and .msh (Gmsh 4.1), which read back equal, "
          ".inp (Abaqus, CalculiX), .k (LS-DYNA), .rad (OpenRadioss). The surface alone: .obj, .ply, .stl. "
          "The old file stays until the new one is whole.",
          std::string(disk_sample) +
              "local file = os.tmpname()..'.vtu'\nmesh:write(file)\n"
              "assert(#fabric.mesh.read(file):set 'boundary' == 16)\nos.remove(file)",
          write_mesh};
}

Entry deck_lines_row() {
  return kernel("deck_lines()",
                {object_("mesh", "mesh", ""), value_("format", text, "").one_of({"inp", "k", "rad"}),
                 number_("length", "", positive, "").or_else(1.0), flag_("membrane", ""),
                 value_("elements", text, "").or_else("all")},
                deck_lines);
}

Entry check_row() {
  return {"mesh:check()",
          {object_("card?", "card", "of the cloth that the mesh is for"),
           Argument{"warp", number | numbers, "degrees", everything, "as for fabric.model"}.optional(),
           number_("flesh?", "Pa/m", positive, "stiffness of what the cloth lies on, as flesh")},
          "Errors of the mesh and remarks on it: a table {ok, text, items, area, shortest, longest, "
          "aspect, warping, least_angle, triangles, quadrilaterals, parts, borders}, which prints as its "
          "text; an item has key (degenerate, inverted, fold, repeated, orientation, one_sided, apart, "
          "unused, duplicate, nonmanifold, aspect, warping, angle, wide, taper, hanging, free), severity "
          "(note, warning, error), text, elements, nodes. With a card two lines more, and yarns (degrees "
          "from the sides of elements, most, stiffness over shear, locking: share of the cloth whose "
          "elements lock) and folds (length: from one to the next by weight, flesh: on flesh, element: its "
          "side, m).",
          std::string(disk_sample) +
              "local report = mesh:check()\nassert(report.ok and report.borders == 1)\n"
              "assert(tostring(report) == report.text)",
          check_file};
}

Entry pair_row() {
  return without_arguments(
      "mesh:pair",
      "Joins triangles in pairs to quadrilaterals where these have corners of 30 to 150 degrees and are "
      "flat; returns how many triangles are left. Stiff yarns that cross triangles obliquely lock them.",
      "local mesh = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=3, ny=2, triangles=true }\n"
      "assert(mesh:pair() == 0 and #mesh.elements == 6)",
      pair);
}

Entry refine_row() {
  return without_arguments(
      "mesh:refine",
      "Cuts every element from its middle to the middles of its sides into quadrilaterals, four of a "
      "quadrilateral and three of a triangle, so that no triangle is left, which stiff yarns would lock. New "
      "nodes lie on the sides: make a mesh of a curved outline fine enough before. Sets take them.",
      "local mesh = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=1, ny=1, triangles=true }\n"
      "mesh:refine()\n"
      "assert(#mesh.elements == 6 and #mesh:set 'left' == 3)",
      refine);
}

Entry orient_row() {
  return {
      "mesh:orient()",
      {Argument{"direction", numbers, "", everything,
                "{x, y, z}: the mean normal of each part points along it"}
           .optional()},
      "Turns elements around until neighbours agree on the normal, as few as that takes; returns how many.",
      std::string(disk_sample) + "assert(mesh:orient() == 0 and mesh:orient{0, 0, -1} == #mesh.elements)",
      orient};
}

// "*MATERIAL (3), *STEP": the first of them.
std::string list_of(const std::vector<Mesh::PassedOver>& all) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
    text += (i > 0 ? ", " : "") + all[i].statement +
            (all[i].count > 1 ? " (" + std::to_string(all[i].count) + ")" : "");
  return all.size() > most ? text + " and " + std::to_string(all.size() - most) + " more" : text;
}

}  // namespace

Mesh read_mesh_file(const Call& call, const std::string& path, bool at_rest, double unit) {
  if (unit > 0 && format::states_units(path))
    call.refuse("units", "expected none, since " + path + " states its own (/BEGIN), got '" +
                             call.text("units") + "'");
  format::Remarks remarks;
  Mesh mesh = at_rest ? format::read_mesh_at_rest(path, &remarks) : format::read_mesh(path, &remarks);
  if (unit > 0) {
    const std::string doubt = mesh::doubt_about_units(mesh);  // the deck has said what they are
    if (!doubt.empty())
      std::erase_if(remarks, [&](const std::string& r) { return r.find(doubt) != std::string::npos; });
    for (Vec3& x : mesh.nodes) x *= unit;
  }
  for (const std::string& remark : remarks) call.session().warn("mesh", remark);
  if (!mesh.passed_over.empty())
    call.session().notices().remark(path + ": only its mesh is read, not " + list_of(mesh.passed_over) +
                                    "; mesh:check().passed_over lists them with their lines");
  return mesh;
}

std::vector<Entry> mesh_file_rows() {
  return {read_row(), write_row(), deck_lines_row(), check_row(), pair_row(), refine_row(), orient_row()};
}

}  // namespace fabricsh::script
