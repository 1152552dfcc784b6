#include "contact/search.hpp"

#include <omp.h>

#include "contact/grid.hpp"

namespace fabricsh::contact {
namespace {

constexpr double neighbour_share = 0.9;  // of their reference distance, as the gap of neighbours
constexpr double crossing_share = 0.5;   // share of the area of two crossing edges, see contact.md
constexpr double faces_reach = 3;    // mean edges: in the reference, how far crack faces are apart at most
constexpr double same_place = 1e-9;  // mean edges
// The weight of facets and edges that are on guard only, as a share of that of a contact point inside.
constexpr double on_guard = 0.01;
constexpr double shared = 0.5;  // weight where both surfaces have facets: two cloths press from both sides

using Rows = std::vector<Candidate>;

class Search {
 public:
  Search(const Scene& scene, std::span<const Vec3> x, double skin, std::span<const Vec3> by)
      : scene_(scene), x_(x), by_(by), skin_(skin) {
    for (const Vec3& u : by) mean_way_ += u / double(by.size());
    const auto& surfaces = scene.surfaces();
    number_.assign(surfaces.size() * surfaces.size(), -1);
    reach_.assign(surfaces.size(), 0);
    facet_reach_ = reach_;
    for (std::size_t i = 0; i < scene.interactions().size(); ++i) {
      const Interaction& it = scene.interactions()[i];
      const auto a = std::size_t(it.first), b = std::size_t(it.second);
      number_[a * surfaces.size() + b] = number_[b * surfaces.size() + a] = int(i);
      if (!has_facets(surfaces[a]) || !has_facets(surfaces[b])) continue;  // those are simple_shapes()
      const double gap = it.law.gap(),
                   far = by.empty() ? gap : std::min(gap, it.law.floor() + (room_of_way - 1) * skin),
                   more = surfaces[a].radius + surfaces[b].radius + (by.empty() ? skin : 0),
                   guarded = more + (by.empty() ? it.guarded : 1) * far;
      for (const std::size_t s : {a, b}) reach_[s] = std::max(reach_[s], guarded);
      facet_reach_[a] = std::max(facet_reach_[a], guarded);
      facet_reach_[b] = std::max(facet_reach_[b], more + far);
    }
    measure();
  }

  Rows run() {
    Rows out;
    if (std::any_of(reach_.begin(), reach_.end(), [](double reach) { return reach > 0; })) meshes(out);
    simple_shapes(out);
    return out;
  }

 private:
  const Vec3& at(std::int32_t p) const { return x_[std::size_t(p)]; }
  const Vec3& reference(std::int32_t p) const { return scene_.reference()[std::size_t(p)]; }
  const Surface& surface(std::int32_t s) const { return scene_.surfaces()[std::size_t(s)]; }
  static bool has_facets(const Surface& s) { return s.shape == Shape::cloth || s.shape == Shape::solid; }
  bool cloth(std::int32_t s) const { return surface(s).shape == Shape::cloth; }
  int number(std::int32_t a, std::int32_t b) const {
    return number_[std::size_t(a) * scene_.surfaces().size() + std::size_t(b)];
  }

  // The bounding box of the cloth and the size of its edges.
  void measure() {
    double sum = 0, count = 0;
    for (std::size_t s = 0; s < scene_.surfaces().size(); ++s) {
      const Surface& it = scene_.surfaces()[s];
      if (it.shape != Shape::cloth && it.shape != Shape::solid) continue;
      for (const std::int32_t p : it.points) {
        const Box way = box_of({p}, 0);
        if (it.shape == Shape::cloth) {
          room_.add(way.low);
          room_.add(way.high);
        }
        half_way_ = std::max(half_way_, half_of(way));
        points_.push_back(p);
        owner_.push_back(std::int32_t(s));
      }
      if (it.shape != Shape::cloth) continue;
      for (std::int32_t e = it.first_edge; e < it.first_edge + it.edges; ++e) {
        const EdgeRow& row = scene_.edges()[std::size_t(e)];
        half_ = std::max(half_, half_of(box_of({row.a, row.b}, 0)));
        sum += row.length;
        longest_ = std::max(longest_, row.length);
        count += 1;
        cloth_edges_.push_back(e);
      }
    }
    double most = 0;
    for (const double reach : facet_reach_) most = std::max(most, reach);
    room_ = room_.grown(most + half_way_);
    cell_ = std::max(count > 0 ? sum / count : 1, 1e-12);
  }

