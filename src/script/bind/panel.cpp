// fabric.mesh.panel and mesh:wrap: the reading of outlines, holes, darts and notches from a deck.
#include "mesh/panel.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "base/number.hpp"
#include "format/pattern.hpp"
#include "mesh/check.hpp"
#include "mesh/rim.hpp"
#include "script/bind/mesh.hpp"
#include "script/bind/model.hpp"
#include "script/call/boundary.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

using mesh::PlaneCurve;
using mesh::Vec2;

namespace {

// "outline[3]", "holes[1][2]": where in the deck's tables a value stands.
std::string inner(const std::string& path, lua_Integer place) {
  return path + "[" + std::to_string(place) + "]";
}

[[noreturn]] void refuse_at(const std::string& path, const std::string& why) {
  throw Error("field '" + path + "': " + why);
}

// Reads the point {x, y} at the top of the stack.
Vec2 read_point(lua_State* L, const std::string& path) {
  const std::string wanted = "expected a point {x, y}, m, got ";
  if (!lua_istable(L, -1)) refuse_at(path, wanted + describe(L, -1));
  if (const auto n = lua_rawlen(L, -1); n != 2) refuse_at(path, wanted + counted(n, "number"));
  Vec2 x;
  for (int i = 0; i < 2; ++i) {
    const bool good = lua_rawgeti(L, -1, i + 1) == LUA_TNUMBER && std::isfinite(lua_tonumber(L, -1));
    if (!good) refuse_at(path, wanted + describe(L, -1) + " at place " + std::to_string(i + 1));
    x[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return x;
}

Vec2 point_in(const Fields& given, const char* name, const std::string& path) {
  given.push(name);
  const Vec2 x = read_point(given.L(), path + name);
  lua_pop(given.L(), 1);
  return x;
}

// The points of a list in the field, at least `least` of them.
std::vector<Vec2> points_in(const Fields& given, const char* name, const std::string& path,
                            std::size_t least) {
  lua_State* L = given.L();
  std::vector<Vec2> points;
  given.push(name);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1))
    points.push_back(read_point(L, inner(path + name, i)));
  lua_pop(L, 2);
  if (points.size() < least)
    refuse_at(path + name,
              "expected at least " + counted(least, "point") + ", got " + std::to_string(points.size()));
  return points;
}

Argument point_(std::string name, std::string sentence) {
  return value_(std::move(name), table, "{x, y}, m: " + std::move(sentence));
}

std::vector<Argument> arc_rows() {
  return {point_("to", "its end"), point_("through?", "a point on the way"),
          point_("centre?", "of its circle"), flag_("clockwise", "with a centre: around it clockwise")};
}

std::vector<Argument> piece_rows() {
  return {value_("name?", text, "of the edge that the piece belongs to"),
          integer_("elements?", from_one, "along the piece"),
          fields_("arc?", arc_rows(), "an arc of a circle"),
          value_("spline?", table, "{ {x, y}, ... }: a smooth curve through these points to the last one"),
          value_("bezier?", table, "{ {x, y}, {x, y}, {x, y} }: two control points and the end"),
          point_("circle?", "centre of a whole circle, the only piece of its line"),
          number_("radius?", "m", positive, "of the circle")};
}

const std::vector<Argument>& known_piece() {
  static const std::vector<Argument> rows = piece_rows();
  return rows;
}

// One closed line while its pieces are read.
class LineReader {
 public:
  LineReader(lua_State* L, std::string path) : L_(L), path_(std::move(path)) {}

  // The table of pieces is at the top of the stack.
  mesh::Loop read() {
    if (!lua_istable(L_, -1)) refuse_at(path_, "expected a list of pieces, got " + describe(L_, -1));
    const int list = lua_gettop(L_);
    // A line of one piece, { circle={x, y}, radius= }, may be written without the list around it.
    const bool bare = lua_rawlen(L_, list) == 0;
    if (bare) lua_pushvalue(L_, list);
    for (lua_Integer i = 1; bare ? i == 1 : lua_rawgeti(L_, list, i) != LUA_TNIL; ++i) {
      if (done_) refuse_at(inner(path_, i), "expected nothing after the piece that closes the line");
      read_piece(bare ? path_ : inner(path_, i));
      lua_settop(L_, list);
    }
    lua_settop(L_, list);
    if (!done_) close();
    return std::move(loop_);
  }

