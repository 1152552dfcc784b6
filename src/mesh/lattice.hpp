// Shared by the generators: checks of their fields, and a
// lattice of quadrilaterals that may be closed in one direction.
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

// Unit vector in the x-y plane, exact at multiples of 90 degrees.
Vec3 direction(double degrees);

// A lattice of columns x rows elements; node (i, j) has the number j * width + i and the position
// position(i / columns, j / rows). In a closed lattice the last column of nodes is the first one.
struct Lattice {
  Index columns = 1, rows = 1;
  bool closed = false;
  bool clockwise = false;  // the elements' orientation runs from rows to columns
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
