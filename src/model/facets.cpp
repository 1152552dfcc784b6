#include "model/facets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>

#include "contact/grid.hpp"
#include "contact/scene.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::model {

using contact::Edge;
using contact::Triangle;
using mesh::Index;

namespace {

constexpr double kDigits = 3e-5;    // of the farthest coordinate: as far apart are numbers of six digits
constexpr double kOfEdges = 0.01;   // of a short edge: nodes that are farther apart are two
constexpr double kShort = 0.1;      // of the edges are shorter
constexpr double kFlattest = 1e-6;  // height over longest edge of a facet, up to which it has no area

using Corners = std::array<Index, 4>;

std::size_t place(std::int64_t id) { return static_cast<std::size_t>(id); }

Edge edge_of(const Triangle& t, std::size_t k) {
  const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
  return {a, b};
}

// Along this axis the nodes of few meshes lie in planes across it.
double along(const Vec3& x) { return x.dot(Vec3(0.8017837, 0.5345225, 0.2672612)); }

class Mender {
 public:
  // cancels: of two facets on the same corners that look in opposite directions, inside a solid, none is
  // left. blunt: nor are facets that are lower than nodes at one place may be apart.
  Mender(const Shapes& shapes, bool closed, bool cancels, bool blunt)
      : shapes_(shapes), closed_(closed), cancels_(cancels), blunt_(blunt), near_(nearness()) {
    find_places();
    drop_doubles();
    join();
    cut();
    divide();
    if (closed_) turn();
  }
  std::vector<Facets> facets() const;
  const Mended& mended() const { return mended_; }
  // Whether every edge is walked as often in either sense.
  bool is_closed() const;

 private:
  const Vec3& at(std::size_t shape, std::int64_t node) const { return shapes_[shape]->nodes[place(node)]; }
  const Vec3& at(std::int64_t node) const { return at(0, node); }
  double nearness() const;
  void find_places();
  void drop_doubles();
  void join();
  void cut();
  void divide();
  std::vector<std::int32_t> on_edge(const Edge& edge, std::span<const std::int32_t> sorted) const;
  bool lies_on(const Edge& edge, std::int32_t vertex) const;
  bool is_flat(const Triangle& t) const;
  void turn();
  double volume(std::span<const std::size_t> triangles) const;

  const Shapes& shapes_;
  const bool closed_, cancels_, blunt_;
  const double near_;                // m: nodes no farther apart are at one place
  std::vector<Index> place_;         // of each node the first one there
  std::vector<Index> vertex_;        // of each node the one that stands for it
  std::vector<Corners> elements_;    // that are left
  std::vector<Triangle> triangles_;  // of nodes that stand for themselves
  Mended mended_;
};

double Mender::nearness() const {
  double farthest = 0;
  for (const auto& shape : shapes_)
    for (const Vec3& x : shape->nodes) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  std::vector<double> lengths;
  for (const Corners& e : shapes_.front()->elements)
    for (std::size_t k = 0, n = mesh::corner_count(e); k < n; ++k)
      if (const double l = (at(e[k]) - at(e[(k + 1) % n])).norm(); l > 0) lengths.push_back(l);
  if (lengths.empty()) return 0;
  const auto short_one = lengths.begin() + static_cast<std::ptrdiff_t>(kShort * double(lengths.size()));
  std::nth_element(lengths.begin(), short_one, lengths.end());
  return std::min(kDigits * farthest, kOfEdges * *short_one);
}

void Mender::find_places() {
  const std::size_t count = shapes_.front()->nodes.size();
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return along(at(a)) < along(at(b)); });
  place_.resize(count);
  std::iota(place_.begin(), place_.end(), Index{0});
  const auto together = [&](Index a, Index b) {
    for (std::size_t s = 0; s < shapes_.size(); ++s)
      if (!((at(s, a) - at(s, b)).norm() <= near_)) return false;
    return true;
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count && along(at(order[j])) - along(at(order[i])) <= near_; ++j) {
      const auto [a, b] = std::minmax(order[i], order[j]);
      if (together(a, b)) place_[place(b)] = std::min(place_[place(b)], a);
    }
  for (Index& p : place_) p = place_[place(p)];  // ascending: that of an earlier one is final
}

