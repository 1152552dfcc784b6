// fabric.plot: figures from the curves of decks, tables and tests.
#include <algorithm>

#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

namespace {

const std::vector<Argument>& curve_rows() {
  static const std::vector<Argument> rows = {
      value_("x", table | text, "abscissas; with rows: the name of their field"),
      value_("y", table | text, "ordinates; a nan interrupts the curve; with rows: the name of their field"),
      value_("rows", table, "a list of tables, such as the curve of a virtual test").optional(),
      value_("label", text, "in the key").or_else(""),
      value_("style", text, "how it is drawn; points for what was measured")
          .one_of({"line", "dashed", "points", "line_points"})
          .or_else("line")};
  return rows;
}

plot::CurveStyle style_of(const std::string& word) {
  if (word == "dashed") return plot::CurveStyle::dashed;
  if (word == "points") return plot::CurveStyle::points;
  return word == "line" ? plot::CurveStyle::line : plot::CurveStyle::line_points;
}

// The field `name` of each row of the table on top of the stack.
std::vector<double> column(lua_State* L, const std::string& path, const std::string& name) {
  std::vector<double> out;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    const std::string place = path + "rows[" + std::to_string(i) + "]";
    if (lua_rawgeti(L, -1, i) != LUA_TTABLE)
      throw Error("field '" + place + "': expected a table, got " + describe(L, -1));
    lua_getfield(L, -1, name.c_str());
    if (lua_type(L, -1) != LUA_TNUMBER)
      throw Error("field '" + place + "." + name + "': expected a number, got " + describe(L, -1));
    out.push_back(lua_tonumber(L, -1));
    lua_pop(L, 2);
  }
  return out;
}

// A list of numbers; one that is not finite is a gap.
std::vector<double> listed(const Fields& f, const char* name) {
  lua_State* L = f.L();
  // At a second call a metamethod may return another value than the one that was checked.
  if (f.push(name) != LUA_TTABLE) f.refuse(name, "expected a list of numbers, got " + describe(L, -1));
  std::vector<double> out(lua_rawlen(L, -1));
  if (out.empty()) f.refuse(name, "expected a list of numbers, got an empty table");
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (lua_rawgeti(L, -1, static_cast<lua_Integer>(i + 1)) != LUA_TNUMBER)
      f.refuse(name,
               "expected a list of numbers, got " + describe(L, -1) + " at place " + std::to_string(i + 1));
    out[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return out;
}

std::vector<double> ordinates(const Fields& f, const std::string& path, const char* name) {
  if (!f.is(name, LUA_TSTRING)) return listed(f, name);
  if (!f.has("rows")) f.refuse(name, "expected a list of numbers; a name goes with rows");
  f.push("rows");
  auto out = column(f.L(), path, f.text(name));
  lua_pop(f.L(), 1);
  return out;
}

plot::Curve read_curve(lua_State* L, lua_Integer place) {
  const std::string path = "curves[" + std::to_string(place) + "]";
  if (!lua_istable(L, -1)) throw Error("field '" + path + "': expected a table, got " + describe(L, -1));
  const Fields f(L, -1, curve_rows(), path + ".");
  plot::Curve curve{f.text("label"), ordinates(f, path + ".", "x"), ordinates(f, path + ".", "y"),
                    style_of(f.text("style"))};
  if (curve.x.size() != curve.y.size())
    throw Error("field '" + path + "': expected x and y of one length, got " +
                std::to_string(curve.x.size()) + " and " + std::to_string(curve.y.size()));
  return curve;
}

// The size in SI of the unit in which an axis is labelled.
double unit_size(const Call& call, const std::string& field) {
  const std::string name = call.text(field);
  if (name.empty()) return 1;
  if (name == "%") return 0.01;
  lua_State* L = call.L();
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  lua_pushliteral(L, "units");
  lua_rawget(L, -2);
  want_table(L, -1, "fabric.units");
  std::vector<std::string> known{"%"};
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
    if (lua_type(L, -2) == LUA_TSTRING) known.emplace_back(lua_tostring(L, -2));
  lua_pushstring(L, name.c_str());
  const double size = lua_rawget(L, -2) == LUA_TNUMBER ? lua_tonumber(L, -1) : 0;
  lua_pop(L, 3);
  std::sort(known.begin(), known.end());
  if (size == 0) call.refuse(field, unknown("unit", name, known));
  return size;
}

// Scales the axis to its unit, and appends the unit to its label.
plot::Axis read_axis(const Call& call, const std::string& name, double unit) {
  plot::Axis axis{call.text(name + "label"), {}, {}, call.text("log").find(name) != std::string::npos};
  if (const std::string word = call.text(name + "unit"); !word.empty())
    axis.label += (axis.label.empty() ? "" : ", ") + word;
  if (!call.has(name + "range")) return axis;
  const auto range = call.numbers(name + "range");
  if (range.size() != 2 || !(range[0] < range[1]))
    call.refuse(name + "range", "expected {low, high} in SI, low below high");
  axis.low = range[0] / unit;
  axis.high = range[1] / unit;
  return axis;
}

plot::Figure read_figure(const Call& call) {
  lua_State* L = call.L();
  const double x = unit_size(call, "xunit"), y = unit_size(call, "yunit");
  plot::Figure figure{call.text("title"), read_axis(call, "x", x), read_axis(call, "y", y)};
  call.push("curves");
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    figure.curves.push_back(read_curve(L, i));
    lua_pop(L, 1);
    for (double& value : figure.curves.back().x) value /= x;
    for (double& value : figure.curves.back().y) value /= y;
  }
  lua_pop(L, 1);
  return figure;
}

