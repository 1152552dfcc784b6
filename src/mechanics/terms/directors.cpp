#include "mechanics/terms/directors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kUpright = 0.5 * std::numbers::sqrt2;  // cosine of 45 degrees, where leaning begins to cost
constexpr double kClosed = 0.5;         // cosine of 60 degrees, where a triangle's director begins to cost
constexpr double kShareOfBending = 10;  // of the bending rigidity, at each corner of a triangle
constexpr double kWellBefore = 0.9;     // cosine with the normal that directors of the reference must have
constexpr double kShareOfShear = 0.5;   // of the transverse shear modulus: with it the stable step holds
constexpr double kOnset = 0.5;          // share of B' over B kappa^2 b^2 / 4 where the guard of splay begins
constexpr double kReturned = 1.5;  // what is given back over what is lost, so that leaning costs something

// Zero up to 0, x - 1/2 from 1 on, with two continuous derivatives.
struct Ramp {
  double value, slope, bend;
};

Ramp ramp(double x) {
  if (x <= 0) return {0, 0, 0};
  if (x >= 1) return {x - 0.5, 1, 0};
  return {x * x * x * (1 - x / 2), x * x * (3 - 2 * x), 6 * x * (1 - x)};
}

// The ends of the two diagonals of an element, 1 to 3 and 2 to 4; a triangle's second leads from 2 to 1. The
// normal times the area is half their product.
std::array<Index, 4> diagonals(const std::array<Index, 4>& e) {
  return {e[0], e[2], e[1], e[3] < 0 ? e[0] : e[3]};
}

Vec3 area_vector(const std::array<Index, 4>& element, std::span<const double> x) {
  const auto [a, c, b, d] = diagonals(element);
  return 0.5 * (at(x, c) - at(x, a)).cross(at(x, d) - at(x, b));
}

// Bending rigidities along warp and weft and of twist, N m; of a section that is integrated through the
// thickness near zero strain.
std::array<double, 3> rigidities(const section::Section& section) {
  if (section.bends_apart)
    return {section.bending[0].rigidity, section.bending[1].rigidity, section.bending[2].rigidity};
  std::array<double, 3> sum{};
  for (const auto& point : section.points) {
    const std::vector<double> virgin(law::state_size(*point.law) + 1, 0.0);
    std::vector<double> trial = virgin;
    double E[5] = {}, S[5], C[25];
    law::evaluate(*point.law, law::Step{}, E, virgin.data(), trial.data(), S, C);
    const double half = section.thickness / 2, z = half * (point.zeta - section.offset);
    for (int i = 0; i < 3; ++i) sum[i] += point.weight * half * z * z * C[std::array{0, 6, 24}[i]];
  }
  return sum;
}

// Rigidity against bending about the normal of a direction with these components on warp and weft.
double rigidity_along(const std::array<double, 3>& B, double c, double s) {
  return B[0] * c * c * c * c + B[1] * s * s * s * s + 4 * B[2] * c * c * s * s;
}

// N/m: modulus of transverse shear times thickness.
double shear_rigidity(const section::Section& section) {
  double sum = 0;
  for (const auto& point : section.points) sum += point.weight / 2 * law::transverse_modulus(*point.law);
  return sum * section.thickness;
}

}  // namespace

Directors::Directors(const model::Model& model, const Configuration& configuration, Cloth& cloth,
                     const Dofs& dofs)
    : configuration_(configuration), cloth_(cloth), dofs_(dofs), model_(model), X_(model.mesh().nodes) {
  find_planes();
  follow_joints();
  for (const auto& section : model.sections()) rigidity_.push_back(rigidities(section));
  limits_ = bent_limits();
  of_edges_.resize(limits_.size());
  cloth.watch_directors(kUpright, limits_);
}

