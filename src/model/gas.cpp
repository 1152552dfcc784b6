#include "model/gas.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "model/declaration_rows.hpp"
#include "model/gas_planes.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

using mesh::Index;

std::string GasGiven::name() const {
  std::string words = sets.size() == 1 ? "of set '" : "of sets '";
  for (std::size_t i = 0; i < sets.size(); ++i) words += (i > 0 ? "', '" : "") + sets[i];
  return words + "'";
}

namespace {

using EdgeRing = std::vector<Index>;

constexpr double kEmpty = 1e-9;    // volume over the power 3/2 of the surface below which nothing is enclosed
constexpr double kThick = 2;       // thicknesses: how far a rim may be from the body at which it lies
constexpr double kOfRim = 0.1;     // of a rim's mean edge: the same
constexpr double kInPlane = 1e-6;  // of the mesh: how far nodes of a plane of symmetry may be from it

[[noreturn]] void refuse(const GasGiven& gas, const std::string& what) {
  throw Error("gas " + gas.name() + ": " + what);
}

std::string place_of(const Vec3& x) {
  return "(" + number(x.x()) + ", " + number(x.y()) + ", " + number(x.z()) + ") m";
}

// Faces with any number of corners, of which those that share an edge run along it in opposite directions.
class Surface {
 public:
  Surface(const Model& model, const GasGiven& gas)
      : model_(model), mesh_(model.mesh().uncut()), gas_(gas), planes_(planes_of_gas(model)) {}

  Enclosure closed() {
    add_cloth();
    add_strips();
    add_lids();
    for (const EdgeRing& hole : holes())
      if (!is_in_planes(hole)) refuse_hole(hole);
    refuse_idle_bodies();
    orient();
    face_outwards();
    return sorted();
  }

 private:
  struct Side {
    std::size_t face;
    bool forward;  // the face runs from the lower number of a node to the higher
  };

  Vec3 at(Index n) const { return mesh_.nodes[static_cast<std::size_t>(n)]; }

