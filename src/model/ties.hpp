// Ties between nodes: which degrees of freedom follow which others, worked out once from the mesh.
#pragma once
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::model {

class Model;

struct Lead {
  mesh::Index node;
  double weight;
};

// A degree of freedom that follows others: a displacement along a global axis (component 0 to 2), the
// weighted sum of its leads'; or a director (component 3), equal to that of its only lead. Of a seam it is
// the place that is the weighted sum of its leads', and the director may have the direction of the weighted
// sum of several.
struct Follower {
  mesh::Index node;
  int component;
  std::vector<Lead> leads;  // not followers themselves; ascending nodes, each once
  bool sewn = false;
};

struct Ties {
  std::vector<Follower> followers;    // sorted by node, then component
  std::vector<mesh::NodeSet> bodies;  // nodes and directors that move as one rigid body
};

// Errors: a degree of freedom tied and also fixed, moved or rotated; two different ties for one; circular
// ties; sets whose nodes do not pair (naming node and distance); a straight set that is not straight.
Ties work_out_ties(const Model& model);

}  // namespace fabricsh::model
