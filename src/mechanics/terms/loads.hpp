// The loads of a model, one term each: gravity, forces and tractions (dead), pressure and moments (which
// follow the configuration), springs to ground, bands along edges.
#pragma once
#include <memory>
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/rest_shape.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// Those that the model has. mass: kg per node, kept; mass_moment: its first moment about the reference
// surface, kg m, kept. Error: a traction on a set that has neither whole elements nor whole edges.
std::vector<std::unique_ptr<Term>> loads_of(const model::Model& model, const std::vector<double>& mass,
                                            const std::vector<double>& mass_moment, const RestShape& rest,
                                            const Freedoms& freedoms);

}  // namespace fabricsh::mechanics
