#include "mesh/panel.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/check.hpp"
#include "mesh/edges.hpp"
#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"
#include "mesh/matching.hpp"
#include "mesh/rim.hpp"
#include "mesh/triangulate.hpp"

namespace fabricsh::mesh {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

// The points of the mesh: first those of the rim, then those of the lattice inside.
struct Points {
  std::vector<Vec2> local;                 // along and across the rows, m
  std::vector<GridPoint> grid;             // the same on the finest grid of integers
  std::vector<std::array<Index, 2>> cell;  // column and row of a point of the lattice
  Index rim = 0;                           // how many are on the rim
};

enum class Kind {
  mixed,  // squares, and a rim of triangles as far as no two form a good quadrilateral
  halved  // such a mesh of twice the size, cut at the middles of all sides: quadrilaterals alone
};

// The panel of which a mesh is made that is then cut at the middles of all sides.
Panel doubled(const Panel& shape) {
  Panel twice = shape;
  twice.size *= 2;
  const auto halve = [](Loop& loop) {
    for (OutlinePiece& piece : loop) {
      if (piece.elements % 2 != 0)
        refuse_panel("quadrilaterals", "expected an even number of elements along each piece, got " +
                                           std::to_string(piece.elements) +
                                           (piece.edge.empty() ? "" : " along '" + piece.edge + "'"));
      piece.elements /= 2;
    }
  };
  halve(twice.outline);
  for (Loop& hole : twice.holes) halve(hole);
  return twice;
}

double distance(const Vec2& x, const Vec2& a, const Vec2& b) {
  const double share = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (x - a - share * (b - a)).norm();
}

// The least distance of a point of the lattice from the rim, of the smaller step. By trial: of the shares
// from 0.35 to 0.8 the one with the best worst angle over circles, trapezoids and a bodice (27 degrees).
constexpr double clearance = 0.7;

// The same where nodes move afterwards, which needs less, and a narrow panel keeps more rows.
constexpr double clearance_moved = 0.45;

// How far a quadrilateral is from a rectangle: the sine of its worst corner; 0 if it is not convex or if that
// corner is below 45 or above 135 degrees.
double squareness(const std::array<Index, 4>& ids, const Points& points) {
  double worst = 1;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto x = [&](std::size_t k) -> const Vec2& { return points.local[at(ids[k % 4])]; };
    const Vec2 a = x(i + 1) - x(i), b = x(i + 3) - x(i);
    worst = std::min(worst, (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm()));
  }
  return worst < std::sqrt(0.5) ? 0 : worst;
}

// Whether the four are the corners of one cell of the lattice.
bool one_cell(const std::array<Index, 4>& ids, const Points& points) {
  std::array<Index, 2> low{most_cells, most_cells}, high{-1, -1};
  for (const Index id : ids)
    for (std::size_t k = 0; k < 2; ++k) {
      if (points.cell[at(id)][k] < 0) return false;
      low[k] = std::min(low[k], points.cell[at(id)][k]);
      high[k] = std::max(high[k], points.cell[at(id)][k]);
    }
  return high[0] - low[0] == 1 && high[1] - low[1] == 1;
}

class PanelMesher {
 public:
  explicit PanelMesher(const Panel& shape, Kind kind = Kind::mixed)
      : shape_(kind == Kind::halved ? doubled(shape) : shape),
        kind_(kind),
        size_(shape.size),
        border_(border_of(shape_, notches_)),
        weave_(weave_of(shape_, border_)) {}

  Mesh make() {
    check_size();
    rim_ = lay_nodes(border_, weave_, kind_ == Kind::halved);
    add_rim_points();
    check_lines(rim_.links);
    if (kind_ == Kind::halved) check_lines(border_links());
    check_holes();
    add_lattice_points();
    pair_up(triangles_between());
    if (kind_ == Kind::halved) {
      cut();
      smooth_within(6);
      sort_points();
    }
    sort_elements();
    Mesh mesh;
    for (std::size_t i = 0; i < points_.local.size(); ++i) {
      const Vec2 x = i < rim_.nodes.size() ? rim_.nodes[i] : weave_.global(points_.local[i]);
      mesh.nodes.emplace_back(x.x(), x.y(), 0);
    }
    mesh.elements = elements_;
    mesh.warp.assign(mesh.elements.size(), direction(shape_.grain));
    mesh.flat = true;
    mesh.origin = "panel";
    name_sets(mesh);
    check_result(mesh);
    return mesh;
  }

