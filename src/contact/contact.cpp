#include "contact/contact.hpp"

#include <cmath>
#include <limits>

#include "contact/advance.hpp"

namespace fabricsh::contact {
namespace {

constexpr double nearly = 1 - 1e-9;  // of the motion that a list allows for: rounding never decides

double mean_edge(const Scene& scene) {
  double sum = 0, count = 0;
  for (const EdgeRow& row : scene.edges())
    if (scene.surfaces()[std::size_t(row.surface)].shape == Shape::cloth) {
      sum += row.length;
      count += 1;
    }
  return count > 0 ? sum / count : 1e-3;
}

// The corners of a pair move from x to end; the share of that motion until the pair reaches its floor.
double pair_share(const Candidate& c, const Law& law, const Corners& x, const Corners& end) {
  const double least = c.pair.offset + law.floor() * c.pair.scale;
  const auto pairs = Simplices::segment_segment;
  switch (c.pair.kind) {
    case Kind::facet:
      return safe_share(Simplices::point_triangle, x, end, least);
    case Kind::edges:
    case Kind::wrap:
      return safe_share(pairs, x, end, least);
    case Kind::segment:
      return safe_share(pairs, {x[0], x[0], x[1], x[2]}, {end[0], end[0], end[1], end[2]}, least);
    case Kind::centre:
      return safe_share(pairs, {x[0], x[0], x[1], x[1]}, {end[0], end[0], end[1], end[1]}, least);
    case Kind::plane:
      break;
  }
  const double from = point_plane(x).distance - least, to = point_plane(end).distance - least;
  if (!(from > 0)) return 0;
  return to >= 0.1 * from ? 1 : 0.9 * from / (from - to);
}

// Scaling the law's lengths for neighbours in a sheet also scales the way from gap to floor.
double narrowest(const Scene& scene, double least) {
  double gap = 0;
  for (const Interaction& it : scene.interactions()) {
    least = std::min(least, it.law.gap() - it.law.floor());
    gap = std::max(gap, it.law.gap());
  }
  for (const Candidate& c : find_pairs(scene, scene.reference(), 0.2 * gap)) {
    const Law& law = scene.interactions()[std::size_t(c.interaction)].law;
    least = std::min(least, c.pair.scale * (law.gap() - law.floor()));
  }
  return least;
}

}  // namespace

Contact::Contact(const Scene& scene, Skins skins) : scene_(&scene), skins_(skins) {
  const double edge = mean_edge(scene);
  if (!(skins_.outer > 0)) skins_.outer = edge / 3;
  if (!(skins_.inner > 0)) skins_.inner = std::min(edge / 8, skins_.outer / 2);
  for (const Interaction& it : scene.interactions())
    widest_ = std::max(widest_, it.law.gap() - it.law.floor());
  narrowest_ = narrowest(scene, widest_);
  gap_.assign(scene.reference().size(), widest_);
  pressure_.assign(scene.reference().size(), 0);
}

// The largest displacement relative to the mean one, m. The mean decides only how long the lists last.
double Contact::moved(std::span<const Vec3> x, const std::vector<Vec3>& since) const {
  const auto n = std::ptrdiff_t(x.size());
  double a = 0, b = 0, c = 0, most = 0;
#pragma omp parallel for schedule(static) reduction(+ : a, b, c) if (n > 4096)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    a += x[std::size_t(i)].x() - since[std::size_t(i)].x();
    b += x[std::size_t(i)].y() - since[std::size_t(i)].y();
    c += x[std::size_t(i)].z() - since[std::size_t(i)].z();
  }
  const Vec3 mean = Vec3(a, b, c) / double(n);
#pragma omp parallel for schedule(static) reduction(max : most) if (n > 4096)
  for (std::ptrdiff_t i = 0; i < n; ++i)
    most = std::max(most, (x[std::size_t(i)] - since[std::size_t(i)] - mean).squaredNorm());
  return std::sqrt(most);
}

void Contact::prepare(std::span<const Vec3> x) {
  if (at_search_.size() != x.size()) {
    search(x);
  } else if (2 * moved(x, at_refine_) > nearly * skins_.inner) {
    if (2 * moved(x, at_search_) + skins_.inner > nearly * skins_.outer)
      search(x);
    else
      refine(x);
  }
}