  // On their whole way, seen by who goes along with the mean of all.
  Box box_of(std::initializer_list<std::int32_t> points, double reach) const {
    Box box;
    for (const std::int32_t p : points) {
      box.add(at(p));
      if (!by_.empty()) box.add(at(p) + by_[std::size_t(p)] - mean_way_);
    }
    return box.grown(reach);
  }
  static double half_of(const Box& box) { return 0.5 * (box.high - box.low).maxCoeff(); }
  static Vec3 middle_of(const Box& box) { return 0.5 * (box.low + box.high); }

  // Runs work on `count` rows in parallel; the results are joined in the order of the rows.
  template <class Work>
  void join(std::size_t count, Rows& out, Work work) const {
    const auto threads = std::size_t(omp_get_max_threads());
    std::vector<Rows> found(threads);
#pragma omp parallel num_threads(int(threads))
    {
      const auto me = std::size_t(omp_get_thread_num()), all = std::size_t(omp_get_num_threads());
      std::vector<std::int32_t> near;
      for (std::size_t i = count * me / all; i < count * (me + 1) / all; ++i) work(i, near, found[me]);
    }
    for (const Rows& rows : found) out.insert(out.end(), rows.begin(), rows.end());
  }

  // The numbers, ascending, of those things in a grid that are wanted and whose box meets the given box.
  template <class Wanted>
  static void meeting(const Grid& grid, const Boxes& boxes, const Box& cells, const Box& box,
                      std::vector<std::int32_t>& near, Wanted wanted) {
    near.clear();
    const Boxes::Bounds bounds = Boxes::outside(box);
    grid.rows(cells, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; i += Boxes::pack) {
        const std::array<int, Boxes::pack> meets = boxes.meeting(bounds, i);
        for (std::size_t k = 0; k < Boxes::pack && i + k < last; ++k)
          if (meets[k] != 0 && wanted(grid.order()[i + k])) near.push_back(grid.order()[i + k]);
      }
    });
    std::sort(near.begin(), near.end());
  }

  void meshes(Rows& out) const {
    const Grid points(room_, cell_, points_.size(),
                      [&](std::size_t i) { return middle_of(box_of({points_[i]}, 0)); });
    const Boxes places(points.order(), [&](std::int32_t i) { return box_of({points_[std::size_t(i)]}, 0); });
    join(scene_.triangles().size(), out, [&](std::size_t t, std::vector<std::int32_t>& near, Rows& rows) {
      const TriangleRow& row = scene_.triangles()[t];
      const double reach = facet_reach_[std::size_t(row.surface)];
      if (reach == 0) return;
      const Box box = box_of({row.nodes[0], row.nodes[1], row.nodes[2]}, reach);
      meeting(points, places, box.grown(half_way_), box, near, [](std::int32_t) { return true; });
      for (const std::int32_t i : near)
        facet(points_[std::size_t(i)], owner_[std::size_t(i)], std::int32_t(t), rows);
    });
    const auto ends = [&](std::int32_t e) {
      const EdgeRow& row = scene_.edges()[std::size_t(cloth_edges_[std::size_t(e)])];
      return box_of({row.a, row.b}, 0);
    };
    const Grid middles(room_, cell_, cloth_edges_.size(),
                       [&](std::size_t i) { return middle_of(ends(std::int32_t(i))); });
    const Boxes boxes(middles.order(), ends);
    join(scene_.edges().size(), out, [&](std::size_t e, std::vector<std::int32_t>& near, Rows& rows) {
      const EdgeRow& row = scene_.edges()[e];
      const double reach = reach_[std::size_t(row.surface)];
      if (reach == 0 || surface(row.surface).shape == Shape::rod || row.inside_flat) return;
      const Box box = box_of({row.a, row.b}, reach);
      const std::int32_t after = cloth(row.surface) ? std::int32_t(e) : -1;  // each two once
      meeting(middles, boxes, box.grown(half_), box, near,
              [&](std::int32_t i) { return cloth_edges_[std::size_t(i)] > after; });
      for (const std::int32_t i : near) edges(std::int32_t(e), cloth_edges_[std::size_t(i)], rows);
    });
  }

