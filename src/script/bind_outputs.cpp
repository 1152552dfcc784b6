// a:record and a:vtk.
#include <algorithm>
#include <filesystem>
#include <set>

#include "files/csv.hpp"
#include "output/vtk_series.hpp"
#include "script/bind_run.hpp"
#include "script/checkpoint.hpp"
#include "script/words.hpp"

namespace fabricsh::script {

namespace {

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

// s; 0: every step.
double interval_of(const Fields& options) {
  return !options.has("every") || options.is("every", LUA_TSTRING) ? 0 : options.number("every");
}

// Has its frames written as often as `interval` says; drive() asks for one more when the run ends.
void schedule(Run& run, double interval, const std::shared_ptr<Output>& output) {
  const auto frame = [output](analysis::Run& a) { output->series->frame(a); };
  const auto repeat = analysis::Run::AfterError::repeat;
  output->hook =
      interval > 0 ? run.analysis->every(interval, frame, repeat) : run.analysis->every_step(frame, repeat);
  run.analysis->on_restore([output](analysis::Run& a) { output->series->rewind(a.steps().size()); });
  run.outputs.push_back(output);
}

// The output of the run that another one may take the place of: it was an error, or was one in the part of
// the run that a restarted deck passes over. Null: none.
Output* replaceable(const Run& run, const std::string& kind, const std::string& file) {
  for (const auto& output : run.outputs)
    if (output->kind == kind && output->file == file &&
        (output->series->in_trouble() || run.calls < run.passing))
      return output.get();
  return nullptr;
}

// Opens the output, new or, where the run begins from a checkpoint that has it, continued.
template <class Series, class Options>
void add_output(Run& run, Output output, double interval, const Options& options) {
  const std::string written = output.file;
  Output* const old = replaceable(run, output.kind, absolute(written));
  output.file = old != nullptr ? old->file : free_path(run, written);
  if (const std::string* kept = take_part(run, output.kind, output.path)) {
    Archive from(*kept);
    output.series = std::make_shared<Series>(output.path, options, from);
    for (const std::string& file : output.series->lost())
      run.session.notices().say("warning: restart: '" + file + "' is gone, the series goes on without it");
  } else {
    output.series = std::make_shared<Series>(output.path, options);
  }
  if (old != nullptr) {
    old->series = output.series;
    run.analysis->reschedule(old->hook, interval);
    return;
  }
  run.paths.insert(output.file);
  run.record.add_output(written);
  schedule(run, interval, std::make_shared<Output>(std::move(output)));
}

}  // namespace

std::string free_path(const Run& run, const std::string& path) {
  const std::string file = absolute(path);
  if (run.paths.count(file) != 0) throw Error("argument 1: '" + path + "' is an output of this run already");
  return file;
}

namespace {

struct Column {
  std::string name;
  Hook value;
  std::string heading;  // the name with its unit
};

class Record final : public output::Series {
 public:
  Record(const std::string& path, std::vector<Column> columns)
      : columns_(std::move(columns)), writer_(path, names()) {}
  // Goes on with a table that another program has left.
  Record(const std::string& path, std::vector<Column> columns, Archive& from)
      : Series(from), columns_(std::move(columns)), writer_(path, names(), place(from)) {}
  void sync() override { writer_.sync(); }

 private:
  void write(const analysis::Run& run) override {
    std::vector<double> values = {run.time()};
    for (const Column& column : columns_) values.push_back(value(column));
    writer_.row(values);
  }
  void cut(std::size_t rows) override { writer_.keep(rows); }
  void keep_place(Archive& archive) override {
    files::CsvPlace place = writer_.place();
    archive(place);
  }
  files::CsvPlace place(Archive& from) const {
    files::CsvPlace place;
    from(place);
    if (place.ends.size() != frames() + 1) throw Error("rows of a table were lost count of");
    return place;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> out = {"time (s)"};
    for (const Column& column : columns_) out.push_back(column.heading);
    return out;
  }

  static double value(const Column& column) {
    const Still still = column.value.still();
    lua_State* L = column.value.push();
    lua_call(L, 1, 1);
    if (lua_type(L, -1) != LUA_TNUMBER)
      throw Error("record: field 'columns." + column.name +
                  "': expected the function to return a number, got " + describe(L, -1));
    const double result = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return result;
  }