  void add(EdgeRing face) {
    const std::size_t f = faces_.size();
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i], b = face[(i + 1) % face.size()];
      edges_[std::minmax(a, b)].push_back({f, a < b});
    }
    faces_.push_back(std::move(face));
  }

  void add_cloth() {
    std::set<Index> all;
    for (const auto& set : gas_.sets) {
      const auto inside = mesh_.elements_in(mesh_.set(set));
      all.insert(inside.begin(), inside.end());
    }
    for (const Zone& zone : model_.all<Zone>())
      for (const Index e : mesh_.elements_in(mesh_.set(zone.set)))
        if (all.contains(e))
          refuse(gas_, "element " + std::to_string(e + 1) + " is in the tearable zone '" + zone.set +
                           "': expected a surface that stays closed");
    for (const Index e : all) {
      const auto& n = mesh_.elements[static_cast<std::size_t>(e)];
      add(n[3] < 0 ? EdgeRing{n[0], n[1], n[2]} : EdgeRing{n[0], n[1], n[2], n[3]});
      for (const Index i : faces_.back()) nodes_.insert(i);
    }
    cloth_ = faces_.size();
    span_ = 0;
    for (const Index n : nodes_) span_ = std::max(span_, (at(n) - at(*nodes_.begin())).norm());
  }

  // Between the edges of a seam, which are drawn together and then have no area between them.
  void add_strips() {
    const auto& seams = model_.all<Seam>();
    if (seams.empty()) return;
    std::vector<std::map<Index, Index>> met(
        seams.size());  // of each node of the finer edge, one of the other
    for (const Stitch& s : work_out_seams(model_)) {
      const auto nearest = std::max_element(s.leads.begin(), s.leads.end(),
                                            [](const Lead& a, const Lead& b) { return a.weight < b.weight; });
      met[s.seam][s.node] = nearest->node;
    }
    for (std::size_t i = 0; i < seams.size(); ++i) add_strip(seams[i], met[i]);
  }

  void add_strip(const Seam& seam, const std::map<Index, Index>& met) {
    if (met.empty() || !nodes_.contains(met.begin()->first) || !nodes_.contains(met.begin()->second)) return;
    const auto& first = mesh_.set(seam.first);
    const bool in_first = std::binary_search(first.begin(), first.end(), met.begin()->first);
    const EdgeChain fine = chain_of(mesh_, in_first ? seam.first : seam.second),
                    coarse = chain_of(mesh_, in_first ? seam.second : seam.first);
    const auto other = [&](Index n) {
      const auto found = met.find(n);
      return found == met.end() ? n : found->second;
    };
    const std::size_t count = fine.nodes.size();
    for (std::size_t k = 0; k + (fine.ring ? 0 : 1) < count; ++k) {
      const Index from = fine.nodes[k], to = fine.nodes[(k + 1) % count];
      add_triangle(from, to, other(from));
      const EdgeRing way = along(coarse, other(from), other(to));
      for (std::size_t j = 0; j + 1 < way.size(); ++j) add_triangle(to, way[j + 1], way[j]);
    }
  }

  // The nodes of a chain from one to another, by the shorter way.
  static EdgeRing along(const EdgeChain& chain, Index from, Index to) {
    const auto place = [&](Index n) {
      return std::find(chain.nodes.begin(), chain.nodes.end(), n) - chain.nodes.begin();
    };
    const auto count = static_cast<std::ptrdiff_t>(chain.nodes.size());
    const std::ptrdiff_t a = place(from), b = place(to);
    if (a == count || b == count) return {};
    std::ptrdiff_t step = b < a ? -1 : 1;
    if (chain.ring && std::abs(b - a) > count / 2) step = -step;
    EdgeRing way{from};
    for (std::ptrdiff_t i = a; i != b;) {
      i = (i + step + count) % count;
      way.push_back(chain.nodes[static_cast<std::size_t>(i)]);
    }
    return way;
  }

  void add_triangle(Index a, Index b, Index c) {
    if (a != b && b != c && c != a) add({a, b, c});
  }

  // Along the edges of one face alone.
  std::vector<EdgeRing> holes() const {
    std::map<Index, std::vector<Index>> next;
    for (const auto& [edge, sides] : edges_)
      if (sides.size() == 1) {
        next[edge.first].push_back(edge.second);
        next[edge.second].push_back(edge.first);
      }
    std::vector<EdgeRing> all;
    const auto walk = [&](Index from, Index to) {
      std::erase(next[from], to);
      std::erase(next[to], from);
    };
    for (auto& [begin, ends] : next)
      while (!ends.empty()) {
        EdgeRing ring;
        for (Index n = begin; !next[n].empty();) {
          ring.push_back(n);
          const Index to = next[n].front();
          walk(n, to);
          n = to;
        }
        all.push_back(std::move(ring));
      }
    return all;
  }

  bool inside(const EdgeRing& ring, const std::string& set) const {
    const auto& nodes = mesh_.set(set);
    return std::all_of(ring.begin(), ring.end(),
                       [&](Index n) { return std::binary_search(nodes.begin(), nodes.end(), n); });
  }
  const std::string* lid_of(const EdgeRing& ring) const {
    const auto found =
        std::find_if(gas_.lids.begin(), gas_.lids.end(), [&](const auto& set) { return inside(ring, set); });
    return found == gas_.lids.end() ? nullptr : &*found;
  }
  bool is_closed_otherwise(const EdgeRing& ring) const {
    if (lid_of(ring) != nullptr) return true;
    for (const Support& s : model_.all<Support>())
      if (s.symmetry >= 0 && inside(ring, s.set)) return true;
    return std::all_of(ring.begin(), ring.end(), [&](Index n) { return is_at_seam(n); });
  }
  bool lies_in(Index n, const SymmetryPlane& plane) const {
    for (const Support& s : model_.all<Support>())
      if (s.symmetry == plane.axis && inside({n}, s.set) &&
          std::abs(at(n)[plane.axis] - plane.at) <= kInPlane * std::abs(span_))
        return true;
    return false;
  }
  // Whether each of its edges lies in a plane of symmetry, which closes the volume there.
  bool is_in_planes(const EdgeRing& ring) const {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (std::none_of(planes_.begin(), planes_.end(), [&](const SymmetryPlane& plane) {
            return lies_in(ring[i], plane) && lies_in(ring[(i + 1) % ring.size()], plane);
          }))
        return false;
    return true;
  }
  // Where three panels meet, the ends of their seams leave a hole.
  bool is_at_seam(Index n) const {
    return std::any_of(model_.all<Seam>().begin(), model_.all<Seam>().end(),
                       [&](const Seam& s) { return inside({n}, s.first) || inside({n}, s.second); });
  }
  void add_lids() {
    strips_ = faces_.size();
    for (EdgeRing& hole : holes()) {
      if (is_in_planes(hole)) continue;
      const RigidPointer body = body_at(hole);
      if (const std::string* set = lid_of(hole); body && set != nullptr)
        refuse(gas_, "field 'lids': set '" + *set + "' and the " + name_of(*body) +
                         " close the same hole, at " + place_of(at(hole.front())) + ": expected one of them");
      if (!body && !is_closed_otherwise(hole)) continue;
      add(std::move(hole));
      closed_by_.push_back(body);
    }
  }

  // --- rigid bodies that close holes

  // m, how far a rim is from a body, and at which of its nodes.
  std::pair<double, Index> away(const EdgeRing& rim, const Rigid& body) const {
    std::pair<double, Index> most{-1, -1};
    for (const Index n : rim)
      if (const double d = (at(n) - seat_on(body, at(n))).norm(); d > most.first) most = {d, n};
    return most;
  }
  // m, by which a rim may be away from a body that it lies at: cloth is as far as it is thick, and coarse
  // cloth farther.
  double near(const EdgeRing& rim) const {
    double thickness = 0;
    for (const auto& section : model_.sections()) thickness = std::max(thickness, section.thickness);
    return std::max(kThick * thickness, kOfRim * round(rim) / static_cast<double>(rim.size()));
  }
  RigidPointer body_at(const EdgeRing& rim) const {
    for (const RigidPointer& body : gas_.bodies)
      if (away(rim, *body).first <= near(rim)) return body;
    return nullptr;
  }
  double round(const EdgeRing& ring) const {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum += (at(ring[(i + 1) % ring.size()]) - at(ring[i])).norm();
    return sum;
  }
  std::string name_of(const Rigid& body) const { return model_.interactions().name_of(body); }

  // Of the body that is nearest to a hole which nothing closes.
  std::string gap_words(const EdgeRing& hole) const {
    std::pair<double, Index> least{0, -1};
    std::string words;
    for (const RigidPointer& body : gas_.bodies) {
      const auto gap = away(hole, *body);
      if (!words.empty() && gap.first >= least.first) continue;
      least = gap;
      words = "; the " + name_of(*body) + " is " + number(gap.first) + " m away from its node " +
              std::to_string(gap.second + 1) + ", at " + place_of(at(gap.second)) + ", expected at most " +
              number(near(hole)) + " m";
    }
    return words;
  }
  void refuse_idle_bodies() const {
    for (const RigidPointer& body : gas_.bodies)
      if (std::find(closed_by_.begin(), closed_by_.end(), body) == closed_by_.end())
        refuse(gas_, "the " + name_of(*body) +
                         " closes no hole: expected a hole of the surface whose rim lies at it");
  }

  [[noreturn]] void refuse_hole(const EdgeRing& hole) const {
    Vec3 centre = Vec3::Zero();
    std::string nodes;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      centre += at(hole[i]) / static_cast<double>(hole.size());
      if (i < 6) nodes += (i > 0 ? ", " : "") + std::to_string(hole[i] + 1);
    }
    if (hole.size() > 6) nodes += ", ...";
    std::string name;
    for (const auto& set : mesh_.set_names())
      if (inside(hole, set) && (name.empty() || mesh_.set(set).size() <= mesh_.set(name).size())) name = set;
    refuse(gas_, "the surface has a hole, " + number(round(hole)) + " m round, at " + place_of(centre) +
                     ", along the nodes " + nodes + (name.empty() ? "" : " of set '" + name + "'") +
                     gap_words(hole) +
                     ": expected a surface that closes, a seam along the hole, or something that closes it, "
                     "lids=" +
                     (name.empty() ? "{ the set of its nodes }" : "'" + name + "'"));
  }

  // Turns faces so that neighbours agree, from the first one on.
  void orient() {
    std::vector<int> turned(faces_.size(), -1);
    std::vector<std::vector<std::pair<std::size_t, bool>>> neighbours(faces_.size());
    for (const auto& [edge, sides] : edges_) {
      if (sides.size() > 2)
        refuse(gas_, std::to_string(sides.size()) + " faces meet at the edge between nodes " +
                         std::to_string(edge.first + 1) + " and " + std::to_string(edge.second + 1) +
                         ", at " + place_of(at(edge.first)) +
                         ": expected two, as in a surface that closes once");
      if (sides.size() < 2) continue;
      const bool agree = sides[0].forward != sides[1].forward;
      neighbours[sides[0].face].emplace_back(sides[1].face, agree);
      neighbours[sides[1].face].emplace_back(sides[0].face, agree);
    }
    std::vector<std::size_t> reached{0};
    turned[0] = 0;
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const auto& [next, agree] : neighbours[reached[i]]) {
        const int wanted = agree ? turned[reached[i]] : 1 - turned[reached[i]];
        if (turned[next] >= 0 && turned[next] != wanted)
          refuse(gas_, "the surface has only one side, like a Moebius strip: expected one that closes");
        if (turned[next] >= 0) continue;
        turned[next] = wanted;
        reached.push_back(next);
      }
    if (reached.size() < faces_.size()) refuse_parts(turned);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (turned[f] > 0) std::reverse(faces_[f].begin(), faces_[f].end());
  }

  [[noreturn]] void refuse_parts(const std::vector<int>& turned) const {
    const auto other = static_cast<std::size_t>(std::find(turned.begin(), turned.end(), -1) - turned.begin());
    refuse(gas_, "the surface is in several parts, around " + place_of(at(faces_[0][0])) + " and around " +
                     place_of(at(faces_[other][0])) + ": expected one volume for each call, with set=");
  }

  void face_outwards() {
    double volume = 0, area = 0;
    const Vec3 from = apex_of_gas(model_, at(faces_[0][0]));
    for (const EdgeRing& face : faces_) {
      Vec3 centre = Vec3::Zero();
      for (const Index n : face) centre += (at(n) - from) / static_cast<double>(face.size());
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = at(face[i]) - from, b = at(face[(i + 1) % face.size()]) - from;
        volume += centre.dot(a.cross(b)) / 6;
        area += (a - centre).cross(b - centre).norm() / 2;
      }
    }
    if (!(std::abs(volume) > kEmpty * std::pow(area, 1.5)))
      refuse(gas_, "the surface encloses nothing, " + number(std::abs(volume)) + " m3 with " + number(area) +
                       " m2: expected a volume at the start, as between sheets that lie apart");
    if (volume < 0)
      for (EdgeRing& face : faces_) std::reverse(face.begin(), face.end());
  }

  BodyLid closed(EdgeRing rim, const RigidPointer& body) const {
    try {
      return body_lid(std::move(rim), mesh_, body, name_of(*body));
    } catch (const Error& error) {
      refuse(gas_, error.what());
    }
  }

  Enclosure sorted() {
    Enclosure all;
    const auto as_face = [](const EdgeRing& r) {
      return std::array<Index, 4>{r[0], r[1], r[2], r.size() == 4 ? r[3] : -1};
    };
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (f >= strips_ && closed_by_[f - strips_])
        all.bodies.push_back(closed(std::move(faces_[f]), closed_by_[f - strips_]));
      else if (f >= strips_)
        all.lids.push_back(std::move(faces_[f]));
      else
        (f < cloth_ ? all.cloth : all.strips).push_back(as_face(faces_[f]));
    }
    return all;
  }

  const Model& model_;
  const mesh::Mesh& mesh_;
  const GasGiven& gas_;
  const std::vector<SymmetryPlane> planes_;
  double span_ = 1;  // m, of the mesh
  std::vector<EdgeRing> faces_;
  std::size_t cloth_ = 0, strips_ = 0;   // numbers of faces up to the last of the cloth, and of strips
  std::vector<RigidPointer> closed_by_;  // per lid; null: something without weight
  std::set<Index> nodes_;                // of the cloth
  std::map<std::pair<Index, Index>, std::vector<Side>> edges_;
};

