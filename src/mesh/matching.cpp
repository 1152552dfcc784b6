#include "mesh/matching.hpp"

#include <algorithm>
#include <limits>

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

  std::vector<TrianglePair> chosen() const {
    std::vector<TrianglePair> result;
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      if (joined_[pairs_[p].first] == p) result.push_back(pairs_[p]);
    return result;
  }

 private:
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

}  // namespace

std::vector<TrianglePair> match_triangles(const Mesh& mesh, const RankOf& rank, int most_new) {
  Matching matching(candidates(mesh, rank), mesh.elements.size());
  matching.exchange(most_new);
  return matching.chosen();
}

}  // namespace fabricsh::mesh
