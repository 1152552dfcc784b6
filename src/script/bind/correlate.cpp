// fabric.lab.correlate and fabric.lab.speckles.
#include "script/bind/correlate.hpp"

#include <cmath>

#include "base/error.hpp"
#include "format/source.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

void set_scaled(lua_State* L, const char* name, std::vector<double> values, double scale) {
  for (double& v : values) v *= scale;
  put(L, name, values);
}

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

namespace {

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

}  // namespace

lab::PhotographSeries series_of(const Call& call) {
  auto names = call.texts("files", "names of photographs");
  if (names.size() < 2) call.refuse("files", "expected at least two photographs");
  return {std::move(names), format::read_file,
          [&call](int width, int height) { return region_of(call, width, height); }};
}

namespace {

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
  set_scaled(L, "E11", out.E11);
  set_scaled(L, "E22", out.E22);
  set_scaled(L, "E12", out.E12);
  set_scaled(L, "correlation", out.correlation);
  set_scaled(L, "deviation", out.deviation, scale);
  set_scaled(L, "found", out.found);
  return 1;
}

int speckles(Call& call) {
  const std::string file = call.text("file");
  if (file.size() < 4 || file.substr(file.size() - 4) != ".png")
    call.refuse("file", "expected a name ending in .png, got '" + file + "'");
  lab::Speckles s;
  s.width = call.count("width");
  s.height = call.count("height");
  s.size = call.number("size");
  if (call.has("F")) {
    const auto F = call.numbers("F");
    if (F.size() != 4 || F[0] * F[3] - F[1] * F[2] <= 0)
      call.refuse("F", "expected {F11, F12, F21, F22} of positive determinant");
    s.F = {F[0], -F[1], -F[2], F[3]};  // the picture's y points downwards
  }
  if (call.has("shift")) {
    const auto shift = call.numbers("shift");
    if (shift.size() != 2) call.refuse("shift", "expected {x, y} in pixels, y upwards");
    s.shift = {shift[0], -shift[1]};
  }
  s.noise = call.number("noise");
  s.pattern = static_cast<std::uint64_t>(call.integer("pattern"));
  s.seed = static_cast<std::uint64_t>(call.integer("seed"));
  return write_picture(call, s);
}

}  // namespace

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
       {value_("file", text, "ends in .png"), integer_("width", Range{1, 30000}, "of the picture, pixels"),
        integer_("height", Range{1, 30000}, "of the picture, pixels"),
        number_("size", "pixels", Range{0.5, 100}, "of a speckle: deviation of its round blot").or_else(2.0),
        Argument{"F", numbers, "", everything,
                 "{F11, F12, F21, F22}: the map of the cloth about the middle, y upwards; default: none"}
            .optional(),
        Argument{"shift", numbers, "pixels", everything, "{x, y}, y upwards, after the map"}.optional(),
        number_("noise", "", Range{0, 1}, "of a pixel, white being 1").or_else(0.0),
        integer_("pattern", not_negative, "seed of the speckles").or_else(1.0),
        integer_("seed", not_negative, "of the noise").or_else(1.0)},
       "Makes a photograph of speckled cloth under a known map, exact at every place: for trying the "
       "correlation. Needs the part photographs.",
       name + "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)",
       speckles,
       {"cover"}},
  };
}

}  // namespace fabricsh::script
