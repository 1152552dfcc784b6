// The frames of a run as VTK files, with the collection file that lists them (format/pvd.hpp).
#include "base/error.hpp"
#include "format/pvd.hpp"
#include "run/bodies.hpp"
#include "run/series.hpp"

namespace fabricsh::run {

namespace {

// The series that a checkpoint has counted so many frames of. Error: its files hold another number.
format::PvdSeries continued(const std::string& stem, std::size_t frames, Archive& from) {
  format::PvdPlace place;
  from(place);
  if (place.frames.size() != frames)
    throw Error("cannot go on with '" + stem + "': the number of its frames differs from what was counted");
  return {stem, place};
}

// The rigid bodies in their present positions, one grid each; surfaces with the pressure of the cloth on
// them.
std::vector<format::PvdPart> bodies_of(const Run& run) {
  std::vector<format::PvdPart> parts;
  for (const BodyShown& body : shown_bodies(run)) {
    format::PvdPart part{body.name, body.vertices, {}};
    for (const auto& t : body.triangles) part.cells.push_back({t[0], t[1], t[2], -1});
    if (!body.pressure.empty())
      part.point_data.push_back({"contact_pressure", 1, body.pressure, {}, false, "Pa"});
    parts.push_back(std::move(part));
  }
  return parts;
}

class VtkSeries final : public Series {
 public:
  VtkSeries(const std::string& stem, VtkContents contents, Archive* from)
      : Series(from),
        series_(from == nullptr ? format::PvdSeries(stem) : continued(stem, frames(), *from)),
        contents_(std::move(contents)) {}
  void sync() override { series_.sync(); }
  std::vector<std::string> lost() const override { return series_.lost(); }

 private:
  void write(const Run& run) override {
    const VtkFrame frame(run, contents_);
    series_.frame(run.time(), frame.grid(), bodies_of(run));
  }
  void cut(std::size_t frames) override { series_.keep(frames); }
  void keep_place(Archive& archive, std::size_t frames) override {
    format::PvdPlace place = series_.place(frames);
    archive(place);
  }

  format::PvdSeries series_;
  VtkContents contents_;
};

}  // namespace

std::shared_ptr<Series> make_vtk(const std::string& stem, VtkContents contents, Archive* from) {
  return std::make_shared<VtkSeries>(stem, std::move(contents), from);
}

}  // namespace fabricsh::run
