#include "mechanics/height_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

double step_across_heights(const model::Model& model) {
  std::vector<double> speed;  // m/s, per region
  for (const auto& section : model.sections()) {
    double stiffness = 0, mass = 0;
    for (const auto& p : section.points) {
      stiffness += p.weight * law::stiffest(*p.law);
      mass += p.weight * p.density;
    }
    speed.push_back(std::sqrt(stiffness / mass));
  }
  double shortest = std::numeric_limits<double>::infinity();
  const auto& mesh = model.mesh();
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto region = static_cast<std::size_t>(model.region_of(static_cast<mesh::Index>(e)));
    shortest = std::min(shortest, size(mesh.elements[e], mesh.nodes) / speed[region]);
  }
  return shortest;
}

}  // namespace fabricsh::mechanics
