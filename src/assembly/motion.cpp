// What a run in motion asks of the assembly: masses, velocities, the stable step, work.
#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"
#include "base/error.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::assembly {

namespace {

int corners(const std::array<Index, 4>& nodes) { return nodes[3] < 0 ? 3 : 4; }

double area(const std::array<Index, 4>& e, const std::vector<Vec3>& X) {
  if (corners(e) == 3) return (X[e[1]] - X[e[0]]).cross(X[e[2]] - X[e[0]]).norm() / 2;
  return (X[e[2]] - X[e[0]]).cross(X[e[3]] - X[e[1]]).norm() / 2;
}

// m: the height over the longest edge, that a wave crosses first.
double size(const std::array<Index, 4>& e, const std::vector<Vec3>& X) {
  const int n = corners(e);
  double longest = 0;
  for (int c = 0; c < n; ++c) longest = std::max(longest, (X[e[(c + 1) % n]] - X[e[c]]).norm());
  return (n == 3 ? 2 : 1) * area(e, X) / longest;
}

// m^2: rotary inertia per mass that the thickness has, int rho z^2 / int rho.
double gyration(const section::Section& section) {
  if (section.points.size() == 1)
    return section.thickness * section.thickness * (1.0 / 12 + section.offset * section.offset / 4);
  double mass = 0, second = 0;
  for (const auto& p : section.points) {
    const double z = section.thickness / 2 * (p.zeta - section.offset);
    mass += p.weight * p.density;
    second += p.weight * p.density * z * z;
  }
  return second / mass;
}

// (m/s)^2: the stiffest in-plane and the transverse shear modulus, over the density, of the whole thickness.
struct Speeds {
  double membrane = 0, shear = 0;
};
Speeds speeds(const section::Section& section) {
  double stiffness = 0, transverse = 0, mass = 0;
  for (const auto& p : section.points) {
    stiffness += p.weight * fabric::stiffest(*p.law);
    transverse += p.weight * fabric::transverse_modulus(*p.law);
    mass += p.weight * p.density;
  }
  return {stiffness / mass, transverse / mass};
}

// s: the step that the waves in the plane of the cloth allow.
double membrane_step(const mesh::Mesh& mesh, double speed_squared) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& e : mesh.elements)
    shortest = std::min(shortest, size(e, mesh.nodes) / std::sqrt(speed_squared));
  return shortest;
}

// m^2: rotary inertia per mass, the thickness' own and, if scaled, at least as much as lets rotations against
// the transverse shear, of frequency c_s / sqrt(inertia), take the membrane's step, 2 / frequency: h^2 (c_s /
// c)^2 / 4. It slows a wave of wave number k by (k h)^2 (c_s / c)^2 / 8, for woven cloth some hundredth of
// what the lumped mass does, (k h)^2 / 24; [hughes1978] has A/8 whatever the moduli, which is (k h)^2 / 16.
double inertia_per_mass(const section::Section& section, const mesh::Mesh& mesh, bool scaled) {
  const double own = gyration(section);
  if (!scaled) return own;
  const Speeds speed = speeds(section);
  const double step = membrane_step(mesh, speed.membrane);
  return std::max(own, speed.shear * step * step / 4);
}

}  // namespace

void Assembly::add_inertia() {
  const auto& section = model_.section();
  for (const bool scaled : {false, true}) {
    const double inertia = inertia_per_mass(section, model_.mesh(), scaled);
    rotary_[scaled].assign(X_.size(), 0);
    for (const auto& e : model_.mesh().elements) {
      const double mass = section.areal_mass * area(e, X_) / corners(e);
      for (int c = 0; c < corners(e); ++c) rotary_[scaled][e[c]] += mass * inertia;
    }
  }
  for (const auto& motion : freedoms_.motions)
    if (driven_nodes_.empty() || driven_nodes_.back() != motion.node) driven_nodes_.push_back(motion.node);
  std::sort(driven_nodes_.begin(), driven_nodes_.end());
  driven_nodes_.erase(std::unique(driven_nodes_.begin(), driven_nodes_.end()), driven_nodes_.end());
}

double Assembly::stable_step(bool scaled) const {
  const auto& section = model_.section();
  const Speeds speed = speeds(section);
  double bending = 0;  // N m per metre of width
  if (section.bends_apart)
    for (const auto& spring : section.bending) bending = std::max(bending, spring.rigidity);
  const double inertia = inertia_per_mass(section, model_.mesh(), scaled);
  double shortest = membrane_step(model_.mesh(), speed.membrane);
  if (bending > 0)
    shortest = std::min(shortest, smallest_size() * std::sqrt(inertia * section.areal_mass / (2 * bending)));
  // Scaled, both are the same but for rounding.
  if (!scaled) shortest = std::min(shortest, 2 * std::sqrt(inertia / speed.shear));
  return shortest;
}

double Assembly::smallest_size() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& e : model_.mesh().elements) smallest = std::min(smallest, size(e, X_));
  return smallest;
}

double Assembly::largest_stretch() const {
  const auto x = std::as_const(*state_).x();
  double largest = 0;  // squared
#pragma omp parallel for schedule(static) reduction(max : largest) if (place_.size() >= 4096)
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const auto& e = model_.mesh().elements[i];
    const int n = corners(e);
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        largest = std::max(largest,
                           (at(x, e[b]) - at(x, e[a])).squaredNorm() / (X_[e[b]] - X_[e[a]]).squaredNorm());
  }
  return std::sqrt(largest);
}