// A missing gnuplot only gives a warning, because the results of the deck would otherwise be lost.
bool drawn(const Call& call, const plot::Figure& figure) {
  const std::string path = call.text("file");
  system::make_folder_for(path);
  try {
    plot::draw(path, figure);
    return true;
  } catch (const plot::NoGnuplot& missing) {
    const std::string words = "plot: no figure '" + path + "': " + missing.what();
    call.session().notices().once(words, "warning: " + words);
    return false;
  }
}

int plot(Call& call) {
  const plot::Figure figure = read_figure(call);
  if (call.session().options().check) return 0;
  if (call.has("file")) {
    lua_pushboolean(call.L(), drawn(call, figure));
    return 1;
  }
  const std::string letters = plot::drawn_in_letters(figure, call.count("columns"), call.count("lines"));
  lua_pushlstring(call.L(), letters.data(), letters.size());
  return 1;
}

std::vector<Entry> rows() {
  const Range letters{10, 400};
  const auto range = [](const char* name) {
    return Argument{name, numbers, "", everything, "{low, high} shown, in SI; default: all"}.optional();
  };
  return {
      {"fabric.plot",
       Style::fields,
       {value_("curves", table,
               "{ {x=, y=, label=, style=}, ... }: lists of numbers, a nan being a gap, or {rows=, x=\"E\", "
               "y=\"S\"} by the fields of a list of tables; style: line, dashed, points, line_points"),
        value_("file", text, "ends in .svg, .png or .pdf; none: drawn in letters").optional(),
        value_("title", text, "above the curves").or_else(""),
        value_("xlabel", text, "what x is").or_else(""), value_("ylabel", text, "what y is").or_else(""),
        value_("xunit", text, "of fabric.units, or %: x is SI and shown in it, behind the label").or_else(""),
        value_("yunit", text, "likewise").or_else(""), range("xrange"), range("yrange"),
        value_("log", text, "logarithmic axes").one_of({"", "x", "y", "xy"}).or_else(""),
        integer_("columns", letters, "width of a drawing in letters").or_else(79.0),
        integer_("lines", letters, "height of a drawing in letters").or_else(24.0)},
       "Draws curves (by gnuplot) into a file, or without one returns them as text, which the prompt shows. "
       "With a "
       "file it returns whether it was drawn: false, with a warning, where gnuplot is not installed.",
       "local fabric = require 'fabric'\nlocal ok, text = pcall(fabric.plot, { xlabel='time', xunit='ms', "
       "curves={ {x={0, 1}, y={0, 2}, label='a line'},\n  {rows={ {t=0, v=1}, {t=1, v=2} }, x='t', y='v', "
       "style='points'} } })\nassert((ok and text:find 'time, ms') or text:find 'gnuplot')",
       plot},
  };
}

}  // namespace

void bind_plot(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
