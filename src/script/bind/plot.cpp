// fabric.plot: figures from the curves of decks, tables and tests.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/number.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "plot/visible.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

namespace {

constexpr const char* curve_list =
    "{ {x=, y=, label=, style=}, ... }: lists of numbers, a nan being a gap, or {rows=, x=\"E\", y=\"S\"} by "
    "the fields of a list of tables; style: line, dashed, points, line_points; error=, xerror=, band={low=, "
    "high=}, colour=";

const std::vector<Argument>& drawn_rows() {
  static const std::vector<Argument> rows = {
      value_("x", table | text, "abscissas; with rows: the name of their field"),
      value_("y?", table | text,
             "ordinates; a nan interrupts the curve; with rows: the name of their field; left out: the band "
             "alone"),
      value_("rows?", table, "a list of tables, such as the curve of a virtual test, or a table of lists"),
      value_("label", text, "in the key").or_else(""),
      value_("style", text, "how it is drawn; points for what was measured")
          .one_of({"line", "dashed", "points", "line_points"})
          .or_else("line"),
      value_("error?", table | text | number,
             "{low=, high=} or half the length of error bars, of all or a list, in SI; with rows: names of "
             "fields"),
      value_("xerror?", table | text | number, "error bars along x, given like error"),
      value_("band?", table, "{low=, high=}: lists in SI, a shade between them; with rows: names of fields"),
      value_("colour?", text,
             "a name or \"#rrggbb\"; default: the next of those that colour-blind readers can distinguish")};
  return rows;
}

const std::vector<Argument>& ends_rows() {
  static const std::vector<Argument> rows = {value_("low", table | text, "lower ends"),
                                             value_("high", table | text, "upper ends")};
  return rows;
}

std::string colour_of(const Fields& f) {
  static const std::vector<std::pair<std::string, std::string>> names = {
      {"black", "#000000"},  {"blue", "#0072b2"},   {"green", "#009e73"}, {"grey", "#808080"},
      {"orange", "#e69f00"}, {"purple", "#cc79a7"}, {"sky", "#56b4e9"},   {"vermillion", "#d55e00"}};
  const std::string word = f.text("colour");
  if (word.empty()) return word;
  const bool hex = word.size() == 7 && word[0] == '#' &&
                   word.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (hex) return word;
  std::vector<std::string> known;
  for (const auto& [name, value] : names) {
    if (name == word) return value;
    known.push_back(name);
  }
  f.refuse("colour", "expected \"#rrggbb\" or a name; " + unknown("colour", word, known));
}

plot::CurveStyle style_of(const std::string& word) {
  if (word == "dashed") return plot::CurveStyle::dashed;
  if (word == "points") return plot::CurveStyle::points;
  return word == "line" ? plot::CurveStyle::line : plot::CurveStyle::line_points;
}

// The list of numbers on top of the stack. refuse: throws an error with what is there instead.
template <class Refuse>
std::vector<double> numbers_on_top(lua_State* L, const Refuse& refuse) {
  if (lua_type(L, -1) != LUA_TTABLE) refuse(describe(L, -1));
  std::vector<double> out(lua_rawlen(L, -1));
  if (out.empty()) refuse("an empty table");
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (lua_rawgeti(L, -1, static_cast<lua_Integer>(i + 1)) != LUA_TNUMBER)
      refuse(describe(L, -1) + " at place " + std::to_string(i + 1));
    out[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
  return out;
}

// The field `name` of each row of the table on top of the stack. The table may also be a test with a
// curve, or contain a list for each name.
std::vector<double> column(lua_State* L, const std::string& path, const std::string& name) {
  luaL_checkstack(L, 10, "rows");
  const int before = lua_gettop(L);
  const auto names_list = [&](int index) {
    lua_getfield(L, index, name.c_str());
    const bool list = lua_type(L, -1) == LUA_TTABLE;
    if (!list) lua_pop(L, 1);
    return list;
  };
  if (lua_rawlen(L, -1) == 0 && lua_getfield(L, -1, "curve") != LUA_TTABLE) lua_settop(L, before);
  if (lua_rawlen(L, -1) == 0 && names_list(lua_gettop(L))) {
    auto out = numbers_on_top(L, [&](const std::string& got) {
      throw Error("field '" + path + "rows." + name + "': expected a list of numbers, got " + got);
    });
    lua_settop(L, before);
    return out;
  }
  std::vector<double> out;
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  if (n == 0)
    throw Error("field '" + path + "rows': expected a list of tables with the field '" + name +
                "', or a table with a list of that name");
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
  lua_settop(L, before);
  return out;
}

// A list of numbers; one that is not finite is a gap.
std::vector<double> listed(const Fields& f, const char* name) {
  f.push(name);  // at a second call a metamethod may return another value than the one that was checked
  auto out = numbers_on_top(
      f.L(), [&](const std::string& got) { f.refuse(name, "expected a list of numbers, got " + got); });
  lua_pop(f.L(), 1);
  return out;
}

// The list of numbers `name` of the table `ends`, or a field of the rows of the curve.
std::vector<double> one_end(const Fields& curve, const std::string& path, const Fields& ends,
                            const char* name) {
  if (!ends.is(name, LUA_TSTRING)) return listed(ends, name);
  if (!curve.has("rows")) ends.refuse(name, "expected a list of numbers; a name goes with rows");
  curve.push("rows");
  auto out = column(curve.L(), path, ends.text(name));
  lua_pop(curve.L(), 1);
  return out;
}

std::vector<double> ordinates(const Fields& f, const std::string& path, const char* name) {
  return one_end(f, path, f, name);
}

// Ends given as {low=, high=}.
plot::Ends both_ends(const Fields& f, const std::string& path, const char* name) {
  f.push(name);
  const Fields ends(f.L(), -1, ends_rows(), path + name + ".");
  plot::Ends out{one_end(f, path, ends, "low"), one_end(f, path, ends, "high")};
  lua_pop(f.L(), 1);
  return out;
}

bool has_field(const Fields& f, const char* list, const char* name) {
  f.push(list);
  const bool found = push_raw(f.L(), -1, name) != LUA_TNIL;
  lua_pop(f.L(), 2);
  return found;
}

// Error bars about `y`, given by their ends or by half their length.
plot::Ends error_of(const Fields& f, const std::string& path, const char* name,
                    const std::vector<double>& y) {
  if (!f.has(name)) return {};
  const bool list = f.is(name, LUA_TTABLE);
  if (list && (has_field(f, name, "low") || has_field(f, name, "high"))) return both_ends(f, path, name);
  std::vector<double> half =
      f.is(name, LUA_TNUMBER) ? std::vector<double>(y.size(), f.number(name)) : ordinates(f, path, name);
  if (half.size() != y.size())
    f.refuse(name, "expected as many as there are points, got " + std::to_string(half.size()) + " for " +
                       std::to_string(y.size()));
  plot::Ends out;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (half[i] < 0)
      f.refuse(name, "expected lengths of at least 0, got " + fabricsh::number(half[i]) + " at place " +
                         std::to_string(i + 1));
    out.low.push_back(y[i] - half[i]), out.high.push_back(y[i] + half[i]);
  }
  return out;
}

plot::PlottedCurve read_curve(lua_State* L, const std::string& path) {
  if (!lua_istable(L, -1)) throw Error("field '" + path + "': expected a table, got " + describe(L, -1));
  const Fields f(L, -1, drawn_rows(), path + ".");
  const bool band = f.has("band");
  if (!band && !f.has("y"))
    f.refuse("y", "expected a table or a string, got nil (missing, or a misspelt variable)");
  plot::PlottedCurve curve{f.text("label"), ordinates(f, path + ".", "x"),
                           f.has("y") ? ordinates(f, path + ".", "y") : std::vector<double>{},
                           style_of(f.text("style"))};
  if (f.has("y") && curve.x.size() != curve.y.size())
    throw Error("field '" + path + "': expected x and y of one length, got " +
                std::to_string(curve.x.size()) + " and " + std::to_string(curve.y.size()));
  if (band) curve.band = both_ends(f, path + ".", "band");
  curve.error = error_of(f, path + ".", "error", curve.y);
  if (f.has("xerror") && curve.y.empty()) f.refuse("xerror", "expected y beside it");
  curve.x_error = error_of(f, path + ".", "xerror", curve.x);
  for (const auto& [name, ends] : {std::pair{"band", &curve.band}, std::pair{"error", &curve.error},
                                   std::pair{"xerror", &curve.x_error}})
    if (!ends->empty() && (ends->low.size() != curve.x.size() || ends->high.size() != curve.x.size()))
      f.refuse(name, "expected as many ends as x, got " + std::to_string(ends->low.size()) + " and " +
                         std::to_string(ends->high.size()) + " for " + std::to_string(curve.x.size()));
  curve.colour = colour_of(f);
  return curve;
}

// The options of a panel: its own fields, and for missing ones the fields of the call.
class Asked {
 public:
  Asked(const Call& call, const Fields* panel) : call_(call), panel_(panel) {}
  const Fields& where(const std::string& name) const {
    return panel_ != nullptr && panel_->has(name) ? *panel_ : static_cast<const Fields&>(call_);
  }
  bool has(const std::string& name) const { return where(name).has(name); }
  std::string text(const std::string& name) const { return where(name).text(name); }

