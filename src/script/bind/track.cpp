// fabric.lab.track and fabric.lab.photograph.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "script/bind/correlate.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

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

int photograph(Call& call) {
  std::string ending = call.text("file");
  ending.erase(0, ending.size() - std::min<std::size_t>(ending.size(), 4));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending != ".png")
    call.refuse("file", "expected a name ending in .png, got '" + call.text("file") + "'");
  lab::DotGrid s;
  s.rows = static_cast<std::size_t>(call.integer("rows"));
  s.columns = static_cast<std::size_t>(call.integer("columns"));
  s.width = call.count("width");
  s.height = call.count("height");
  s.pitch = call.number("pitch");
  s.radius = call.number("radius");
  if (2 * s.radius >= s.pitch) call.refuse("radius", "expected less than half of the pitch");
  if (call.has("F")) {
    const auto F = call.numbers("F");
    if (F.size() != 4 || F[0] * F[3] - F[1] * F[2] <= 0)
      call.refuse("F", "expected {F11, F12, F21, F22} of positive determinant");
    s.F = {F[0], -F[1], -F[2], F[3]};  // the image's y axis points downwards
  }
  s.blur = call.number("blur");
  s.noise = call.number("noise");
  s.ground = call.number("ground");
  s.ink = call.number("ink");
  if (s.ground == s.ink) call.refuse("ink", "expected another brightness than that of the ground");
  s.seed = static_cast<std::uint64_t>(call.integer("seed"));
  return write_picture(call, s);
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
        number_("radius", "pixels", positive, "of an undeformed dot"),
        integer_("width", Range{1, 30000}, "of the picture, pixels"),
        integer_("height", Range{1, 30000}, "of the picture, pixels"),
        Argument{"F", numbers, "", everything,
                 "{F11, F12, F21, F22}: the map of the cloth, y upwards; default: none"}
            .optional(),
        number_("blur", "pixels", not_negative, "standard deviation of the lens").or_else(1.0),
        number_("noise", "", Range{0, 1}, "of a pixel, white being 1").or_else(0.01),
        number_("ground", "", Range{0, 1}, "brightness of the cloth, white being 1").or_else(0.85),
        number_("ink", "", Range{0, 1}, "brightness of the dots").or_else(0.15),
        integer_("seed", not_negative, "of the noise").or_else(1.0)},
       "Makes a photograph of a dot grid under a known map, with blur and noise: for trying the tracker. "
       "Needs "
       "the part photographs.",
       name + "for i = 1, 2 do os.remove(name..i..'.png') end\nos.remove(name)",
       photograph},
  };
}

}  // namespace

void bind_track(Session& session) {
  install(session, track_entries());
  install(session, correlation_rows());
}

}  // namespace fabricsh::script
