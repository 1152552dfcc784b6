#include "run/vtk_frame.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "run/readings.hpp"

namespace fabricsh::run {

namespace {

std::vector<Vec3> points_of(const Readings& run, bool reference) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < run.model().mesh().nodes.size(); ++i) {
    const NodeValues node = run.node(static_cast<mesh::Index>(i));
    points.push_back(reference ? node.X : node.x);
  }
  return points;
}

// 11 22 23 13 12 as VTK has symmetric tensors: 11 22 33 12 23 13. Across the sheet there is neither strain
// (its thickness stays) nor stress.
format::Array six(format::Array five) {
  format::Array out{five.name, 6, {}, {}, false, five.unit};
  const std::string letter = five.component_names[0].substr(0, five.component_names[0].size() - 2);
  for (const char* pair : {"11", "22", "33", "12", "23", "13"}) out.component_names.push_back(letter + pair);
  for (std::size_t i = 0; i < five.values.size(); i += 5) {
    const double* v = &five.values[i];
    out.values.insert(out.values.end(), {v[0], v[1], 0, v[4], v[2], v[3]});
  }
  return out;
}

bool has_array(const std::vector<format::Array>& arrays, const std::string& name) {
  return std::any_of(arrays.begin(), arrays.end(), [&name](const auto& a) { return a.name == name; });
}

// The array of a field, of one ply or (empty) of all, with the wanted numbers alone; without components if
// none is wanted.
format::Array chosen(const Readings& run, const std::vector<std::string>& fields, const ResultField& field,
                     const std::string& ply) {
  std::vector<int> numbers;
  const FieldPart all_of_it{&field, -1, ply};
  bool whole = fields.empty() && field.usual;
  whole = whole || field.name == "displacement" || field.name == "reference";
  for (const std::string& name : fields) {
    const FieldPart part = find_field(run, name);
    if (part.field != &field || part.ply != ply) continue;
    whole = whole || part.component < 0 || field.size() == 1 || field.shape == FieldShape::vector;
    if (std::find(numbers.begin(), numbers.end(), part.component) == numbers.end())
      numbers.push_back(part.component);
  }
  if (whole) return array_of(run, all_of_it);
  format::Array array{all_of_it.array(), static_cast<int>(numbers.size()), {}, {}, false, field.unit};
  if (numbers.empty()) return array;
  const std::vector<double> all = values_of(run, all_of_it);
  for (const int c : numbers) array.component_names.push_back(field.labels[c]);
  for (std::size_t i = 0; i < all.size(); i += field.size())
    for (const int c : numbers) array.values.push_back(all[i + c]);
  return array;
}

// The plies that the names ask for, each once; first "", all together.
std::vector<std::string> plies_of(const Readings& run, const std::vector<std::string>& fields) {
  std::vector<std::string> plies = {""};
  for (const std::string& name : fields)
    if (const std::string ply = find_field(run, name).ply;
        std::find(plies.begin(), plies.end(), ply) == plies.end())
      plies.push_back(ply);
  return plies;
}

}  // namespace

format::Array array_of(const Readings& run, const FieldPart& part) {
  const ResultField& field = *part.field;
  format::Array array{part.array(),
                      static_cast<int>(field.size()),
                      values_of(run, {&field, -1, part.ply}),
                      field.labels,
                      false,
                      field.unit};
  return field.shape == FieldShape::tensor ? six(std::move(array)) : array;
}

void check_fields(const Readings& run, const VtkContents& contents, const std::string& call) {
  for (const auto& field : contents.fields) {
    try {
      find_field(run, field);
    } catch (const Error& unknown) {
      throw Error(call + ": field 'fields': " + unknown.what());
    }
  }
}

VtkFrame::VtkFrame(const Readings& run, const VtkContents& contents)
    : points_(points_of(run, contents.reference)), grid_{points_, run.model().mesh().elements} {
  grid_.time = run.time();
  for (const std::string& ply : plies_of(run, contents.fields))
    for (const ResultField* field : fields_of(run))
      if (ply.empty() || field->by_ply) add_field(run, contents, *field, ply);
  add_sets(run);
}

void VtkFrame::add_field(const Readings& run, const VtkContents& contents, const ResultField& field,
                         const std::string& ply) {
  if (ply.empty() && !has(run, field)) return;
  format::Array array = chosen(run, contents.fields, field, ply);
  if (array.components == 0) return;
  if (field.place == FieldPlace::node) return grid_.point_data.push_back(std::move(array));
  if (contents.averaged && field.continuous) add_average(run, array, field.shape == FieldShape::vector);
  grid_.cell_data.push_back(std::move(array));
}

// The values that recovery finds at the nodes. Directions stay of length 1.
void VtkFrame::add_average(const Readings& run, format::Array array, bool directions) {
  const auto size = static_cast<std::size_t>(array.components);
  if (recovery_ == nullptr) recovery_ = std::make_unique<Recovery>(run);
  array.values = recovery_->at_nodes(array.values, size);
  for (std::size_t i = 0; i < array.values.size() && directions; i += size) {
    const double length = Eigen::Map<const Eigen::VectorXd>(&array.values[i], array.components).norm();
    for (std::size_t c = 0; c < size && length > 0; ++c) array.values[i + c] /= length;
  }
  grid_.point_data.push_back(std::move(array));
}

// A set with the name of another array is written as "set NAME".
void VtkFrame::add_sets(const Readings& run) {
  for (const std::string& name : run.model().mesh().set_names()) {
    const mesh::NodeSet& ids = run.model().mesh().set(name);
    if (ids.size() == points_.size()) continue;
    format::Array array{has_array(grid_.point_data, name) ? "set " + name : name, 1,
                        std::vector<double>(points_.size(), 0.0)};
    for (const mesh::Index id : ids) array.values[static_cast<std::size_t>(id)] = 1;
    array.flags = true;
    grid_.point_data.push_back(std::move(array));
  }
}

}  // namespace fabricsh::run