 private:
  void check_size() const {
    if (size_ > weave_.size.minCoeff() * (1 + 1e-9))
      refuse_panel("size", "expected at most the smaller extent of the panel, " +
                               number(weave_.size.minCoeff()) + " m, got " + number(size_));
  }

  // By a sweep along the rows.
  void check_lines(std::vector<Rim::RimEdge> links) const {
    const auto& x = points_.grid;
    const auto low = [&x](const Rim::RimEdge& l) { return std::min(x[at(l.first)][0], x[at(l.second)][0]); };
    const auto high = [&x](const Rim::RimEdge& l) { return std::max(x[at(l.first)][0], x[at(l.second)][0]); };
    std::stable_sort(links.begin(), links.end(),
                     [&](const Rim::RimEdge& a, const Rim::RimEdge& b) { return low(a) < low(b); });
    for (std::size_t i = 0; i < links.size(); ++i)
      for (std::size_t k = i + 1; k < links.size() && low(links[k]) <= high(links[i]); ++k)
        check_pair(links[i], links[k]);
  }

  // The sides of the triangles on the rim. Of a rim that is halved every other node is a corner of them.
  std::vector<Rim::RimEdge> border_links() const {
    if (kind_ == Kind::mixed) return rim_.links;
    std::vector<Rim::RimEdge> links;
    for (std::size_t l = 0; l < rim_.links.size(); l += 2) {
      links.push_back(rim_.links[l]);
      links.back().second = rim_.links[l + 1].second;
    }
    return links;
  }

  // Two links of the rim that are not neighbours have no common point; neighbours have no other one.
  void check_pair(const Rim::RimEdge& a, const Rim::RimEdge& b) const {
    const auto p = [this](Index i) -> const GridPoint& { return points_.grid[at(i)]; };
    const bool behind = a.second == b.first, before = b.second == a.first;
    bool bad;
    if (behind && before) {
      bad = true;
    } else if (behind || before) {
      const auto &first = behind ? a : b, &second = behind ? b : a;
      const GridPoint u = p(first.first), v = p(first.second), w = p(second.second);
      bad = doubled_area(u, v, w) == 0 && (u[0] - v[0]) * (w[0] - v[0]) + (u[1] - v[1]) * (w[1] - v[1]) > 0;
    } else {
      bad = touch(p(a.first), p(a.second), p(b.first), p(b.second));
    }
    if (!bad) return;
    const bool in_order = std::pair(a.loop, a.side) <= std::pair(b.loop, b.side);
    const Side *one = &side(in_order ? a : b), *other = &side(in_order ? b : a);
    if (one->field == "outline" && other->field != "outline") std::swap(one, other);
    refuse_panel(one->field, one->words + " crosses or touches " +
                                 (one == other ? std::string("itself") : other->words) + " near " +
                                 place_text(meeting(a, b)));
  }

  // Where the lines of two links meet, on the first of them; its middle if they are parallel.
  Vec2 meeting(const Rim::RimEdge& a, const Rim::RimEdge& b) const {
    const auto x = [this](Index i) -> const Vec2& { return rim_.nodes[at(i)]; };
    const Vec2 p = x(a.second) - x(a.first), q = x(b.second) - x(b.first), between = x(b.first) - x(a.first);
    const double across = p.x() * q.y() - p.y() * q.x();
    const double share = across == 0 ? 0.5 : (between.x() * q.y() - between.y() * q.x()) / across;
    return x(a.first) + std::clamp(share, 0.0, 1.0) * p;
  }

  void check_holes() const {
    std::vector<std::vector<Vec2>> lines(border_.size());
    for (const Rim::RimEdge& link : rim_.links) lines[link.loop].push_back(rim_.nodes[at(link.first)]);
    for (std::size_t h = 1; h < lines.size(); ++h) {
      const Vec2& x = lines[h].front();
      if (!encloses(lines[0], x))
        refuse_panel("holes",
                     "hole " + std::to_string(h) + " lies outside of the outline, at " + place_text(x));
      for (std::size_t k = 1; k < lines.size(); ++k)
        if (k != h && encloses(lines[k], x))
          refuse_panel("holes", "hole " + std::to_string(h) + " lies in hole " + std::to_string(k) + ", at " +
                                    place_text(x));
    }
  }

