// What the generators share: checks of their fields, and a lattice of quadrilaterals that may close on
// itself.
#pragma once
#include <functional>

#include "mesh/mesh.hpp"

namespace fabricsh::mesh {

inline constexpr Index most_cells = 1'000'000'000;

// Errors: "annulus: field 'inner': expected a positive length, m, got -1".
void check_length(const char* call, const char* field, double length);
void check_count(const char* call, const char* field, Index count, Index least = 1);
void check_angle(const char* call, const char* field, double angle, double most);
void check_product(const char* call, const char* fields, Index a, Index b);

// Unit vector in the x-y plane; exact at multiples of 90 degrees.
Vec3 direction(double degrees);

// columns x rows elements; node (i, j) is number j * width + i and lies at position(i / columns, j / rows).
// A closed lattice has its last column of nodes on its first.
struct Lattice {
  Index columns = 1, rows = 1;
  bool closed = false;
  bool clockwise = false;  // elements turn from rows to columns
  Index width() const { return closed ? columns : columns + 1; }
  Index node(Index i, Index j) const { return j * width() + (closed ? i % columns : i); }
};

using Place = std::function<Vec3(double s, double t)>;
Mesh fill(const Lattice& lattice, const Place& position);
NodeSet row(const Lattice& lattice, Index j);
NodeSet column(const Lattice& lattice, Index i);

// Names the sets of a surface of revolution: its first and last row, start and end or seam, boundary, all.
void add_sets(Mesh& mesh, const Lattice& lattice, const char* first_row, const char* last_row);

}  // namespace fabricsh::mesh