void Contact::search(std::span<const Vec3> x) {
  outer_ = find_pairs(*scene_, x, skins_.outer);
  at_search_.assign(x.begin(), x.end());
  ++searches_;
  refine(x);
}

void Contact::refine(std::span<const Vec3> x) {
  std::vector<char> near(outer_.size());
#pragma omp parallel for schedule(static) if (outer_.size() > 1024)
  for (std::size_t i = 0; i < outer_.size(); ++i)
    near[i] = gap_of(outer_[i], corners_of(outer_[i], x)) <
              law(outer_[i]).gap() * outer_[i].pair.scale + skins_.inner;
  inner_.clear();
  for (std::size_t i = 0; i < outer_.size(); ++i)
    if (near[i]) inner_.push_back(outer_[i]);
  at_refine_.assign(x.begin(), x.end());
  ++version_;
  index_slots();
}

// For each point, the slots that hold forces on it, in the order of the pairs.
void Contact::index_slots() {
  slots_.resize(inner_.size());
  std::vector<std::uint32_t> count(scene_->reference().size() + 1, 0);
  for (const Candidate& c : inner_)
    for (const std::int32_t p : c.point)
      if (p >= 0) ++count[std::size_t(p) + 1];
  touched_.clear();
  for (std::size_t p = 0; p + 1 < count.size(); ++p) {
    if (count[p + 1] > 0) touched_.push_back(std::int32_t(p));
    count[p + 1] += count[p];
  }
  of_point_.resize(count.back());
  first_.clear();
  for (const std::int32_t p : touched_) first_.push_back(count[std::size_t(p)]);
  first_.push_back(count.back());
  std::vector<std::uint32_t> next(count.begin(), count.end() - 1);
  for (std::size_t i = 0; i < inner_.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (inner_[i].point[k] >= 0)
        of_point_[next[std::size_t(inner_[i].point[k])]++] = std::uint32_t(4 * i + k);
  energy_.resize(touched_.size());
  guard_.resize(touched_.size());
  lost_.resize(touched_.size());
  std::fill(gap_.begin(), gap_.end(), widest_);
  std::fill(pressure_.begin(), pressure_.end(), 0);
}

Totals Contact::add_forces(std::span<const Vec3> x, std::span<Vec3> force, const Motion* motion) {
  prepare(x);
  Totals totals;
  double least = narrowest_;
  const auto n = std::ptrdiff_t(inner_.size());
#pragma omp parallel for schedule(static) reduction(min : least) if (n > 256)
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Candidate& c = inner_[std::size_t(i)];
    const Corners corners = corners_of(c, x);
    const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
    Sliding sliding;
    const bool slides = motion != nullptr && it.friction > 0;
    if (slides) {
      sliding.friction = it.friction;
      sliding.step = motion->step;
      for (std::size_t k = 0; k < 4; ++k)
        if (c.point[k] >= 0) {
          sliding.velocity[k] = motion->velocity[std::size_t(c.point[k])];
          sliding.inverse_mass[k] = motion->inverse_mass[std::size_t(c.point[k])];
        }
    }
    Force& slot = slots_[std::size_t(i)];
    slot = pair_force(it.law, c.pair, corners, slides ? &sliding : nullptr);
    if (slot.active) least = std::min(least, slot.gap);
  }
  totals.gap = least;
  gather(force, totals);
  return totals;
}

void Contact::gather(std::span<Vec3> force, Totals& totals) {
  const auto n = std::ptrdiff_t(touched_.size());
  std::size_t touching = 0;
#pragma omp parallel for schedule(static) reduction(+ : touching) if (n > 256)
  for (std::ptrdiff_t t = 0; t < n; ++t) {
    const auto row = std::size_t(t);
    const auto p = std::size_t(touched_[row]);
    Vec3 sum = Vec3::Zero();
    double contact = 0, guard = 0, lost = 0, nearest = widest_;
    for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
      const Force& slot = slots_[of_point_[k] / 4];
      if (!slot.active) continue;
      nearest = std::min(nearest, slot.gap);
      sum += slot.on[of_point_[k] % 4];
      if (of_point_[k] % 4 != 0) continue;  // the energies of a pair are counted at its first corner
      contact += slot.contact;
      guard += slot.guard;
      lost += slot.lost;
      ++touching;
    }
    force[p] += sum;
    energy_[row] = contact;
    guard_[row] = guard;
    lost_[row] = lost;
    gap_[p] = nearest;
    const double area = scene_->area(std::int32_t(p));
    pressure_[p] = area > 0 ? sum.norm() / area : 0;
  }
  totals.touching = touching;
  // Over all points and not only those in the lists, which depend on the skin.
  for (std::size_t row = 0; row < touched_.size(); ++row) {
    totals.contact += energy_[row];
    totals.guard += guard_[row];
    totals.lost += lost_[row];
  }
}