void check_number(const char* field, bool good, const char* expected, double got) {
  if (!good || !std::isfinite(got))
    throw Error("gas: field '" + std::string(field) + "': expected " + expected + ", got " + number(got));
}

void check_vent(const Model& model, const GasGiven& gas, const GasVent& vent) {
  if (vent.set.empty() == (vent.area == 0))
    throw Error("gas: field 'vents': expected either a set or an area of each, got " +
                std::string(vent.set.empty() ? "neither" : "both"));
  if (!vent.set.empty() && model.mesh().elements_in(model.mesh().set(vent.set)).empty())
    throw Error("gas: field 'vents': set '" + vent.set + "' holds no whole element");
  if (!vent.to) return;
  const auto& all = model.all<GasPointer>();
  if (std::find(all.begin(), all.end(), vent.to) == all.end())
    throw Error("gas: field 'vents.to': expected a gas volume of this model that was declared before");
  if (vent.to->molar != gas.molar || vent.to->cp != gas.cp || vent.to->outside != gas.outside)
    throw Error("gas: field 'vents.to': expected a volume with the same gas and the same outside pressure");
}

}  // namespace

std::vector<SymmetryPlane> planes_of_gas(const Model& model) {
  std::vector<SymmetryPlane> first;
  for (const SymmetryPlane& plane : symmetry_planes(model))
    if (std::none_of(first.begin(), first.end(), [&](const auto& p) { return p.axis == plane.axis; }))
      first.push_back(plane);
  return first;
}

