#include "mesh/matching.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "mesh/edges.hpp"

namespace fabricsh::mesh {

namespace {

constexpr auto none = static_cast<std::size_t>(-1);

std::vector<TrianglePair> candidates(const Mesh& mesh, const RankOf& rank) {
  std::vector<TrianglePair> pairs;
  const auto corners = [&](const Edge& edge) {
    return mesh.elements[static_cast<std::size_t>(edge.element)];
  };
  for_each_edge(edges(mesh), [&](const Edge* begin, const Edge* end) {
    if (end - begin != 2 || begin[0].forward == begin[1].forward) return;
    if (corners(begin[0])[3] >= 0 || corners(begin[1])[3] >= 0) return;
    const auto third = [&](const Edge& edge) {
      for (const Index id : corners(edge))
        if (id != edge.first && id != edge.second) return id;
      return Index{-1};
    };
    const Edge &one = begin[0].forward ? begin[0] : begin[1], &other = begin[0].forward ? begin[1] : begin[0];
    const std::array<Index, 4> ids{one.first, third(other), one.second, third(one)};
    if (const auto good = rank(ids); good > 0)
      pairs.push_back(
          {good, static_cast<std::size_t>(one.element), static_cast<std::size_t>(other.element), ids});
  });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const TrianglePair& a, const TrianglePair& b) { return a.rank > b.rank; });
  return pairs;
}

// Alternating paths in the graph of triangles: from a single triangle by a pair that is not
// joined to another triangle, by its joined pair to the next, and so on to a single one. Exchanging
// the pairs along the path joins both ends.
class Matching {
 public:
  Matching(std::vector<TrianglePair> pairs, std::size_t elements)
      : pairs_(std::move(pairs)), of_(elements), joined_(elements, none), on_path_(elements, 0) {
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const TrianglePair& pair = pairs_[p];
      of_[pair.first].push_back(p);
      of_[pair.second].push_back(p);
      if (joined_[pair.first] == none && joined_[pair.second] == none)
        joined_[pair.first] = joined_[pair.second] = p;
    }
  }

  void exchange(int most_new) {
    for (int changes = 1; changes <= most_new; ++changes)
      for (std::size_t t = 0; t < of_.size(); ++t) {
        if (joined_[t] != none || of_[t].empty()) continue;
        best_.clear();
        least_ = std::numeric_limits<std::int64_t>::max();
        search(t, changes, 0);
        for (const std::size_t p : best_) joined_[pairs_[p].first] = joined_[pairs_[p].second] = p;
      }
  }

  // Joins as many as can be joined (Edmonds 1965): a breadth-first search from each single triangle over
  // alternating paths, in which an odd ring of triangles that closes on itself counts as one.
  void augment();

  std::vector<TrianglePair> chosen() const {
    std::vector<TrianglePair> result;
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      if (joined_[pairs_[p].first] == p) result.push_back(pairs_[p]);
    return result;
  }

 private:
  class Search;
  std::size_t other(std::size_t pair, std::size_t t) const {
    return pairs_[pair].first == t ? pairs_[pair].second : pairs_[pair].first;
  }

  // loss: of rank on the way to the triangle t.
  void search(std::size_t t, int changes, std::int64_t loss) {
    on_path_[t] = 1;
    for (const std::size_t p : of_[t]) {
      const std::size_t next = other(p, t);
      if (p == joined_[t] || on_path_[next] != 0) continue;
      path_.push_back(p);
      const std::int64_t now = loss - pairs_[p].rank;
      if (joined_[next] == none) {
        if (now < least_) {
          least_ = now;
          best_ = path_;
        }
      } else if (const std::size_t behind = other(joined_[next], next);
                 changes > 1 && on_path_[behind] == 0) {
        on_path_[next] = 1;
        search(behind, changes - 1, now + pairs_[joined_[next]].rank);
        on_path_[next] = 0;
      }
      path_.pop_back();
    }
    on_path_[t] = 0;
  }

  std::vector<TrianglePair> pairs_;
  std::vector<std::vector<std::size_t>> of_;  // the pairs of each triangle
  std::vector<std::size_t> joined_;           // the pair that it is in
  std::vector<char> on_path_;
  std::vector<std::size_t> path_, best_;
  std::int64_t least_ = 0;
};