  // Where overlaps are opened, sheets that share no node are no neighbours, however near they lie.
  bool same_sheet(int which, std::int32_t p, std::int32_t q) const {
    return scene_.interactions()[std::size_t(which)].opening.empty() || scene_.neighbours().same_sheet(p, q);
  }
  // Factor on the law's lengths: 1, less for neighbours in a sheet, 0 for pairs that share a place, as on
  // both sides of a slit.
  double scale(double reference_distance, const ContactLaw& law) const {
    if (reference_distance < same_place * cell_) return 0;
    return std::min(1.0, neighbour_share * reference_distance / law.gap());
  }
  // Whether a pair at this distance in the reference is one of crack faces.
  bool crack_faces(std::span<const std::int32_t> one, std::span<const std::int32_t> other,
                   double distance) const {
    const auto is_crack_face = [&](std::int32_t p) { return scene_.neighbours().apart(p) >= 0; };
    return !scene_.neighbours().apart().empty() && distance < faces_reach * cell_ &&
           std::any_of(one.begin(), one.end(), is_crack_face) &&
           std::any_of(other.begin(), other.end(), is_crack_face);
  }
  // The same for crack faces, which may lie at the same place and are no neighbours then.
  double scale(double reference_distance, const ContactLaw& law, bool crack_faces) const {
    return crack_faces && reference_distance < same_place * cell_ ? 1 : scale(reference_distance, law);
  }
  // Whether a seam holds a point and one of others together; `parted`: it did until it was opened.
  bool sewn(std::int32_t p, std::span<const std::int32_t> others, bool& parted) const {
    if (!scene_.neighbours().is_sewn(p)) return false;
    bool together = false;
    for (const std::int32_t q : others) {
      if (!scene_.neighbours().are_sewn(p, q)) continue;
      if (scene_.neighbours().apart(p) >= 0 && scene_.neighbours().apart(q) >= 0)
        parted = true;
      else
        together = true;
    }
    return together;
  }
  double reference_distance(std::int32_t p, const Triangle& t) const {
    return std::sqrt(squared_point_triangle(reference(p), reference(t[0]), reference(t[1]), reference(t[2])));
  }
  double facet_scale(std::int32_t p, const Triangle& t, double distance, const ContactLaw& law,
                     bool& are_faces) const {
    are_faces = false;
    if (p == t[0] || p == t[1] || p == t[2]) return 0;
    are_faces = crack_faces(std::span(&p, 1), t, distance);
    return scale(distance, law, are_faces);
  }
  // Share at which a pair begins where overlaps are opened: its point's, or the smallest of its edges' ends.
  static double start(const Candidate& row, const std::vector<double>& opening) {
    if (opening.empty()) return 1;
    double least = 1;
    if (row.spot.any())
      for (const std::int32_t p : row.spot.node) least = std::min(least, opening[std::size_t(p)]);
    else
      least = opening[std::size_t(row.point[0])];
    if (row.pair.kind == PairKind::edges || row.pair.kind == PairKind::wrap)
      for (const std::int32_t p : row.point) least = std::min(least, opening[std::size_t(p)]);
    return least;
  }
  // Pairs out of reach at the law's whole lengths need no further look.
  bool far(const Candidate& row, const ContactLaw& law) const {
    return gap_of(row, corners_of(row, x_)) >= reach_of(row, law);
  }
  // m: how near a pair is to be listed.
  double reach_of(const Candidate& row, const ContactLaw& law) const {
    return by_.empty() ? law.gap() * row.pair.scale + skin_ : reach_on_way(row, law, by_, skin_);
  }
  bool keep(Candidate& row, const ContactLaw& law, Rows& rows) const {
    const double gap = gap_of(row, corners_of(row, x_));
    if (gap >= reach_of(row, law)) return false;
    row.whole = row.pair.scale;
    row.start = start(row, scene_.interactions()[std::size_t(row.interaction)].opening);
    rows.push_back(row);
    return true;
  }

