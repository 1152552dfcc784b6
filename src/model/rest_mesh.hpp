// The mesh of a model, without further nodes, in its stress-free shape: what lengths along edges are measured
// on.
#pragma once
#include "mesh/mesh.hpp"

namespace fabricsh::model {

class Model;
mesh::Mesh rest_mesh(const Model& model);

}  // namespace fabricsh::model