// The elements about each joint are those of its leader; the other nodes have none.
void Directors::follow_joints() {
  const auto& all = model_.mesh().elements;
  const Joints& joints = dofs_.joints();
  around_.first.assign(X_.size() + 1, 0);
  for (const auto& e : all)
    for (int a = 0; a < corners(e); ++a) ++around_.first[joints.leader(e[a]) + 1];
  for (std::size_t n = 0; n < X_.size(); ++n) around_.first[n + 1] += around_.first[n];
  around_.elements.resize(around_.first.back());
  auto next = around_.first;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (int a = 0; a < corners(all[i]); ++a)
      around_.elements[next[joints.leader(all[i][a])]++] = static_cast<Index>(i);
  find_weights();
}

// Directors that only one rotation moves stay in a plane, as in one of symmetry. There the normal of the
// whole sheet is the part in the plane.
void Directors::find_planes() {
  const auto& nodes = dofs_.freedoms().nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].held_axes.empty()) continue;
    const Vec3& D = dofs_.reference_directors()[n];
    const Vec3 way = allowed_direction(nodes[n].held_axes, D);
    if (!way.isZero()) plane_[static_cast<Index>(n)] = D.cross(way);
  }
}

// A director that is held, driven or tied does not choose its way, and the normal at a tie is that of one
// side.
void Directors::find_weights() {
  const Freedoms& freedoms = dofs_.freedoms();
  weight_.assign(X_.size(), 0);
  area_.assign(X_.size(), 0);
  const auto& all = model_.mesh().elements;
  for (Index e = 0; e < static_cast<Index>(all.size()); ++e) {
    const double shear = shear_rigidity(model_.sections()[static_cast<std::size_t>(model_.region_of(e))]);
    for (int a = 0; a < corners(all[e]); ++a)
      weight_[dofs_.joints().leader(all[e][a])] += kShareOfShear * shear * area(all[e], X_) / corners(all[e]);
  }
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    Vec3 normal = Vec3::Zero();
    for (const Index e : elements_of(n)) {
      const auto [a, c, b, d] = diagonals(all[e]);
      normal += 0.5 * (X_[c] - X_[a]).cross(X_[d] - X_[b]);
    }
    area_[n] = plane_projected(n, normal).norm();
    const auto& equation = freedoms.nodes[n].equation;
    const bool turns = equation[3] >= 0 || equation[4] >= 0;
    const double upright = kWellBefore * area_[n];  // where sheets meet, their mean may be no normal of any
    if (!turns || !dofs_.joints().leads(n) || !(dofs_.reference_directors()[n].dot(normal) > upright) ||
        freedoms.ties(n) || freedoms.body(n) >= 0)
      weight_[n] = 0;
  }
  for (const auto& follower : freedoms.followers)
    for (const auto& lead : follower.leads) weight_[lead.node] = 0;
}

std::span<const Index> Directors::Around::of(Index node) const {
  const auto from = static_cast<std::size_t>(first[node]);
  return std::span(elements).subspan(from, static_cast<std::size_t>(first[node + 1]) - from);
}

Vec3 Directors::plane_projected(Index node, const Vec3& v) const {
  const auto plane = plane_.find(node);
  return plane == plane_.end() ? v : Vec3(v - v.dot(plane->second) * plane->second);
}

Vec3 Directors::normal_at(Index node, std::span<const double> x) const {
  Vec3 sum = Vec3::Zero();
  for (const Index e : elements_of(node)) sum += area_vector(model_.mesh().elements[e], x);
  return sum;
}

// --- splay