class Matching::Search {
 public:
  explicit Search(Matching& of) : m_(of) {}

  void from(std::size_t root) {
    reach(root, none);
    enqueue(root);
    // A search that has come so far gives up: its cost goes with the square.
    constexpr std::size_t most = 3000;
    for (std::size_t k = 0; k < queue_.size() && seen_.size() < most; ++k)
      for (const std::size_t p : m_.of_[queue_[k]])
        if (step(queue_[k], p)) return;
  }

 private:
  struct Place {
    std::size_t base;  // of the ring of triangles that the triangle belongs to, itself if of none
    std::size_t by;    // the pair that led to it and is not joined, none at the root
    bool outer;        // an even number of pairs from the root
  };

  void reach(std::size_t t, std::size_t by) { seen_.emplace(t, Place{t, by, false}); }
  void enqueue(std::size_t t) {
    if (std::exchange(seen_.at(t).outer, true)) return;
    queue_.push_back(t);
  }
  std::size_t base(std::size_t t) const { return seen_.at(t).base; }
  std::size_t partner(std::size_t t) const {
    return m_.joined_[t] == none ? none : m_.other(m_.joined_[t], t);
  }

  // Along a pair from an outer triangle; whether that ended the search.
  bool step(std::size_t t, std::size_t pair) {
    const std::size_t next = m_.other(pair, t);
    if (pair == m_.joined_[t]) return false;
    if (const auto at = seen_.find(next); at != seen_.end()) {
      if (at->second.outer && base(next) != base(t)) contract(t, next, pair);
      return false;
    }
    reach(next, pair);
    if (m_.joined_[next] == none) {
      exchange(next);
      return true;
    }
    const std::size_t behind = partner(next);
    if (!seen_.contains(behind)) reach(behind, none);
    enqueue(behind);
    return false;
  }

  // The outer triangle before this one on the way to the root.
  std::size_t before(std::size_t outer) const {
    const std::size_t inner = partner(outer);
    return m_.other(seen_.at(inner).by, inner);
  }

  std::size_t meeting(std::size_t a, std::size_t b) const {
    std::set<std::size_t> way;
    for (a = base(a);; a = base(before(a))) {
      way.insert(a);
      if (partner(a) == none) break;
    }
    for (b = base(b); !way.contains(b); b = base(before(b))) {
    }
    return b;
  }

  void mark(std::size_t t, std::size_t to, std::size_t pair, std::set<std::size_t>& ring) {
    while (base(t) != to) {
      const std::size_t inner = partner(t);
      ring.insert(base(t));
      ring.insert(base(inner));
      seen_.at(t).by = pair;
      pair = seen_.at(inner).by;
      t = m_.other(pair, inner);
    }
  }

  void contract(std::size_t a, std::size_t b, std::size_t pair) {
    const std::size_t to = meeting(a, b);
    std::set<std::size_t> ring;
    mark(a, to, pair, ring);
    mark(b, to, pair, ring);
    for (auto& [t, place] : seen_)
      if (ring.contains(place.base)) {
        place.base = to;
        enqueue(t);
      }
  }

  // Joins the single triangle and, on the way back to the root, all that lose their partner.
  void exchange(std::size_t t) {
    while (t != none) {
      const std::size_t pair = seen_.at(t).by, outer = m_.other(pair, t);
      const std::size_t left = partner(outer);
      m_.joined_[t] = m_.joined_[outer] = pair;
      t = left;
    }
  }

  Matching& m_;
  std::map<std::size_t, Place> seen_;
  std::vector<std::size_t> queue_;
};

void Matching::augment() {
  for (std::size_t t = 0; t < of_.size(); ++t)
    if (joined_[t] == none && !of_[t].empty()) Search(*this).from(t);
}

}  // namespace

std::vector<TrianglePair> match_triangles(const Mesh& mesh, const RankOf& rank, int most_new) {
  Matching matching(candidates(mesh, rank), mesh.elements.size());
  matching.exchange(most_new);
  if (most_new > 0) matching.augment();
  return matching.chosen();
}

}  // namespace fabricsh::mesh