 private:
  const Call& call_;
  const Fields* panel_;
};

// The size in SI of a unit: one of fabric.units, or a quotient such as N/mm, N/5cm or cN/tex. 0: none of
// them; `known` receives the names.
double size_of(lua_State* L, const std::string& name, std::vector<std::string>& known) {
  known = {"%"};
  lua_getfield(L, LUA_REGISTRYINDEX, "fabric");
  push_raw(L, -1, "units");
  want_table(L, -1, "fabric.units");
  for (const std::string& unit : keys_of(L, -1)) known.push_back(unit);
  const auto one = [&](const std::string& word) {
    const double size = push_raw(L, -1, word) == LUA_TNUMBER ? lua_tonumber(L, -1) : 0;
    lua_pop(L, 1);
    return size;
  };
  const std::size_t bar = name.find('/');
  double size = one(name.substr(0, bar));
  if (bar != std::string::npos) {
    const std::string below = name.substr(bar + 1);
    const std::size_t letters = std::min(below.find_first_not_of("0123456789."), below.size());
    const std::string digits = below.substr(0, letters);
    char* end = nullptr;
    const double count = letters == 0 ? 1 : std::strtod(digits.c_str(), &end);
    const bool whole = letters == 0 || end == digits.c_str() + digits.size();
    const double each = whole ? count * one(below.substr(letters)) : 0;
    size = each > 0 ? size / each : 0;
  }
  lua_pop(L, 2);
  std::sort(known.begin(), known.end());
  return size;
}

// The size in SI of the unit in which an axis is labelled.
double unit_size(const Asked& asked, const std::string& field) {
  const std::string name = asked.text(field);
  if (name.empty()) return 1;
  if (name == "%") return 0.01;
  std::vector<std::string> known;
  const double size = size_of(asked.where(field).L(), name, known);
  if (size == 0) asked.where(field).refuse(field, unknown("unit", name, known));
  return size;
}

// The names of the places 1, 2, ... along the upright axis.
std::vector<std::string> read_names(const Asked& asked) {
  if (!asked.has("ynames")) return {};
  const Fields& where = asked.where("ynames");
  lua_State* L = where.L();
  std::vector<std::string> names;
  where.push("ynames");
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    if (lua_type(L, -1) != LUA_TSTRING)
      where.refuse("ynames",
                   "expected a list of names, got " + describe(L, -1) + " at place " + std::to_string(i));
    names.emplace_back(lua_tostring(L, -1));
  }
  lua_pop(L, 2);
  if (names.empty()) where.refuse("ynames", "expected at least one name, got an empty table");
  if (!asked.text("yunit").empty() || asked.text("log").find('y') != std::string::npos)
    where.refuse("ynames", "expected neither yunit nor a logarithmic y beside it");
  return names;
}