namespace {

// The first and second corner of an edge, in the order of the elements' kernels.
const int* ends_of(int corners, int edge) {
  static constexpr int four[4][2] = {{3, 2}, {0, 1}, {1, 2}, {0, 3}}, three[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  return corners == 4 ? four[edge] : three[edge];
}

// (chord . delta)^2 of an edge, m^2.
double bend_of(const Configuration& now, Index first, Index second) {
  const auto x = now.x(), d = now.d();
  const double p = (at(x, second) - at(x, first)).dot(at(d, second) - at(d, first)) / 4;
  return p * p;
}

}  // namespace

Directors::Ridge Directors::ridge(std::size_t b, int lane, int edge) const {
  constexpr double across4[2][4] = {{-0.25, -0.25, 0.25, 0.25}, {-0.25, 0.25, 0.25, -0.25}};
  const Batch& batch = cloth_.batches()[b];
  const bool four = batch.kind->corners == 4;
  const int* const ends = ends_of(batch.kind->corners, edge);
  const OfEdge& of = of_edge(b, lane, edge);
  Ridge r{batch.nodes[lane], batch.kind->corners, ends[0], ends[1], {}, of.bend, of.width, of.energy};
  for (int a = 0; a < r.corners; ++a)
    r.across[a] = four ? across4[edge / 2][a] : a == r.first || a == r.second ? -0.5 : 1;
  return r;
}

const Directors::OfEdge& Directors::of_edge(std::size_t b, int lane, int edge) const {
  auto& known = of_edges_[b];
  if (!known) {
    const Batch& batch = cloth_.batches()[b];
    known = std::make_unique<std::array<OfEdge, 4 * lanes>>();
    for (int l = 0; l < batch.used; ++l)
      for (int e = 0; e < batch.kind->corners; ++e)
        (*known)[static_cast<std::size_t>(4 * l + e)] = found_of_edge(batch, l, e);
  }
  return (*known)[static_cast<std::size_t>(4 * lane + edge)];
}

Directors::OfEdge Directors::found_of_edge(const Batch& batch, int lane, int edge) const {
  const bool four = batch.kind->corners == 4;
  const int* const ends = ends_of(batch.kind->corners, edge);
  const auto& nodes = batch.nodes[lane];
  // The base vectors in material axes: m_i . G_j, the inverse of the transpose of T.
  const double* T = batch.geometry + static_cast<long>(batch.kind->first_point) * lanes + lane;
  const double G1[2] = {T[3 * lanes], -T[lanes]}, G2[2] = {-T[2 * lanes], T[0]};
  const bool along1 = four ? edge < 2 : edge == 0, along2 = four ? edge >= 2 : edge == 1;
  const Vec3 way(along2   ? G2[0]
                 : along1 ? G1[0]
                          : G2[0] - G1[0],
                 along2   ? G2[1]
                 : along1 ? G1[1]
                          : G2[1] - G1[1],
                 0);
  const double c = way.normalized().x(), s = way.normalized().y();
  const auto& B = rigidity_[static_cast<std::size_t>(batch.section - model_.sections().data())];
  const double along = rigidity_along(B, c, s), other = rigidity_along(B, s, c);
  const double half = (X_[nodes[ends[1]]] - X_[nodes[ends[0]]]).norm() / 2, size = area(nodes, X_);
  const double b = (four ? size : 2 * size) / (2 * half), onset = kOnset * 4 * other / (b * b);
  return {along > 0 ? half * half * half * half * onset / along : std::numeric_limits<double>::infinity(),
          four ? b / 2 : b, kReturned * onset / 2 * (four ? size / 2 : size)};
}

std::vector<double> Directors::bent_limits() const {
  std::vector<double> limits;
  for (const Batch& batch : cloth_.batches()) {
    double least = std::numeric_limits<double>::infinity();
    for (int l = 0; l < batch.used; ++l)
      for (int e = 0; e < batch.kind->corners; ++e) least = std::min(least, found_of_edge(batch, l, e).bend);
    limits.push_back(least);
  }
  return limits;
}

namespace {

// The energy F(p, q) = w R(p^2 / p0^2 - 1) (s^2 + s^4), s = q / width, of an edge, with its derivatives; p =
// chord . delta, q = mean . across, with half the chord, half the sum and the difference of the directors,
// and the direction across. s is the sine of the angle by which the directors lean across.
struct Splay {
  Vec3 chord, delta, mean, across;
  double F, Fp, Fq, Fpp, Fpq, Fqq;
};

template <class Ridge>
bool splay_of(const Ridge& r, const Configuration& now, Splay& v) {
  const auto x = now.x(), d = now.d();
  const Index i = r.nodes[r.first], j = r.nodes[r.second];
  v.chord = (at(x, j) - at(x, i)) / 2;
  v.delta = (at(d, j) - at(d, i)) / 2;
  const double p = v.chord.dot(v.delta), ratio = p * p / r.bend - 1;
  if (!(ratio > 0)) return false;
  v.mean = (at(d, j) + at(d, i)) / 2;
  v.across = Vec3::Zero();
  for (int a = 0; a < r.corners; ++a) v.across += r.across[a] * at(x, r.nodes[a]);
  const double s = v.mean.dot(v.across) / r.width, by_p = 2 * p / r.bend, by_q = 1 / r.width;
  const Ramp R = ramp(ratio);
  const double g = s * s + s * s * s * s, slope = 2 * s + 4 * s * s * s, bend = 2 + 12 * s * s;
  v.F = r.energy * R.value * g;
  v.Fp = r.energy * R.slope * by_p * g;
  v.Fq = r.energy * R.value * slope * by_q;
  v.Fpp = r.energy * g * (R.bend * by_p * by_p + R.slope * 2 / r.bend);
  v.Fpq = r.energy * R.slope * by_p * slope * by_q;
  v.Fqq = r.energy * R.value * bend * by_q * by_q;
  return true;
}

}  // namespace

template <class Visit>
void Directors::visit_ridges(const Configuration& configuration, Visit visit) const {
  const auto flags = cloth_.astray();
  for (std::size_t b = 0; b < flags.size(); ++b) {
    if (flags[b] == 0) continue;
    const Batch& batch = cloth_.batches()[b];
    for (int l = 0; l < batch.used; ++l) {
      if ((flags[b] >> l & 1u) == 0) continue;
      for (int e = 0; e < batch.kind->corners; ++e) {
        const int* const ends = ends_of(batch.kind->corners, e);
        if (bend_of(configuration, batch.nodes[l][ends[0]], batch.nodes[l][ends[1]]) <= limits_[b]) continue;
        const Ridge r = ridge(b, l, e);
        Splay v;
        if (splay_of(r, configuration, v)) visit(r, v);
      }
    }
  }
}

namespace {

template <class Ridge>
void add_splay_forces(const Ridge& r, const Splay& v, Forces& forces) {
  const Index i = r.nodes[r.first], j = r.nodes[r.second];
  const Vec3 on_chord = v.Fp / 2 * v.delta, on_delta = v.Fp / 2 * v.chord, on_mean = v.Fq / 2 * v.across;
  at(forces.on_x, j) += on_chord;
  at(forces.on_x, i) -= on_chord;
  at(forces.on_d, j) += on_mean + on_delta;
  at(forces.on_d, i) += on_mean - on_delta;
  for (int a = 0; a < r.corners; ++a) at(forces.on_x, r.nodes[a]) += r.across[a] * v.Fq * v.mean;
}

using Block = Eigen::Matrix<double, 5, 5>;

template <class Ridge>
void add_splay_tangent(const Ridge& r, const Splay& v, const Configuration& now, TangentSink& sink) {
  using Column = Eigen::Matrix<double, 5, 1>;
  std::array<Column, 4> P, Q;  // derivatives of p and q by the unknowns of the corners
  std::array<Eigen::Matrix<double, 3, 2>, 4> B;
  std::array<double, 4> end{};  // -1 and 1 at the ends of the edge
  end[r.first] = -1;
  end[r.second] = 1;
  for (int a = 0; a < r.corners; ++a) {
    B[a] = turning_axes(at(now.d(), r.nodes[a]), at(now.b1(), r.nodes[a]));
    const double share = std::abs(end[a]) / 2;
    P[a] << end[a] / 2 * v.delta, B[a].transpose() * (end[a] / 2 * v.chord);
    Q[a] << r.across[a] * v.mean, B[a].transpose() * (share * v.across);
  }
  for (int a = 0; a < r.corners; ++a)
    for (int b = 0; b < r.corners; ++b) {
      Block k =
          P[a] * (v.Fpp * P[b] + v.Fpq * Q[b]).transpose() + Q[a] * (v.Fpq * P[b] + v.Fqq * Q[b]).transpose();
      k.topRightCorner<3, 2>() +=
          (v.Fp * end[a] * end[b] / 4 + v.Fq * r.across[a] * std::abs(end[b]) / 2) * B[b];
      k.bottomLeftCorner<2, 3>() +=
          (v.Fp * end[a] * end[b] / 4 + v.Fq * r.across[b] * std::abs(end[a]) / 2) * B[a].transpose();
      if (a == b) {  // second variation of the director
        const Vec3 on_d = v.Fp * end[a] / 2 * v.chord + v.Fq * std::abs(end[a]) / 2 * v.across;
        k.bottomRightCorner<2, 2>().diagonal().array() -= on_d.dot(at(now.d(), r.nodes[a]));
      }
      sink.on_nodes(r.nodes[a], r.nodes[b], k);
    }
}

}  // namespace

// --- lean

std::vector<Directors::Corner> Directors::leaning_corners(const Configuration& configuration) const {
  std::vector<Corner> found;
  const auto flags = cloth_.astray();
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (int l = 0; flags[b] >> l != 0; ++l) {
      if ((flags[b] >> l & 1u) == 0) continue;
      const Batch& batch = cloth_.batches()[b];
      const Vec3 normal = area_vector(batch.nodes[l], configuration.x());
      const double least = kUpright * normal.norm();
      for (int a = 0; a < batch.kind->corners; ++a)
        if (at(configuration.d(), batch.nodes[l][a]).dot(normal) < least)
          found.push_back({dofs_.joints().leader(batch.nodes[l][a]), batch.element[l]});
    }
  return sorted(found);
}

// By node, which are counted, and of each by element, of which there are few.
std::vector<Directors::Corner> Directors::sorted(const std::vector<Corner>& corners) const {
  if (corners.empty()) return {};
  std::vector<std::uint32_t> end(X_.size() + 1, 0);
  for (const Corner& c : corners) ++end[static_cast<std::size_t>(c.node) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Corner> out(corners.size(), Corner{-1, -1});
  for (const Corner& c : corners) {
    std::uint32_t at = end[static_cast<std::size_t>(c.node)]++;
    for (; at > 0 && out[at - 1].node == c.node && c.element < out[at - 1].element; --at)
      out[at] = out[at - 1];
    out[at] = c;
  }
  return out;
}

// At all other nodes the mean of the elements' normals is no farther away than 45 degrees either.
std::vector<Index> Directors::leaning_nodes(const Configuration& configuration) const {
  std::vector<Index> found;
  for (const Corner& corner : leaning_corners(configuration))
    if (found.empty() || found.back() != corner.node) found.push_back(corner.node);
  return found;
}

namespace {

// The lean s = (c |N| - d.N) / m, with the cosine c where it begins to cost, m^2 = (|N|^2 + A^2) / 2 and A
// the value of |N| in the reference: a difference of cosines where the sheet keeps its area, and zero with N.
struct TiltMeasure {
  double s, size, m, excess;
  Vec3 by_normal, by_director;
};

TiltMeasure measure(const Vec3& N, const Vec3& d, double area, double upright) {
  TiltMeasure v;
  v.size = N.norm();
  v.m = std::sqrt((v.size * v.size + area * area) / 2);
  v.excess = upright * v.size - d.dot(N);
  v.s = v.excess / v.m;
  if (!(v.s > 0)) return v;
  v.by_normal = (upright / v.size * N - d) / v.m - v.excess / (2 * v.m * v.m * v.m) * N;
  v.by_director = -N / v.m;
  return v;
}

}  // namespace

double Directors::upright(Index node) const {
  const auto found = lowered_.find(node);
  return found == lowered_.end() ? kUpright : found->second;
}

bool Directors::costs(const Configuration& configuration, Lean& lean) const {
  const TiltMeasure v = measure(lean.normal, at(configuration.d(), lean.node), lean.area, lean.upright);
  if (!(v.s > 0)) return false;
  const Ramp R = ramp(v.s / lean.scale);
  lean.energy = lean.weight * lean.scale * R.value;
  lean.by_normal = lean.weight * R.slope * v.by_normal;
  lean.by_director = lean.weight * R.slope * v.by_director;
  return true;
}

bool Directors::lean_of(Index node, const Configuration& configuration, Lean& lean) const {
  if (!(weight_[node] > 0)) return false;
  lean.node = node;
  lean.elements = elements_of(node);
  lean.weight = weight_[node];
  lean.area = area_[node];
  lean.upright = upright(node);
  lean.scale = kUpright;
  lean.normal = plane_projected(node, normal_at(node, configuration.x()));
  return costs(configuration, lean);
}

bool Directors::lean_of(const Corner& corner, const Configuration& configuration, Lean& lean) const {
  const auto& nodes = model_.mesh().elements[corner.element];
  if (corners(nodes) != 3 || !(weight_[corner.node] > 0)) return false;
  const Vec3 before =
      plane_projected(corner.node, 0.5 * (X_[nodes[1]] - X_[nodes[0]]).cross(X_[nodes[2]] - X_[nodes[0]]));
  lean.area = before.norm();
  const double cosine = dofs_.reference_directors()[corner.node].dot(before) / std::max(lean.area, 1e-300);
  if (!(cosine > 0)) return false;
  lean.node = corner.node;
  const auto around = elements_of(corner.node);
  lean.elements = around.subspan(std::find(around.begin(), around.end(), corner.element) - around.begin(), 1);
  const auto& B = rigidity_[static_cast<std::size_t>(model_.region_of(corner.element))];
  lean.weight = kShareOfBending * std::max(B[0], B[1]);
  lean.upright = kClosed * cosine;
  lean.scale = kClosed;
  lean.normal = plane_projected(corner.node, area_vector(nodes, configuration.x()));
  return costs(configuration, lean);
}

template <class Visit>
void Directors::visit_leans(const Configuration& configuration, Visit visit) const {
  Lean lean;
  const auto found = leaning_corners(configuration);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if ((i == 0 || found[i - 1].node != found[i].node) && lean_of(found[i].node, configuration, lean))
      visit(lean);
    if (lean_of(found[i], configuration, lean)) visit(lean);
  }
}

void Directors::add_lean_forces(const Lean& lean, std::span<const double> x, Forces& forces) const {
  at(forces.on_d, lean.node) += lean.by_director;
  const Vec3 p = plane_projected(lean.node, lean.by_normal) / 2;
  for (const Index e : lean.elements) {
    const auto [a, c, b, d] = diagonals(model_.mesh().elements[e]);
    const Vec3 on_first = (at(x, d) - at(x, b)).cross(p), on_second = p.cross(at(x, c) - at(x, a));
    at(forces.on_x, c) += on_first;
    at(forces.on_x, a) -= on_first;
    at(forces.on_x, d) += on_second;
    at(forces.on_x, b) -= on_second;
  }
}

void Directors::add_lean_tangent(const Lean& lean, const Configuration& now, TangentSink& sink) const {
  const auto x = now.x();
  const Vec3 d = at(now.d(), lean.node), &N = lean.normal;
  const double cosine = lean.upright;
  const TiltMeasure v = measure(N, d, lean.area, cosine);
  const Ramp R = ramp(v.s / lean.scale);
  const double w = lean.weight, U1 = w * R.slope, U2 = w * R.bend / lean.scale, m3 = v.m * v.m * v.m;
  const Mat3 one = Mat3::Identity();
  const Vec3 n = N / v.size, c = cosine * n - d;
  Mat3 NN = cosine / (v.size * v.m) * (one - n * n.transpose()) -
            (c * N.transpose() + N * c.transpose()) / (2 * m3) - v.excess / (2 * m3) * one +
            3 * v.excess / (4 * m3 * v.m * v.m) * N * N.transpose();
  NN = U2 * v.by_normal * v.by_normal.transpose() + U1 * NN;
  const Mat3 dN =
      U2 * v.by_director * v.by_normal.transpose() + U1 * (N * N.transpose() / (2 * m3) - one / v.m);
  const Eigen::Matrix<double, 3, 2> B = turning_axes(at(now.d(), lean.node), at(now.b1(), lean.node));
  Eigen::Matrix2d own = B.transpose() * (U2 * v.by_director * v.by_director.transpose()) * B;
  own.diagonal().array() -= lean.by_director.dot(d);
  sink.on_director(lean.node, own);
  Mat3 project = one;
  if (const auto plane = plane_.find(lean.node); plane != plane_.end())
    project -= plane->second * plane->second.transpose();
  std::vector<std::pair<Index, Mat3>> by;  // derivative of N by the nodes of its elements
  const auto add = [&](Index node, const Mat3& Z) {
    const auto known = std::find_if(by.begin(), by.end(), [&](const auto& b) { return b.first == node; });
    known == by.end() ? by.emplace_back(node, project * Z) : (known->second += project * Z, *known);
  };
  const Mat3 geometric = -cross_matrix(project * lean.by_normal) / 2;
  for (const Index e : lean.elements) {
    const auto [a, k, b, l] = diagonals(model_.mesh().elements[e]);
    const Mat3 first = -cross_matrix(at(x, l) - at(x, b)) / 2, second = cross_matrix(at(x, k) - at(x, a)) / 2;
    add(k, first);
    add(a, -first);
    add(l, second);
    add(b, -second);
    for (const auto& [i, on] : {std::pair(k, 1), std::pair(a, -1)})
      for (const auto& [j, off] : {std::pair(l, 1), std::pair(b, -1)}) {
        sink.on_positions(i, j, on * off * geometric);
        sink.on_positions(j, i, on * off * geometric.transpose());
      }
  }
  for (const auto& [i, Zi] : by) {
    Block k = Block::Zero();
    k.bottomLeftCorner<2, 3>() = B.transpose() * dN * Zi;
    sink.on_nodes(lean.node, i, k);
    sink.on_nodes(i, lean.node, k.transpose());
    for (const auto& [j, Zj] : by) sink.on_positions(i, j, Zi.transpose() * NN * Zj);
  }
}

// --- the term

Outcome Directors::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const Configuration& now = trial.configuration;
  visit_ridges(now, [&](const Ridge& r, const Splay& v) { add_splay_forces(r, v, forces); });
  visit_leans(now, [&](const Lean& lean) { add_lean_forces(lean, now.x(), forces); });
  return {};
}