  void add_rim_points() {
    for (const Vec2& x : rim_.nodes) add_point(weave_.local(x), {-1, -1});
    points_.rim = static_cast<Index>(rim_.nodes.size());
  }

  void add_lattice_points() {
    const Index width = weave_.cells[0] + 1;
    std::vector<char> kept;
    for (Index j = 0; j <= weave_.cells[1]; ++j) {
      const std::vector<char> row = inside(j);
      kept.insert(kept.end(), row.begin(), row.end());
    }
    strike_near(kept);
    for (Index j = 0; j <= weave_.cells[1]; ++j)
      for (Index i = 0; i < width; ++i)
        if (kept[at(j * width + i)] != 0) add_point(lattice_point(i, j), {i, j});
  }

  std::vector<Corners> triangles_between() const {
    const Index every = kind_ == Kind::halved ? 2 : 1;
    std::vector<Index> ids, place(points_.local.size(), -1);
    std::vector<GridPoint> grid;
    for (Index i = 0; i < static_cast<Index>(points_.local.size()); ++i)
      if (i >= points_.rim || i % every == 0) {
        place[at(i)] = static_cast<Index>(ids.size());
        ids.push_back(i);
        grid.push_back(points_.grid[at(i)]);
      }
    std::vector<Segment> border;
    for (const Rim::RimEdge& link : border_links())
      border.push_back({place[at(link.first)], place[at(link.second)]});
    std::vector<Corners> triangles = triangulate(grid, border);
    for (Corners& t : triangles)
      for (Index& id : t) id = ids[at(id)];
    return triangles;
  }

  // Cuts every element at the middles of its sides, those on the rim at the nodes that are there.
  void cut() {
    std::map<std::pair<Index, Index>, Index> middle;
    for (std::size_t l = 0; l < rim_.links.size(); l += 2)
      middle[std::minmax(rim_.links[l].first, rim_.links[l + 1].second)] = rim_.links[l].second;
    const auto add = [this](const Vec2& x) {
      points_.local.push_back(x);
      return static_cast<Index>(points_.local.size()) - 1;
    };
    std::vector<std::array<Index, 4>> whole;
    std::swap(whole, elements_);
    for (const auto& ids : whole) {
      const std::size_t n = corner_count(ids);
      std::array<Index, 4> on;
      Vec2 sum = Vec2::Zero();
      for (std::size_t i = 0; i < n; ++i) {
        const Index a = ids[i], b = ids[(i + 1) % n];
        const auto [there, fresh] = middle.try_emplace(std::minmax(a, b), 0);
        if (fresh) there->second = add((points_.local[at(a)] + points_.local[at(b)]) / 2);
        on[i] = there->second;
        sum += points_.local[at(a)] / static_cast<double>(n);
      }
      const Index inside = add(sum);
      for (std::size_t i = 0; i < n; ++i) elements_.push_back({ids[i], on[i], inside, on[(i + n - 1) % n]});
    }
  }

  // For each point of a row of the lattice, whether the panel encloses it.
  std::vector<char> inside(Index row) const {
    const double y = lattice_point(0, row).y();
    std::vector<double> crossings;
    for (const Rim::RimEdge& link : rim_.links) {
      const Vec2 &a = points_.local[at(link.first)], &b = points_.local[at(link.second)];
      if ((a.y() > y) != (b.y() > y))
        crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<char> in(at(weave_.cells[0]) + 1, 0);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto behind =
          std::upper_bound(crossings.begin(), crossings.end(), lattice_point(static_cast<Index>(i), row).x());
      in[i] = static_cast<char>((behind - crossings.begin()) % 2);
    }
    return in;
  }