// Elements on the same corners count once, however they are turned.
void Mender::drop_doubles() {
  const auto& all = shapes_.front()->elements;
  // The corners, sorted, and whether they run as they do in the first element there.
  std::map<Corners, std::vector<std::size_t>> there;
  for (std::size_t e = 0; e < all.size(); ++e) {
    Corners key = all[e];
    for (Index& id : key)
      if (id >= 0) id = place_[place(id)];
    std::sort(key.begin(), key.end());
    there[key].push_back(e);
  }
  // Whether two elements on the same corners run around in the same sense.
  const auto alike = [&](std::size_t one, std::size_t other) {
    const std::size_t n = mesh::corner_count(all[one]);
    const auto corner = [&](std::size_t e, std::size_t k) { return place_[place(all[e][k % n])]; };
    for (std::size_t k = 0; k < n; ++k)
      if (corner(other, k) == corner(one, 0)) return corner(other, k + 1) == corner(one, 1);
    return true;
  };
  std::vector<char> left(all.size(), 1);
  for (const auto& [corners, elements] : there) {
    if (elements.size() < 2) continue;
    const bool opposite = std::any_of(elements.begin(), elements.end(),
                                      [&](std::size_t e) { return !alike(elements.front(), e); });
    for (const std::size_t e : elements) left[e] = 0;
    const bool none = cancels_ && opposite;
    left[elements.front()] = none ? 0 : 1;
    mended_.doubled += elements.size() - (none ? 0 : 1);
  }
  for (std::size_t e = 0; e < all.size(); ++e)
    if (left[e] != 0) elements_.push_back(all[e]);
}

// Nodes that share their place with one on a free edge are one vertex.
void Mender::join() {
  mesh::Mesh rest;
  rest.elements = elements_;
  std::vector<char> is_free(place_.size(), 0);
  for (const Index node : mesh::free_nodes(rest)) is_free[place(place_[place(node)])] = 1;
  vertex_.resize(place_.size());
  for (std::size_t i = 0; i < vertex_.size(); ++i)
    vertex_[i] = is_free[place(place_[i])] != 0 ? place_[i] : static_cast<Index>(i);
}

// In every shape.
bool Mender::is_flat(const Triangle& t) const {
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    const Vec3 a = at(s, t[1]) - at(s, t[0]), b = at(s, t[2]) - at(s, t[1]), c = at(s, t[0]) - at(s, t[2]);
    const double longest = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}));
    const double least = std::max(kFlattest * longest, blunt_ ? near_ : 0);
    if (a.cross(b).norm() > least * longest) return false;
  }
  return true;
}

void Mender::cut() {
  std::set<Triangle> seen;
  for (Triangle t : contact::split(shapes_.front()->nodes, elements_).triangles) {
    for (std::int32_t& corner : t) corner = static_cast<std::int32_t>(vertex_[place(corner)]);
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    const bool flat = sorted[0] == sorted[1] || sorted[1] == sorted[2] || is_flat(t);
    if (flat)
      ++mended_.flat;
    else if (!seen.insert(sorted).second)
      ++mended_.doubled;
    else
      triangles_.push_back(t);
  }
}

bool Mender::lies_on(const Edge& edge, std::int32_t vertex) const {
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    const Vec3 way = at(s, edge[1]) - at(s, edge[0]), to = at(s, vertex) - at(s, edge[0]);
    const double length = way.norm(), on = length > 0 ? to.dot(way) / length : 0;
    if (!(on > near_ && on < length - near_ && (to - on / length * way).norm() <= near_)) return false;
  }
  return true;
}

// Vertices on the inside of an edge, from its first end to the second; of those sorted along the axis.
std::vector<std::int32_t> Mender::on_edge(const Edge& edge, std::span<const std::int32_t> sorted) const {
  const auto [from, to] = std::minmax({along(at(edge[0])), along(at(edge[1]))});
  std::vector<std::int32_t> found;
  for (auto v = std::lower_bound(sorted.begin(), sorted.end(), from - near_,
                                 [this](std::int32_t one, double value) { return along(at(one)) < value; });
       v != sorted.end() && along(at(*v)) <= to + near_; ++v)
    if (*v != edge[0] && *v != edge[1] && lies_on(edge, *v)) found.push_back(*v);
  std::sort(found.begin(), found.end(), [&](std::int32_t a, std::int32_t b) {
    return (at(a) - at(edge[0])).squaredNorm() < (at(b) - at(edge[0])).squaredNorm();
  });
  return found;
}

