// fabric.lab.track and fabric.lab.correlate: photographs of cloth, of which the part that looks at them is
// loaded when it is first asked for; and fabric.lab.photograph and fabric.lab.speckles, which draw some for
// trying.
#include "lab/photographs.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.hpp"
#include "format/source.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

namespace {

// Sets a field of the table on top of the stack to the values times the scale.
void set_scaled(lua_State* L, const char* name, std::vector<double> values, double scale) {
  for (double& v : values) v *= scale;
  put(L, name, values);
}

// Error, in the name of the call: the part is missing.
const lab::Photographs& photographs(const Call& call) {
  try {
    return lab::photographs();
  } catch (const Error& error) {
    throw Error(last_word(call.entry().name) + ": " + error.what());
  }
}

Argument region_() {
  return fields_("region?",
                 {integer_("left?", not_negative, "first column, from 0 at the left"),
                  integer_("top?", not_negative, "first row, from 0 at the top"),
                  integer_("right?", from_one, "column behind the last"),
                  integer_("bottom?", from_one, "row below the last")},
                 "pixels of the photograph, as picture viewers count them; default: all");
}

lab::PixelRegion region_of(const Call& call, int width, int height) {
  lab::PixelRegion r{0, 0, width, height};
  if (!call.has("region")) return r;
  const Fields given = call.fields("region");
  const auto take = [&](const char* name, int& edge, int most) {
    if (!given.has(name)) return;
    edge = given.count(name);
    if (edge > most)
      given.refuse(name, "expected a pixel of the photograph, " + std::to_string(most) + " at most, got " +
                             std::to_string(edge));
  };
  take("left", r.left, width);
  take("top", r.top, height);
  take("right", r.right, width);
  take("bottom", r.bottom, height);
  if (r.right <= r.left)
    given.refuse("right",
                 "expected more than left, " + std::to_string(r.left) + ", got " + std::to_string(r.right));
  if (r.bottom <= r.top)
    given.refuse("bottom",
                 "expected more than top, " + std::to_string(r.top) + ", got " + std::to_string(r.bottom));
  lua_pop(call.L(), 1);
  return r;
}

lab::PhotographSeries series_of(const Call& call) {
  auto names = call.texts("files", "names of photographs");
  if (names.size() < 2) call.refuse("files", "expected at least two photographs");
  return {std::move(names), format::read_file,
          [&call](int width, int height) { return region_of(call, width, height); }};
}

// Metres per pixel: given, or from the distance of two markers in the first photograph.
double scale_of(const Call& call, const lab::Tracks& t) {
  if (call.has("scale")) return call.number("scale");
  if (!call.has("known")) return 1;
  const Fields known = call.fields("known");
  const auto marker = [&](const char* name) {
    const auto m = known.integer(name);
    if (m < 1 || m > static_cast<std::int64_t>(t.markers()))
      known.refuse(
          name, "expected a marker from 1 to " + std::to_string(t.markers()) + ", got " + std::to_string(m));
    return static_cast<std::size_t>(m - 1);
  };
  const std::size_t a = marker("from"), b = marker("to");
  if (a == b) known.refuse("to", "expected another marker than 'from'");
  const double pixels = std::hypot(t.x[a] - t.x[b], t.y[a] - t.y[b]);
  const double distance = known.number("distance");
  lua_pop(call.L(), 1);
  return distance / pixels;
}

void push_doubts(lua_State* L, const std::vector<lab::DoubtfulMarker>& doubts) {
  lua_createtable(L, static_cast<int>(doubts.size()), 0);
  lua_Integer place = 0;
  for (const lab::DoubtfulMarker& doubt : doubts) {
    push_record(L, "frame", doubt.frame + 1, "marker", doubt.marker + 1, "lost", doubt.lost);
    lua_rawseti(L, -2, ++place);
  }
}

int track(Call& call) {
  lua_State* L = call.L();
  lab::DotOptions options;
  options.dark = call.flag("dark");
  options.largest = call.number("largest");
  options.contrast = call.number("contrast");
  const lab::TrackedDots found =
      photographs(call).track(series_of(call), static_cast<std::size_t>(call.integer("rows")),
                              static_cast<std::size_t>(call.integer("columns")), options);
  const lab::Tracks& t = found.tracks;
  const double scale = scale_of(call, t);
  push_record(L, "rows", static_cast<double>(t.rows), "columns", static_cast<double>(t.columns), "frames",
              static_cast<double>(t.frames), "scale", scale);
  set_scaled(L, "x", t.x, scale);
  set_scaled(L, "y", t.y, scale);
  put(L, "doubtful", [&] { push_doubts(L, found.doubts); });
  return 1;
}

int correlate(Call& call) {
  lua_State* L = call.L();
  const lab::PhotographSeries series = series_of(call);
  lab::CorrelationOptions options;
  const int side = call.count("subset");
  if (side % 2 == 0)
    call.refuse("subset",
                "expected an odd number of pixels, which has a middle, got " + std::to_string(side));
  options.half = side / 2;
  options.step = call.has("step") ? call.count("step") : options.half;
  options.search = call.count("search");
  options.gauge = call.count("gauge");
  if (options.gauge % 2 == 0)
    call.refuse("gauge", "expected an odd number of subsets, got " + std::to_string(options.gauge));
  const lab::CorrelatedSubsets out = photographs(call).correlate(series, options);
  const double scale = call.has("scale") ? call.number("scale") : 1;
  push_record(L, "rows", static_cast<double>(out.rows), "columns", static_cast<double>(out.columns), "frames",
              static_cast<double>(series.names.size()), "scale", scale);
  set_scaled(L, "x", out.x, scale);
  set_scaled(L, "y", out.y, scale);
  set_scaled(L, "deviation", out.deviation, scale);
  put(L, "E11", out.E11, "E22", out.E22, "E12", out.E12, "correlation", out.correlation, "found", out.found);
  return 1;
}

// The map {F11, F12, F21, F22} of the cloth; a picture's y axis points downwards.
void read_map(const Call& call, std::array<double, 4>& map) {
  if (!call.has("F")) return;
  const auto F = call.numbers("F");
  if (F.size() != 4 || F[0] * F[3] - F[1] * F[2] <= 0)
    call.refuse("F", "expected {F11, F12, F21, F22} of positive determinant");
  map = {F[0], -F[1], -F[2], F[3]};
}

Argument map_(const std::string& about) {
  return Argument{"F", numbers, "", everything,
                  "{F11, F12, F21, F22}: the map of the cloth" + about + ", y upwards; default: none"}
      .optional();
}

Argument size_(const char* name) { return integer_(name, Range{1, 30000}, "of the picture, pixels"); }
Argument noise_seed_() { return integer_("seed", not_negative, "of the noise").or_else(1.0); }

// Draws the scene into the `file` of the call, which it replaces.
template <class Scene>
int draw(const Call& call, Scene scene) {
  const std::string file = call.text("file");
  std::string ending = file.substr(file.size() - std::min<std::size_t>(file.size(), 4));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending != ".png") call.refuse("file", "expected a name ending in .png, got '" + file + "'");
  scene.width = call.count("width");
  scene.height = call.count("height");
  read_map(call, scene.F);
  scene.noise = call.number("noise");
  scene.seed = static_cast<std::uint64_t>(call.integer("seed"));
  if (call.session().options().check) return 0;
  system::write_file(file, photographs(call).picture(scene), system::Sync::no);
  return 0;
}

