// What a deck writes by itself: card:write, fabric.plot.
#include "files/atomic.hpp"
#include "files/figure.hpp"
#include "script/bind.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

namespace {

int write_card(Call& call) {
  if (!call.session().options().check) {
    files::make_folder_for(call.text("path"));
    files::write_file(call.text("path"), card_text(*call.self<card::Card>()));
  }
  return 0;
}

const std::vector<Argument>& curve_rows() {
  static const std::vector<Argument> rows = {{"x", numbers | table, "", everything, "abscissas"},
                                             {"y", numbers | table, "", everything, "ordinates"},
                                             value_("label", text, "in the key").or_else(""),
                                             value_("style", text, "how it is drawn")
                                                 .one_of({"line", "dashed", "points", "line_points"})
                                                 .or_else("line")};
  return rows;
}

files::CurveStyle style_of(const std::string& word) {
  if (word == "dashed") return files::CurveStyle::dashed;
  if (word == "points") return files::CurveStyle::points;
  return word == "line" ? files::CurveStyle::line : files::CurveStyle::line_points;
}

files::Curve read_curve(lua_State* L, lua_Integer place) {
  const std::string path = "curves[" + std::to_string(place) + "]";
  if (!lua_istable(L, -1)) throw Error("field '" + path + "': expected a table, got " + describe(L, -1));
  const Fields f(L, -1, curve_rows(), path + ".");
  files::Curve curve{f.text("label"), f.numbers("x"), f.numbers("y"), style_of(f.text("style"))};
  if (curve.x.size() != curve.y.size())
    throw Error("field '" + path + "': expected x and y of one length, got " +
                std::to_string(curve.x.size()) + " and " + std::to_string(curve.y.size()));
  return curve;
}

int plot(Call& call) {
  lua_State* L = call.L();
  std::vector<files::Curve> curves;
  call.push("curves");
  const auto n = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= n; ++i) {
    lua_rawgeti(L, -1, i);
    curves.push_back(read_curve(L, i));
    lua_pop(L, 1);
  }
  if (call.session().options().check) return 0;
  files::make_folder_for(call.text("file"));
  files::figure(call.text("file"), call.text("title"), call.text("xlabel"), call.text("ylabel"), curves);
  return 0;
}

std::vector<Entry> rows() {
  return {
      {"card:write",
       Style::positional,
       {value_("path", text, "of the Lua file")},
       "Writes the card as a Lua file that reads back equal; the old file stays until the new one is whole.",
       "local fabric = require 'fabric'\nlocal path = os.tmpname()..'.lua'\nlocal card = fabric.card 'duck'\n"
       "card:write(path)\nassert(fabric.card(path) == card)\nos.remove(path)",
       write_card},
      {"fabric.plot",
       Style::fields,
       {value_("file", text, "ends in .svg, .png or .pdf"),
        value_("title", text, "above the curves").or_else(""),
        value_("xlabel", text, "with its unit").or_else(""),
        value_("ylabel", text, "with its unit").or_else(""),
        value_("curves", table, "{ {x=, y=, label=, style=}, ... }")},
       "Draws curves into a file (by gnuplot).",
       "local path = os.tmpname()..'.svg'\n"
       "pcall(require 'fabric'.plot, { file=path, curves={ {x={0, 1}, y={0, 2}, label='a line'} } "
       "})\nos.remove(path)",
       plot},
  };
}

}  // namespace

void bind_files(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