 private:
  // The piece is at the top of the stack: {x, y, name=}, {arc=}, {spline=}, {bezier=}, {circle=} or {name=}.
  void read_piece(const std::string& path) {
    if (!lua_istable(L_, -1))
      refuse_at(path, "expected {x, y}, {arc=}, {spline=}, {bezier=}, {circle=} or {name=}, got " +
                          describe(L_, -1));
    const bool point = lua_rawlen(L_, -1) > 0;
    const int piece = lua_gettop(L_);
    Vec2 to = start_;
    if (point) to = read_point(L_, path);
    lua_newtable(L_);  // the named fields alone, which Fields checks
    for (lua_pushnil(L_); lua_next(L_, piece) != 0; lua_pop(L_, 1)) {
      if (lua_type(L_, -2) == LUA_TNUMBER && point) continue;
      lua_pushvalue(L_, -2);
      lua_pushvalue(L_, -2);
      lua_rawset(L_, -5);
    }
    const Fields given(L_, lua_gettop(L_), known_piece(), path + ".");
    int kinds = point ? 1 : 0;
    for (const char* kind : {"arc", "spline", "bezier", "circle"}) kinds += given.has(kind) ? 1 : 0;
    if (kinds > 1) refuse_at(path, "expected one piece, a point or one of arc, spline, bezier, circle");
    if (given.has("radius") != given.has("circle")) refuse_at(path, "expected circle and radius together");
    if (kinds == 0 && !given.has("name"))
      refuse_at(path, "expected {x, y}, {arc=}, {spline=}, {bezier=}, {circle=} or {name=}");
    add(given, path, point || kinds == 0, to);
  }

  void add(const Fields& given, const std::string& path, bool straight_to, const Vec2& to) {
    const bool circle = given.has("circle");
    if (!started_ && !circle) {
      if (!straight_to || given.has("elements") || given.has("name"))
        refuse_at(path,
                  "expected the line to start with a point {x, y}, and names with the pieces behind it");
      started_ = true;
      start_ = now_ = to;
      return;
    }
    if (started_ && circle) refuse_at(path, "expected a circle to be the only piece of its line");
    const PlaneCurve made = straight_to ? PlaneCurve::line(now_, to) : curve(given, path);
    loop_.push_back({made, given.text("name"), given.has("elements") ? given.integer("elements") : 0});
    now_ = made.end();
    done_ = circle || (straight_to && to == start_);
  }

  PlaneCurve arc(const Fields& given, const std::string& path) const {
    const std::string inside = path + ".arc.";
    const Fields arc = given.fields("arc");
    if (arc.has("through") == arc.has("centre"))
      refuse_at(path + ".arc", "expected either through={x, y} or centre={x, y}");
    const Vec2 to = point_in(arc, "to", inside);
    if (arc.has("through")) return PlaneCurve::arc_through(now_, point_in(arc, "through", inside), to);
    return PlaneCurve::arc_about(point_in(arc, "centre", inside), now_, to, arc.flag("clockwise"));
  }

  PlaneCurve curve(const Fields& given, const std::string& path) const {
    try {
      if (given.has("arc")) return arc(given, path);
      if (given.has("circle"))
        return PlaneCurve::circle(point_in(given, "circle", path + "."), given.number("radius"));
      const bool spline = given.has("spline");
      std::vector<Vec2> points{now_};
      const auto more = points_in(given, spline ? "spline" : "bezier", path + ".", spline ? 1 : 3);
      points.insert(points.end(), more.begin(), more.end());
      if (spline) return PlaneCurve::spline(points);
      if (more.size() != 3)
        refuse_at(path + ".bezier", "expected 3 points, got " + std::to_string(more.size()));
      return PlaneCurve::bezier(points);
    } catch (const Error& error) {
      const std::string words = error.what();
      if (words.starts_with("field ")) throw;
      refuse_at(path, words);
    }
  }

