#include "run/vtk_series.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "run/bodies.hpp"

namespace fabricsh::run {

using run::FieldPart;
using run::ResultField;
using run::Shape;

format::Array array_of(const run::Run& run, const ResultField& field) {
  return {field.name, static_cast<int>(field.size()), values_of(run, {&field, -1}), field.labels};
}

namespace {

format::PvdSeries continued(const std::string& stem, std::size_t frames, Archive& from) {
  format::PvdPlace place;
  from(place);
  if (place.frames.size() != frames)
    throw Error("cannot go on with '" + stem + "': the number of its frames differs from what was counted");
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
  format::PvdPlace place = series_.place();
  archive(place);
}

void VtkSeries::check_fields() const {
  for (const auto& field : fields_) {
    try {
      run::find_field(field);
    } catch (const Error& unknown) {
      throw Error(std::string("vtk: field 'fields': ") + unknown.what());
    }
  }
}

// The field with only the requested values; without a request the whole field.
format::Array VtkSeries::chosen(const run::Run& run, const ResultField& field) const {
  std::vector<int> numbers;
  bool whole = fields_.empty() && field.usual;
  for (const std::string& name : fields_) {
    const FieldPart part = run::find_field(name);
    if (part.field != &field) continue;
    whole = whole || part.component < 0 || field.size() == 1 || field.shape == Shape::vector;
    if (std::find(numbers.begin(), numbers.end(), part.component) == numbers.end())
      numbers.push_back(part.component);
  }
  if (whole) return array_of(run, field);
  format::Array array{field.name, static_cast<int>(numbers.size()), {}, {}};
  if (numbers.empty()) return array;
  const std::vector<double> all = values_of(run, {&field, -1});
  for (const int c : numbers) array.component_names.push_back(field.labels[c]);
  for (std::size_t i = 0; i < all.size(); i += field.size())
    for (const int c : numbers) array.values.push_back(all[i + c]);
  return array;
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
  const auto& mesh = run.model().mesh();
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    points.push_back(run.node(static_cast<mesh::Index>(i)).x);
  format::Grid grid{points, mesh.elements};
  grid.time = run.time();
  for (const ResultField& field : run::result_fields()) {
    if (!has(run, field)) continue;
    format::Array array = chosen(run, field);
    if (array.components == 0) continue;
    (field.place == run::Place::node ? grid.point_data : grid.cell_data).push_back(std::move(array));
  }
  series_.frame(run.time(), grid, bodies_of(run));
}

}  // namespace fabricsh::run
