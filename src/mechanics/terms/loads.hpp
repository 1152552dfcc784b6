// The loads of a model, one term each: gravity, forces and tractions (dead), pressure and moments (which
// follow the configuration), springs to ground; and each file NAME.cpp of the folder loads, with a function
// NAME_term, which the build finds.
#pragma once
#include <memory>
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/freedoms.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// Of what loads are made. Terms may keep references.
struct LoadSite {
  const model::Model& model;
  const Cloth& cloth;
  const Freedoms& freedoms;
};

// Those that the model has, in a fixed order, in which forces are summed; those of files by name. Error: a
// traction on a set that has neither whole elements nor whole edges.
std::vector<std::unique_ptr<Term>> loads_of(const LoadSite& site);

}  // namespace fabricsh::mechanics