// Where vertices lie on a free edge, as of a row of smaller facets beside a large one, this is divided there.
void Mender::divide() {
  std::map<Edge, int> facets;
  for (const Triangle& t : triangles_)
    for (std::size_t k = 0; k < 3; ++k) ++facets[edge_of(t, k)];
  std::erase_if(facets, [](const auto& one) { return one.second > 1; });
  std::set<std::int32_t> ends;
  for (const auto& [edge, count] : facets) ends.insert(edge.begin(), edge.end());
  std::vector<std::int32_t> sorted(ends.begin(), ends.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [this](std::int32_t a, std::int32_t b) { return along(at(a)) < along(at(b)); });
  std::map<Edge, std::vector<std::int32_t>> hanging;
  for (const auto& [edge, count] : facets)
    if (auto found = on_edge(edge, sorted); !found.empty()) hanging.emplace(edge, std::move(found));
  if (hanging.empty()) return;
  std::vector<Triangle> divided;
  for (const Triangle& whole : triangles_) {
    std::vector<Triangle> open{whole};
    while (!open.empty()) {
      const Triangle t = open.back();
      open.pop_back();
      std::size_t k = 0;
      while (k < 3 && !hanging.contains(edge_of(t, k))) ++k;
      if (k == 3) {
        divided.push_back(t);
        continue;
      }
      const Edge edge = edge_of(t, k);
      const std::vector<std::int32_t> on = std::move(hanging.extract(edge).mapped());
      const auto middle = on.begin() + static_cast<std::ptrdiff_t>(on.size() / 2);
      const std::int32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], v = *middle;
      const auto leave = [&](std::int32_t from, std::int32_t to, std::vector<std::int32_t> between) {
        if (from > to) std::reverse(between.begin(), between.end());
        if (!between.empty()) hanging[Edge{std::min(from, to), std::max(from, to)}] = std::move(between);
      };
      leave(edge[0], v, {on.begin(), middle});
      leave(v, edge[1], {middle + 1, on.end()});
      open.push_back({v, b, c});
      open.push_back({a, v, c});
    }
    mended_.divided += divided.back() == whole ? 0 : 1;
  }
  triangles_ = std::move(divided);
}

bool Mender::is_closed() const { return !triangles_.empty() && contact::open_edges(triangles_).empty(); }

// m3, six times: of the tetrahedra on these triangles.
double Mender::volume(std::span<const std::size_t> triangles) const {
  double sum = 0;
  const Vec3& origin = at(triangles_.front()[0]);
  for (const std::size_t i : triangles) {
    const Triangle& t = triangles_[i];
    sum += (at(t[0]) - origin).dot((at(t[1]) - origin).cross(at(t[2]) - origin));
  }
  return sum;
}

// Those of each connected part are turned like their neighbours, where these do not agree so that it encloses
// a volume. A surface that is inside out is turned as a whole, then the parts that are, but for hollows:
// those that an odd number of others encloses. Parts that only touch along an edge are two.
void Mender::turn() {
  std::map<Edge, std::vector<std::size_t>> at_edge;
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) at_edge[edge_of(triangles_[i], k)].push_back(i);
  if (triangles_.empty() ||
      std::any_of(at_edge.begin(), at_edge.end(), [](const auto& one) { return one.second.size() % 2 != 0; }))
    return;
  const auto walks = [&](std::size_t i, const Edge& edge) {  // whether from its first end to the second
    for (std::size_t k = 0; k < 3; ++k)
      if (edge_of(triangles_[i], k) == edge) return triangles_[i][k] == edge[0];
    return false;
  };
  std::vector<int> sense(triangles_.size(), 0);  // 1: as its part's first, -1: against it
  std::vector<std::vector<std::size_t>> parts;
  for (std::size_t first = 0; first < sense.size(); ++first) {
    if (sense[first] != 0) continue;
    sense[first] = 1;
    auto& part = parts.emplace_back(1, first);
    for (std::size_t next = 0; next < part.size(); ++next)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = part[next];
        const Edge edge = edge_of(triangles_[i], k);
        const auto& two = at_edge[edge];
        if (two.size() > 2) continue;
        const std::size_t other = two[two[0] == i ? 1 : 0];
        const int wanted = walks(i, edge) == walks(other, edge) ? -sense[i] : sense[i];
        if (sense[other] != 0 && sense[other] != wanted) return;  // one-sided
        if (sense[other] == 0) part.push_back(other);
        sense[other] = wanted;
      }
  }
  const auto before = triangles_;
  const auto reverse = [&](std::size_t i) { std::swap(triangles_[i][1], triangles_[i][2]); };
  double whole = 0;
  for (const auto& part : parts) {
    const bool agrees = std::all_of(part.begin(), part.end(), [&](std::size_t i) { return sense[i] > 0; });
    for (const std::size_t i : part)
      if (sense[i] < 0) reverse(i);
    if (!agrees && volume(part) < 0) std::for_each(part.begin(), part.end(), reverse);
    whole += volume(part);
  }
  for (std::size_t i = 0; whole < 0 && i < triangles_.size(); ++i) reverse(i);
  const auto encloses = [&](const std::vector<std::size_t>& part, const Vec3& p) {
    std::vector<Triangle> outwards;
    for (const std::size_t i : part) outwards.push_back(triangles_[i]);
    if (volume(part) < 0)
      for (Triangle& t : outwards) std::swap(t[1], t[2]);
    return contact::encloses(shapes_.front()->nodes, outwards, p);
  };
  for (const auto& part : parts) {
    if (volume(part) >= 0) continue;
    const Triangle& t = triangles_[part.front()];
    const Vec3 middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3;
    const auto around = std::count_if(parts.begin(), parts.end(), [&](const auto& other) {
      return &other != &part && encloses(other, middle);
    });
    if (around % 2 == 0) std::for_each(part.begin(), part.end(), reverse);
  }
  for (std::size_t i = 0; i < before.size(); ++i) mended_.turned += before[i] != triangles_[i] ? 1 : 0;
}