int photograph(Call& call) {
  lab::DotGrid s;
  s.rows = static_cast<std::size_t>(call.integer("rows"));
  s.columns = static_cast<std::size_t>(call.integer("columns"));
  s.pitch = call.number("pitch");
  s.radius = call.number("radius");
  if (2 * s.radius >= s.pitch) call.refuse("radius", "expected less than half of the pitch");
  s.blur = call.number("blur");
  s.ground = call.number("ground");
  s.ink = call.number("ink");
  if (s.ground == s.ink) call.refuse("ink", "expected another brightness than that of the ground");
  return draw(call, s);
}

int speckles(Call& call) {
  lab::Speckles s;
  s.size = call.number("size");
  if (call.has("shift")) {
    const auto shift = call.numbers("shift");
    if (shift.size() != 2) call.refuse("shift", "expected {x, y} in pixels, y upwards");
    s.shift = {shift[0], -shift[1]};
  }
  s.pattern = static_cast<std::uint64_t>(call.integer("pattern"));
  return draw(call, s);
}

std::vector<Entry> track_entries() {
  const auto rows_row = integer_("rows", Range{2, 10000}, "of dots, following each other along the pull (y)");
  const auto columns_row = integer_("columns", Range{2, 10000}, "of dots, across");
  const std::string name =
      "local name = os.tmpname()\nlocal lab = require 'fabric'.lab\nfor i = 1, 2 do\n"
      "  lab.photograph{ file=name..i..'.png', rows=3, columns=2, pitch=40, radius=6, width=160, "
      "height=200,\n"
      "    F={1, 0, 0, 1 + 0.1*(i - 1)} }\nend\n";
  return {
      {"fabric.lab.track{}",
       {value_("files", table, "photographs in order: PNG, JPEG, TIFF or BMP"), rows_row, columns_row,
        region_(), number_("scale?", "m", positive, "of a pixel"),
        fields_("known?",
                {integer_("from", from_one, "a marker"), integer_("to", from_one, "another"),
                 number_("distance", "m", positive, "between them on the first photograph")},
                "a known distance, instead of the scale"),
        value_("dark", boolean, "dots on lighter cloth").or_else(true),
        number_("largest", "", positive, "area of a dot, pixels").or_else(1e5),
        number_("contrast", "", Range{0, 1}, "least, black on white being 1").or_else(0.1)},
       "Follows a grid of dots through photographs: rows, columns, frames, x, y (m, or pixels without a "
       "scale; y upwards; nan: lost), scale, doubtful = { {frame, marker, lost}, ... }; lost ones are looked "
       "for again. Needs the part photographs.",
       name + "local t = lab.track{ files={name..'1.png', name..'2.png'}, rows=3, columns=2 }\n"
              "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)\n"
              "assert(t.frames == 2 and #t.doubtful == 0 and math.abs((t.y[11] - t.y[9]) / 44 - 1) < 0.01)",
       track,
       {"smallest"}},
      {"fabric.lab.photograph{}",
       {value_("file", text, "ends in .png"), rows_row, columns_row,
        number_("pitch", "pixels", positive, "of the undeformed grid"),
        number_("radius", "pixels", positive, "of an undeformed dot"), size_("width"), size_("height"),
        map_(""), number_("blur", "pixels", not_negative, "standard deviation of the lens").or_else(1.0),
        number_("noise", "", Range{0, 1}, "of a pixel, white being 1").or_else(0.01),
        number_("ground", "", Range{0, 1}, "brightness of the cloth, white being 1").or_else(0.85),
        number_("ink", "", Range{0, 1}, "brightness of the dots").or_else(0.15), noise_seed_()},
       "Makes a photograph of a dot grid under a known map, with blur and noise: for trying the tracker. "
       "Needs "
       "the part photographs.",
       name + "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)",
       photograph},
  };
}

