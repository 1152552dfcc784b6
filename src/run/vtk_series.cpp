#include "run/vtk_series.hpp"

#include "base/error.hpp"
#include "run/bodies.hpp"

namespace fabricsh::run {

namespace {

format::PvdSeries continued(const std::string& stem, std::size_t frames, Archive& from) {
  format::PvdPlace place;
  from(place);
  if (place.frames.size() != frames)
    throw Error("cannot go on with '" + stem + "': the number of its frames differs from what was counted");
  return {stem, place};
}

}  // namespace

VtkSeries::VtkSeries(const std::string& stem, VtkContents contents)
    : series_(stem), contents_(std::move(contents)) {}

VtkSeries::VtkSeries(const std::string& stem, VtkContents contents, Archive& from)
    : Series(from), series_(continued(stem, frames(), from)), contents_(std::move(contents)) {}

void VtkSeries::keep_place(Archive& archive, std::size_t frames) {
  format::PvdPlace place = series_.place(frames);
  archive(place);
}

// The rigid bodies in their present positions, one grid each.
std::vector<format::PvdPart> VtkSeries::bodies_of(const run::Run& run) {
  std::vector<format::PvdPart> parts;
  for (const BodyShown& body : shown_bodies(run)) {
    format::PvdPart part{body.name, body.vertices, {}};
    for (const auto& t : body.triangles) part.cells.push_back({t[0], t[1], t[2], -1});
    parts.push_back(std::move(part));
  }
  return parts;
}

void VtkSeries::write(const run::Run& run) {
  const VtkFrame frame(run, contents_);
  series_.frame(run.time(), frame.grid(), bodies_of(run));
}

}  // namespace fabricsh::run