// The normal at a node couples all nodes of its elements.
void Directors::couple(const Trial& trial, std::vector<NodePair>& pairs) {
  visit_leans(trial.configuration, [&](const Lean& lean) {
    std::vector<Index> ring;
    for (const Index e : lean.elements)
      for (const Index node : model_.mesh().elements[e])
        if (node >= 0) ring.push_back(node);
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (std::size_t j = i + 1; j < ring.size(); ++j) pairs.emplace_back(ring[i], ring[j]);
  });
}

void Directors::add_tangent(const Trial& trial, TangentSink& sink) const {
  const Configuration& now = trial.configuration;
  visit_ridges(now, [&](const Ridge& r, const Splay& v) { add_splay_tangent(r, v, now, sink); });
  visit_leans(now, [&](const Lean& lean) { add_lean_tangent(lean, now, sink); });
}

void Directors::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  double sum = 0;
  visit_ridges(trial.configuration, [&](const Ridge&, const Splay& v) { sum += v.F; });
  visit_leans(trial.configuration, [&](const Lean& lean) { sum += lean.energy; });
  out.push_back({"directors", Account::stored, sum});
  if (changes_joints()) out.push_back({"joints", Account::dissipated, lost_});
}

// --- joints

bool Directors::changes_joints() const { return dofs_.joints().any() || !dofs_.stitches().empty(); }