// Scales the axis to its unit, and appends the unit to its label.
plot::Axis read_axis(const Asked& asked, const std::string& name, double unit) {
  plot::Axis axis{asked.text(name + "label"), {}, {}, asked.text("log").find(name) != std::string::npos};
  if (const std::string word = asked.text(name + "unit"); !word.empty())
    axis.label += (axis.label.empty() ? "" : ", ") + word;
  if (!asked.has(name + "range")) return axis;
  const Fields& where = asked.where(name + "range");
  const auto range = where.numbers(name + "range");
  if (range.size() != 2 || !(range[0] < range[1]))
    where.refuse(name + "range", "expected {low, high} in SI, low below high");
  axis.low = range[0] / unit;
  axis.high = range[1] / unit;
  return axis;
}

const std::vector<std::pair<std::string, plot::Key>>& key_words() {
  static const std::vector<std::pair<std::string, plot::Key>> all = {
      {"best", plot::Key::best},
      {"none", plot::Key::none},
      {"top left", plot::Key::top_left},
      {"top right", plot::Key::top_right},
      {"bottom left", plot::Key::bottom_left},
      {"bottom right", plot::Key::bottom_right},
      {"below", plot::Key::below},
      {"right", plot::Key::right}};
  return all;
}

plot::Key key_of(const std::string& asked) {
  for (const auto& [word, key] : key_words())
    if (word == asked) return key;
  return plot::Key::best;
}