  // Strikes out the points of the lattice that are nearer to the rim than that.
  void strike_near(std::vector<char>& kept) const {
    const double least = (kind_ == Kind::mixed ? clearance : clearance_moved) * weave_.step.minCoeff();
    for (const Rim::RimEdge& link : rim_.links) {
      const Vec2 &a = points_.local[at(link.first)], &b = points_.local[at(link.second)];
      const Vec2 low = (a.cwiseMin(b) - weave_.low).array() - least,
                 high = (a.cwiseMax(b) - weave_.low).array() + least;
      const auto index = [this](double x, int k, double slack) {
        return std::clamp<Index>(static_cast<Index>(std::floor(x / weave_.step[k] + slack)), 0,
                                 weave_.cells[static_cast<std::size_t>(k)]);
      };
      for (Index j = index(low.y(), 1, 0); j <= index(high.y(), 1, 1); ++j)
        for (Index i = index(low.x(), 0, -1); i <= index(high.x(), 0, 1); ++i)
          if (distance(lattice_point(i, j), a, b) < least) kept[at(j * (weave_.cells[0] + 1) + i)] = 0;
    }
  }

  // Every other row of a lattice of triangles is moved by half a step, and begins and ends with the others.
  Vec2 lattice_point(Index i, Index j) const {
    const double shift = shape_.triangles && j % 2 == 1 ? 0.5 : 0;
    return weave_.low +
           Vec2(weave_.step.x() * (static_cast<double>(i) + shift), weave_.step.y() * static_cast<double>(j));
  }
  void add_point(const Vec2& local, const std::array<Index, 2>& cell) {
    const double scale = static_cast<double>(most_coordinate / 2) / weave_.size.maxCoeff();
    const Vec2 scaled = scale * (local - weave_.low);
    points_.local.push_back(local);
    points_.grid.push_back({std::llround(scaled.x()), std::llround(scaled.y())});
    points_.cell.push_back(cell);
  }

  void pair_up(const std::vector<Corners>& triangles) {
    std::vector<char> used(triangles.size(), 0);
    Mesh mesh;
    for (const Corners& t : triangles) mesh.elements.push_back({t[0], t[1], t[2], -1});
    const auto rank = [this](const std::array<Index, 4>& ids) -> std::int64_t {
      return one_cell(ids, points_) ? 2000 : std::llround(1000 * squareness(ids, points_));
    };
    if (!shape_.triangles)
      for (const TrianglePair& pair : match_triangles(mesh, rank, 0)) {
        used[pair.first] = used[pair.second] = 1;
        elements_.push_back(pair.ids);
      }
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (used[t] == 0) elements_.push_back({triangles[t][0], triangles[t][1], triangles[t][2], -1});
  }

  // Moves the points that are at most so many sides of elements from the rim and not on it.
  void smooth_within(int sides) {
    std::vector<char> reached(points_.local.size(), 0);
    std::fill_n(reached.begin(), points_.rim, char{1});
    for (int k = 0; k < sides; ++k) {
      const std::vector<char> before = reached;
      for (const auto& ids : elements_)
        for (std::size_t i = 0; i < 4; ++i)
          if (before[at(ids[i])] != 0) reached[at(ids[(i + 1) % 4])] = reached[at(ids[(i + 3) % 4])] = 1;
    }
    std::vector<Index> free;
    for (Index i = points_.rim; i < static_cast<Index>(points_.local.size()); ++i)
      if (reached[at(i)] != 0) free.push_back(i);
    smooth(points_.local, elements_, free);
  }