  void facet(std::int32_t p, std::int32_t owner, std::int32_t t, Rows& rows) const {
    const TriangleRow& row = scene_.triangles()[std::size_t(t)];
    const int which = number(owner, row.surface);
    if (which < 0) return;
    if (p == row.nodes[0] || p == row.nodes[1] || p == row.nodes[2]) return;
    bool parted = false;
    if (sewn(p, row.nodes, parted)) return;
    const ContactLaw& law = scene_.interactions()[std::size_t(which)].law;
    Candidate out;
    out.point = {p, row.nodes[0], row.nodes[1], row.nodes[2]};
    out.interaction = which;
    out.pair.kind = PairKind::facet;
    out.pair.edge = row.edge;
    out.pair.corner = row.corner;
    out.pair.offset = surface(owner).radius + surface(row.surface).radius;
    const bool neighbours = owner == row.surface && same_sheet(which, p, row.nodes[0]);
    bool beside_neighbours = false;
    if (neighbours) {
      if (far(out, law)) return;
      const double distance = reference_distance(p, row.nodes);
      beside_neighbours = distance < longest_ + law.gap() / neighbour_share;
      out.pair.scale = facet_scale(p, row.nodes, distance, law, out.crack_faces);
      if (out.pair.scale == 0) return;
    }
    out.crack_faces = out.crack_faces || parted;
    if (!cloth(row.surface))
      out.pair.area = scene_.area(p);
    else if (cloth(owner))
      out.pair.area = shared * scene_.area(p);
    else {
      out.pair.area = shared * std::min(scene_.area(p), surface(row.surface).mean_area);
      out.pair.scale = scene_.interactions()[std::size_t(which)].guarded;
    }
    if (!keep(out, law, rows)) return;
    if (!by_.empty()) return;
    rows.back().facet = t;
    // Crack faces have other lengths from facet to facet.
    if (!neighbours || scene_.neighbours().apart().empty()) rows.back().shared = row.shared;
    if (beside_neighbours || scene_.neighbours().is_sewn(p)) uncount_neighbours(rows.back(), row, law);
  }

  // Next to a facet that has the point as a neighbour nothing is
  // subtracted: places there count more than once rather than not at all.
  void uncount_neighbours(Candidate& out, const TriangleRow& row, const ContactLaw& law) const {
    const auto neighbour = [&](std::span<const std::int32_t> triangles) {
      for (const std::int32_t t : triangles) {
        const TriangleRow& other = scene_.triangles()[std::size_t(t)];
        bool crack_faces = false;
        if (sewn(out.point[0], other.nodes, crack_faces)) return true;
        if (other.surface != row.surface) continue;
        const double distance = reference_distance(out.point[0], other.nodes);
        if (facet_scale(out.point[0], other.nodes, distance, law, crack_faces) < 1) return true;
      }
      return false;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const auto uncount = [&](std::int8_t& count, unsigned bit, std::span<const std::int32_t> triangles) {
        if ((count == 0 && (out.shared & bit) == 0) || !neighbour(triangles)) return;
        count = 0;
        out.shared &= std::uint8_t(~bit);
      };
      uncount(out.pair.edge[k], 1u << k, scene_.triangles_at_edge(row.edge_row[k]));
      uncount(out.pair.corner[k], 8u << k, scene_.triangles_at_point(row.nodes[k]));
    }
  }

  void edges(std::int32_t e, std::int32_t f, Rows& rows) const {
    const EdgeRow& a = scene_.edges()[std::size_t(e)];
    const EdgeRow& b = scene_.edges()[std::size_t(f)];
    const int which = number(a.surface, b.surface);
    if (which < 0) return;
    if (a.a == b.a || a.a == b.b || a.b == b.a || a.b == b.b) return;
    bool parted = false;
    const std::array<std::int32_t, 2> ends{b.a, b.b};
    if (sewn(a.a, ends, parted) || sewn(a.b, ends, parted)) return;
    const ContactLaw& law = scene_.interactions()[std::size_t(which)].law;
    Candidate out;
    out.point = {a.a, a.b, b.a, b.b};
    out.interaction = which;
    out.pair.kind = PairKind::edges;
    out.pair.offset = surface(a.surface).radius + surface(b.surface).radius;
    if (a.surface != b.surface) out.pair.scale = scene_.interactions()[std::size_t(which)].guarded;
    if (a.surface == b.surface && same_sheet(which, a.a, b.a)) {
      if (far(out, law)) return;
      const double apart =
          std::sqrt(squared_segment_segment(reference(a.a), reference(a.b), reference(b.a), reference(b.b)));
      out.crack_faces = crack_faces(std::array{a.a, a.b}, std::array{b.a, b.b}, apart);
      out.pair.scale = scale(apart, law, out.crack_faces);
      if (out.pair.scale == 0) return;
    }
    out.crack_faces = out.crack_faces || parted;
    const double width = std::min(a.area / a.length, b.area / b.length);
    const double end = law.gap() * out.pair.scale + out.pair.offset;
    out.pair.area = crossing_share * width * width;
    out.pair.fading = {true, std::min(0.5, end / a.length), std::min(0.5, end / b.length)};
    keep(out, law, rows);
  }