  // A line whose last piece does not end at its start is closed by a straight one; if the two are nearly at
  // one place, that place was probably meant.
  void close() {
    if (loop_.empty())
      refuse_at(path_, "expected at least three pieces, got " + std::to_string(started_ ? 1 : 0));
    double length = 0;
    for (const mesh::OutlinePiece& piece : loop_) length += piece.curve.length();
    const double gap = (now_ - start_).norm();
    if (gap <= 1e-9 * length) return;
    if (gap < 1e-2 * length)
      refuse_at(path_, "open: it ends at " + mesh::place_text(now_) + ", " + fabricsh::number(gap) +
                           " m from its start " + mesh::place_text(start_) +
                           " (end it there, or close it with {name='...'})");
    loop_.push_back({PlaneCurve::line(now_, start_)});
  }

  lua_State* L_;
  std::string path_;
  mesh::Loop loop_;
  bool started_ = false, done_ = false;
  Vec2 start_ = Vec2::Zero(), now_ = Vec2::Zero();
};

mesh::Loop read_line(lua_State* L, const std::string& path) { return LineReader(L, path).read(); }

// Calls read(path) for each entry of a list in the field, with the entry on top of the stack.
template <class Read>
void each_in(const Call& call, const char* name, const Read& read) {
  if (!call.has(name)) return;
  lua_State* L = call.L();
  call.push(name);
  const int list = lua_gettop(L);
  for (lua_Integer i = 1; lua_rawgeti(L, list, i) != LUA_TNIL; ++i, lua_settop(L, list)) {
    if (!lua_istable(L, -1)) refuse_at(inner(name, i), "expected a table, got " + describe(L, -1));
    read(inner(name, i));
  }
  lua_settop(L, list - 1);
}

std::vector<Argument> dart_rows() {
  return {value_("name?", text, "default dart1, dart2, ..."),
          point_("from", "on the outline, one end of its mouth"), point_("tip", "inside"),
          point_("to", "on the outline, the other end")};
}

mesh::Dart read_dart(lua_State* L, const std::string& path, std::size_t number) {
  static const std::vector<Argument> rows = dart_rows();
  const Fields given(L, lua_gettop(L), rows, path + ".");
  const auto x = [&](const char* name) { return point_in(given, name, path + "."); };
  return {given.has("name") ? given.text("name") : "dart" + std::to_string(number), x("from"), x("tip"),
          x("to")};
}

std::vector<Argument> notch_rows() {
  return {value_("name", text, "of its set"), value_("edge?", text, "on which it is"),
          number_("at?", "m", not_negative, "from the start of the edge as drawn"),
          number_("share?", "", Range{0, 1}, "of the length of the edge, from its start"),
          point_("point?", "on the outline or the edge")};
}

mesh::Notch read_notch(lua_State* L, const std::string& path) {
  static const std::vector<Argument> rows = notch_rows();
  const Fields given(L, lua_gettop(L), rows, path + ".");
  mesh::Notch notch{given.text("name"), given.text("edge")};
  if (given.has("at")) notch.at = given.number("at");
  if (given.has("share")) notch.share = given.number("share");
  if (given.has("point")) notch.point = point_in(given, "point", path + ".");
  return notch;
}

std::string quoted(const std::string& words) { return "'" + words + "'"; }

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

void add_once(std::vector<std::string>& words, const std::string& word) {
  if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
}

// 'FRONT' (sizes '38', '40'), 'BACK': every name once, with what cannot be read.
std::string names_of(const std::vector<format::PatternPiece>& pieces) {
  std::vector<std::string> names, words;
  for (const auto& piece : pieces) add_once(names, piece.name);
  for (const std::string& name : names) {
    std::vector<std::string> sizes;
    std::size_t all = 0, bad = 0;
    for (const auto& piece : pieces) {
      if (piece.name != name) continue;
      ++all;
      bad += piece.trouble.empty() ? 0 : 1;
      if (!piece.size.empty()) add_once(sizes, quoted(piece.size));
    }
    std::string one = quoted(name);
    if (sizes.size() > 1) one += " (sizes " + listed(sizes) + ")";
    if (bad == all) one += " (cannot be read)";
    words.push_back(one);
  }
  return listed(words);
}

// The piece of a file that the call names, by name or block and size; the only one if it names none.
format::PatternPiece choose(const Call& call, std::vector<format::PatternPiece> pieces) {
  using Piece = format::PatternPiece;
  const std::string list = names_of(pieces);
  std::vector<std::string> names;
  for (const Piece& piece : pieces) add_once(names, piece.name);
  if (!call.has("piece") && names.size() > 1)
    call.refuse("piece", "the file has " + counted(names.size(), "piece") + ": expected one of " + list);
  const auto keep = [&pieces](const auto& good) {
    std::vector<Piece> kept;
    for (Piece& piece : pieces)
      if (good(piece)) kept.push_back(piece);
    return kept;
  };
  if (call.has("piece")) {
    const std::string name = call.text("piece");
    auto kept = keep([&](const Piece& piece) { return piece.name == name; });
    if (kept.empty()) kept = keep([&](const Piece& piece) { return piece.block == name; });
    if (kept.empty()) call.refuse("piece", "expected one of " + list + ", got '" + name + "'");
    pieces = std::move(kept);
  }
  std::vector<std::string> sizes;
  for (const Piece& piece : pieces) add_once(sizes, piece.size.empty() ? "none" : quoted(piece.size));
  if (call.has("size_name")) {
    const std::string size = call.text("size_name");
    auto kept = keep([&](const Piece& piece) { return piece.size == size; });
    if (kept.empty())
      call.refuse("size_name", "piece '" + pieces.front().name + "': expected one of the sizes " +
                                   listed(sizes) + ", got '" + size + "'");
    pieces = std::move(kept);
  } else if (sizes.size() > 1) {
    call.refuse("size_name", "piece '" + pieces.front().name + "' is there in " +
                                 counted(sizes.size(), "size") + ": expected one of " + listed(sizes));
  }
  if (pieces.size() > 1) {
    std::vector<std::string> blocks;
    for (const Piece& piece : pieces) add_once(blocks, quoted(piece.block));
    call.refuse("piece", std::to_string(pieces.size()) + " pieces are called '" + pieces.front().name +
                             "': expected the name of a block, one of " + listed(blocks));
  }
  if (!pieces.front().trouble.empty()) throw Error(pieces.front().trouble);
  return std::move(pieces.front());
}

using Reader = std::vector<format::PatternPiece> (*)(const std::string&, std::optional<double>,
                                                     format::Remarks*);

Reader reader_of(const Call& call, const std::string& file) {
  std::string ending = file.size() < 4 ? "" : file.substr(file.size() - 4);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".dxf") return format::read_dxf_pattern;
  if (ending == ".svg") return format::read_svg_pattern;
  call.refuse("file", "expected a file that ends in .dxf or .svg, got '" + file + "'");
}

