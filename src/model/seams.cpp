#include "model/seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/edges.hpp"
#include "model/model.hpp"
#include "model/rest_mesh.hpp"

namespace fabricsh::model {

using mesh::Index;

namespace {

constexpr double kOnNode = 1e-3;    // of an element's edge: a stitch as near to a node joins that node alone
constexpr double kTogether = 1e-4;  // of the mean edge: how far apart edges may be that lie on each other
constexpr double kEqual = 1e-9;     // of their sum: distances that differ by less are equal

[[noreturn]] void refuse(const Seam& seam, const std::string& what) {
  throw Error("seam " + seam.name() + ": " + what);
}

std::string metres(double length) { return number(length) + " m"; }

using Neighbours = std::map<Index, std::vector<Index>>;

// Of each node of the set, those of it at the other ends of its edges on the boundary.
Neighbours neighbours_in(const mesh::Mesh& mesh, const std::string& set) {
  const mesh::NodeSet& nodes = mesh.set(set);
  const auto has = [&](Index n) { return std::binary_search(nodes.begin(), nodes.end(), n); };
  Neighbours all;
  mesh::for_each_edge(mesh::edges(mesh), [&](const mesh::Edge* begin, const mesh::Edge* end) {
    if (end - begin != 1 || !has(begin->first) || !has(begin->second)) return;
    all[begin->first].push_back(begin->second);
    all[begin->second].push_back(begin->first);
  });
  for (const Index n : nodes)
    if (!all.contains(n))
      throw Error("node " + std::to_string(n + 1) + " of set '" + set +
                  "' has no edge of the set on the boundary of the cloth: expected the nodes of an edge");
  return all;
}

// The node where a line begins: the end with the lowest number, or the lowest number of a ring.
Index first_of(const Neighbours& neighbours, const std::string& set) {
  std::vector<Index> ends;
  for (const auto& [n, others] : neighbours) {
    if (others.size() == 1) ends.push_back(n);
    if (others.size() > 2)
      throw Error("set '" + set + "' branches at node " + std::to_string(n + 1) +
                  ": expected one line of nodes along the edge, or one ring");
  }
  if (ends.size() > 2)
    throw Error("set '" + set + "' is in " + std::to_string(ends.size() / 2) +
                " pieces, which end at nodes " + std::to_string(ends[0] + 1) + ", " +
                std::to_string(ends[1] + 1) + ", " + std::to_string(ends[2] + 1) +
                "...: expected one line of nodes along the edge");
  return ends.empty() ? neighbours.begin()->first : ends.front();
}

void measure(const mesh::Mesh& mesh, EdgeChain& chain) {
  chain.along.assign(1, 0);
  for (std::size_t i = 1; i < chain.nodes.size(); ++i)
    chain.along.push_back(chain.along.back() +
                          (mesh.nodes[chain.nodes[i]] - mesh.nodes[chain.nodes[i - 1]]).norm());
  chain.length = chain.along.back();
  if (chain.ring) chain.length += (mesh.nodes[chain.nodes.front()] - mesh.nodes[chain.nodes.back()]).norm();
}

// From the other end; of a ring from its same first node the other way round.
EdgeChain turned(const mesh::Mesh& mesh, EdgeChain chain) {
  std::reverse(chain.nodes.begin() + (chain.ring ? 1 : 0), chain.nodes.end());
  measure(mesh, chain);
  return chain;
}

// A ring from its i-th node on.
EdgeChain from(const mesh::Mesh& mesh, EdgeChain ring, std::size_t i) {
  std::rotate(ring.nodes.begin(), ring.nodes.begin() + static_cast<std::ptrdiff_t>(i), ring.nodes.end());
  measure(mesh, ring);
  return ring;
}

// The place at a share of a chain's length; on the node that is as near to it as a share of the element's
// edge.
std::vector<Lead> place_at(const EdgeChain& chain, double share, double on_node) {
  const double s = share * chain.length;
  const auto above = std::upper_bound(chain.along.begin(), chain.along.end(), s);
  const auto i = static_cast<std::size_t>(above - chain.along.begin()) - 1;
  const bool last = i + 1 == chain.nodes.size();
  if (last && !chain.ring) return {{chain.nodes.back(), 1}};
  const double end = last ? chain.length : chain.along[i + 1];
  const Index a = chain.nodes[i], b = last ? chain.nodes.front() : chain.nodes[i + 1];
  const double w = (s - chain.along[i]) / (end - chain.along[i]);
  if (w < on_node) return {{a, 1}};
  if (w > 1 - on_node) return {{b, 1}};
  return {{a, 1 - w}, {b, w}};
}

// Half of the way to the nodes before and behind.
double length_at(const EdgeChain& chain, std::size_t i) {
  const std::size_t last = chain.nodes.size() - 1;
  const double before = i > 0        ? chain.along[i] - chain.along[i - 1]
                        : chain.ring ? chain.length - chain.along[last]
                                     : 0;
  const double behind = i < last     ? chain.along[i + 1] - chain.along[i]
                        : chain.ring ? chain.length - chain.along[last]
                                     : 0;
  return (before + behind) / 2;
}

Vec3 place(const mesh::Mesh& mesh, const std::vector<Lead>& leads) {
  Vec3 sum = Vec3::Zero();
  for (const Lead& lead : leads) sum += lead.weight * mesh.nodes[lead.node];
  return sum;
}

double distance(const mesh::Mesh& mesh, const Stitch& stitch) {
  return (mesh.nodes[stitch.node] - place(mesh, stitch.leads)).norm();
}

class Matching {
 public:
  // rest: the same in its stress-free shape, in which the edges have their lengths.
  Matching(const mesh::Mesh& mesh, const mesh::Mesh& rest, const Seam& seam, std::size_t which)
      : mesh_(mesh), rest_(rest), seam_(seam), which_(which) {
    if (seam.first == seam.second) refuse(seam, "an edge cannot be sewn to itself: expected two edges");
    EdgeChain a = chain_of(rest, seam.first), b = chain_of(rest, seam.second);
    if (a.ring != b.ring)
      refuse(seam, "set '" + (a.ring ? seam.first : seam.second) +
                       "' is a ring and the other is not: expected two lines or two rings");
    const double longer = std::max(a.length, b.length);
    if (std::abs(a.length - b.length) > seam.ease * longer)
      refuse(seam, "the edges are " + metres(a.length) + " and " + metres(b.length) +
                       " long: expected lengths that differ by at most " + number(100 * seam.ease) +
                       " % (field 'ease')");
    swapped_ = b.nodes.size() > a.nodes.size();
    if (swapped_) std::swap(a, b);
    fine_ = std::move(a);
    coarse_ = std::move(b);
    if (fine_.ring) align_rings();
  }

