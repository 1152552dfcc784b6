#include "mesh/mesh.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/suggest.hpp"
#include "base/utf8.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::mesh {

namespace {

[[noreturn]] void unknown_set(const Mesh& mesh, std::string_view name) {
  const auto names = mesh.set_names();
  const std::string whole = std::string(name) + ".all";  // of a body
  const bool body = std::find(names.begin(), names.end(), whole) != names.end();
  std::string message = "unknown set '" + std::string(name) + "'" +
                        (body ? ", did you mean '" + whole + "'?" : did_you_mean(name, names)),
              list;
  message += message.back() == '?' ? " known sets: " : "; known sets: ";
  for (const auto& known : names) list += (list.empty() ? "" : ", ") + known;
  throw Error(message + (list.empty() ? "none" : list));
}

std::string text(const Vec3& p) {
  return "(" + number(p.x()) + ", " + number(p.y()) + ", " + number(p.z()) + ")";
}

}  // namespace

const NodeSet& Mesh::set(std::string_view name) const {
  if (whole) return set_of_whole(name);
  if (const auto found = sets.find(name); found != sets.end()) return found->second;
  if (const NodeSet* of_part = set_of_part(name)) return *of_part;
  unknown_set(*this, name);
}

const NodeSet* Mesh::set_of_part(std::string_view name) const {
  for (const Part& part : parts) {
    if (name.size() <= part.name.size() || name.substr(0, part.name.size()) != part.name ||
        name[part.name.size()] != '.')
      continue;
    const auto found = part.mesh->sets.find(name.substr(part.name.size() + 1));
    if (found == part.mesh->sets.end()) continue;
    Borrowed& known = borrowed_[std::string(name)];
    if (known.here.empty() || known.own != found->second) {
      known.own = known.here = found->second;
      for (Index& id : known.here) id += part.first_node;
    }
    return &known.here;
  }
  return nullptr;
}

// The nodes of the set, and the further ones at their places.
const NodeSet& Mesh::set_of_whole(std::string_view name) const {
  const NodeSet& own = whole->set(name);
  Borrowed& known = borrowed_[std::string(name)];
  if (!known.here.empty() && known.own == own) return known.here;
  known.own = known.here = own;
  std::vector<char> member(whole->nodes.size(), 0);
  for (const Index id : own) member[static_cast<std::size_t>(id)] = 1;
  for (std::size_t n = whole->nodes.size(); n < nodes.size(); ++n)
    if (member[static_cast<std::size_t>(place[n])] != 0) known.here.push_back(static_cast<Index>(n));
  return known.here;
}

std::vector<std::string> Mesh::set_names() const {
  if (whole) return whole->set_names();
  std::vector<std::string> names;
  for (const auto& [name, ids] : sets) names.push_back(name);
  for (const Part& part : parts)
    for (const auto& [name, ids] : part.mesh->sets) names.push_back(part.name + "." + name);
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

// The warp of a joined mesh, if a part has one. A flat part without one gets the default of flat meshes.
void join_warp(Mesh& joined) {
  const auto has_none = [](const Mesh::Part& part) { return part.mesh->warp.empty(); };
  if (std::all_of(joined.parts.begin(), joined.parts.end(), has_none)) return;
  for (const auto& part : joined.parts) {
    joined.warp.insert(joined.warp.end(), part.mesh->warp.begin(), part.mesh->warp.end());
    joined.warp.resize(static_cast<std::size_t>(part.first_element) + part.mesh->elements.size(),
                       part.mesh->flat ? Vec3(Vec3::UnitX()) : Vec3(Vec3::Zero()));
  }
}

}  // namespace

Mesh join(const std::vector<std::pair<std::string, std::shared_ptr<const Mesh>>>& parts) {
  Mesh joined;
  joined.flat = true;
  for (const auto& [name, mesh] : parts) {
    if (name.empty() || name.find('.') != std::string::npos)
      throw Error("bodies: expected a name without a full stop for every body, got '" + name + "'");
    want_plain(name, "bodies");
    for (const auto& before : joined.parts)
      if (before.name == name) throw Error("bodies: expected different names, got '" + name + "' twice");
    const auto first = static_cast<Index>(joined.nodes.size());
    joined.parts.push_back({name, mesh, first, static_cast<Index>(joined.elements.size())});
    joined.nodes.insert(joined.nodes.end(), mesh->nodes.begin(), mesh->nodes.end());
    for (auto element : mesh->elements) {
      for (Index& id : element)
        if (id >= 0) id += first;
      joined.elements.push_back(element);
    }
    joined.flat = joined.flat && mesh->flat;
    joined.slit_parts += mesh->slit_parts;
    joined.origin += (joined.origin.empty() ? "" : ", ") + name + " (" + mesh->origin + ")";
  }
  join_warp(joined);
  NodeSet all(joined.nodes.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  joined.sets.emplace("all", std::move(all));
  return joined;
}

std::vector<Index> Mesh::elements_in(const NodeSet& ids) const {
  std::vector<char> member(nodes.size(), 0);
  for (const Index id : ids) member[static_cast<std::size_t>(id)] = 1;
  std::vector<Index> found;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto first = elements[e].begin();
    const auto last = first + static_cast<std::ptrdiff_t>(corner_count(elements[e]));
    if (std::all_of(first, last, [&](Index id) { return member[static_cast<std::size_t>(id)] != 0; }))
      found.push_back(static_cast<Index>(e));
  }
  return found;
}

// Messages count nodes from 1, as decks do.
void Mesh::define(const std::string& name, NodeSet ids) {
  if (name.empty()) throw Error("set: expected a name, got an empty one");
  want_plain(name, "set");
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
  for (std::size_t e = 0; e < warp.size(); ++e) warp[e] = moved_warp(e, moved);
  nodes = std::move(moved);
  flat = false;
}

bool Mesh::has_warp() const {
  return !warp.empty() && std::none_of(warp.begin(), warp.end(), [](const Vec3& w) { return w.isZero(0); });
}

// The warp is a combination of two lines of the element, the diagonals or two edges, and stays the same one.
Vec3 Mesh::moved_warp(std::size_t element, const std::vector<Vec3>& moved) const {
  const auto& ids = elements[element];
  const std::size_t last = corner_count(ids) - 1;
  const auto lines = [&](const std::vector<Vec3>& x) {
    const auto line = [&](std::size_t from, std::size_t to) -> Vec3 {
      return x[static_cast<std::size_t>(ids[to])] - x[static_cast<std::size_t>(ids[from])];
    };
    Eigen::Matrix<double, 3, 2> both;
    both << line(0, 2), line(1, last == 3 ? 3 : 0);
    return both;
  };
  const Eigen::Matrix<double, 3, 2> before = lines(nodes);
  const Eigen::Matrix2d metric = before.transpose() * before;
  const Vec3 now = lines(moved) * metric.inverse() * (before.transpose() * warp[element]);
  return now.norm() > 0 && now.allFinite() ? Vec3(now.normalized()) : Vec3(Vec3::Zero());
}

void check_unused(const Mesh& mesh, const char* call) {
  if (mesh.in_use) throw Error(std::string(call) + ": a compiled model uses this mesh: make a new one");
}

}  // namespace fabricsh::mesh