void Contact::stiffness(std::span<const Vec3> x, const VisitStiffness& visit, std::span<const Vec3> start,
                        double creep) {
  prepare(x);
  for (const Candidate& c : inner_) {
    const Corners corners = corners_of(c, x);
    const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
    if (gap_of(c, corners) >= it.law.gap() * c.pair.scale) continue;
    Matrix12 k = pair_derivatives(it.law, c.pair, corners).hessian;
    if (!start.empty() && it.friction > 0)
      k -= pair_friction(it.law, c.pair, corners, {it.friction, creep, corners_of(c, start)}, true).jacobian;
    visit(c.point, k);
  }
}

double Contact::add_friction(std::span<const Vec3> x, std::span<const Vec3> start, double creep,
                             std::span<Vec3> force) {
  prepare(x);
  double lost = 0;
  for (const Candidate& c : inner_) {
    const Interaction& it = scene_->interactions()[std::size_t(c.interaction)];
    if (it.friction == 0) continue;
    const Friction f =
        pair_friction(it.law, c.pair, corners_of(c, x), {it.friction, creep, corners_of(c, start)}, false);
    if (f.lost == 0) continue;
    lost += f.lost;
    for (std::size_t k = 0; k < 4; ++k)
      if (c.point[k] >= 0) force[std::size_t(c.point[k])] += f.force.segment<3>(3 * int(k));
  }
  return lost;
}

void Contact::couples(std::span<const Vec3> x,
                      const std::function<void(const std::array<std::int32_t, 4>&)>& visit) {
  prepare(x);
  for (const Candidate& c : inner_) visit(c.point);
}

double Contact::safe_share(std::span<const Vec3> x, std::span<const Vec3> by) const {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& u : by) mean += u;
  mean /= double(by.size());
  double most = 0;
  for (const Vec3& u : by) most = std::max(most, (u - mean).norm());
  const auto pairs = find_pairs(*scene_, x, 2 * most * (1 + 1e-9));
  double share = 1;
#pragma omp parallel for schedule(static) reduction(min : share) if (pairs.size() > 64)
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Corners start = corners_of(pairs[i], x), step = corners_of(pairs[i], by);
    Corners end;
    for (std::size_t k = 0; k < 4; ++k) end[k] = start[k] + step[k];
    share = std::min(share, pair_share(pairs[i], law(pairs[i]), start, end));
  }
  return share;
}

std::vector<Contact::Overlap> Contact::overlaps(std::span<const Vec3> x) const {
  std::vector<Overlap> found;
  for (const Candidate& c : find_pairs(*scene_, x, 0)) {
    const double gap = gap_of(c, corners_of(c, x));
    if (gap <= law(c).floor() * c.pair.scale) found.push_back({c.point, gap});
  }
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;
  for (const EdgeRow& e : scene_->edges()) edges.push_back({e.a, e.b});
  for (const TriangleRow& t : scene_->triangles()) triangles.push_back(t.nodes);
  for (const auto& [e, t] : intersections(x, edges, triangles)) {
    const EdgeRow& edge = scene_->edges()[e];
    const TriangleRow& triangle = scene_->triangles()[t];
    if (scene_->between(edge.surface, triangle.surface) == nullptr) continue;
    const std::int32_t apex = triangle.nodes[2];
    found.push_back({{edge.a, edge.b, triangle.nodes[0], apex}, 0});
  }
  return found;
}

Contact::Overlap Contact::nearest(std::span<const Vec3> x) {
  prepare(x);
  Overlap found{{-1, -1, -1, -1}, widest_};
  for (const Candidate& c : inner_) {
    const double gap = gap_of(c, corners_of(c, x)), scale = c.pair.scale;
    if (gap >= law(c).gap() * scale || gap - law(c).floor() * scale >= found.gap) continue;
    found = {c.point, gap - law(c).floor() * scale};
  }
  return found;
}

}  // namespace fabricsh::contact
