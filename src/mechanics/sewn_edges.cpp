#include "mechanics/sewn_edges.hpp"

#include <algorithm>
#include <map>

#include "base/error.hpp"

namespace fabricsh::mechanics {

using mesh::Index;

namespace {
constexpr double kOnePiece = 0.5;  // cosine of the angle between normals up to which they become one
}

std::uint8_t SewnEdges::turning(const model::Seam& seam, std::size_t number) const {
  if (seam.hinge && *seam.hinge) return 0;
  const Index node = disagree(number);
  if (!seam.hinge) return node < 0 && continues(number) ? 1 : 0;
  if (node < 0) return 1;
  throw Error("seam " + seam.name() + ": field 'hinge': the normals of the edges at node " +
              std::to_string(node + 1) +
              " are more than 60 degrees apart: expected hinge=true, or edges whose normals agree");
}

Index SewnEdges::disagree(std::size_t seam) const {
  for (const model::Stitch& s : stitches) {
    if (s.seam != seam) continue;
    Vec3 other = Vec3::Zero();
    for (const model::Lead& lead : s.leads) other += lead.weight * director(lead.node);
    if (!(director(s.node).dot(other) >= kOnePiece * other.norm())) return s.node;
  }
  return -1;
}

bool SewnEdges::continues(std::size_t seam) const {
  std::map<Index, std::pair<Vec3, int>>
      middle;  // of the elements about each node: sum of corners, their count
  std::vector<const model::Stitch*> own;
  for (const auto& s : stitches) {
    if (s.seam != seam) continue;
    own.push_back(&s);
    middle.try_emplace(s.node, Vec3::Zero(), 0);
    for (const auto& lead : s.leads) middle.try_emplace(lead.node, Vec3::Zero(), 0);
  }
  for (const auto& e : mesh.elements)
    for (const Index n : e)
      if (const auto found = middle.find(n); n >= 0 && found != middle.end())
        for (const Index other : e)
          if (other >= 0) {
            found->second.first += place(other);
            ++found->second.second;
          }
  const auto inwards = [&](Index n) {
    const auto& [sum, count] = middle.at(n);
    return Vec3(sum / count - place(n));
  };
  double sum = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Vec3 way = place(own[std::min(i + 1, own.size() - 1)]->node) - place(own[i > 0 ? i - 1 : 0]->node);
    const Vec3 along = way.norm() > 0 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
    Vec3 one = inwards(own[i]->node), other = Vec3::Zero();
    for (const auto& lead : own[i]->leads) other += lead.weight * inwards(lead.node);
    one -= one.dot(along) * along;
    other -= other.dot(along) * along;
    sum += one.dot(other);
  }
  return sum < 0;
}

}  // namespace fabricsh::mechanics