  // Pairs of balls, rods and walls with every cloth that they meet.
  void simple_shapes(Rows& out) const {
    for (std::size_t i = 0; i < scene_.interactions().size(); ++i) {
      const Interaction& it = scene_.interactions()[i];
      const Surface& shape = surface(it.second);
      const Surface& sheet = surface(it.first);
      if (it.rigid) {
        rigid_shapes(it, std::int32_t(i), out);
        continue;
      }
      if (shape.shape == Shape::cloth || shape.shape == Shape::solid) continue;
      const std::int32_t v = shape.first_vertex;
      Candidate row;
      row.interaction = std::int32_t(i);
      row.pair.offset = shape.radius;
      nodes(it, sheet, shape, row, out);
      spots(it, sheet, shape, row, out);
      if (shape.shape == Shape::rod) wraps(it, sheet, v, row, out);
      if (shape.shape != Shape::wall)
        for (std::int32_t k = 0; k < shape.vertices; ++k) facets(it, sheet, v + k, row, out);
    }
  }

  // Two rigid shapes press from where their surfaces touch, so that the law's gap is taken off the radii.
  void rigid_shapes(const Interaction& it, std::int32_t which, Rows& out) const {
    const Surface &points = surface(it.first), &shape = surface(it.second);
    Candidate row;
    row.interaction = which;
    row.pair.area = 1;
    row.pair.offset = points.radius + shape.radius - it.law.gap();
    row.pair.kind = shape.shape == Shape::wall    ? PairKind::plane
                    : shape.shape == Shape::rod   ? PairKind::segment
                    : shape.shape == Shape::solid ? PairKind::facet
                                                  : PairKind::centre;
    for (const std::int32_t p : points.points) {
      row.point[0] = p;
      if (shape.shape == Shape::solid) {
        for (std::int32_t t = shape.first_triangle; t < shape.first_triangle + shape.triangles; ++t)
          facet_of_rigid(it, row, t, out);
        continue;
      }
      for (std::int32_t k = 0; k < shape.vertices; ++k)
        row.point[std::size_t(k + 1)] = shape.first_vertex + k;
      keep(row, it.law, out);
    }
  }

  void facet_of_rigid(const Interaction& it, Candidate row, std::int32_t t, Rows& out) const {
    const TriangleRow& triangle = scene_.triangles()[std::size_t(t)];
    for (std::size_t k = 0; k < 3; ++k) row.point[k + 1] = triangle.nodes[k];
    row.pair.edge = triangle.edge;
    row.pair.corner = triangle.corner;
    keep(row, it.law, out);
  }

  void nodes(const Interaction& it, const Surface& sheet, const Surface& shape, Candidate row,
             Rows& out) const {
    const std::int32_t v = shape.first_vertex;
    const bool wall = shape.shape == Shape::wall;
    row.pair.kind = wall ? PairKind::plane : shape.shape == Shape::rod ? PairKind::segment : PairKind::centre;
    const double reach = it.law.gap() + shape.radius + skin_;
    const Box box = wall ? Box{} : shape.vertices == 1 ? box_of({v}, reach) : box_of({v, v + 1}, reach);
    const Vec3 normal = wall ? Vec3((at(v + 1) - at(v)).cross(at(v + 2) - at(v)).normalized()) : Vec3::Zero();
    join(sheet.points.size(), out, [&](std::size_t i, std::vector<std::int32_t>&, Rows& rows) {
      const std::int32_t p = sheet.points[i];
      if (wall ? normal.dot(at(p) - at(v)) >= reach : !box.meets(Box{at(p), at(p)})) return;
      Candidate found = row;
      found.point[0] = p;
      for (std::int32_t k = 0; k < shape.vertices; ++k) found.point[std::size_t(k + 1)] = v + k;
      if (wall)
        found.pair.area = scene_.area(p);
      else
        node_area(it, sheet, p).set(found.pair);
      keep(found, it.law, rows);
    });
  }