  std::vector<Stitch> stitches() {
    const EdgeChain back = turned(rest_, coarse_);
    const std::vector<Stitch> plain = matched(coarse_), other = matched(back);
    const double as_is = apart(plain), the_other = apart(other);
    const bool equal = std::abs(as_is - the_other) <= kEqual * (as_is + the_other);
    if (equal && !seam_.reverse)
      refuse(seam_, "both ways round the ends are " + metres(as_is) +
                        " apart: expected reverse=true or false, or "
                        "edges that face each other");
    const bool turn = seam_.reverse ? *seam_.reverse : the_other < as_is;
    const double mine = turn ? the_other : as_is, better = turn ? as_is : the_other;
    if (!equal && mine > better)
      refuse(seam_, "it is sewn the wrong way round, the lines between the ends cross: they are " +
                        metres(mine) + " apart, and " + metres(better) +
                        " with reverse=" + (turn ? "false" : "true") + (fine_.ring ? "" : sketch(turn)));
    std::vector<Stitch> all = turn ? other : plain;
    if (!seam_.over && !std::all_of(all.begin(), all.end(), [&](const Stitch& s) { return meets(s); }))
      all = matched(turn ? back : coarse_, false);
    std::erase_if(all, [](const Stitch& s) { return s.leads.size() == 1 && s.leads[0].node == s.node; });
    check_shared(all);
    if (!seam_.over) check_together(all);
    return all;
  }