double Directors::cosine_at(Index node) const {
  const Vec3 normal = plane_projected(node, normal_at(node, configuration_.x()));
  return at(configuration_.d(), node).dot(normal) / std::max(normal.norm(), 1e-300);
}

// A node whose normal is that of other elements now, or whose guard weighs more or less, stores nothing.
void Directors::renumbered(Forces&) {
  std::vector<double> stored(X_.size(), 0);
  Lean lean;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n)
    if (lean_of(n, configuration_, lean)) stored[n] = lean.energy;
  const Around around = std::exchange(around_, {});
  const std::vector<double> weight = std::exchange(weight_, {});
  follow_joints();
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const auto now = elements_of(n), before = around.of(n);
    if (weight_[n] == weight[n] && std::equal(now.begin(), now.end(), before.begin(), before.end())) continue;
    lost_ += stored[n];
    lowered_.erase(n);
    if (!(weight_[n] > 0)) continue;
    if (const double cosine = cosine_at(n); cosine < kUpright) lowered_[n] = cosine;
  }
}

// Where a director has come nearer to the normal, leaning costs from there on.
void Directors::commit() {
  for (auto it = lowered_.begin(); it != lowered_.end();) {
    it->second = std::max(it->second, cosine_at(it->first));
    it = it->second < kUpright ? std::next(it) : lowered_.erase(it);
  }
}