void scale(plot::PlottedCurve& curve, double x, double y) {
  for (auto* list : {&curve.x, &curve.x_error.low, &curve.x_error.high})
    for (double& value : *list) value /= x;
  for (auto* list : {&curve.y, &curve.band.low, &curve.band.high, &curve.error.low, &curve.error.high})
    for (double& value : *list) value /= y;
}

// A curve for each name in y, from the fields of rows.
void read_rows(const Fields& f, const std::string& path, plot::Figure& figure) {
  if (!f.is("x", LUA_TSTRING)) f.refuse("x", "expected the name of a field of rows");
  lua_State* L = f.L();
  const std::vector<std::string> names =
      f.has("y") ? f.texts("y", "names of fields of rows") : std::vector<std::string>{};
  if (names.empty()) f.refuse("y", "expected the name of a field of rows, or a list of names");
  f.push("rows");
  const auto x = column(L, path, f.text("x"));
  for (const std::string& name : names)
    figure.curves.push_back({names.size() > 1 ? name : "", x, column(L, path, name)});
  lua_pop(L, 1);
  if (figure.x.label.empty()) figure.x.label = f.text("x");
  if (figure.y.label.empty() && names.size() == 1) figure.y.label = names[0];
}

void read_curves(const Fields& f, const std::string& path, plot::Figure& figure) {
  lua_State* L = f.L();
  f.each("curves", [&](lua_Integer i) {
    figure.curves.push_back(read_curve(L, path + "curves[" + std::to_string(i) + "]"));
  });
}

// path: prefix of the field names of `own` in messages.
plot::Figure read_figure(const Asked& asked, const Fields& own, const std::string& path) {
  const double x = unit_size(asked, "xunit"), y = unit_size(asked, "yunit");
  plot::Figure figure{asked.text("title"), read_axis(asked, "x", x), read_axis(asked, "y", y)};
  figure.y.names = read_names(asked);
  figure.key = key_of(asked.text("key"));
  if (own.has("rows") == own.has("curves"))
    own.refuse("curves", own.has("rows") ? "expected either rows or curves, got both"
                                         : "expected a table { {x=, y=, label=, style=}, ... }, got nil "
                                           "(missing, or a misspelt variable)");
  if (own.has("rows")) {
    const bool xless = figure.x.label.empty() || figure.x.label == asked.text("xunit"),
               yless = figure.y.label.empty() || figure.y.label == asked.text("yunit");
    read_rows(own, path, figure);
    const auto with_unit = [&](plot::Axis& axis, bool less, const std::string& name,
                               const std::string& unit) {
      if (less && !unit.empty() && !name.empty()) axis.label = name + ", " + unit;
    };
    with_unit(figure.x, xless, own.text("x"), asked.text("xunit"));
    if (own.is("y", LUA_TSTRING)) with_unit(figure.y, yless, own.text("y"), asked.text("yunit"));
  } else {
    read_curves(own, path, figure);
  }
  for (plot::PlottedCurve& curve : figure.curves) scale(curve, x, y);
  return figure;
}

