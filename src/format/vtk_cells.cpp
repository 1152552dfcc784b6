#include "format/vtk_cells.hpp"

#include <vtkCellType.h>

#include <array>

namespace fabricsh::format {

namespace {

constexpr std::size_t most_values = 256;

// The distinct values, ascending; stops when there are more than most_values.
std::set<std::int64_t> distinct(std::span<const std::int64_t> values) {
  std::set<std::int64_t> found;
  for (const std::int64_t value : values)
    if (found.insert(value).second && found.size() > most_values) break;
  return found;
}

}  // namespace

std::span<const std::int64_t> VtkCells::corners(std::size_t cell) const {
  const std::int64_t begin = cell == 0 ? 0 : ends[cell - 1];
  return std::span(connectivity)
      .subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(ends[cell] - begin));
}

VtkMesh::VtkMesh(const Source& source, VtkCells cells)
    : source_(source), cells_(std::move(cells)), builder_(source) {
  check_ends();
  for (std::size_t i = 0; i + 2 < cells_.points.size(); i += 3)
    builder_.add_node(static_cast<std::int64_t>(i / 3),
                      Vec3(cells_.points[i], cells_.points[i + 1], cells_.points[i + 2]));
  for (std::size_t cell = 0; cell < cells_.count(); ++cell) add_cell(cell);
}

void VtkMesh::check_ends() const {
  if (cells_.types.size() != cells_.count())
    source_.fail("expected a type for each of " + std::to_string(cells_.count()) + " cells, got " +
                 std::to_string(cells_.types.size()));
  std::int64_t before = 0;
  const auto all = static_cast<std::int64_t>(cells_.connectivity.size());
  for (std::size_t cell = 0; cell < cells_.count(); ++cell) {
    const std::int64_t end = cells_.ends[cell];
    if (end < before || end > all)
      source_.fail("cell " + std::to_string(cell) + ": expected an offset from " + std::to_string(before) +
                   " to " + std::to_string(all) + ", got " + std::to_string(end));
    before = end;
  }
  if (before != all)
    source_.fail("the cells have " + std::to_string(before) + " corners in all, but the connectivity has " +
                 std::to_string(all));
}

void VtkMesh::add_cell(std::size_t cell) {
  const auto number = static_cast<std::int64_t>(cell);
  const std::string who = "cell " + std::to_string(cell);
  const auto corners = cells_.corners(cell);
  const std::int64_t type = cells_.types[cell];
  for (const std::int64_t node : corners)
    if (!builder_.has_node(node))
      source_.fail(who + ": expected points from 0 to " +
                   std::to_string(static_cast<std::int64_t>(points()) - 1) + ", got " + std::to_string(node));
  if (type == VTK_VERTEX || type == VTK_POLY_VERTEX || type == VTK_LINE || type == VTK_POLY_LINE) return;
  if (type == VTK_QUADRATIC_EDGE || type == VTK_QUADRATIC_TRIANGLE || type == VTK_QUADRATIC_QUAD ||
      type == VTK_BIQUADRATIC_QUAD)
    source_.fail(who + " is of second order (type " + std::to_string(type) +
                 "): expected lines, triangles and quadrilaterals of first order");
  if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_PIXEL && type != VTK_POLYGON)
    source_.fail(who + ": expected a vertex, line, triangle or quadrilateral, got type " +
                 std::to_string(type));
  const std::size_t n = type == VTK_TRIANGLE ? 3 : type == VTK_POLYGON ? corners.size() : 4;
  if (corners.size() != n || n < 3 || n > 4)
    source_.fail(who + ": expected " + (n < 3 || n > 4 ? "3 or 4" : std::to_string(n)) + " corners, got " +
                 std::to_string(corners.size()));
  if (type == VTK_PIXEL)
    builder_.add_element(number, std::array{corners[0], corners[1], corners[3], corners[2]});
  else
    builder_.add_element(number, corners);
}

std::vector<std::int64_t> VtkMesh::nodes_where(std::int64_t value, bool on_cells,
                                               std::span<const std::int64_t> values) const {
  std::vector<std::int64_t> nodes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != value) continue;
    if (!on_cells) {
      nodes.push_back(static_cast<std::int64_t>(i));
    } else {
      const auto corners = cells_.corners(i);
      nodes.insert(nodes.end(), corners.begin(), corners.end());
    }
  }
  return nodes;
}

void VtkMesh::add_sets(const std::string& name, bool on_cells, std::span<const std::int64_t> values) {
  const auto found = distinct(values);
  if (name.empty() || found.size() > most_values || found.empty()) return;
  if (*found.begin() >= 0 && *found.rbegin() <= 1) {
    if (*found.rbegin() == 1) builder_.add_to_set(name, nodes_where(1, on_cells, values));
    return;
  }
  if (found.size() == values.size() && found.size() > 2) return;
  for (const std::int64_t value : found)
    builder_.add_to_set(name + "_" + std::to_string(value), nodes_where(value, on_cells, values));
}

}  // namespace fabricsh::format