mesh::Panel read_file(const Call& call) {
  for (const char* field : {"outline", "holes"})
    if (call.has(field)) call.refuse(field, "expected either file= or an outline, got both");
  const std::string file = call.text("file");
  format::Remarks remarks;
  const auto unit = call.has("unit") ? std::optional(call.number("unit")) : std::nullopt;
  format::PatternPiece piece = choose(call, reader_of(call, file)(file, unit, &remarks));
  remarks.insert(remarks.end(), piece.remarks.begin(), piece.remarks.end());
  for (const std::string& remark : remarks) call.session().warn("pattern", remark);
  if (!piece.has_grain && !call.has("grain"))
    call.refuse("grain", "piece '" + piece.name + "' has no grain line: expected an angle in degrees");
  return std::move(piece.panel);
}

mesh::Panel read_outline(const Call& call) {
  for (const char* field : {"piece", "size_name", "unit"})
    if (call.has(field)) call.refuse(field, "expected with file= only");
  if (!call.has("outline")) call.refuse("outline", "expected either an outline or file=, got neither");
  mesh::Panel shape;
  call.push("outline");
  shape.outline = read_line(call.L(), "outline");
  lua_pop(call.L(), 1);
  each_in(call, "holes", [&](const std::string& path) { shape.holes.push_back(read_line(call.L(), path)); });
  return shape;
}

