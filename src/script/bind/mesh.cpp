// fabric.mesh.rectangle, sets, and reading nodes and elements.
#include "script/bind/mesh.hpp"

#include <cmath>

#include "base/number.hpp"
#include "geometry/box.hpp"
#include "mesh/generators.hpp"
#include "script/call/words.hpp"
#include "script/show/show.hpp"

namespace fabricsh::script {

using mesh::Index;
using mesh::Mesh;

namespace {

// The objects mesh.nodes and mesh.elements, views of the mesh.
struct NodeView {
  std::shared_ptr<Mesh> mesh;
};
struct ElementView {
  std::shared_ptr<Mesh> mesh;
};

}  // namespace

template <>
struct ClassName<NodeView> {
  static constexpr const char* name = "nodes";
};
template <>
struct ClassName<ElementView> {
  static constexpr const char* name = "elements";
};

namespace {

void push_vector(lua_State* L, const Vec3& v) { push_numbers(L, {v[0], v[1], v[2]}); }

Vec3 point_of(const Call& call, const char* name) {
  const auto numbers = call.numbers(name);
  if (numbers.size() < 2 || numbers.size() > 3)
    call.refuse(name, "expected {x, y} or {x, y, z}, got " + counted(numbers.size(), "number"));
  return {numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0};
}

Vec3 origin_of(const Call& call) {
  return call.numbers("origin").empty() ? Vec3::Zero() : point_of(call, "origin");
}

// The number of elements along an axis: given, or by the lines of nodes.
Index cells_of(const Call& call, const char* name, const std::vector<double>& lines) {
  if (lines.empty()) {
    if (!call.has(name)) call.refuse(name, "expected an integer of at least 1, or grading, got neither");
    return call.integer(name);
  }
  const Index cells = static_cast<Index>(lines.size()) - 1;
  if (call.has(name) && call.integer(name) != cells)
    call.refuse(name, "expected " + std::to_string(cells) + ", one less than the lines of grading, got " +
                          std::to_string(call.integer(name)));
  return cells;
}

// Lines of nodes where they are given, otherwise at equal distances.
std::vector<double> lines_of(std::vector<double> given, Index cells, double size) {
  for (Index i = 0; given.size() < static_cast<std::size_t>(cells) + 1; ++i)
    given.push_back(size * static_cast<double>(i) / static_cast<double>(cells));
  return given;
}

mesh::Grading grading_of(const Call& call) {
  if (!call.has("grading")) return {};
  const Fields given = call.fields("grading");
  mesh::Grading lines{given.numbers("x"), given.numbers("y")};
  if (lines.x.empty() && lines.y.empty()) call.refuse("grading", "expected x, y or both, got neither");
  return lines;
}

int rectangle(Call& call) {
  const double width = call.number("width"), height = call.number("height");
  const mesh::Grading lines = grading_of(call);
  const Index nx = cells_of(call, "nx", lines.x), ny = cells_of(call, "ny", lines.y);
  auto mesh =
      lines.x.empty() && lines.y.empty()
          ? mesh::rectangle(width, height, nx, ny, origin_of(call))
          : mesh::rectangle(width, height, {lines_of(lines.x, nx, width), lines_of(lines.y, ny, height)},
                            origin_of(call));
  if (call.flag("triangles")) mesh::split(mesh, nx);
  return push_object(call.L(), std::make_shared<Mesh>(std::move(mesh)));
}

// Calls f(x, y, z); leaves this number of results on the stack.
lua_State* call_with(const Function& f, const Vec3& x, int results) {
  lua_State* L = f.push();
  for (int i = 0; i < 3; ++i) lua_pushnumber(L, x[i]);
  lua_call(L, 3, results);
  return L;
}

void define_inside(Mesh& mesh, const std::string& name, const Function& inside) {
  mesh.define(name, [&inside](const Vec3& x) {
    lua_State* L = call_with(inside, x, 1);
    const bool in = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    return in;
  });
}

void define_listed(Mesh& mesh, const std::string& name, const std::vector<double>& numbers) {
  mesh::NodeSet ids;
  for (const double number : numbers) {
    if (!(number >= 1 && number <= static_cast<double>(mesh.nodes.size())) || number != std::floor(number))
      throw Error("argument 'nodes': expected node numbers from 1 to " + std::to_string(mesh.nodes.size()) +
                  ", got " + exact_number(number));
    ids.push_back(static_cast<Index>(number) - 1);
  }
  mesh.define(name, std::move(ids));
}

int set(Call& call) {
  const auto mesh = call.self<Mesh>();
  const std::string name = call.text("name");
  if (!call.has("nodes")) {
    return push_ids(call.L(), mesh->set(name));
  }
  const ChangeRefused still(call.session(), mesh.get());
  if (const Function inside = call.function("nodes"))
    define_inside(*mesh, name, inside);
  else
    define_listed(*mesh, name, call.numbers("nodes"));
  return call.itself();
}

int sets(Call& call) { return push_texts(call.L(), call.self<Mesh>()->set_names()); }

int elements_in(Call& call) {
  const auto mesh = call.self<Mesh>();
  return push_ids(call.L(), mesh->elements_in(mesh->set(call.text("set"))));
}

int map(Call& call) {
  const Function f = call.function("f");
  const ChangeRefused still(call.session(), call.self<Mesh>().get());
  call.self<Mesh>()->map([&f](const Vec3& x) {
    lua_State* L = call_with(f, x, 3);
    Vec3 y;
    for (int i = 0; i < 3; ++i) {
      if (lua_type(L, i - 3) != LUA_TNUMBER)
        throw Error("argument 'f': expected the function to return x, y, z in m, got " + describe(L, i - 3) +
                    " in place " + std::to_string(i + 1));
      y[i] = lua_tonumber(L, i - 3);
    }
    lua_pop(L, 3);
    return y;
  });
  return call.itself();
}

int slit(Call& call) {
  const auto mesh = call.self<Mesh>();
  std::array<std::string, 2> names;
  if (call.has("left")) names[0] = call.text("left");
  if (call.has("right")) names[1] = call.text("right");
  const mesh::CrackFaces crack_faces = mesh::slit(*mesh, point_of(call, "from"), point_of(call, "to"));
  if (!names[0].empty()) mesh->define(names[0], crack_faces.left);
  if (!names[1].empty()) mesh->define(names[1], crack_faces.right);
  return call.itself();
}

int hole(Call& call) {
  const auto mesh = call.self<Mesh>();
  const Function inside = call.function("inside");
  mesh::NodeSet rim;
  {
    const ChangeRefused still(call.session(), mesh.get());
    rim = mesh::hole(*mesh, [&inside](const Vec3& x) {
      lua_State* L = call_with(inside, x, 1);
      const bool in = lua_toboolean(L, -1) != 0;
      lua_pop(L, 1);
      return in;
    });
  }
  if (call.has("rim")) mesh->define(call.text("rim"), rim);
  return call.itself();
}

int nodes(Call& call) {
  return push_object(call.L(), std::make_shared<NodeView>(NodeView{call.self<Mesh>()}));
}

int elements(Call& call) {
  return push_object(call.L(), std::make_shared<ElementView>(ElementView{call.self<Mesh>()}));
}

int node_count(lua_State* L) { return push_value(L, to_object<NodeView>(L, 1)->mesh->nodes.size()); }

int element_count(lua_State* L) { return push_value(L, to_object<ElementView>(L, 1)->mesh->elements.size()); }

// The number at stack index 2 as an index from 0; -1 if it is not from 1 to count.
Index place_of(lua_State* L, std::size_t count) {
  const lua_Integer i = lua_tointeger(L, 2);
  return i >= 1 && i <= static_cast<lua_Integer>(count) ? i - 1 : -1;
}

int node_at(lua_State* L) {
  const auto& list = to_object<NodeView>(L, 1)->mesh->nodes;
  const Index i = place_of(L, list.size());
  if (i < 0) return 0;
  push_vector(L, list[static_cast<std::size_t>(i)]);
  return 1;
}

int element_at(lua_State* L) {
  const auto& list = to_object<ElementView>(L, 1)->mesh->elements;
  const Index i = place_of(L, list.size());
  if (i < 0) return 0;
  std::vector<Index> corners;
  for (const Index node : list[static_cast<std::size_t>(i)])
    if (node >= 0) corners.push_back(node);
  return push_ids(L, corners);
}

// mesh:elements("set") first reads mesh.elements and then calls that.
int call_elements(lua_State* L) {
  push_class(L, "mesh", nullptr);
  lua_getfield(L, -1, "methods");
  lua_getfield(L, -1, "elements");
  lua_replace(L, 1);
  lua_settop(L, lua_gettop(L) - 2);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// A size in the x-y plane is shown with two numbers, any other with three.
std::string size_text(const Vec3& size) {
  return size[2] == 0 ? lengths_text({size[0], size[1]}) : lengths_text({size[0], size[1], size[2]});
}

// For example "20x20" for a rectangle, "disk 4+2"; for a mesh from a file its elements and the file.
std::string mesh_words(const Mesh& mesh) {
  const BoundingBox box = box_of(mesh.nodes);
  const auto starts = [&mesh](const char* word) { return mesh.origin.rfind(word, 0) == 0; };
  std::string words = "<mesh " +
                      mesh.origin.substr(starts("rectangle ") ? 10
                                         : starts("file ")    ? 5
                                                              : 0) +
                      ", " + std::to_string(mesh.nodes.size()) + " nodes, ";
  if (!starts("file ")) return words + size_text(box.size()) + ">";
  words += std::to_string(mesh.elements.size()) + " elements, ";
  for (int i = 0; i < 3; ++i)
    words += std::string(i > 0 ? ", " : "") + "xyz"[i] + " " +
             (box.low[i] == box.high[i] ? lengths_text({box.low[i]})
                                        : lengths_text({box.low[i], box.high[i]}, " to "));
  return words + ">";
}

int mesh_text(lua_State* L) { return push_text(L, mesh_words(*to_object<Mesh>(L, 1))); }

int nodes_text(lua_State* L) {
  const Mesh& mesh = *to_object<NodeView>(L, 1)->mesh;
  const BoundingBox box = box_of(mesh.nodes);
  return push_text(L, "<" + std::to_string(mesh.nodes.size()) + " x 3 numbers, " +
                          lengths_text({box.low.minCoeff(), box.high.maxCoeff()}, " to ") + ">");
}

int elements_text(lua_State* L) {
  const Mesh& mesh = *to_object<ElementView>(L, 1)->mesh;
  return push_text(L, "<" + std::to_string(mesh.elements.size()) + " elements of node numbers 1 to " +
                          std::to_string(mesh.nodes.size()) + ">");
}

constexpr const char* sample_deck =
    "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=3, ny=9 }\n";

std::vector<Entry> mesh_entries() {
  const std::string with_mesh = sample_deck;
  const std::string ask = "are the lengths in m? (write 25.4*mm)";
  return {
      {"fabric.mesh.rectangle{}",
       {number_("width", "m", positive, "size along x").usually(1e-3, 20, ask),
        number_("height", "m", positive, "size along y").usually(1e-3, 20, ask),
        integer_("nx?", from_one, "elements along x; may be left out with grading.x"),
        integer_("ny?", from_one, "elements along y; may be left out with grading.y"),
        Argument{"origin", numbers, "m", everything, "corner of smallest x and y, {x, y} or {x, y, z}"}
            .optional(),
        fields_(
            "grading?",
            {Argument{"x", numbers, "m", everything,
                      "of the lines of nodes across x, from 0 to the width, ascending"}
                 .optional(),
             Argument{"y", numbers, "m", everything, "of those across y, from 0 to the height"}.optional()},
            "positions of the lines of nodes, from the origin corner; without: at equal distances"),
        flag_("triangles", "cut every cell into two triangles, the cuts turning from cell to cell")},
       "A structured rectangle in the x-y plane, normal +z, nodes and elements row by row from the origin "
       "corner; sets left, right, bottom, top, boundary, corners, all.",
       with_mesh + "assert(#mesh.nodes == 40 and #mesh.elements == 27)",
       rectangle},
      {"mesh:set()",
       {value_("name", text, "of the set"),
        Argument{"nodes", numbers | function, "", everything,
                 "node numbers, or function(x, y, z) that says whether a node is inside"}
            .optional()},
       "Makes or replaces a named set of nodes; with the name alone gives its node numbers.",
       with_mesh + "mesh:set('middle', function(x, y, z) return math.abs(y - 0.0381) < 0.01 end)\n"
                   "assert(#mesh:set 'middle' == 8)",
       set},
      {"mesh:elements()",
       {value_("set", text, "name of a node set")},
       "Numbers of the elements all of whose nodes are in the set.",
       with_mesh + "assert(#mesh:elements 'all' == 27)",
       elements_in},
      {"mesh:map()",
       {value_("f", function, "function(x, y, z) that returns the new x, y, z")},
       "Moves every node; on an error none is moved.",
       with_mesh + "mesh:map(function(x, y, z) return x, y, 0.001*y end)\nassert(mesh.nodes[40][3] > 0)",
       map},
      {"mesh:slit{}",
       {Argument{"from", numbers, "m", everything, "{x, y} or {x, y, z}: a node, where the slit begins"},
        Argument{"to", numbers, "m", everything, "where it ends"},
        value_("left?", text,
               "name of a set to make of the nodes of its left side, seen on the way against the normal"),
        value_("right?", text, "the same of its right side")},
       "Slits the mesh along a straight line of edges between nodes: the nodes on it are doubled, but for an "
       "end inside the mesh, which is the tip. The left side keeps them, the new nodes follow all others and "
       "are in the same sets; boundary has the sides of the slit, too.",
       with_mesh + "mesh:slit{ from={0.0254/3, 0}, to={0.0254/3, 0.0254}, right='face' }\n"
                   "assert(#mesh.nodes == 43 and #mesh:set 'face' == 4)",
       slit},
      {"mesh:hole()",
       {value_("inside", function, "function(x, y, z) that says whether the middle of an element is inside"),
        value_("rim?", text, "name of a set to make of the nodes of its rim")},
       "Cuts a hole along the grid: leaves out the elements inside and the nodes that no element has any "
       "more. The others are numbered anew in their order; sets keep them, boundary has the rim, too.",
       with_mesh +
           "mesh:hole(function(x, y) return y > 0.02 and y < 0.025 and x > 0.01 and x < 0.015 end, 'rim')\n"
           "assert(#mesh.elements == 26 and #mesh:set 'rim' == 4)",
       hole},
      without_arguments(
          "mesh.nodes",
          "Reference positions {x, y, z}, m, by node number. Each is a copy: mesh:map() moves nodes.",
          with_mesh + "assert(mesh.nodes[4][1] == 0.0254)", nodes),
      without_arguments("mesh.elements", "Node numbers of each element, counter-clockwise.",
                        with_mesh + "assert(mesh.elements[1][3] == 6)", elements),
      without_arguments("mesh.sets",
                        "Names of the node sets. In the mesh of a model of several bodies also those of "
                        "each, as body.left.",
                        with_mesh + "assert(mesh.sets[1] == 'all')", sets),
  };
}

}  // namespace

void bind_mesh(Session& session) {
  install(session, mesh_entries());
  install(session, mesh_generator_rows());
  install(session, mesh_file_rows());
  install(session, panel_rows());
  set_meta(session, "mesh", "__tostring", mesh_text);
  set_meta(session, "nodes", "__tostring", nodes_text);
  set_meta(session, "elements", "__tostring", elements_text);
  set_meta(session, "nodes", "__len", node_count);
  set_meta(session, "nodes", "__index", node_at);
  set_meta(session, "elements", "__len", element_count);
  set_meta(session, "elements", "__index", element_at);
  set_meta(session, "elements", "__call", call_elements);
}

}  // namespace fabricsh::script