  // Numbers the points inside row by row.
  void sort_points() {
    std::vector<std::tuple<Index, Index, Index>> keys;
    for (Index i = points_.rim; i < static_cast<Index>(points_.local.size()); ++i) {
      const Vec2 place = 2 * (points_.local[at(i)] - weave_.low).cwiseQuotient(weave_.step);
      keys.emplace_back(std::llround(place.y()), std::llround(place.x()), i);
    }
    std::sort(keys.begin(), keys.end());
    const std::vector<Vec2> before = points_.local;
    std::vector<Index> number(before.size());
    std::iota(number.begin(), number.end(), Index{0});
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const Index now = points_.rim + static_cast<Index>(k), old = std::get<2>(keys[k]);
      number[at(old)] = now;
      points_.local[at(now)] = before[at(old)];
    }
    for (auto& ids : elements_)
      for (Index& id : ids) id = number[at(id)];
  }

  // Row by row of the lattice, by the cell that has the middle of the element.
  void sort_elements() {
    using Key = std::tuple<Index, Index, std::array<Index, 4>>;
    std::vector<Key> keys;
    for (const auto& ids : elements_) {
      Vec2 sum = Vec2::Zero();
      const int n = ids[3] < 0 ? 3 : 4;
      for (int i = 0; i < n; ++i) sum += points_.local[at(ids[static_cast<std::size_t>(i)])];
      const Vec2 cell = (sum / n - weave_.low).cwiseQuotient(weave_.step);
      // The slack keeps elements in the middle of a cell's border where they are, whatever the rounding.
      keys.emplace_back(std::llround(std::floor(cell.y() + 1e-6)), std::llround(std::floor(cell.x() + 1e-6)),
                        ids);
    }
    std::sort(keys.begin(), keys.end());
    for (std::size_t e = 0; e < keys.size(); ++e) elements_[e] = std::get<2>(keys[e]);
  }

  void name_sets(Mesh& mesh) const {
    for (const auto& [name, ids] : rim_.sets) mesh.define(name, ids);
    for (std::size_t i = 0; i < notches_.size(); ++i) {
      Index best = 0;
      for (Index n = 0; n < points_.rim; ++n)
        if ((rim_.nodes[at(n)] - notches_[i]).norm() < (rim_.nodes[at(best)] - notches_[i]).norm()) best = n;
      mesh.define(shape_.notches[i].name, {best});
    }
    add_usual_sets(mesh);
  }

  // The elements cover what the rim encloses, and no element has a defect.
  void check_result(const Mesh& mesh) const {
    const Report report = check(mesh);
    for (const Finding& item : report.items) {
      if (item.severity != Severity::error) continue;
      const Index node =
          item.elements.empty() ? item.nodes.front() : mesh.elements[at(item.elements.front())][0];
      const Vec3& x = mesh.nodes[at(node)];
      refuse_panel("size", "no good mesh near " + place_text({x.x(), x.y()}) + " with elements of " +
                               number(size_) + " m (" + item.text + "): try a smaller size");
    }
    if (std::abs(report.measures.area / rim_area() - 1) > 1e-9)
      refuse_panel("size", "elements of " + number(size_) + " m cover " + number(report.measures.area) +
                               " m2 in place of " + number(rim_area()) + ": try a smaller size");
  }

  const Side& side(const Rim::RimEdge& link) const { return border_[link.loop][link.side]; }
  double rim_area() const {
    double sum = 0;
    for (const Rim::RimEdge& link : rim_.links) {
      const Vec2 a = points_.local[at(link.first)] - weave_.low,
                 b = points_.local[at(link.second)] - weave_.low;
      sum += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    return sum;
  }

  const Panel shape_;
  const Kind kind_;
  const double size_;  // that was asked for
  std::vector<Vec2> notches_;
  Border border_;
  Weave weave_;
  Rim rim_;
  Points points_;
  std::vector<std::array<Index, 4>> elements_;
};

// Degrees from the grain to the nearest line along or across it, -45 to 45.
double off_grain(double degrees, double grain) { return std::remainder(degrees - grain, 90.0); }

// Directions of the straight sides that run obliquely to the grain, degrees, at most four: those of the
// greatest lengths. Sides at right angles are one.
std::vector<double> oblique_sides(const Panel& shape) {
  constexpr double same = 0.1, along = 5;  // degrees
  struct Direction {
    double degrees, length;
  };
  std::vector<Direction> found;
  const auto add = [&](const Loop& loop) {
    for (const OutlinePiece& piece : loop) {
      if (!piece.curve.straight()) continue;
      const Vec2 side = piece.curve.end() - piece.curve.start();
      const double degrees = std::atan2(side.y(), side.x()) * 180 / std::numbers::pi;
      if (std::abs(off_grain(degrees, shape.grain)) <= along) continue;
      const auto like = std::find_if(found.begin(), found.end(), [&](const Direction& d) {
        return std::abs(std::remainder(d.degrees - degrees, 90.0)) < same;
      });
      if (like != found.end())
        like->length += side.norm();
      else
        found.push_back({degrees, side.norm()});
    }
  };
  add(shape.outline);
  for (const Loop& hole : shape.holes) add(hole);
  std::stable_sort(found.begin(), found.end(),
                   [](const Direction& a, const Direction& b) { return a.length > b.length; });
  std::vector<double> directions;
  for (std::size_t i = 0; i < std::min<std::size_t>(found.size(), 4); ++i)
    directions.push_back(found[i].degrees);
  return directions;
}

