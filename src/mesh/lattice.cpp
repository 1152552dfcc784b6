#include "mesh/lattice.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::mesh {

namespace {

[[noreturn]] void refuse(const char* call, const char* field, const std::string& expected,
                         const std::string& got) {
  throw Error(std::string(call) + ": field '" + field + "': expected " + expected + ", got " + got);
}

std::string all_digits(double x) { return number(x, 10); }

}  // namespace

void check_length(const char* call, const char* field, double length) {
  if (!std::isfinite(length) || length <= 0) refuse(call, field, "a positive length, m", all_digits(length));
}

void check_count(const char* call, const char* field, Index count, Index least) {
  if (count < least || count > most_cells)
    refuse(call, field, "a count from " + std::to_string(least) + " to " + std::to_string(most_cells),
           std::to_string(count));
}

void check_angle(const char* call, const char* field, double angle, double most) {
  if (!(angle > 0 && angle <= most))
    refuse(call, field, "an angle above 0 and up to " + all_digits(most) + " degrees", all_digits(angle));
}

void check_product(const char* call, const char* fields, Index a, Index b) {
  if (a > most_cells / b)
    throw Error(std::string(call) + ": " + fields + ": expected at most " + std::to_string(most_cells) +
                " cells, got " + std::to_string(a) + " x " + std::to_string(b));
}

// Exact at multiples of 90 degrees, so that nodes on axes have no rounding beside them.
Vec3 direction(double degrees) {
  const double quarter = std::round(degrees / 90);
  const double rest = (degrees - 90 * quarter) * (std::numbers::pi / 180);
  const double c = std::cos(rest), s = std::sin(rest);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {c, s, 0};
    case 1:
      return {-s, c, 0};
    case 2:
      return {-c, -s, 0};
    default:
      return {s, -c, 0};
  }
}

Mesh fill(const Lattice& lattice, const Place& position) {
  Mesh mesh;
  mesh.nodes.reserve(static_cast<std::size_t>(lattice.width() * (lattice.rows + 1)));
  mesh.elements.reserve(static_cast<std::size_t>(lattice.columns * lattice.rows));
  for (Index j = 0; j <= lattice.rows; ++j)
    for (Index i = 0; i < lattice.width(); ++i)
      mesh.nodes.push_back(position(static_cast<double>(i) / static_cast<double>(lattice.columns),
                                    static_cast<double>(j) / static_cast<double>(lattice.rows)));
  for (Index j = 0; j < lattice.rows; ++j)
    for (Index i = 0; i < lattice.columns; ++i) {
      const Index a = lattice.node(i, j), b = lattice.node(i + 1, j);
      const Index c = lattice.node(i + 1, j + 1), d = lattice.node(i, j + 1);
      mesh.elements.push_back(lattice.clockwise ? std::array{a, d, c, b} : std::array{a, b, c, d});
    }
  return mesh;
}

NodeSet row(const Lattice& lattice, Index j) {
  NodeSet ids(static_cast<std::size_t>(lattice.width()));
  std::iota(ids.begin(), ids.end(), lattice.node(0, j));
  return ids;
}

NodeSet column(const Lattice& lattice, Index i) {
  NodeSet ids;
  for (Index j = 0; j <= lattice.rows; ++j) ids.push_back(lattice.node(i, j));
  return ids;
}

void add_sets(Mesh& mesh, const Lattice& lattice, const char* first_row, const char* last_row) {
  NodeSet all(mesh.nodes.size());
  std::iota(all.begin(), all.end(), Index{0});
  mesh.define("all", std::move(all));
  mesh.define(first_row, row(lattice, 0));
  mesh.define(last_row, row(lattice, lattice.rows));
  NodeSet boundary = row(lattice, 0);
  const auto add = [&boundary](const NodeSet& ids) {
    boundary.insert(boundary.end(), ids.begin(), ids.end());
  };
  add(row(lattice, lattice.rows));
  if (lattice.closed) {
    mesh.define("seam", column(lattice, 0));
  } else {
    mesh.define("start", column(lattice, 0));
    mesh.define("end", column(lattice, lattice.columns));
    add(column(lattice, 0));
    add(column(lattice, lattice.columns));
  }
  mesh.define("boundary", std::move(boundary));
}

}  // namespace fabricsh::mesh