void Directors::keep(Archive& archive) {
  if (!changes_joints()) return;
  std::vector<Index> nodes;
  std::vector<double> cosines;
  for (const auto& [node, cosine] : lowered_) {
    nodes.push_back(node);
    cosines.push_back(cosine);
  }
  archive(nodes, cosines, lost_);
  if (!archive.reading()) return;
  lowered_.clear();
  for (std::size_t i = 0; i < nodes.size(); ++i) lowered_[nodes[i]] = cosines[i];
}

// An element is sound if its normal is on the side of the mean at the node, and not all of its directors are
// on the other one.
bool Directors::sound(Index element, const Vec3& mean, const Configuration& configuration) const {
  const auto& nodes = model_.mesh().elements[element];
  const Vec3 normal = area_vector(nodes, configuration.x());
  const auto upright = [&](Index n) { return n >= 0 && at(configuration.d(), n).dot(normal) > 0; };
  return normal.dot(mean) > 0 && std::any_of(nodes.begin(), nodes.end(), upright);
}

Directors::Overturned Directors::overturned(const Configuration& configuration) const {
  const std::vector<Index> turned = turned_over(configuration);
  return {cloth_.readings().inverted_element(turned), turned.empty() ? -1 : turned.front()};
}

std::vector<Index> Directors::turned_over(const Configuration& configuration) const {
  std::vector<Index> turned;
  if (model_.membrane()) return turned;
  for (const Index n : leaning_nodes(configuration)) {
    const Vec3 normal = normal_at(n, configuration.x());
    const auto about = elements_of(n);
    if (at(configuration.d(), n).dot(normal) <= 0 &&
        std::all_of(about.begin(), about.end(), [&](Index e) { return sound(e, normal, configuration); }))
      turned.push_back(n);
  }
  return turned;
}

}  // namespace fabricsh::mechanics