std::vector<Facets> Mender::facets() const {
  std::vector<std::int32_t> number(place_.size(), -1);
  for (const Triangle& t : triangles_)
    for (const std::int32_t corner : t) number[place(corner)] = 0;
  std::int32_t count = 0;
  for (std::int32_t& n : number)
    if (n == 0) n = count++;
  std::vector<Facets> out;
  for (const auto& shape : shapes_) {
    Facets facets{{}, triangles_, closed_};
    for (Triangle& t : facets.triangles)
      for (std::int32_t& corner : t) corner = number[place(corner)];
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] >= 0) facets.vertices.push_back(shape->nodes[i]);
    out.push_back(std::move(facets));
  }
  return out;
}

}  // namespace

std::string Mended::words() const {
  std::string text;
  const auto add = [&text](const char* what, std::size_t count) {
    if (count > 0)
      text += (text.empty() ? "facets " : ", ") + std::string(what) + ": " + std::to_string(count);
  };
  add("left out, on the corners of others", doubled);
  add("left out, without area", flat);
  add("divided at corners of others on their sides", divided);
  add("turned, to look outwards", turned);
  return text;
}

std::vector<Facets> facets_of(const Shapes& shapes, bool closed, Mended* mended) {
  const auto made = [&](bool cancels, bool blunt) {
    return std::make_unique<const Mender>(shapes, closed, cancels, blunt);
  };
  auto best = made(false, false);
  for (int way = 1; way < 4 && closed && !best->is_closed(); ++way)
    if (auto other = made(way % 2 == 1, way > 1); other->is_closed()) best = std::move(other);
  if (mended != nullptr) *mended = best->mended();
  return best->facets();
}

namespace {

// Facets by size, to within a factor of two, each size sorted by the middles of their boxes.
class Finder {
 public:
  explicit Finder(const Facets& facets) : facets_(facets), box_(facets.triangles.size()) {
    std::map<int, std::vector<std::size_t>> of_size;
    for (std::size_t i = 0; i < box_.size(); ++i) {
      for (const std::int32_t corner : facets.triangles[i]) box_[i].add(facets.vertices[place(corner)]);
      of_size[std::ilogb(size(i))].push_back(i);
    }
    for (auto& [exponent, own] : of_size) {
      contact::Box room;
      for (const std::size_t i : own) room.add(middle(i));
      const double cell = std::ldexp(1.0, exponent + 1);
      classes_.push_back({own, cell, contact::Grid(room, cell, own.size(), [&own = own, this](std::size_t k) {
                            return middle(own[k]);
                          })});
    }
  }
  // Calls visit(facet) for those whose boxes meet the box.
  template <class Visit>
  void in(const contact::Box& box, Visit visit) const {
    for (const auto& one : classes_)
      one.grid.in(box.grown(one.largest / 2), [&](std::int32_t k) {
        if (const std::size_t i = one.facets[place(k)]; box_[i].meets(box)) visit(i);
      });
  }

 private:
  struct SizeClass {
    std::vector<std::size_t> facets;
    double largest;  // m
    contact::Grid grid;
  };
  double size(std::size_t i) const { return (box_[i].high - box_[i].low).norm(); }
  Vec3 middle(std::size_t i) const { return (box_[i].low + box_[i].high) / 2; }

