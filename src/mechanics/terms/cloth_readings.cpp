// Directions of the deformed yarns. At each in-plane point the material direction m_i = T_i1 G_1 + T_i2 G_2
// of the reference has become T_i1 a_1 + T_i2 a_2. Transform and base vectors belong to the same point: in
// quadrilaterals that are no parallelograms both change from point to point.
#include "mechanics/terms/cloth_readings.hpp"

#include <algorithm>
#include <cmath>

#include "base/shares.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

namespace {

// The thickness point at which the yarns are read: the middle one of the ply, or of all plies. The two that
// count folds, the second of which has a negative weight, are at the end of each ply (section.cpp).
int middle_point(const section::Section& section, int ply) {
  std::vector<int> found;
  const int points = static_cast<int>(section.points.size());
  for (int k = 0; k < points; ++k) {
    const bool folds = section.points[k].weight < 0 || (k + 1 < points && section.points[k + 1].weight < 0);
    if (!folds && (ply == ClothReadings::all_plies || section.points[k].ply == ply)) found.push_back(k);
  }
  return found[found.size() / 2];
}

// The base vectors a_1 + eta d and a_2 + xi d, in a triangle without d.
struct Bases {
  Vec3 a1, a2, d = Vec3::Zero();
};

Bases bases(const std::array<Vec3, 4>& p, int corners) {
  if (corners == 3) return {p[1] - p[0], p[2] - p[0]};
  return {(p[1] + p[2] - p[0] - p[3]) / 4, (p[2] + p[3] - p[0] - p[1]) / 4, (p[0] + p[2] - p[1] - p[3]) / 4};
}

}  // namespace

std::pair<Vec3, Vec3> ClothReadings::yarns(Index element, int ply) const {
  const BatchLane place = cloth_.places()[element];
  const Batch& batch = cloth_.batches()[place.batch];
  const BatchKind& kind = *batch.kind;
  const auto& section = *batch.section;
  const int k = middle_point(section, ply), points = static_cast<int>(section.points.size());
  const auto& point = section.points[k];
  const double z = section.thickness / 2 * (point.zeta - section.offset);
  std::array<Vec3, 4> p;
  for (int a = 0; a < kind.corners; ++a) {
    const Index node = batch.nodes[place.lane][a];
    p[a] = at(cloth_.configuration().x(), node) + z * at(cloth_.configuration().d(), node);
  }
  const Bases base = bases(p, kind.corners);
  // Sums over the in-plane points of T_i1 and T_i2, and of T_i1 eta + T_i2 xi.
  constexpr int xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
  double T[4] = {}, by[2] = {};
  for (int g = 0; g < kind.in_plane; ++g) {
    const double* t = batch.geometry + kind.point(g, k, points) * lanes + place.lane;
    for (int i = 0; i < 4; ++i) T[i] += t[i * lanes];
    for (int i = 0; i < 2; ++i) by[i] += t[2 * i * lanes] * eta[g] + t[(2 * i + 1) * lanes] * xi[g];
  }
  const double away = 1 / std::sqrt(3.0);  // of the points from the middle
  const Vec3 warp = T[0] * base.a1 + T[1] * base.a2 + away * by[0] * base.d,
             weft = T[2] * base.a1 + T[3] * base.a2 + away * by[1] * base.d;
  const double angle = ply == all_plies ? point.angle - section.common_angle() : 0;
  if (angle == 0) return {warp.normalized(), weft.normalized()};
  const double c = std::cos(angle), s = std::sin(angle);
  return {(c * warp - s * weft).normalized(), (s * warp + c * weft).normalized()};
}

void ClothReadings::visit(Index element, const PointVisitor& f) const {
  const BatchLane place = cloth_.places()[element];
  const Batch& batch = cloth_.batches()[place.batch];
  const auto& section = *batch.section;
  const int points = static_cast<int>(section.points.size());
  const BatchKind& kind = *batch.kind;
  alignas(64) double x[12 * lanes], d[12 * lanes];
  std::vector<double> E(static_cast<std::size_t>(kind.in_plane) * points * 5 * lanes),
      state(section.state_size + 1);
  cloth_.gather(batch, x, d, nullptr);
  const double* geometry = batch.geometry;
  kind.kernels.strain(section, {geometry, x, d, nullptr, nullptr, nullptr}, E.data());
  const double* law = cloth_.states().current().data() + batch.law;
  for (int g = 0; g < kind.in_plane; ++g)
    for (int k = 0; k < points; ++k) {
      const auto& point = section.points[k];
      double e[5];
      for (int i = 0; i < 5; ++i) e[i] = E[((g * points + k) * 5 + i) * lanes + place.lane];
      const int size = law::state_size(*point.law);
      for (int i = 0; i < size; ++i)
        state[i] = law[(g * section.state_size + point.state + i) * lanes + place.lane];
      f(geometry[(kind.point(g, k, points) + 7) * lanes + place.lane], *point.law, e, state.data());
    }
}