std::ptrdiff_t triangles_of(const Mesh& mesh) {
  return std::count_if(mesh.elements.begin(), mesh.elements.end(),
                       [](const auto& element) { return element[3] < 0; });
}

// A mesh and the shape with the rows that it has.
struct Meshed {
  Mesh mesh;
  Panel shape;
};

// Stiff yarns lock the triangles of a rim that they cross obliquely, so rows are along sides that are oblique
// to the grain where these leave less than half as many.
Meshed best_of_rows(const Panel& shape) {
  Meshed best{PanelMesher(shape).make(), shape};
  std::ptrdiff_t fewest = (triangles_of(best.mesh) + 1) / 2;
  for (const double rows : oblique_sides(shape)) {
    if (fewest == 0) break;
    Panel turned = shape;
    turned.rows = rows;
    try {
      Mesh other = PanelMesher(turned).make();
      if (triangles_of(other) >= fewest) continue;
      fewest = triangles_of(other);
      best = {std::move(other), turned};
    } catch (const Error&) {
      // These rows give no good mesh; the one along the grain is there.
    }
  }
  return best;
}

double area_of(const Mesh& mesh, const std::array<Index, 4>& ids) {
  const auto x = [&](std::size_t k) -> const Vec3& { return mesh.nodes[at(ids[k])]; };
  return ids[3] < 0 ? (x(1) - x(0)).cross(x(2) - x(0)).norm() / 2
                    : (x(2) - x(0)).cross(x(3) - x(1)).norm() / 2;
}

// The least height of an element over its longest side, which the explicit step goes with, m.
double narrowest(const Mesh& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& ids : mesh.elements) {
    const std::size_t n = corner_count(ids);
    double longest = 0;
    for (std::size_t i = 0; i < n; ++i)
      longest = std::max(longest, (mesh.nodes[at(ids[i])] - mesh.nodes[at(ids[(i + 1) % n])]).norm());
    least = std::min(least, (n == 3 ? 2 : 1) * area_of(mesh, ids) / longest);
  }
  return least;
}

double share_of_triangles(const Mesh& mesh) {
  double all = 0, triangles = 0;
  for (const auto& ids : mesh.elements) {
    const double area = area_of(mesh, ids);
    all += area;
    if (ids[3] < 0) triangles += area;
  }
  return triangles / all;
}

// Whether triangles lock so much of a panel that it is better without them: always where the yarns cross all
// elements obliquely, otherwise from the share of which a model warns.
bool triangles_matter(const Meshed& with) {
  constexpr double much = 0.05;
  const double share = share_of_triangles(with.mesh);
  return share > (with.shape.rows ? 0 : much);
}

// Without triangles where they matter, unless elements would become much narrower.
Mesh best_of_kinds(const Panel& shape) {
  Meshed with = best_of_rows(shape);
  if (!triangles_matter(with)) return std::move(with.mesh);
  const double least = std::min(0.7 * narrowest(with.mesh), 0.35 * shape.size);
  try {
    Mesh without = PanelMesher(with.shape, Kind::halved).make();
    if (narrowest(without) >= least) return without;
  } catch (const Error&) {
    // An odd number of elements along a side, or a shape too narrow for elements of twice the size.
  }
  return std::move(with.mesh);
}

}  // namespace

Mesh panel(const Panel& shape) {
  check_length("panel", "size", shape.size);
  if (!std::isfinite(shape.grain)) refuse_panel("grain", "expected an angle in degrees");
  if (shape.rows && !std::isfinite(*shape.rows)) refuse_panel("rows", "expected an angle in degrees");
  const bool chosen = shape.rows || shape.triangles;
  if (!shape.quadrilaterals) return chosen ? PanelMesher(shape).make() : best_of_kinds(shape);
  if (!*shape.quadrilaterals) return chosen ? PanelMesher(shape).make() : best_of_rows(shape).mesh;
  if (shape.triangles) refuse_panel("quadrilaterals", "expected false with triangles=true");
  const Panel rowed = chosen ? shape : best_of_rows(shape).shape;
  return PanelMesher(rowed, Kind::halved).make();
}

}  // namespace fabricsh::mesh
