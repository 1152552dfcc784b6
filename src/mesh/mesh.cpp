#include "mesh/mesh.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/suggest.hpp"

namespace fabricsh::mesh {

namespace {

std::string known_sets(const Mesh& mesh) {
  std::string list;
  for (const auto& [name, ids] : mesh.sets) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "none" : list;
}

[[noreturn]] void unknown_set(const Mesh& mesh, std::string_view name) {
  std::vector<std::string> names;
  for (const auto& [known, ids] : mesh.sets) names.push_back(known);
  std::string message = "unknown set '" + std::string(name) + "'" + did_you_mean(name, names);
  message += message.back() == '?' ? " known sets: " : "; known sets: ";
  throw Error(message + known_sets(mesh));
}

std::string text(const Vec3& p) {
  char buffer[96];
  std::snprintf(buffer, sizeof buffer, "(%g, %g, %g)", p.x(), p.y(), p.z());
  return buffer;
}

// Corners of an element in use: 4, or 3 for a triangle.
std::size_t corners(const std::array<Index, 4>& element) { return element[3] < 0 ? 3 : 4; }

}  // namespace

const NodeSet& Mesh::set(std::string_view name) const {
  const auto found = sets.find(name);
  if (found == sets.end()) unknown_set(*this, name);
  return found->second;
}

std::vector<Index> Mesh::elements_in(const NodeSet& ids) const {
  std::vector<char> member(nodes.size(), 0);
  for (const Index id : ids) member[static_cast<std::size_t>(id)] = 1;
  std::vector<Index> found;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto first = elements[e].begin();
    const auto last = first + static_cast<std::ptrdiff_t>(corners(elements[e]));
    if (std::all_of(first, last, [&](Index id) { return member[static_cast<std::size_t>(id)] != 0; }))
      found.push_back(static_cast<Index>(e));
  }
  return found;
}

// Ids are shown from 1, as decks count.
void Mesh::define(const std::string& name, NodeSet ids) {
  if (name.empty()) throw Error("set: expected a name, got an empty one");
  if (ids.empty()) throw Error("set '" + name + "': no node is in it");
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const Index count = static_cast<Index>(nodes.size());
  for (const Index id : {ids.front(), ids.back()})
    if (id < 0 || id >= count)
      throw Error("set '" + name + "': expected node ids from 1 to " + std::to_string(count) + ", got " +
                  std::to_string(id + 1));
  if (in_use) {
    const auto known = sets.find(name);
    if (known != sets.end() && known->second != ids)
      throw Error("set '" + name +
                  "': a compiled model uses this mesh, whose sets stay as they were: take another name");
  }
  sets.insert_or_assign(name, std::move(ids));
}

void Mesh::define(const std::string& name, const std::function<bool(const Vec3&)>& inside) {
  NodeSet ids;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (inside(nodes[i])) ids.push_back(static_cast<Index>(i));
  define(name, std::move(ids));
}

void Mesh::map(const std::function<Vec3(const Vec3&)>& f) {
  check_unused(*this, "map");
  std::vector<Vec3> moved;
  moved.reserve(nodes.size());
  for (const Vec3& node : nodes) {
    moved.push_back(f(node));
    if (!moved.back().allFinite())
      throw Error("map: node " + std::to_string(moved.size()) + " at " + text(node) +
                  ": expected a finite position, got " + text(moved.back()));
  }
  nodes = std::move(moved);
  flat = false;
}

void check_unused(const Mesh& mesh, const char* call) {
  if (mesh.in_use) throw Error(std::string(call) + ": a compiled model uses this mesh: make a new one");
}

// The shortest edge, or the smallest height (area over longest edge; twice that for a triangle) where an
// element is skewed.
double smallest_length(const Mesh& mesh, Index element) {
  const auto& ids = mesh.elements[static_cast<std::size_t>(element)];
  const std::size_t n = corners(ids);
  const auto node = [&](std::size_t i) -> const Vec3& {
    return mesh.nodes[static_cast<std::size_t>(ids[i])];
  };
  double shortest = std::numeric_limits<double>::infinity(), longest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double edge = (node((i + 1) % n) - node(i)).norm();
    shortest = std::min(shortest, edge);
    longest = std::max(longest, edge);
  }
  // Half the product of the diagonals is a quadrilateral's area, and the product of two edges twice a
  // triangle's.
  const Vec3 a = node(2) - node(0);
  const Vec3 b = n == 4 ? Vec3(node(3) - node(1)) : Vec3(node(1) - node(0));
  const double area = (n == 4 ? 0.5 : 1.0) * a.cross(b).norm();
  return longest > 0.0 ? std::min(shortest, area / longest) : 0.0;
}

}  // namespace fabricsh::mesh