  // The number of parts of a triangle with contact points inside it for an interaction with a ball or a rod.
  int parts(const Interaction& it, const Surface& sheet, std::int32_t t) const {
    return it.parts.empty() ? 0 : it.parts[std::size_t(t - sheet.first_triangle)];
  }
  // The areas of nodes, edges and facets without those triangles. In these nodes, edges and facets stay on
  // guard: they keep what is between the contact points from coming nearer to the body than these may. What
  // the barrier carries there rubs on a spring that is as stiff as if all of the area were theirs.
  struct Area {
    double whole = 0, counted = 0;  // m2
    void add(double area, double share) {
      whole += shared * area;
      counted += share * area;
    }
    void set(Pair& pair) const {
      pair.area = counted;
      pair.grip = static_cast<float>(whole > counted ? whole / counted : 1);
    }
  };
  double share(const Interaction& it, const Surface& sheet, std::int32_t t) const {
    const int n = parts(it, sheet, t);
    return n == 0 ? shared : on_guard / (n * n);
  }
  Area facet_area(const Interaction& it, const Surface& sheet, std::int32_t t) const {
    Area out;
    out.add(scene_.triangles()[std::size_t(t)].area, share(it, sheet, t));
    return out;
  }
  Area node_area(const Interaction& it, const Surface& sheet, std::int32_t p) const {
    Area all;
    if (it.parts.empty()) {
      all.add(scene_.area(p), shared);
      return all;
    }
    for (const std::int32_t t : scene_.triangles_at_point(p))
      if (scene_.triangles()[std::size_t(t)].surface == it.first)
        all.add(scene_.triangles()[std::size_t(t)].area, share(it, sheet, t));
    const double whole = shared * scene_.area(p);
    return {whole, whole * (all.counted / all.whole)};
  }
  Area edge_area(const Interaction& it, const Surface& sheet, std::int32_t e) const {
    Area out;
    if (it.parts.empty())
      out.add(scene_.edges()[std::size_t(e)].area, shared);
    else
      for (const std::int32_t t : scene_.triangles_at_edge(e))
        out.add(scene_.triangles()[std::size_t(t)].area / 3, share(it, sheet, t));
    return out;
  }

  // Facets and edges tell what passes on a way, so that contact points are left out there.
  void spots(const Interaction& it, const Surface& sheet, const Surface& shape, Candidate row,
             Rows& out) const {
    if (it.parts.empty() || !by_.empty()) return;
    const std::int32_t v = shape.first_vertex;
    row.pair.kind = shape.shape == Shape::rod ? PairKind::segment : PairKind::centre;
    for (std::int32_t k = 0; k < shape.vertices; ++k) row.point[std::size_t(k + 1)] = v + k;
    const double reach = it.law.gap() + shape.radius + skin_;
    join(std::size_t(sheet.triangles), out, [&](std::size_t i, std::vector<std::int32_t>&, Rows& rows) {
      const auto t = sheet.first_triangle + std::int32_t(i);
      const int n = parts(it, sheet, t);
      if (n == 0) return;
      const Triangle& c = scene_.triangles()[std::size_t(t)].nodes;
      const Vec3 middle = (at(c[0]) + at(c[1]) + at(c[2])) / 3;
      double far = 0;
      for (const std::int32_t p : c) far = std::max(far, (at(p) - middle).squaredNorm());
      far = reach + std::sqrt(far);
      if (squared_point_segment(middle, at(v), at(v + shape.vertices - 1)) > far * far) return;
      Candidate found = row;
      found.pair.area = scene_.triangles()[std::size_t(t)].area / (n * n);
      for (int k = 0; k < n * n; ++k) {
        found.spot = scene_.spots().at(t, n, k);
        found.point[0] = scene_.spots().number(t, k);
        keep(found, it.law, rows);
      }
    });
  }