Vec3 ClothReadings::centre(Index element) const {
  const Batch& batch = cloth_.batches()[cloth_.places()[element].batch];
  Vec3 sum = Vec3::Zero();
  for (int a = 0; a < batch.kind->corners; ++a)
    sum += at(cloth_.configuration().x(), batch.nodes[cloth_.places()[element].lane][a]);
  return sum / batch.kind->corners;
}

// The directors of a membrane do not follow it.
Index ClothReadings::inverted_element(std::span<const Index> but_for) const {
  if (cloth_.model().membrane()) return -1;
  Index first = -1;
  const auto counts = [&](const std::array<Index, 4>& nodes) {
    return std::none_of(nodes.begin(), nodes.end(),
                        [&](Index n) { return std::binary_search(but_for.begin(), but_for.end(), n); });
  };
  for (const Batch& batch : cloth_.batches()) {
    alignas(64) double x[12 * lanes], d[12 * lanes];
    cloth_.gather(batch, x, d, nullptr);
    const unsigned lost =
        batch.kind->kernels.inverted({nullptr, x, d, nullptr, nullptr, nullptr}) & ((1u << batch.used) - 1);
    for (int l = 0; l < batch.used; ++l)
      if ((lost >> l & 1u) != 0 && (first < 0 || batch.element[l] < first) && counts(batch.nodes[l]))
        first = batch.element[l];
  }
  return first;
}

namespace {

// The square of the largest stretch in the plane of two vectors that were A and B and are a and b.
double largest_stretch_squared(const Vec3& A, const Vec3& B, const Vec3& a, const Vec3& b) {
  const double AA = A.squaredNorm(), AB = A.dot(B), BB = B.squaredNorm();
  const double aa = a.squaredNorm(), ab = a.dot(b), bb = b.squaredNorm();
  const double det = AA * BB - AB * AB, half = (BB * aa - 2 * AB * ab + AA * bb) / det / 2;
  return half + std::sqrt(std::max(0.0, half * half - (aa * bb - ab * ab) / det));
}

}  // namespace

double ClothReadings::growth(Index i) const {
  const RestShape& rest = cloth_.rest();
  const auto& e = cloth_.model().mesh().elements[static_cast<std::size_t>(i)];
  const auto x = cloth_.configuration().x();
  const auto across = [&](const auto& corner) {
    const int last = corners(e) == 3 ? 0 : 3;
    return std::pair<Vec3, Vec3>(corner(2) - corner(0), corner(1) - corner(last));
  };
  const auto [A, B] = across([&](int c) { return rest.X(i, c); });
  const auto [a, b] = across([&](int c) { return Vec3(at(x, e[c])); });
  double squared = std::max(1.0, largest_stretch_squared(A, B, a, b));
  for (int k = 0; k < corners(e); ++k) {
    const int next = (k + 1) % corners(e);
    squared = std::max(squared, (at(x, e[next]) - at(x, e[k])).squaredNorm() /
                                    (rest.X(i, next) - rest.X(i, k)).squaredNorm());
  }
  return squared + (squared - 1) / 2;
}

double ClothReadings::largest_stretch() const {
  const RestShape& rest = cloth_.rest();
  const auto& elements = cloth_.model().mesh().elements;
  const auto x = cloth_.configuration().x();
  const auto of_element = [&](std::size_t i) {
    const auto& e = elements[i];
    const int n = corners(e);
    double largest = 0;  // squared
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        largest = std::max(
            largest, (at(x, e[b]) - at(x, e[a])).squaredNorm() /
                         (rest.X(static_cast<Index>(i), b) - rest.X(static_cast<Index>(i), a)).squaredNorm());
    return largest;
  };
  return std::sqrt(largest_of(elements.size(), elements.size() >= 4096, of_element));
}