int panel(Call& call) {
  lua_State* L = call.L();
  mesh::Panel shape = call.has("file") ? read_file(call) : read_outline(call);
  each_in(call, "darts", [&](const std::string& path) {
    shape.darts.push_back(read_dart(L, path, shape.darts.size() + 1));
  });
  each_in(call, "notches", [&](const std::string& path) { shape.notches.push_back(read_notch(L, path)); });
  shape.size = call.number("size");
  if (call.has("grain")) shape.grain = call.number("grain");
  if (call.has("rows")) shape.rows = call.number("rows");
  shape.triangles = call.flag("triangles");
  if (call.has("quadrilaterals")) shape.quadrilaterals = call.flag("quadrilaterals");
  auto made = std::make_shared<mesh::Mesh>(mesh::panel(shape));
  if (const std::string doubt = mesh::doubt_about_units(*made); !doubt.empty()) {
    const std::string field = call.has("file") ? "file" : "outline";
    call.session().warn("units", position(L) + "panel: field '" + field + "': " + doubt + " (write 5*mm)");
  }
  return push_object(L, std::move(made));
}

Entry panel_row() {
  return {
      "fabric.mesh.panel{}",
      {value_("outline?", table,
              "{ {x, y}, {x, y, name=}, {arc=, name=}, {spline=, name=}, ... }: a start, then pieces, each "
              "from where the one before it ends"),
       value_("file?", text, "in place of an outline: a .dxf of a pattern program (AAMA/ASTM), or a .svg"),
       value_("piece?", text, "of the file, if it has several: its name or block"),
       value_("size_name?", text, "of the garment, if the file holds the piece in several: '38'"),
       number_("unit?", "m", positive, "of the file's lengths (fabric.units.mm), if it does not say"),
       number_("size", "m", positive, "of an element").usually(1e-4, 1, "is it in m? (write 5*mm)"),
       number_(
           "grain?", "degrees", everything,
           "direction of the warp, counter-clockwise from +x, default 0; wins over the grain line of a file"),
       value_("holes?", table, "{ line, ... }: closed lines like the outline"),
       value_("darts?", table, "{ {from=, tip=, to=, name=}, ... }: wedges cut from the outline"),
       value_("notches?", table, "{ {name=, edge=, at=|share=|point=}, ... }: places that get a node"),
       flag_("triangles", "equilateral ones, in place of squares"),
       value_("quadrilaterals?", boolean,
              "true: no element is a triangle, and each side has an even number of them; false: triangles "
              "along the outline where they fit; default: without, where rows oblique to the grain or more "
              "than 5 % of the area would have them, unless elements get much narrower or rows= is given"),
       number_("rows?", "degrees", everything,
               "direction of the rows of elements, counter-clockwise from +x; default: the grain, or "
               "straight sides oblique to it where that leaves less than half as many triangles")},
      "A panel from its outline, in the x-y plane, normal +z: rows of squares along the grain or along sides "
      "oblique to it, and a rim of quadrilaterals, and triangles unless these matter, whose border nodes lie "
      "on the outline. A "
      "piece is a straight line to {x, y}, {arc={to=, through=|centre=, clockwise=}}, {spline={ {x, y}, ... "
      "}}, {bezier={c, c, to}}, or {name=}, which closes the line; a line {circle={x, y}, radius=} is a "
      "circle; elements= of a piece sets their number. Named edges, the sides NAME_in and NAME_out of darts, "
      "and notches become sets; all and boundary as usual. Edges of a file are edge1, edge2, ..., its "
      "notches notch1, notch2, .... A model takes the warp from the grain.",
      "local mesh = fabric.mesh.panel{ size=0.01, grain=90,\n"
      "  outline={ {0, 0}, {0.2, 0, name='hem'}, {0.16, 0.3, name='right'},\n"
      "            {arc={through={0.1, 0.28}, to={0.04, 0.3}}, name='neck'}, {name='left'} },\n"
      "  notches={ {name='hip', edge='right', share=0.5} } }\n"
      "assert(#mesh:set 'hem' == 21 and #mesh:set 'hip' == 1 and mesh:check().ok)",
      panel};
}