  void wraps(const Interaction& it, const Surface& sheet, std::int32_t v, Candidate row, Rows& out) const {
    row.pair.kind = PairKind::wrap;
    const Box box = box_of({v, v + 1}, it.law.gap() + row.pair.offset + skin_);
    join(std::size_t(sheet.edges), out, [&](std::size_t i, std::vector<std::int32_t>&, Rows& rows) {
      const EdgeRow& e = scene_.edges()[std::size_t(sheet.first_edge) + i];
      if (!box.meets(box_of({e.a, e.b}, 0))) return;
      Candidate found = row;
      found.point = {e.a, e.b, v, v + 1};
      edge_area(it, sheet, sheet.first_edge + std::int32_t(i)).set(found.pair);
      keep(found, it.law, rows);
    });
  }

  void facets(const Interaction& it, const Surface& sheet, std::int32_t v, Candidate row, Rows& out) const {
    row.pair.kind = PairKind::facet;
    const Box box = box_of({v}, it.law.gap() + row.pair.offset + skin_);
    join(std::size_t(sheet.triangles), out, [&](std::size_t i, std::vector<std::int32_t>&, Rows& rows) {
      const TriangleRow& t = scene_.triangles()[std::size_t(sheet.first_triangle) + i];
      if (!box.meets(box_of({t.nodes[0], t.nodes[1], t.nodes[2]}, 0))) return;
      Candidate found = row;
      found.point = {v, t.nodes[0], t.nodes[1], t.nodes[2]};
      facet_area(it, sheet, sheet.first_triangle + std::int32_t(i)).set(found.pair);
      keep(found, it.law, rows);
    });
  }

  const Scene& scene_;
  std::span<const Vec3> x_, by_;
  double skin_;
  std::vector<int> number_;
  // m: of each surface's edges to others, and of its facets to points; 0: it meets none that has facets.
  std::vector<double> reach_, facet_reach_;
  std::vector<std::int32_t> points_, owner_;  // points of cloths and solids
  std::vector<std::int32_t> cloth_edges_;
  Box room_;
  Vec3 mean_way_ = Vec3::Zero();
  double half_ = 0, half_way_ = 0;  // m: half of the largest boxes of edges, of points on their way
  double cell_ = 1;                 // m: width of a cell
  double longest_ = 0;              // m: of the reference edges of cloth
};

}  // namespace

std::vector<Candidate> find_pairs(const Scene& scene, std::span<const Vec3> x, double skin,
                                  std::span<const Vec3> by) {
  return Search(scene, x, skin, by).run();
}

Corners corners_of(const Candidate& candidate, std::span<const Vec3> x) {
  Corners out;
  std::size_t i = 0;
  if (candidate.spot.any()) out[i++] = candidate.spot.of(x);
  for (; i < 4; ++i)
    out[i] = candidate.point[i] < 0 ? Vec3(Vec3::Zero()) : x[std::size_t(candidate.point[i])];
  return out;
}

double reach_on_way(const Candidate& candidate, const ContactLaw& law, std::span<const Vec3> by,
                    double most) {
  const auto& point = candidate.point;
  double square = 0;
  for (std::size_t i = 1; i < 4 && candidate.pair.kind != PairKind::plane; ++i)
    for (std::size_t j = 0; j < i && point[i] >= 0; ++j)
      square = std::max(square, (by[std::size_t(point[i])] - by[std::size_t(point[j])]).squaredNorm());
  const double nearer = candidate.pair.kind == PairKind::plane ? most : std::min(most, std::sqrt(square));
  return std::min(law.gap() * candidate.pair.scale + nearer,
                  law.floor() * candidate.pair.scale + room_of_way * nearer);
}

double gap_of(const Candidate& candidate, const Corners& x) {
  const double offset = candidate.pair.offset;
  switch (candidate.pair.kind) {
    case PairKind::facet:
      return std::sqrt(squared_point_triangle(x[0], x[1], x[2], x[3])) - offset;
    case PairKind::plane:
      return point_plane(x).distance - offset;
    case PairKind::edges:
    case PairKind::wrap:
      return std::sqrt(squared_segment_segment(x[0], x[1], x[2], x[3])) - offset;
    case PairKind::segment:
      return std::sqrt(squared_point_segment(x[0], x[1], x[2])) - offset;
    case PairKind::centre:
      break;
  }
  return (x[0] - x[1]).norm() - offset;
}

}  // namespace fabricsh::contact
