// a:record, a:vtk and a:write.
#include <algorithm>
#include <functional>
#include <set>

#include "base/utf8.hpp"
#include "format/mesh_file.hpp"
#include "run/vtk_frame.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/session/at_work.hpp"

namespace fabricsh::script {

namespace {

// s; 0: every step.
double interval_of(const Fields& options) {
  return !options.has("every") || options.is("every", LUA_TSTRING) ? 0 : options.number("every");
}

// Names of the columns: first those in `order`, then the others alphabetically.
std::vector<std::string> column_names(const Fields& options) {
  lua_State* L = options.L();
  std::vector<std::string> names = options.texts("order", "a table of names"), rest;
  const std::set<std::string> ordered(names.begin(), names.end());
  options.push("columns");
  for (const std::string& name : names) {
    if (lua_getfield(L, -1, name.c_str()) == LUA_TNIL) options.refuse("order", "no column '" + name + "'");
    lua_pop(L, 1);
  }
  lua_pushnil(L);
  while (lua_next(L, -2) != 0) {
    if (lua_type(L, -2) != LUA_TSTRING ||
        (!lua_isfunction(L, -1) && lua_type(L, -1) != LUA_TSTRING && !lua_istable(L, -1)))
      options.refuse("columns", "expected name = function(a) or the name of a field, got " + describe(L, -1));
    std::size_t length = 0;
    const char* const text = lua_tolstring(L, -2, &length);
    const std::string name(text, length);
    want_plain(name, "record: field 'columns'");
    if (ordered.count(name) == 0) rest.push_back(name);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  std::sort(rest.begin(), rest.end());
  names.insert(names.end(), rest.begin(), rest.end());
  if (names.empty()) options.refuse("columns", "expected at least one column");
  return names;
}

double called(const Hook& hook, const std::string& name) {
  const ChangeRefused still = hook.still();
  lua_State* L = hook.push();
  call_deck(L, 1, 1);
  if (lua_type(L, -1) != LUA_TNUMBER)
    throw Error("record: field 'columns." + name + "': expected the function to return a number, got " +
                describe(L, -1));
  const double result = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return result;
}

// The mean of a field: "S11", or {"S11", "left"} over a set. The value is on top of the
// stack.
std::function<double(const run::Run&)> mean_of_field(const Fields& columns, const std::string& name,
                                                     const run::Run& run, std::string& unit) {
  lua_State* L = columns.L();
  std::string words[2] = {"", "all"};
  bool windowed = false;
  if (lua_istable(L, -1)) {
    windowed = lua_getfield(L, -1, "window") != LUA_TNIL;
    lua_pop(L, 1);
  }
  if (lua_type(L, -1) == LUA_TSTRING) words[0] = lua_tostring(L, -1);
  for (int i = 0; lua_istable(L, -1) && i < 2; ++i) {
    const int kind = lua_rawgeti(L, -1, i + 1);
    if (i == 1 && kind == LUA_TNIL && windowed) {
      lua_pop(L, 1);
      break;
    }
    if (kind != LUA_TSTRING)
      columns.refuse(name, "expected a field's name or {name, set}, got " + describe(L, -1) + " at place " +
                               std::to_string(i + 1));
    words[i] = lua_tostring(L, -1);
    lua_pop(L, 1);
  }
  const std::vector<std::string> known = run::scalar_names();
  const std::string word = last_word(words[0]);
  if (std::find(known.begin(), known.end(), word) == known.end())
    columns.refuse(name, unknown("field", word, known));
  try {
    run::check_mean(run, words[0], words[1]);
  } catch (const Error& error) {
    columns.refuse(name, error.what());
  }
  unit = run::find_field(words[0]).field->unit;
  return [field = words[0], set = words[1]](const run::Run& a) { return a.mean(field, set); };
}

// The width of a column's window, {function or field, set?, window=seconds}, or that of all columns; 0: none.
// The value is on top of the stack.
double window_of(const Fields& options, const Fields& columns, const std::string& name) {
  lua_State* L = columns.L();
  double width = options.has("window") ? options.number("window") : 0;
  if (!lua_istable(L, -1)) return width;
  if (const int kind = lua_getfield(L, -1, "window"); kind != LUA_TNIL) {
    if (kind != LUA_TNUMBER || !(lua_tonumber(L, -1) > 0) || !std::isfinite(lua_tonumber(L, -1)))
      columns.refuse(name, "expected window = a positive time in s, got " + describe(L, -1));
    width = lua_tonumber(L, -1);
  }
  lua_pop(L, 1);
  return width;
}

// Columns named after a quantity are in SI units, unless the deck states otherwise.
std::string usual_unit(const std::string& name) {
  if (name == "displacement") return "m";
  for (const char* force : {"force", "force_x", "force_y", "force_z"})
    if (name == force) return "N";
  return "";
}

// Reads only this column's function: to look through all columns for each would cost the cube of their
// number.
run::RecordColumn read_column(const Fields& options, const std::string& name, DeckRun* run) {
  lua_State* L = options.L();
  const std::vector<Argument> row = {value_(name, function | text | table, "a column")};
  options.push("columns");
  lua_newtable(L);
  lua_getfield(L, -2, name.c_str());
  lua_setfield(L, -2, name.c_str());
  const Fields columns(L, -1, row, "options.columns.");
  run::RecordColumn column{name, {}, {}};
  const bool in_table = columns.push(name) == LUA_TTABLE;
  column.window = window_of(options, columns, name);
  // {function, window=}: the function takes the place of the table.
  if (in_table && lua_rawgeti(L, -1, 1) == LUA_TFUNCTION) {
    lua_pushvalue(L, -1);
    lua_setfield(L, -4, name.c_str());
    lua_remove(L, -2);
  } else if (in_table) {
    lua_pop(L, 1);
  }
  if (lua_isfunction(L, -1)) {
    column.value = [hook = Hook(columns, name, run), name](const run::Run&) { return called(hook, name); };
    column.unit = usual_unit(name);
  } else {
    column.value = mean_of_field(columns, name, *run->analysis, column.unit);
  }
  lua_pop(L, 3);
  return column;
}

// The unit of a column as given in `units`; "": none. By default the usual one.
std::string unit_of(const Fields& options, const run::RecordColumn& column) {
  lua_State* L = options.L();
  const std::string& name = column.name;
  std::string unit = column.unit;
  if (options.push("units") == LUA_TTABLE) {
    if (lua_getfield(L, -1, name.c_str()) == LUA_TSTRING)
      unit = lua_tostring(L, -1);
    else if (!lua_isnil(L, -1))
      options.refuse("units",
                     "expected name = 'unit' or '' for none, got " + describe(L, -1) + " for '" + name + "'");
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  if (unit.find_first_of("()[]<>{}\r\n") != std::string::npos)
    options.refuse("units", "expected a unit without brackets, got '" + unit + "' for '" + name + "'");
  return unit;
}

// Error unless every name in `units` is that of a column.
void check_units(const Fields& options, const std::vector<run::RecordColumn>& columns) {
  lua_State* L = options.L();
  if (options.push("units") == LUA_TTABLE)
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
      const bool known = lua_type(L, -2) == LUA_TSTRING &&
                         std::any_of(columns.begin(), columns.end(), [&](const run::RecordColumn& column) {
                           return column.name == lua_tostring(L, -2);
                         });
      if (!known) options.refuse("units", "no column " + describe(L, -2));
    }
  lua_pop(L, 1);
}

int record(Call& call) {
  const auto run = call.self<DeckRun>();
  const Fields options = call.fields("options");
  std::vector<run::RecordColumn> columns;
  for (const std::string& name : column_names(options))
    columns.push_back(read_column(options, name, run.get()));
  check_units(options, columns);
  for (run::RecordColumn& column : columns) column.unit = unit_of(options, column);
  if (call.session().options().check) return call.itself();
  run->job.record(call.text("path"), columns, interval_of(options));
  return call.itself();
}

// The table of options, an empty one where the call has none.
Fields options_of(Call& call, const char* name) {
  luaL_checkstack(call.L(), 10, name);
  if (!call.has("options")) {
    lua_newtable(call.L());
    lua_setfield(call.L(), -2, "options");
  }
  return call.fields("options");
}

run::VtkContents contents_of(const Fields& options) {
  run::VtkContents contents{options.texts("fields", "a table of names")};
  contents.reference = options.text("points") == "reference";
  contents.averaged = options.flag("averaged");
  return contents;
}

int vtk(Call& call) {
  const auto run = call.self<DeckRun>();
  const Fields options = options_of(call, "vtk");
  const run::VtkContents contents = contents_of(options);
  if (call.session().options().check) return call.itself();
  std::string stem = call.text("stem");
  if (stem.ends_with(".pvd")) stem.resize(stem.size() - 4);
  run->job.vtk(stem, interval_of(options), contents);
  return call.itself();
}

bool is_vtu(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  std::string ending = dot == path.npos ? "" : path.substr(dot);
  for (char& c : ending) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c);
  return ending == ".vtu";
}

// The present state: a frame of a series if the format holds fields, else the mesh.
int write_output(Call& call) {
  const auto run = call.self<DeckRun>();
  const Fields options = options_of(call, "write");
  const run::VtkContents contents = contents_of(options);
  const std::string path = call.text("file");
  if (!is_vtu(path) && (!contents.fields.empty() || contents.averaged))
    options.refuse(contents.averaged ? "averaged" : "fields",
                   "expected a file that ends in .vtu, which holds fields, got '" + path + "'");
  run::check_fields(*run->analysis, contents, "write");
  if (call.session().options().check) return call.itself();
  system::make_folder_for(path);
  const run::Run& a = *run->analysis;
  if (is_vtu(path)) {
    format::write_vtu(path, run::VtkFrame(a, contents).grid());
    return call.itself();
  }
  mesh::Mesh shape = a.model().mesh();
  for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
    const run::NodeValues node = a.node(static_cast<mesh::Index>(i));
    shape.nodes[i] = contents.reference ? node.X : node.x;
  }
  const bool is_deck = path.ends_with(".inp") || path.ends_with(".k") || path.ends_with(".rad");
  if (is_deck && a.model().has_rest())
    call.session().warn("dropped", position(call.L()) + "write: " + path +
                                       " has the mesh alone: the stress-free shape of the model is left out");
  format::write_mesh(path, shape);
  return call.itself();
}

std::vector<Argument> contents_rows() {
  return {
      value_("fields?", table,
             "names of fields, or of single numbers: see the table of fields of a run; default: displacement "
             "velocity director reference reaction E S residual slack energy warp weft. Displacement and "
             "reference are always there")
          .one_of(run::field_names()),
      value_("points", text,
             "where the nodes are now, or where they were: with reference, ParaView's Warp By Vector by "
             "displacement shows the sheet as it is")
          .one_of({"deformed", "reference"})
          .or_else("deformed"),
      flag_("averaged",
            "fields of elements also on the nodes, under the same names, as a:field finds them with "
            "at='nodes'")};
}

std::vector<Argument> joined(std::vector<Argument> first, std::vector<Argument> rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

Argument every_row() {
  return Argument{"every", number | text, "s", positive, "time between rows or frames, or 'step'", true,
                  {},      {"step"}}
      .optional();
}

std::vector<Entry> outputs_entries() {
  const std::string sample = sample_run() + "local name = os.tmpname()\nos.remove(name)\n";
  return {
      {"analysis:record()",
       {value_("path", text, "of the CSV file"),
        fields_(
            "options",
            {every_row(),
             value_(
                 "columns", table,
                 "name = function(a) that returns a number; or a field's name, for its mean over all "
                 "elements or nodes, or {field, set}; {function or field, set, window=seconds} is the "
                 "mean over the last seconds of the run's own steps, in which a:reaction(body) counts as in "
                 "its own window (the function is then called twice a step)"),
             number_("window?", "s", positive, "the same for all columns that have none of their own"),
             value_("order?", table, "names in the order of the columns"),
             value_("units?", table,
                    "name = unit of what the function returns, '' for none; put behind the name in the "
                    "heading. Default: that of the field; N for a column called force (or force_x, "
                    "force_y, force_z), m for displacement")},
            "columns, and how often")},
       "Writes a table as the run goes: time, then the columns, with their units in the heading, so that "
       "fabric.lab.tensile reads it.",
       sample + "a:record(name..'/curve.csv', { columns={ force=function(run) return select(2, run:reaction "
                "'top') end } })\n"
                "a:solve()\nassert(io.open(name..'/curve.csv'):read 'l' == 'time (s),force (N)')\n"
                "os.remove(name..'/curve.csv') os.remove(name..'/run.json') os.remove(name)",
       record},
      {"analysis:vtk()",
       {value_("stem", text, "out/drape writes out/drape.pvd and numbered .vtu files"),
        fields_("options?", joined({every_row()}, contents_rows()), "how often, and what")},
       "Writes a series for ParaView as the run goes; the .pvd is valid at any moment. Node sets are arrays "
       "of 0 and 1 on the points, E and S symmetric tensors in material axes (11 22 33 12 23 13; those of 33 "
       "are 0), units stand with the arrays.",
       sample + "a:vtk(name..'/pull')\na:solve()\nassert(io.open(name..'/pull.pvd'):read 'a':find "
                "'pull_00002.vtu')\n"
                "for i = 0, 2 do os.remove(name..('/pull_%05d.vtu'):format(i)) end\n"
                "os.remove(name..'/pull.pvd') os.remove(name..'/run.json') os.remove(name)",
       vtk},
      {"analysis:write()",
       {value_("file", text, "ends in " + format::written_endings()),
        fields_("options?", contents_rows(), "what; fields go into a .vtu alone")},
       "Writes the sheet as it is now, or as it was in the reference, for another program: with fields as a "
       "frame of a:vtk into a .vtu, else as mesh:write does.",
       sample + "a:solve()\nlocal file = name..'.stl'\na:write(file)\n"
                "assert(math.abs(fabric.mesh.read(file).nodes[7][2] - a:node(7).y) < 1e-9)\nos.remove(file)",
       write_output},
  };
}

}  // namespace

void bind_outputs(Session& session) { install(session, outputs_entries()); }

}  // namespace fabricsh::script