  std::vector<Column> columns_;
  files::CsvWriter writer_;
};

std::vector<std::string> text_list(const Fields& fields, const char* name) {
  std::vector<std::string> words;
  lua_State* L = fields.L();
  if (fields.push(name) == LUA_TTABLE)
    for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i) {
      if (lua_type(L, -1) != LUA_TSTRING)
        fields.refuse(name, "expected a table of names, got " + describe(L, -1));
      words.emplace_back(lua_tostring(L, -1));
      lua_pop(L, 1);
    }
  else
    lua_pushnil(L);
  lua_pop(L, 2);
  return words;
}

// Names of the columns: `order` first, the rest by the alphabet.
std::vector<std::string> column_names(const Fields& options) {
  lua_State* L = options.L();
  std::vector<std::string> names = text_list(options, "order"), rest;
  const std::set<std::string> ordered(names.begin(), names.end());
  options.push("columns");
  for (const std::string& name : names) {
    if (lua_getfield(L, -1, name.c_str()) != LUA_TFUNCTION)
      options.refuse("order", "no column '" + name + "'");
    lua_pop(L, 1);
  }
  lua_pushnil(L);
  while (lua_next(L, -2) != 0) {
    if (lua_type(L, -2) != LUA_TSTRING || !lua_isfunction(L, -1))
      options.refuse("columns", "expected name = function(a), got " + describe(L, -1));
    const std::string name = lua_tostring(L, -2);
    if (ordered.count(name) == 0) rest.push_back(name);
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  std::sort(rest.begin(), rest.end());
  names.insert(names.end(), rest.begin(), rest.end());
  if (names.empty()) options.refuse("columns", "expected at least one column");
  return names;
}

// In the order of the table. Each function is taken out by itself: to look through all of them for each would
// cost the cube of their number.
std::vector<Column> read_columns(const Fields& options, Run* run) {
  lua_State* L = options.L();
  const std::vector<Argument> row = {value_("column", function, "a column")};
  std::vector<Column> columns;
  options.push("columns");
  for (const std::string& name : column_names(options)) {
    lua_newtable(L);
    lua_getfield(L, -2, name.c_str());
    lua_setfield(L, -2, "column");
    columns.push_back({name, Hook(Fields(L, -1, row, "options.columns."), "column", run), name});
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return columns;
}

// Columns that are called by a quantity hold it in SI, as everything does, unless the deck says otherwise.
std::string usual_unit(const std::string& name) {
  if (name == "displacement") return "m";
  for (const char* force : {"force", "force_x", "force_y", "force_z"})
    if (name == force) return "N";
  return "";
}

// The unit of a column as `units` gives it; "": none.
std::string unit_of(const Fields& options, const std::string& name) {
  lua_State* L = options.L();
  std::string unit = usual_unit(name);
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

// Every name in `units` is that of a column.
void check_units(const Fields& options, const std::vector<Column>& columns) {
  lua_State* L = options.L();
  if (options.push("units") == LUA_TTABLE)
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
      const bool known = lua_type(L, -2) == LUA_TSTRING &&
                         std::any_of(columns.begin(), columns.end(), [&](const Column& column) {
                           return column.name == lua_tostring(L, -2);
                         });
      if (!known) options.refuse("units", "no column " + describe(L, -2));
    }
  lua_pop(L, 1);
}

int record(Call& call) {
  const auto run = call.self<Run>();
  const Fields options = call.fields("options");
  std::vector<Column> columns = read_columns(options, run.get());
  check_units(options, columns);
  for (Column& column : columns) {
    const std::string unit = unit_of(options, column.name);
    column.heading = unit.empty() ? column.name : column.name + " (" + unit + ")";
  }
  lua_pushvalue(call.L(), 1);
  if (call.session().options().check) return 1;
  const std::string path = call.text("path");
  add_output<Record>(*run, {"record", path, path, {}}, interval_of(options), columns);
  return 1;
}

int vtk(Call& call) {
  const auto run = call.self<Run>();
  luaL_checkstack(call.L(), 10, "vtk");
  if (!call.has("options")) {
    lua_newtable(call.L());
    lua_setfield(call.L(), -2, "options");
  }
  const Fields options = call.fields("options");
  const std::vector<std::string> fields = text_list(options, "fields");
  lua_pushvalue(call.L(), 1);
  if (call.session().options().check) return 1;
  std::string stem = call.text("stem");
  if (stem.ends_with(".pvd")) stem.resize(stem.size() - 4);
  add_output<output::VtkSeries>(*run, {"vtk", stem, stem + ".pvd", {}}, interval_of(options), fields);
  return 1;
}

Argument every_row() {
  return Argument{"every", number | text, "s", positive, "time between rows or frames, or 'step'", true,
                  {},      {"step"}}
      .optional();
}

std::vector<Entry> rows() {
  const std::string sample = sample_run() + "local name = os.tmpname()\nos.remove(name)\n";
  return {
      {"analysis:record",
       Style::positional,
       {value_("path", text, "of the CSV file"),
        fields_("options",
                {every_row(), value_("columns", table, "name = function(a) that returns a number"),
                 value_("order", table, "names in the order of the columns").optional(),
                 value_("units", table,
                        "name = unit of what the function returns, '' for none; put behind the name in the "
                        "heading. Default: N for a column called force (or force_x, force_y, force_z), m for "
                        "displacement")
                     .optional()},
                "columns, and how often")},
       "Writes a table as the run goes: time, then the columns, with their units in the heading, so that "
       "fabric.lab.tensile reads it.",
       sample + "a:record(name..'/curve.csv', { columns={ force=function(run) return select(2, run:reaction "
                "'top') end } })\n"
                "a:solve()\nassert(io.open(name..'/curve.csv'):read 'l' == 'time (s),force (N)')\n"
                "os.remove(name..'/curve.csv') os.remove(name..'/run.json') os.remove(name)",
       record},
      {"analysis:vtk",
       Style::positional,
       {value_("stem", text, "out/drape writes out/drape.pvd and numbered .vtu files"),
        fields_("options",
                {every_row(), value_("fields", table, "some of the fields; default all")
                                  .one_of(output::field_names())
                                  .optional()},
                "how often, and what")
            .optional()},
       "Writes a series for ParaView as the run goes; the .pvd is valid at any moment.",
       sample + "a:vtk(name..'/pull')\na:solve()\nassert(io.open(name..'/pull.pvd'):read 'a':find "
                "'pull_00002.vtu')\n"
                "for i = 0, 2 do os.remove(name..('/pull_%05d.vtu'):format(i)) end\n"
                "os.remove(name..'/pull.pvd') os.remove(name..'/run.json') os.remove(name)",
       vtk},
  };
}

}  // namespace

void bind_outputs(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