std::vector<double> Assembly::lumped_mass(bool scaled) const {
  std::vector<double> mass(freedoms_.unknowns, 0);
  const auto& rotary = rotary_[scaled];
  std::vector<Link> node;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    if (!freedoms_.ties(n)) {
      const auto& eq = freedoms_.nodes[n].equation;
      for (int c = 0; c < 5; ++c)
        if (eq[c] >= 0) mass[eq[c]] += c < 3 ? mass_[n] : rotary[n];
      continue;
    }
    // The row sum of L^T M L, where the columns of a freedom's links add up to one.
    links(n, node);
    for (const Link& link : node)
      if (link.equation >= 0)
        mass[link.equation] +=
            mass_[n] * link.column.head<3>().sum() + rotary[n] * link.column.tail<2>().sum();
  }
  for (const double m : mass)
    if (!(m > 0) || !freedoms_.bodies.empty())
      throw Error(
          "dynamic: field 'scheme': ties of the kinds \"rigid\" and \"periodic\" have no lumped mass; "
          "expected "
          "scheme=\"implicit\"");
  return mass;
}

void Assembly::add_diagonal(std::span<const double> c_x, std::span<const double> c_d,
                            solver::SparseMatrix& K) const {
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    if (freedoms_.ties(n)) {
      Eigen::Matrix<double, 5, 1> c;
      c << c_x[n], c_x[n], c_x[n], c_d[n], c_d[n];
      add_block(n, n, c.asDiagonal(), K, {}, {});
      continue;
    }
    const auto& eq = freedoms_.nodes[n].equation;
    for (int c = 0; c < 5; ++c)
      if (eq[c] >= 0) add_entry(eq[c], eq[c], c < 3 ? c_x[n] : c_d[n], K, {}, {});
  }
}

void Assembly::spread_rates(std::span<const double> rates, std::span<const double> driven,
                            NodalRates& out) const {
  out.x.assign(3 * X_.size(), 0);
  out.d.assign(3 * X_.size(), 0);
  const auto rate = [&](Index eq) {
    return eq >= 0 ? rates[eq] : eq == held || eq == tied ? 0.0 : driven[motion_of(eq)];
  };
  const auto d = std::as_const(*state_).d();
  std::vector<Link> node;
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const NodeFreedoms& free = freedoms_.nodes[n];
    Eigen::Matrix<double, 5, 1> v = Eigen::Matrix<double, 5, 1>::Zero();
    if (freedoms_.ties(n)) {
      links(n, node);
      for (const Link& link : node) v += rate(link.equation) * link.column;
    } else {
      for (int c = 0; c < 5; ++c) v[c] = rate(free.equation[c]);
    }
    at(out.x, n) = free.frame.transpose() * v.head<3>();
    const Vec3 dn = at(d, n), b1 = at(std::as_const(*state_).b1(), n);
    at(out.d, n) =
        free.turn_axis ? Vec3(v[3] * free.turn_axis->cross(dn)) : Vec3(v[3] * b1 + v[4] * dn.cross(b1));
  }
}

std::vector<double> Assembly::collect_rates(const NodalRates& nodal) const {
  std::vector<double> rates(freedoms_.unknowns, 0);
  const std::span<const double> v(nodal.x), w(nodal.d);
  const auto& s = std::as_const(*state_);
  for (Index n = 0; n < static_cast<Index>(X_.size()); ++n) {
    const NodeFreedoms& free = freedoms_.nodes[n];
    const Vec3 along = free.frame * at(v, n), b1 = at(s.b1(), n), dn = at(s.d(), n);
    const double value[5] = {along[0], along[1], along[2], b1.dot(at(w, n)), dn.cross(b1).dot(at(w, n))};
    for (int c = 0; c < 5; ++c)
      if (free.equation[c] >= 0) rates[free.equation[c]] = value[c];
  }
  for (const Body& body : freedoms_.bodies) {
    const Vec3 middle = centroid(body, s.x());
    Vec3 mean = Vec3::Zero(), spin = Vec3::Zero();
    Mat3 J = Mat3::Zero();
    for (const Index n : body.nodes) {
      mean += at(v, n) / static_cast<double>(body.nodes.size());
      for (const auto& [arm, rate] : {std::pair<Vec3, Vec3>{at(s.x(), n) - middle, at(v, n)},
                                      std::pair<Vec3, Vec3>{at(s.d(), n), at(w, n)}}) {
        J += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
        spin += arm.cross(rate);
      }
    }
    const Vec3 turn = J.ldlt().solve(spin);
    for (int i = 0; i < 3; ++i) {
      rates[body.equation + i] = mean[i];
      rates[body.equation + 3 + i] = turn[i];
    }
  }
  return rates;
}

void Assembly::working_forces(std::span<const double> dead, WorkingForces& out) const {
  const auto& s = std::as_const(*state_);
  out.on_x.assign(dead.begin(), dead.end());
  if (loads_->pushes()) loads_->add_follower(loads_->aimed(), s.x(), out.on_x, 1);
  bool turns = false;
  for (const Index n : driven_nodes_) {
    at(out.on_x, n) += support_force(n, dead);
    turns = turns || freedoms_.nodes[n].turn_axis;
  }
  out.on_d.clear();
  if (!turns && !loads_->on_directors()) return;
  out.on_d.assign(3 * X_.size(), 0);
  if (loads_->on_directors()) loads_->add_director_loads(s.d(), out.on_d);
  for (const Index n : driven_nodes_)
    if (freedoms_.nodes[n].turn_axis) at(out.on_d, n) += at(force_d_, n);
}

void Assembly::keep(Archive& archive) {
  state_->keep(archive);
  archive.filled(force_x_);
  archive.filled(force_d_);
}

}  // namespace fabricsh::assembly
