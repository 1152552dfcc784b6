// Pressure on the faces of a surface, and the volume behind it.
#pragma once
#include <array>
#include <span>

#include "mechanics/term.hpp"

namespace fabricsh::mechanics {

using FaceNodes = std::array<Index, 4>;  // a triangle has -1 in the last place

// Adds the forces f_A = p sum_g N_A a1 x a2 of a pressure, Pa, along the normals of the faces, N. x: present
// positions, m.
void add_pressure(std::span<const FaceNodes> faces, double pressure, std::span<const double> x,
                  std::span<double> on_x);
// Adds the tangent of these forces; negative, because they are internal forces here.
void add_pressure_tangent(std::span<const FaceNodes> faces, double pressure, std::span<const double> x,
                          TangentSink& sink);
// m3: a third of the integral of the place, seen from a point, times the normal; behind a closed surface
// whose normals point outwards the volume that it encloses.
double volume_behind(std::span<const FaceNodes> faces, std::span<const double> x, const Vec3& from);
// m2
double area_of(std::span<const FaceNodes> faces, std::span<const double> x);

}  // namespace fabricsh::mechanics
