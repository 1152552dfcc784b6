#include "assembly/loads.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::assembly {

namespace {

Mat3 cross_matrix(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

// Shape functions of a face at one of its Gauss points: 2x2 of a quadrilateral; of a triangle one is enough,
// its weight 1/2 in N.
struct FacePoint {
  double N[4], N1[4], N2[4];
};

int corners(const std::array<Index, 4>& face) { return face[3] < 0 ? 3 : 4; }
int points(const std::array<Index, 4>& face) { return face[3] < 0 ? 1 : 4; }

FacePoint face_point(const std::array<Index, 4>& face, int g) {
  if (corners(face) == 3) return {{1.0 / 6, 1.0 / 6, 1.0 / 6, 0}, {-1, 1, 0, 0}, {-1, 0, 1, 0}};
  static constexpr double sx[4] = {-1, 1, 1, -1}, sy[4] = {-1, -1, 1, 1};
  const double r = sx[g] / std::sqrt(3.0), s = sy[g] / std::sqrt(3.0);
  FacePoint p;
  for (int a = 0; a < 4; ++a) {
    p.N[a] = (1 + sx[a] * r) * (1 + sy[a] * s) / 4;
    p.N1[a] = sx[a] * (1 + sy[a] * s) / 4;
    p.N2[a] = sy[a] * (1 + sx[a] * r) / 4;
  }
  return p;
}

struct Tangents {
  Vec3 a1 = Vec3::Zero(), a2 = Vec3::Zero();
};

Tangents tangents(const FacePoint& p, const std::array<Index, 4>& nodes, std::span<const double> x) {
  Tangents t;
  for (int a = 0; a < corners(nodes); ++a) {
    t.a1 += p.N1[a] * at(x, nodes[a]);
    t.a2 += p.N2[a] * at(x, nodes[a]);
  }
  return t;
}

}  // namespace

Vec3 Loads::Spread::at(double time) const {
  Vec3 total = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (value[c]) total += value[c]->value(time) * frame.row(c).transpose();
  return total;
}

Loads::Loads(const model::Model& model, const std::vector<double>& mass,
             const std::vector<double>& mass_moment)
    : mass_(mass), mass_moment_(mass_moment), gravity_(model.gravity()) {
  const auto& mesh = model.mesh();
  const auto spread = [&](const std::string& set, const model::Components& value, const Mat3& frame,
                          bool total) {
    Spread s{mesh.set(set), {}, value, frame};
    const Tributary t = tributary(mesh, s.nodes);
    if (!total && t.kind == Tributary::Kind::count)
      throw Error("traction: set '" + set + "' holds neither whole elements nor whole edges");
    s.share = t.measure;
    if (total)
      for (double& share : s.share) share /= t.total;
    return s;
  };
  for (const auto& f : model.forces()) dead_.push_back(spread(f.set, f.total, f.frame, true));
  for (const auto& t : model.tractions()) dead_.push_back(spread(t.set, t.intensity, t.frame, false));
  for (const auto& m : model.moments()) moments_.push_back(spread(m.set, m.total, m.frame, true));
  for (const auto& p : model.pressures()) {
    Faces faces{{}, p.value};
    for (const auto e : mesh.elements_in(mesh.set(p.set))) faces.elements.push_back(mesh.elements[e]);
    pressures_.push_back(std::move(faces));
  }
  for (const auto& s : model.springs()) {
    const auto& nodes = mesh.set(s.set);
    const Tributary t = tributary(mesh, nodes);
    const Vec3 k(s.stiffness[0], s.stiffness[1], s.stiffness[2]);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      springs_.push_back({nodes[i], t.measure[i] / t.total * s.frame.transpose() * k.asDiagonal() * s.frame});
  }
  aim(0);
}

void Loads::aim(double time) {
  aimed_ = time;
  aimed_gravity_ = gravity_at(time);
  aimed_pressure_.clear();
  for (const auto& p : pressures_) aimed_pressure_.push_back(p.value.value(time));
  aimed_moment_.assign(moments_.empty() ? 0 : mass_.size(), Vec3::Zero());
  for (const auto& m : moments_) {
    const Vec3 total = m.at(time);
    for (std::size_t i = 0; i < m.nodes.size(); ++i) aimed_moment_[m.nodes[i]] += m.share[i] * total;
  }
}

void Loads::dead(double time, std::vector<double>& out) const {
  out.resize(3 * mass_.size());
  const std::span<double> f(out);
  const Vec3 gravity = gravity_at(time);
  for (std::size_t i = 0; i < mass_.size(); ++i) at(f, static_cast<Index>(i)) = mass_[i] * gravity;
  for (const auto& load : dead_) {
    const Vec3 total = load.at(time);
    for (std::size_t i = 0; i < load.nodes.size(); ++i) at(f, load.nodes[i]) += load.share[i] * total;
  }
}

Vec3 Loads::gravity_at(double time) const {
  Vec3 g = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (gravity_[c]) g[c] = gravity_[c]->value(time);
  return g;
}

namespace {
bool constant(const model::Components& value) {
  return std::all_of(value.begin(), value.end(), [](const auto& h) { return !h || h->is_constant(); });
}
}  // namespace

bool Loads::constant() const {
  return assembly::constant(gravity_) &&
         std::all_of(dead_.begin(), dead_.end(), [](const Spread& s) { return assembly::constant(s.value); });
}

bool Loads::on_directors() const {
  const bool weighs = std::any_of(gravity_.begin(), gravity_.end(), [](const auto& g) { return bool(g); });
  return !moments_.empty() ||
         (weighs && std::any_of(mass_moment_.begin(), mass_moment_.end(), [](double m) { return m != 0; }));
}

void Loads::add_director_loads(std::span<const double> d, std::span<double> out) const {
  for (std::size_t i = 0; i < mass_.size(); ++i)
    at(out, static_cast<Index>(i)) += director_load(i, at(d, static_cast<Index>(i)));
}

// Pressure: f_A = p sum_g N_A a1 x a2, positive along the normal of the current surface.
void Loads::add_follower(double time, std::span<const double> x, std::span<double> out, double scale) const {
  for (const auto& faces : pressures_) {
    const double p = scale * faces.value.value(time);
    for (const auto& nodes : faces.elements)
      for (int g = 0; g < points(nodes); ++g) {
        const FacePoint point = face_point(nodes, g);
        const Tangents t = tangents(point, nodes, x);
        const Vec3 f = p * t.a1.cross(t.a2);
        for (int a = 0; a < corners(nodes); ++a) at(out, nodes[a]) += point.N[a] * f;
      }
  }
}

// Force on a director: gravity off the middle surface (dead), and moments about axes fixed in space, whose
// work M . (d x delta d) makes M x d.
Vec3 Loads::director_load(std::size_t node, const Vec3& d) const {
  Vec3 f = mass_moment_[node] * aimed_gravity_;
  if (!aimed_moment_.empty()) f += aimed_moment_[node].cross(d);
  return f;
}

void Loads::add_to_internal(std::span<const double> x, std::span<const double> d, const std::vector<Vec3>& X,
                            std::span<double> force_x, std::span<double> force_d) const {
  for (std::size_t k = 0; k < pressures_.size(); ++k)
    for (const auto& nodes : pressures_[k].elements)
      for (int g = 0; g < points(nodes); ++g) {
        const FacePoint point = face_point(nodes, g);
        const Tangents t = tangents(point, nodes, x);
        const Vec3 f = aimed_pressure_[k] * t.a1.cross(t.a2);
        for (int a = 0; a < corners(nodes); ++a) at(force_x, nodes[a]) -= point.N[a] * f;
      }
  if (on_directors())
    for (std::size_t i = 0; i < mass_.size(); ++i)
      at(force_d, static_cast<Index>(i)) -= director_load(i, at(d, static_cast<Index>(i)));
  for (const auto& s : springs_) at(force_x, s.node) += s.stiffness * (at(x, s.node) - X[s.node]);
}

void Loads::add_stiffness(std::span<const double> x, std::span<const double> d, std::span<const double> b1,
                          const OnX& on_x, const OnQ& on_q) const {
  for (std::size_t k = 0; k < pressures_.size(); ++k)
    for (const auto& nodes : pressures_[k].elements) {
      Mat3 block[4][4];
      for (auto& row : block)
        for (auto& b : row) b.setZero();
      const int n = corners(nodes);
      for (int g = 0; g < points(nodes); ++g) {
        const FacePoint p = face_point(nodes, g);
        const Tangents t = tangents(p, nodes, x);
        const Mat3 C1 = cross_matrix(t.a1), C2 = cross_matrix(t.a2);
        // delta (a1 x a2) = -a2 x delta a1 + a1 x delta a2; counted against the internal force.
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b)
            block[a][b] -= aimed_pressure_[k] * p.N[a] * (p.N2[b] * C1 - p.N1[b] * C2);
      }
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) on_x(nodes[a], nodes[b], block[a][b]);
    }
  for (const auto& s : springs_) on_x(s.node, s.node, s.stiffness);
  const bool weighs = aimed_gravity_.norm() > 0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const bool off_middle = weighs && mass_moment_[i] != 0;
    if (aimed_moment_.empty() && !off_middle) continue;
    const Index n = static_cast<Index>(i);
    const Vec3 dd = at(d, n), first = at(b1, n), second = dd.cross(first);
    Eigen::Matrix2d k = director_load(i, dd).dot(dd) * Eigen::Matrix2d::Identity();  // second variation of d
    if (!aimed_moment_.empty()) {
      const Vec3& M = aimed_moment_[i];
      k(0, 0) -= M.cross(first).dot(first);
      k(0, 1) -= M.cross(second).dot(first);
      k(1, 0) -= M.cross(first).dot(second);
      k(1, 1) -= M.cross(second).dot(second);
    }
    on_q(n, k);
  }
}

double Loads::spring_energy(std::span<const double> x, const std::vector<Vec3>& X) const {
  double sum = 0;
  for (const auto& s : springs_) {
    const Vec3 u = at(x, s.node) - X[s.node];
    sum += u.dot(s.stiffness * u) / 2;
  }
  return sum;
}

}  // namespace fabricsh::assembly