 private:
  // paired: nodes of equal numbers are partners where they are near each other. If not, edges are one from
  // the start: what follows is moved to its place at once, so that a node as near to another as is good
  // enough for edges that are drawn together may still be too far from it.
  std::vector<Stitch> matched(const EdgeChain& coarse, bool paired = true) const {
    std::vector<Stitch> all;
    const bool one_to_one = paired && fine_.nodes.size() == coarse.nodes.size() && pairs(coarse);
    for (std::size_t i = 0; i < fine_.nodes.size(); ++i) {
      const double share = fine_.along[i] / fine_.length;
      Stitch stitch{fine_.nodes[i], {}, length_at(fine_, i), which_};
      stitch.leads = one_to_one ? std::vector<Lead>{{coarse.nodes[i], 1}} : place_at(coarse, share, kOnNode);
      if (!paired && !meets(stitch)) stitch.leads = place_at(coarse, share, 0);
      all.push_back(std::move(stitch));
    }
    return all;
  }
  // Whether a node lies where it is sewn to.
  bool meets(const Stitch& stitch) const { return distance(mesh_, stitch) <= kTogether * mean(); }
  double mean() const { return fine_.length / static_cast<double>(fine_.nodes.size()); }  // m
  // Whether each node is nearer to its partner along the edge than a quarter of an element's edge.
  bool pairs(const EdgeChain& coarse) const {
    for (std::size_t i = 0; i < fine_.nodes.size(); ++i)
      if (std::abs(fine_.along[i] / fine_.length - coarse.along[i] / coarse.length) * fine_.length >
          0.25 * length_at(fine_, i))
        return false;
    return true;
  }
  // Both edges as they lie, with the numbers of the nodes at their ends and the lines that cross.
  std::string sketch(bool turned) const {
    const auto text = [](Index node) { return std::to_string(node + 1); };
    const auto edge = [](const std::string& left, const std::string& right, const std::string& name) {
      return std::string(left.size() < 10 ? 10 - left.size() : 0, ' ') + left + " o-----------o " + right +
             "    '" + name + "'";
    };
    const auto& first = swapped_ ? seam_.second : seam_.first;
    const auto& second = swapped_ ? seam_.first : seam_.second;
    const Index left = turned ? coarse_.nodes.front() : coarse_.nodes.back(),
                right = turned ? coarse_.nodes.back() : coarse_.nodes.front();
    std::string lines = "\n" + edge(text(fine_.nodes.front()), text(fine_.nodes.back()), first) + "\n";
    for (const char* middle : {"\\         /", "  \\     /", "     X", "  /     \\", "/         \\"})
      lines += std::string(12, ' ') + middle + "\n";
    return lines + edge(text(left), text(right), second);
  }
  // m: between the ends of lines, the mean of both; of rings the mean over all nodes.
  double apart(const std::vector<Stitch>& stitches) const {
    if (!fine_.ring) return (distance(mesh_, stitches.front()) + distance(mesh_, stitches.back())) / 2;
    double sum = 0;
    for (const Stitch& s : stitches) sum += distance(mesh_, s);
    return sum / static_cast<double>(stitches.size());
  }
  // Rings begin at the two nodes that are nearest to each other.
  void align_rings() {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t at = 0, other = 0;
    for (std::size_t j = 0; j < coarse_.nodes.size(); ++j)
      for (std::size_t i = 0; i < fine_.nodes.size(); ++i) {
        const double d = (mesh_.nodes[fine_.nodes[i]] - mesh_.nodes[coarse_.nodes[j]]).norm();
        if (!(d < nearest * (1 - kEqual))) continue;
        nearest = d;
        at = i;
        other = j;
      }
    fine_ = from(rest_, std::move(fine_), at);
    coarse_ = from(rest_, std::move(coarse_), other);
  }
  // Both edges may meet in a node, as at the tip of a dart, but nowhere else.
  void check_shared(const std::vector<Stitch>& stitches) const {
    const std::set<Index> leads(coarse_.nodes.begin(), coarse_.nodes.end());
    for (const Stitch& s : stitches)
      if (leads.contains(s.node))
        refuse(seam_, "node " + std::to_string(s.node + 1) +
                          " is in both edges and would be sewn to another place: an edge cannot be sewn to "
                          "itself");
  }
  void check_together(const std::vector<Stitch>& stitches) const {
    const Stitch* worst = nullptr;
    for (const Stitch& s : stitches)
      if (!meets(s) && (worst == nullptr || distance(mesh_, s) > distance(mesh_, *worst))) worst = &s;
    if (worst == nullptr) return;
    const double d = distance(mesh_, *worst);
    refuse(
        seam_,
        "node " + std::to_string(worst->node + 1) + " is " + metres(d) +
            " from where it belongs on the other edge: expected edges that lie on each other, " +
            (d <= bulge() ? "which edges along a curve do where they have the same places of nodes, " : "") +
            "or a time in which they are drawn together (field 'over', s)");
  }
  // m, by which edges of elements part whose nodes lie in other places of the same curve: twice the height of
  // an arc over its chord, as the lengths along the chords differ, too.
  double bulge() const {
    double most = 0;
    for (const EdgeChain* chain : {&fine_, &coarse_})
      for (std::size_t i = 1; i + 1 < chain->nodes.size(); ++i) {
        const auto at = [&](std::size_t k) -> const Vec3& { return mesh_.nodes[chain->nodes[k]]; };
        const Vec3 before = at(i) - at(i - 1), behind = at(i + 1) - at(i);
        const double longer = std::max(before.norm(), behind.norm());
        most = std::max(most, (behind.normalized() - before.normalized()).norm() * longer / 4);
      }
    return most;
  }