Vec3 apex_of_gas(const Model& model, const Vec3& place) {
  Vec3 apex = place;
  for (const SymmetryPlane& plane : planes_of_gas(model)) apex[plane.axis] = plane.at;
  return apex;
}

Enclosure enclosure_of(const Model& model, const GasGiven& gas) { return Surface(model, gas).closed(); }

void check(const Model& model, const GasPointer& pointer) {
  const GasGiven& gas = *pointer;
  const mesh::Mesh& mesh = model.mesh();
  if (gas.sets.empty())
    throw Error("gas: field 'set': expected the name of a set, or a list, got an empty one");
  for (const auto& set : gas.sets)
    if (mesh.elements_in(mesh.set(set)).empty())
      throw Error("gas: field 'set': set '" + set + "' holds no whole element");
  for (const auto& set : gas.lids) mesh.set(set);
  for (const auto& body : gas.bodies)
    if (body->moving() != nullptr)
      throw Error("gas: field 'lids': the " + model.interactions().name_of(*body) +
                  " changes its shape and closes no volume: expected a body that keeps it");
  field::require("gas", gas_rows(), gas);
  check_number("initial", gas.initial > -gas.outside,
               "a pressure above that of a vacuum, Pa, from -outside on", gas.initial);
  check_number("gas.molar", gas.molar > 0, "a positive mass, kg/mol", gas.molar);
  check_number("gas.cp", gas.cp > gas.specific(), "more than the gas constant over the molar mass, J/(kg K)",
               gas.cp);
  if (gas.mass && gas.initial != 0)
    throw Error("gas: field 'mass': the mass determines the pressure: expected mass= or initial=, got both");
  for (const GasVent& vent : gas.vents) check_vent(model, gas, vent);
}

}  // namespace fabricsh::model
