#include "model/parts.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "mesh/check.hpp"

namespace fabricsh::model {

namespace {

using mesh::NodeSet;

// Which nodes are connected: by edges of elements, seams, and ties of whole places.
class Connected {
 public:
  explicit Connected(const mesh::Mesh& mesh) : mesh_(mesh), part_(mesh::parts_of_nodes(mesh)) {
    lead_.resize(mesh.nodes.size());
    std::iota(lead_.begin(), lead_.end(), Index{0});
  }
  void join(const std::string& set, const std::string& other) {
    const Index part = part_.at(static_cast<std::size_t>(mesh_.set(set).front()));
    for (const auto& name : {set, other})
      for (const Index node : mesh_.set(name))
        lead_[static_cast<std::size_t>(leader(part_[static_cast<std::size_t>(node)]))] = leader(part);
  }
  // Of so many nodes from the first one on.
  std::vector<Index> parts(std::size_t first, std::size_t count) const {
    std::vector<Index> all;
    for (std::size_t n = first; n < first + count; ++n) all.push_back(leader(part_[n]));
    return all;
  }

 private:
  Index leader(Index part) const {
    while (lead_[static_cast<std::size_t>(part)] != part) part = lead_[static_cast<std::size_t>(part)];
    return part;
  }
  const mesh::Mesh& mesh_;
  std::vector<Index> part_, lead_;
};

}  // namespace

std::vector<std::string> unconnected(const Model& model) {
  const mesh::Mesh& mesh = model.mesh().uncut();
  Connected all(mesh);
  for (const auto& seam : model.all<Seam>()) all.join(seam.first, seam.second);
  for (const auto& tie : model.all<Tie>()) {
    const auto& held = tie.freedoms.translation;
    if (tie.kind == TieKind::rigid || std::find(held.begin(), held.end(), false) == held.end())
      all.join(tie.set, tie.kind == TieKind::periodic ? tie.partner : tie.set);
  }
  std::vector<std::string> told;
  std::size_t first = 0;
  for (const BodyGiven& body : model.bodies()) {
    const std::vector<Index> part = all.parts(first, body.mesh->nodes.size());
    first += part.size();
    const auto parts = static_cast<Index>(std::set<Index>(part.begin(), part.end()).size());
    if (parts - body.mesh->slit_parts < 2) continue;
    const NodeSet meeting = mesh::meeting(*body.mesh, part);
    if (!meeting.empty() || mesh::of_file(*body.mesh))
      told.push_back((body.name.empty() ? "" : "body '" + body.name + "': ") + body.mesh->origin + ": " +
                     mesh::words_of_parts(*body.mesh, parts, meeting));
  }
  return told;
}

}  // namespace fabricsh::model