  const mesh::Mesh &mesh_, &rest_;
  const Seam& seam_;
  std::size_t which_;
  bool swapped_ = false;  // the second edge has more nodes
  EdgeChain fine_, coarse_;
};

// Nodes that seams cannot move.
void check_nodes(const Model& model, const std::vector<Stitch>& stitches) {
  if (stitches.empty()) return;
  const mesh::Mesh& mesh = model.mesh().uncut();
  std::map<Index, std::string> taken;
  for (const Tie& tie : model.all<Tie>())
    for (const std::string& set : {tie.set, tie.kind == TieKind::periodic ? tie.partner : std::string()})
      if (!set.empty())
        for (const Index n : mesh.set(set)) taken.emplace(n, "is tied (set '" + set + "')");
  for (const Zone& zone : model.all<Zone>())
    for (const Index e : mesh.elements_in(mesh.set(zone.set)))
      for (const Index n : mesh.elements[e])
        if (n >= 0) taken.emplace(n, "is in a tearable zone (set '" + zone.set + "')");
  const auto check = [&](Index n, const Stitch& s) {
    if (const auto found = taken.find(n); found != taken.end())
      refuse(model.all<Seam>()[s.seam], "node " + std::to_string(n + 1) + " " + found->second +
                                            ": expected edges of nodes that are not");
  };
  for (const Stitch& s : stitches) {
    check(s.node, s);
    for (const Lead& lead : s.leads) check(lead.node, s);
  }
}

}  // namespace

EdgeChain chain_of(const mesh::Mesh& mesh, const std::string& set) {
  const Neighbours neighbours = neighbours_in(mesh, set);
  EdgeChain chain;
  Index before = -1, n = first_of(neighbours, set);
  const Index first = n;
  do {
    chain.nodes.push_back(n);
    const auto& others = neighbours.at(n);
    const auto next = std::find_if(others.begin(), others.end(), [&](Index o) { return o != before; });
    before = n;
    n = next == others.end() ? -1 : *next;
  } while (n >= 0 && n != first);
  chain.ring = n == first && chain.nodes.size() > 2;
  if (chain.nodes.size() < neighbours.size())
    throw Error("set '" + set + "' is in several pieces: node " + std::to_string(chain.nodes.front() + 1) +
                " is connected along the edge to " + std::to_string(chain.nodes.size() - 1) + " of its " +
                std::to_string(neighbours.size()) + " nodes");
  measure(mesh, chain);
  return chain;
}

std::vector<Stitch> work_out_seams(const Model& model) {
  std::vector<Stitch> all;
  if (model.all<Seam>().empty()) return all;
  const mesh::Mesh rest = rest_mesh(model);
  for (std::size_t i = 0; i < model.all<Seam>().size(); ++i) {
    auto own = Matching(model.mesh().uncut(), rest, model.all<Seam>()[i], i).stitches();
    all.insert(all.end(), own.begin(), own.end());
  }
  check_nodes(model, all);
  return all;
}

}  // namespace fabricsh::model
