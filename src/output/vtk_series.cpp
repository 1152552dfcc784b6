#include "output/vtk_series.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/suggest.hpp"

namespace fabricsh::output {

namespace {

using analysis::ElementValues;
using files::Array;

Array of_elements(const std::string& name, const std::vector<ElementValues>& values,
                  const std::vector<double ElementValues::*>& members, std::vector<std::string> components) {
  Array array{name, static_cast<int>(members.size()), {}, std::move(components)};
  array.values.reserve(values.size() * members.size());
  for (const auto& v : values)
    for (const auto member : members) array.values.push_back(v.*member);
  return array;
}

void append(Array& array, const Vec3& v) { array.values.insert(array.values.end(), {v.x(), v.y(), v.z()}); }

}  // namespace

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> names = {"displacement", "velocity", "director", "E",    "S",
                                                 "residual",     "slack",    "energy",   "warp", "weft"};
  return names;
}

namespace {

files::PvdSeries continued(const std::string& stem, std::size_t frames, Archive& from) {
  files::PvdPlace place;
  from(place);
  if (place.frames.size() != frames)
    throw Error("cannot go on with '" + stem + "': frames were lost count of");
  return {stem, place};
}

}  // namespace

VtkSeries::VtkSeries(const std::string& stem, std::vector<std::string> fields)
    : series_(stem), fields_(std::move(fields)) {
  check_fields();
}

VtkSeries::VtkSeries(const std::string& stem, std::vector<std::string> fields, Archive& from)
    : Series(from), series_(continued(stem, frames(), from)), fields_(std::move(fields)) {
  check_fields();
}

void VtkSeries::keep_place(Archive& archive) {
  files::PvdPlace place = series_.place();
  archive(place);
}

void VtkSeries::check_fields() const {
  for (const auto& field : fields_) {
    if (std::find(field_names().begin(), field_names().end(), field) != field_names().end()) continue;
    std::string known;
    for (const auto& name : field_names()) known.append(" ").append(name);
    throw Error("vtk: field 'fields': unknown field '" + field + "', expected some of" + known);
  }
}

bool VtkSeries::wants(const std::string& field) const {
  return fields_.empty() || std::find(fields_.begin(), fields_.end(), field) != fields_.end();
}

void VtkSeries::write(const analysis::Run& run) {
  const auto& mesh = run.model().mesh();
  std::vector<Vec3> points;
  Array displacement{"displacement", 3, {}, {}}, velocity{"velocity", 3, {}, {}},
      director{"director", 3, {}, {}};
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const auto node = run.node(static_cast<mesh::Index>(i));
    points.push_back(node.x);
    append(displacement, node.u);
    append(velocity, node.v);
    append(director, node.n);
  }
  files::Grid grid{points, mesh.elements};
  grid.time = run.time();
  if (wants("displacement")) grid.point_data.push_back(std::move(displacement));
  if (wants("velocity") && run.moves()) grid.point_data.push_back(std::move(velocity));
  if (wants("director")) grid.point_data.push_back(std::move(director));
  const auto& values = run.elements();
  using V = ElementValues;
  if (wants("E"))
    grid.cell_data.push_back(of_elements("E", values, {&V::E11, &V::E22, &V::E23, &V::E13, &V::E12},
                                         {"E11", "E22", "E23", "E13", "E12"}));
  if (wants("S"))
    grid.cell_data.push_back(of_elements("S", values, {&V::S11, &V::S22, &V::S23, &V::S13, &V::S12},
                                         {"S11", "S22", "S23", "S13", "S12"}));
  if (wants("residual"))
    grid.cell_data.push_back(
        of_elements("residual", values, {&V::residual1, &V::residual2}, {"warp", "weft"}));
  if (wants("slack"))
    grid.cell_data.push_back(of_elements("slack", values, {&V::slack1, &V::slack2}, {"warp", "weft"}));
  if (wants("energy"))
    grid.cell_data.push_back(
        of_elements("energy", values, {&V::stored, &V::dissipated}, {"stored", "dissipated"}));
  Array warp{"warp", 3, {}, {}}, weft{"weft", 3, {}, {}};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto [along1, along2] = run.assembly().yarns(static_cast<mesh::Index>(e));
    append(warp, along1);
    append(weft, along2);
  }
  if (wants("warp")) grid.cell_data.push_back(std::move(warp));
  if (wants("weft")) grid.cell_data.push_back(std::move(weft));
  series_.frame(run.time(), grid);
}

}  // namespace fabricsh::output