plot::Paper read_paper(const Call& call) {
  plot::Paper paper;
  if (call.has("size")) {
    const auto size = call.numbers("size");
    const bool good = size.size() == 2 &&
                      std::all_of(size.begin(), size.end(), [](double m) { return m >= 0.02 && m <= 1; });
    if (!good) {
      std::string got;
      for (const double m : size) got += (got.empty() ? "{" : ", ") + fabricsh::number(m);
      call.refuse("size", "expected {width, height} in m, each from 0.02 to 1, such as {85*mm, 60*mm}, got " +
                              got + "}");
    }
    paper.width = size[0], paper.height = size[1];
  }
  paper.font = call.text("font");
  if (paper.font.find_first_of(",:;") != std::string::npos)
    call.refuse("font", "expected the name of one family, got '" + paper.font + "'");
  paper.font_size = call.number("font_size");
  paper.dpi = call.number("dpi");
  return paper;
}

void read_grid(const Call& call, plot::Page& page) {
  if (!call.has("layout")) return;
  const auto grid = call.numbers("layout");
  const auto whole = [](double n) { return n >= 1 && n <= 20 && n == std::floor(n); };
  if (grid.size() != 2 || !whole(grid[0]) || !whole(grid[1]))
    call.refuse("layout", "expected {rows, columns}, whole numbers from 1 to 20");
  page.rows = static_cast<int>(grid[0]), page.columns = static_cast<int>(grid[1]);
  if (static_cast<std::size_t>(page.rows * page.columns) < page.panels.size())
    call.refuse("layout", "expected room for " + std::to_string(page.panels.size()) + " panels, got " +
                              std::to_string(page.rows) + " x " + std::to_string(page.columns));
}

std::vector<Argument> panel_rows();

void read_panels(const Call& call, plot::Page& page) {
  static const std::vector<Argument> rows = panel_rows();
  lua_State* L = call.L();
  for (const char* name : {"curves", "rows"})
    if (call.has(name)) call.refuse(name, "expected in each of the panels, where there are panels");
  const auto count = call.each("panels", [&](lua_Integer i) {
    const std::string path = "panels[" + std::to_string(i) + "]";
    if (!lua_istable(L, -1)) throw Error("field '" + path + "': expected a table, got " + describe(L, -1));
    const Fields panel(L, -1, rows, path + ".");
    page.panels.push_back(read_figure(Asked(call, &panel), panel, path + "."));
  });
  if (count == 0) call.refuse("panels", "expected a list of panels, got an empty table");
}

plot::Page read_page(const Call& call) {
  plot::Page page;
  if (call.has("panels"))
    read_panels(call, page);
  else
    page.panels.push_back(read_figure(Asked(call, nullptr), call, ""));
  read_grid(call, page);
  page.letters = call.flag("letters");
  page.paper = read_paper(call);
  return page;
}

// A missing gnuplot only gives a warning, because the results of the deck would otherwise be lost.
bool drawn(const Call& call, const plot::Page& page) {
  const std::string path = call.text("file");
  system::make_folder_for(path);
  const auto warn = [&](const std::string& words) {
    call.session().notices().once(words, "warning: " + words);
  };
  try {
    for (const std::string& words : plot::draw(path, page)) warn("plot: figure '" + path + "': " + words);
    return true;
  } catch (const plot::NoGnuplot& missing) {
    warn("plot: no figure '" + path + "': " + missing.what());
    return false;
  }
}

int plot(Call& call) {
  const plot::Page page = read_page(call);
  if (call.session().options().check) return 0;
  if (call.has("file")) {
    return push_value(call.L(), drawn(call, page));
  }
  const std::string letters = plot::drawn_in_letters(page, call.count("columns"), call.count("lines"));
  for (const std::string& words : plot::left_out(page))
    call.session().notices().once(words, "warning: plot: " + words);
  return push_text(call.L(), letters);
}

