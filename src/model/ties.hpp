// Ties between nodes: which freedoms follow which, worked out once from the mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::model {

class Model;

struct Lead {
  mesh::Index node;
  double weight;
};

// A freedom that follows others: a displacement along a global axis (component 0 to 2), the weighted sum of
// the leads' displacements along it; or a director (component 3), the same as its one lead's.
struct Follower {
  mesh::Index node;
  int component;
  std::vector<Lead> leads;  // none of them follows; ascending nodes, each once
};

struct Ties {
  std::vector<Follower> followers;    // ascending node, then component
  std::vector<mesh::NodeSet> bodies;  // nodes and directors that move as one rigid body
};

// Errors: a freedom tied and fixed, moved or turned; tied twice in two ways; ties that lead in a circle; sets
// whose nodes do not pair (names node and distance); a straight set that is not straight.
Ties work_out_ties(const Model& model);

}  // namespace fabricsh::model