  const Facets& facets_;
  std::vector<contact::Box> box_;
  std::vector<SizeClass> classes_;
};

using Three = std::array<Vec3, 3>;

Three corners_of(const Facets& f, std::size_t i) {
  const Triangle& t = f.triangles[i];
  return {f.vertices[place(t[0])], f.vertices[place(t[1])], f.vertices[place(t[2])]};
}

// Of twice the area along the normal, m2.
Vec3 normal_of(const Three& x) { return (x[1] - x[0]).cross(x[2] - x[0]); }

// m, along n to the inside of a facet that is turned by less than 60 degrees from the plane across it.
std::optional<double> ahead(const Vec3& from, const Vec3& n, const Three& x) {
  constexpr double least = 0.5, rounding = 1e-9;
  const Vec3 area = normal_of(x);
  const double across = n.dot(area);
  if (!(std::abs(across) > least * area.norm())) return {};
  const double t = (x[0] - from).dot(area) / across;
  const Vec3 p = from + t * n;
  for (std::size_t k = 0; k < 3; ++k)
    if (!((x[(k + 1) % 3] - x[k]).cross(p - x[k]).dot(area) > -rounding * area.squaredNorm())) return {};
  return t;
}

// The middles of the facets, and what lies behind and before them. Returns twice the area, m2.
double find_sheets(const Facets& facets, const Finder& finder, double reach, Crowding& out) {
  constexpr double on_it = 1e-3;  // of the reach: sheets that lie on each other have no side
  double whole = 0, crowded = 0;
  for (std::size_t i = 0; i < facets.triangles.size(); ++i) {
    const Three x = corners_of(facets, i);
    const Vec3 area = normal_of(x), n = area.normalized(), middle = (x[0] + x[1] + x[2]) / 3;
    const double farthest = facets.closed ? on_it * reach : reach;
    whole += area.norm();
    contact::Box box;
    box.add(middle - reach * n);
    box.add(middle + farthest * n);
    double nearest = reach;
    finder.in(box, [&](std::size_t other) {
      if (other == i) return;
      const auto t = ahead(middle, n, corners_of(facets, other));
      if (t && *t <= farthest) nearest = std::min(nearest, std::abs(*t));
    });
    if (!(nearest < reach)) continue;
    if (crowded == 0 || nearest < out.nearest) {
      out.nearest = nearest;
      out.sheets = middle;
    }
    crowded += area.norm();
  }
  out.share = whole > 0 ? crowded / whole : 0;
  return whole;
}

// The middles of the free edges, and the facets in front of them within 60 degrees.
void find_gaps(const Facets& facets, const Finder& finder, double reach, Crowding& out) {
  constexpr double in_front = 0.5, on_it = 1e-6;      // the latter of the reach
  std::map<Edge, std::pair<std::size_t, int>> sides;  // a facet, and how many there are
  for (std::size_t i = 0; i < facets.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      auto& [facet, count] = sides[edge_of(facets.triangles[i], k)];
      facet = i;
      ++count;
    }
  for (const auto& [edge, side] : sides) {
    if (side.second > 1) continue;
    const Vec3 &a = facets.vertices[place(edge[0])], &b = facets.vertices[place(edge[1])],
               middle = (a + b) / 2;
    const Three own = corners_of(facets, side.first);
    const Vec3 inwards = (own[0] + own[1] + own[2]) / 3 - middle, way = (b - a).normalized();
    const Vec3 outwards = -(inwards - inwards.dot(way) * way).normalized();
    contact::Box box;
    box.add(middle);
    double gap = reach;
    finder.in(box.grown(reach), [&](std::size_t other) {
      if (other == side.first) return;
      const Three x = corners_of(facets, other);
      const auto touch = contact::point_triangle({middle, x[0], x[1], x[2]}).touch;
      if (touch.distance > on_it * reach && touch.distance < gap && -touch.normal.dot(outwards) > in_front)
        gap = touch.distance;
    });
    if (!(gap < reach)) continue;
    if (out.length == 0 || gap < out.gap) {
      out.gap = gap;
      out.edges = middle;
    }
    out.length += (b - a).norm();
  }
}

}  // namespace

Crowding crowding(const Facets& facets, double reach) {
  Crowding out;
  const Finder finder(facets);
  const double twice = find_sheets(facets, finder, reach, out);
  find_gaps(facets, finder, reach, out);
  out.beside = twice > 0 ? 2 * out.length * reach / twice : 0;
  return out;
}

}  // namespace fabricsh::model