double ClothReadings::largest_turn(const NodalRates& way) const {
  const RestShape& rest = cloth_.rest();
  const auto& elements = cloth_.model().mesh().elements;
  const auto of_element = [&](std::size_t i) {
    const auto& e = elements[i];
    const int n = corners(e);
    double largest = 0;  // squared
    for (int a = 0; a < n; ++a) {
      const Index from = e[a], to = e[(a + 1) % n], id = static_cast<Index>(i);
      const double edge = (at(way.x, to) - at(way.x, from)).squaredNorm() /
                          (rest.X(id, (a + 1) % n) - rest.X(id, a)).squaredNorm();
      largest = std::max({largest, edge, at(way.d, from).squaredNorm()});
    }
    return largest;
  };
  return std::sqrt(largest_of(elements.size(), elements.size() >= 4096, of_element));
}

StrainsReached::StrainsReached(const model::Model& model, const std::vector<Batch>& batches,
                               const std::vector<BatchLane>& place, const LawStates& states)
    : model_(model), batches_(batches), place_(place), states_(states) {
  bool any = false;
  for (std::size_t r = 0; r < model_.regions().size(); ++r) {
    const auto& section = model_.sections()[r];
    const auto& region = model_.regions()[r];
    const auto& plies = region.options.plies;
    tested_.emplace_back();
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto& point = section.points[k];
      TestedPoint here{point.law.get(), point.state, {}, {}};
      here.tested =
          law::tested_strains(plies.empty() ? region.card : plies[static_cast<std::size_t>(point.ply)].card);
      for (std::size_t i = 0; i < 3; ++i) here.inverse[i] = here.tested[i] > 0 ? 1 / here.tested[i] : 0;
      if (here.tested != std::array<double, 3>{}) tested_.back().push_back(here);
    }
    any = any || !tested_.back().empty();
  }
  if (!any) return;
  ratio_at_ = law::strain_ratio_function(best_isa());
  ratio_.assign(batches_.size(), 0);
}

const std::vector<StrainsReached::TestedPoint>& StrainsReached::tested(const Batch& batch) const {
  return tested_[static_cast<std::size_t>(batch.section - model_.sections().data())];
}

void StrainsReached::record(Index b, const double* states) {
  if (ratio_.empty()) return;
  const Batch& batch = batches_[static_cast<std::size_t>(b)];
  const long stride = static_cast<long>(batch.section->state_size) * lanes;
  double most = 0;
  for (const TestedPoint& point : tested(batch))
    most = std::max(
        most, ratio_at_(*point.law, point.inverse.data(), states + static_cast<long>(point.state) * lanes,
                        stride, batch.kind->in_plane));
  ratio_[static_cast<std::size_t>(b)] = most;  // empty lanes repeat an element
}

double StrainsReached::largest_ratio() const {
  return ratio_.empty() ? 0 : *std::max_element(ratio_.begin(), ratio_.end());
}

Strained StrainsReached::most() const {
  if (ratio_.empty()) return {};
  const Batch& batch = batches_[std::max_element(ratio_.begin(), ratio_.end()) - ratio_.begin()];
  return most_of(batch, 0, batch.used);
}

double StrainsReached::ratio(Index element) const {
  if (ratio_.empty()) return 0;
  const BatchLane place = place_[element];
  return most_of(batches_[place.batch], place.lane, place.lane + 1).strain_ratio;
}

// The most strained point of the elements in lanes first_lane to last_lane - 1.
Strained StrainsReached::most_of(const Batch& batch, int first_lane, int last_lane) const {
  Strained most;
  const double* law = states_.current().data() + batch.law;
  for (int lane = first_lane; lane < last_lane; ++lane)
    for (int g = 0; g < batch.kind->in_plane; ++g)
      for (const TestedPoint& point : tested(batch)) {
        const long offset = static_cast<long>(g * batch.section->state_size + point.state) * lanes + lane;
        const auto peak = law::peak_strains(*point.law, law + offset, lanes);
        for (std::size_t i = 0; i < 3; ++i)
          if (const double strain_ratio = peak[i] * point.inverse[i]; strain_ratio > most.strain_ratio)
            most = {strain_ratio, peak[i], point.tested[i], static_cast<int>(i), batch.element[lane]};
      }
  return most;
}

}  // namespace fabricsh::mechanics