std::vector<Entry> correlation_rows() {
  const std::string name =
      "local name, lab = os.tmpname(), require 'fabric'.lab\nfor i = 1, 2 do\n"
      "  lab.speckles{ file=name..i..'.png', width=120, height=100, F={1, 0, 0, 1 + 0.02*(i - 1)} }\nend\n";
  return {
      {"fabric.lab.correlate{}",
       {value_("files", table, "photographs in order, all of one size: PNG, JPEG, TIFF or BMP"), region_(),
        integer_("subset", Range{9, 301}, "pixels of a subset's side, odd: three speckles and more")
            .or_else(25.0),
        integer_("step?", Range{1, 1000}, "pixels between subsets; default: half of a side"),
        integer_("search", Range{1, 500},
                 "pixels that a subset may have moved since the photograph before, to be found without a "
                 "neighbour's help")
            .or_else(20.0),
        integer_("gauge", Range{3, 99}, "subsets in a row, odd, whose displacements make a strain")
            .or_else(5.0),
        number_("scale?", "m", positive, "of a pixel")},
       "Follows a speckled surface through photographs by digital image correlation: rows, columns (of "
       "subsets in the region of the first), frames, x, y (of their middles on each photograph; m, or pixels "
       "without a scale; y upwards; nan: lost, or without texture), E11, E22, E12 (Green-Lagrange), "
       "correlation, deviation (of a displacement, from what differs between the photographs), all frames x "
       "subsets; found (part of the subsets, by frame). rows, columns, x, y are a grid of markers for "
       "poisson and shear_from_bias. Needs the part photographs.",
       name + "local t = lab.correlate{ files={name..'1.png', name..'2.png'} }\n"
              "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)\n"
              "assert(t.found[2] > 0.9 and math.abs(t.E22[#t.E22 - 10] - (1.02^2 - 1)/2) < 1e-3)",
       correlate,
       {"least"}},
      {"fabric.lab.speckles{}",
       {value_("file", text, "ends in .png"), size_("width"), size_("height"),
        number_("size", "pixels", Range{0.5, 100}, "of a speckle: deviation of its round blot").or_else(2.0),
        map_(" about the middle"),
        Argument{"shift", numbers, "pixels", everything, "{x, y}, y upwards, after the map"}.optional(),
        number_("noise", "", Range{0, 1}, "of a pixel, white being 1").or_else(0.0),
        integer_("pattern", not_negative, "seed of the speckles").or_else(1.0), noise_seed_()},
       "Makes a photograph of speckled cloth under a known map, exact at every place: for trying the "
       "correlation. Needs the part photographs.",
       name + "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)",
       speckles,
       {"cover"}},
  };
}

}  // namespace

void bind_photographs(Session& session) {
  install(session, track_entries());
  install(session, correlation_rows());
}

}  // namespace fabricsh::script