std::vector<Argument> surface_rows(bool cone) {
  const auto direction = [](const char* name, const char* sentence) {
    return Argument{name, numbers, "", everything, std::string("{x, y, z}: ") + sentence}.optional();
  };
  std::vector<Argument> rows = {
      number_("radius", "m", positive, "at the point `at` of the panel"),
      direction("from", "the point of the axis beside it, m, default the origin"),
      direction("axis", "its direction, default {0, 0, 1}"),
      direction("towards", "where `at` lies as seen from the axis, default {1, 0, 0}"),
      Argument{"at", numbers, "m", everything, "{x, y}: a point in the plane of the panel, default {0, 0}"}
          .optional()};
  if (cone)
    rows.push_back(number_("angle", "degrees", Range{-90, 90, true, true},
                           "between axis and surface; positive: wider along the axis"));
  return rows;
}

mesh::Wrap read_surface(const Fields& given, const std::string& field) {
  mesh::Wrap shape{.radius = given.number("radius")};
  const auto read = [&](const char* name, Vec3& into) {
    if (given.has(name)) into = read_vector(given.numbers(name), "field '" + field + "." + name + "'");
  };
  read("from", shape.from);
  read("axis", shape.axis);
  read("towards", shape.towards);
  if (field == "cone") shape.angle = given.number("angle");
  if (!given.has("at")) return shape;
  const std::vector<double> at = given.numbers("at");
  if (at.size() != 2) given.refuse("at", "expected {x, y}, got " + counted(at.size(), "number"));
  shape.at = {at[0], at[1]};
  return shape;
}

int wrap(Call& call) {
  if (call.has("cylinder") == call.has("cone"))
    call.refuse("cylinder", "expected either a cylinder or a cone");
  const char* field = call.has("cone") ? "cone" : "cylinder";
  mesh::Wrap shape = read_surface(call.fields(field), field);
  shape.overlap = call.flag("overlap");
  mesh::wrap(*call.self<mesh::Mesh>(), shape);
  return call.itself();
}

Entry wrap_row() {
  return {
      "mesh:wrap{}",
      {fields_("cylinder?", surface_rows(false), "to go around"),
       fields_("cone?", surface_rows(true), "to go around"), flag_("overlap", "allow more than one turn")},
      "Lays a mesh in the x-y plane around a cylinder or a cone, with lengths, angles and areas kept and the "
      "normal outward: the point `at` comes to lie beside `from` at the distance radius, +y runs along the "
      "axis there, +x around it counter-clockwise. The warp of a panel goes along. Errors move no node.",
      "local mesh = fabric.mesh.panel{ outline={ {0, 0}, {0.3, 0}, {0.3, 0.2}, {0, 0.2} }, size=0.02 }\n"
      "mesh:wrap{ cylinder={ radius=0.05, at={0.15, 0} } }\n"
      "local x = mesh.nodes[1]\n"
      "assert(math.abs(x[1]^2 + x[2]^2 - 0.05^2) < 1e-15)",
      wrap};
}

}  // namespace

std::vector<Entry> panel_rows() { return {panel_row(), wrap_row()}; }

}  // namespace fabricsh::script