// Arguments of a panel, and of a call as defaults for all panels.
std::vector<Argument> panel_rows() {
  const auto range = [](const char* name) {
    return Argument{name, numbers, "", everything, "{low, high} shown, in SI; default: all"}.optional();
  };
  const auto word = [](const char* name, const char* sentence) {
    return value_(name, text, sentence).optional();
  };
  std::vector<std::string> keys;
  for (const auto& [name, key] : key_words()) keys.push_back(name);
  return {value_("rows?", table,
                 "in the place of curves: a list of tables, a test with a curve, or a table of lists"),
          value_("x?", text, "with rows: the field along x"),
          value_("y?", text | table, "with rows: the field along y, or a list of fields"),
          value_("curves?", table, curve_list),
          word("title", "above the axes"),
          word("xlabel", "what x is"),
          word("ylabel", "what y is"),
          word("xunit",
               "of fabric.units, a quotient of two (N/mm, N/5cm), or %: x is SI and shown in it, behind the "
               "label"),
          word("yunit", "likewise"),
          range("xrange"),
          range("yrange"),
          value_("ynames?", table, "a list of names: what stands at y = 1, 2, ..., in the place of numbers"),
          value_("log?", text, "logarithmic axes").one_of({"", "x", "y", "xy"}),
          value_("key?", text,
                 "where the labels of the curves stand; best: the first corner free of curves, else below")
              .one_of(keys)};
}

std::vector<Entry> plot_entries() {
  const Range letters{10, 400};
  std::vector<Argument> arguments = panel_rows();
  const std::vector<Argument> more = {
      value_("file?", text, "ends in .svg, .pdf, .eps or .png; none: drawn in letters"),
      value_("panels?", table,
             "{ {curves=, title=, xlabel=, ...}, ... }: several plots on one page; what a panel does not say "
             "is taken from the call"),
      Argument{"layout", numbers, "", everything, "{rows, columns} of the panels; default: two columns"}
          .optional(),
      value_("letters", boolean, "(a), (b), ... above the panels").or_else(true),
      Argument{"size", numbers, "m", everything,
               "{width, height} of the page; default {85*mm, 60*mm}, a column of a journal; with panels 170 "
               "mm wide, 60 mm for a row"}
          .optional(),
      value_("font", text, "a family of letters; default: Helvetica, or what stands for it").or_else(""),
      number_("font_size", "points", Range{4, 40}, "size of all letters").or_else(8.0),
      number_("dpi", "", Range{50, 1200}, "pixels of a PNG per inch").or_else(300.0),
      integer_("columns", letters, "width of a drawing in letters").or_else(79.0),
      integer_("lines", letters, "height of a drawing in letters").or_else(24.0)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return {
      {"fabric.plot{}", arguments,
       "Draws curves (by gnuplot) into a file, or without one returns them as text: the prompt shows it, a "
       "deck prints it by print(fabric.plot{...}). fabric.plot(rows, \"E\", \"S\", {...}) is short for "
       "fabric.plot{ rows=rows, x=\"E\", y=\"S\", ... }. With a file it returns whether it was drawn: false, "
       "with a warning, where gnuplot is not installed.",
       "local ok, text = pcall(fabric.plot, { xlabel='time', xunit='ms', "
       "curves={ {x={0, 1}, y={0, 2}, label='a line'},\n  {rows={ {t=0, v=1}, {t=1, v=2} }, x='t', y='v', "
       "style='points'} } })\nassert((ok and text:find 'time, ms') or text:find 'gnuplot')\n"
       "-- of a list of rows, in short\nok, text = pcall(fabric.plot, { {t=0, v=1}, {t=1, v=2} }, 't', 'v')\n"
       "assert(text:find 'gnuplot' or ok)",
       plot},
  };
}

}  // namespace

void bind_plot(Session& session) { install(session, plot_entries()); }

}  // namespace fabricsh::script
