// The pressure on triangles that bend. A triangle bends by parabolas along its edges (element/shell3.hpp), so
// that a volume lies between them and its plane, A/24 sum (x_j - x_i).(d_j - d_i) over the edges, on which a
// pressure works, too. With the means x and d of the corners it is A/8 sum (x_a - x).d_a, and a pressure p
// adds the forces p A/8 (d_a - d) on the nodes and p A/8 (x_a - x) on the directors.
#pragma once
#include <array>
#include <optional>
#include <span>

#include "mechanics/rest_shape.hpp"
#include "mechanics/term.hpp"

namespace fabricsh::mechanics {

struct Bulge {
  std::array<Index, 3> nodes;
  double area;   // m2, without stress
  double limit;  // Pa: under more the tension holds the cloth, of which this volume takes no account
  // N, for a share 1 / (1 + (p / limit)^2) of the pressure.
  double force_per_length(double pressure) const {
    return pressure * area / 8 / (1 + pressure * pressure / (limit * limit));
  }
};

// Empty: a quadrilateral, or a triangle that does not resist bending.
std::optional<Bulge> bulge_of(const model::Model& model, const RestShape& rest, Index element);

void add_pressure(std::span<const Bulge> bulges, double pressure, const Configuration& now,
                  std::span<double> on_x, std::span<double> on_d);
// Of these forces as internal ones.
void add_pressure_tangent(std::span<const Bulge> bulges, double pressure, const Configuration& now,
                          TangentSink& sink);

}  // namespace fabricsh::mechanics
