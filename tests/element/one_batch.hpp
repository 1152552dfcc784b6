// A batch of eight random warped shells for tests: geometry, configurations, retraction, energies.
#pragma once
#include <random>
#include <vector>

#include "element/shell3.hpp"
#include "test_cards.hpp"

namespace fabricsh::test {

// Largest entry of a matrix in absolute value.
inline double largest(const Eigen::MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

// The two elements, as the tests see them.
struct Quadrilateral {
  using Layout = element::Shell4Layout;
  static constexpr int corners = 4, dofs = element::shell4_dofs, in_plane = element::gauss_points;
  static constexpr auto geometry = element::shell4_geometry;
  static constexpr auto kernels = element::shell4_kernels;
  static constexpr auto sharing = element::shell4_sharing;
};
struct Triangle {
  using Layout = element::Shell3Layout;
  static constexpr int corners = 3, dofs = element::shell3_dofs, in_plane = element::shell3_points;
  static constexpr auto geometry = element::shell3_geometry;
  static constexpr auto kernels = element::shell3_kernels;
  static constexpr auto sharing = element::shell3_sharing;
};

template <class Element>
struct RandomBatch {
  static constexpr int corners = Element::corners, dofs = Element::dofs, in_plane = Element::in_plane;
  section::Section section;
  element::Shell4Kernels kernels;
  inline static const Vec3 square[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::mt19937 random{12345};
  std::vector<double> geometry, s0, s1;
  element::Sharing sharing = element::Sharing::none;
  std::array<std::array<Vec3, corners>, lanes> X, D, x, d, b1;

  RandomBatch(const card::Card& card, int points, double offset = 0, Isa isa = best_isa())
      : section(section::integrated(card, card.thickness, points, offset)), kernels(Element::kernels(isa)) {
    const typename Element::Layout layout(static_cast<int>(section.points.size()));
    geometry.assign(layout.size() * lanes, 0);
    s0.assign(in_plane * section.state_size * lanes + 1, 0);
    s1 = s0;
    for (int l = 0; l < lanes; ++l) {
      for (int a = 0; a < corners; ++a) {
        X[l][a] = 0.01 * (square[a] + 0.15 * vector());
        D[l][a] = (Vec3::UnitZ() + 0.15 * vector()).normalized();
      }
      const Vec3 warp = (Vec3::UnitX() + vector()).normalized();
      Element::geometry(
          section, X[l], D[l], [&](const Vec3&, const Vec3&) { return warp; }, geometry.data(), l, lanes);
    }
    rest();
  }
  // Flat virgin elements, each in a plane of its own, with directors along its normal; parallelograms, or
  // corners moved in the plane.
  void flatten(bool parallelograms) {
    for (int l = 0; l < lanes; ++l) {
      const Mat3 R = Eigen::AngleAxisd(3 * number(), vector().normalized()).toRotationMatrix();
      const Vec3 e1 = Vec3::UnitX() + 0.2 * vector(), e2 = Vec3::UnitY() + 0.2 * vector();
      for (int a = 0; a < corners; ++a) {
        Vec3 corner = square[a].x() * e1 + square[a].y() * e2;
        if (!parallelograms) corner += 0.15 * vector();
        corner.z() = 0;
        X[l][a] = 0.01 * R * corner;
        D[l][a] = R.col(2);
      }
      const Vec3 warp = R * (Vec3::UnitX() + 0.5 * vector());
      Element::geometry(
          section, X[l], D[l], [&](const Vec3&, const Vec3&) { return warp; }, geometry.data(), l, lanes);
    }
    rest();
    sharing = Element::sharing(section, geometry.data());
  }
  double number() { return std::uniform_real_distribution<double>(-1, 1)(random); }
  Vec3 vector() { return {number(), number(), number()}; }
  void rest() {
    x = X;
    d = D;
    basis();
  }
  void basis() {
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < corners; ++a) b1[l][a] = d[l][a].cross(Vec3::UnitX()).normalized();
  }
  // Strains of the order of `size`, after an arbitrary rigid turn of each element.
  void deform(double size) {
    for (int l = 0; l < lanes; ++l) {
      const Mat3 R = Eigen::AngleAxisd(3 * number(), vector().normalized()).toRotationMatrix();
      for (int a = 0; a < corners; ++a) {
        x[l][a] = R * (X[l][a] + 0.01 * size * vector());
        d[l][a] = (R * (D[l][a] + size * vector())).normalized();
      }
    }
    basis();
  }
  // x and d moved by the 20 increments of every lane (column l of `step`).
  RandomBatch moved(const Eigen::MatrixXd& step) const {
    RandomBatch other = *this;
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < corners; ++a) {
        const auto u = step.col(l).template segment<5>(5 * a);
        other.x[l][a] += u.template head<3>();
        const Vec3 q = u[3] * b1[l][a] + u[4] * d[l][a].cross(b1[l][a]);
        if (q.norm() == 0) continue;
        const Vec3 axis = q.normalized(), d0 = d[l][a];
        other.d[l][a] = std::cos(q.norm()) * d0 + std::sin(q.norm()) * axis;
        // b1 carried along the great circle: to first order the derivative of d with respect to q.
        other.b1[l][a] += b1[l][a].dot(axis) * ((std::cos(q.norm()) - 1) * axis - std::sin(q.norm()) * d0);
      }
    return other;
  }
  struct Arrays {
    alignas(64) double x[3 * corners * lanes], d[3 * corners * lanes], b[6 * corners * lanes];
  };
  Arrays arrays() const {
    Arrays r;
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < corners; ++a)
        for (int i = 0; i < 3; ++i) {
          r.x[(3 * a + i) * lanes + l] = x[l][a][i];
          r.d[(3 * a + i) * lanes + l] = d[l][a][i];
          r.b[(6 * a + i) * lanes + l] = b1[l][a][i];
          r.b[(6 * a + 3 + i) * lanes + l] = d[l][a].cross(b1[l][a])[i];
        }
    return r;
  }
  // Internal force on (u, q): 20 x lanes, N and N m. The directors' part is projected on this configuration's
  // basis.
  Eigen::MatrixXd force() {
    const Arrays r = arrays();
    alignas(64) double f[6 * corners * lanes];
    REQUIRE(kernels.force(section, law::Step{},
                          {geometry.data(), r.x, r.d, r.b, s0.data(), s1.data(), sharing}, f) == 0);
    return project(f);
  }
  Eigen::MatrixXd tangent(int lane, Eigen::MatrixXd* force_out = nullptr) {
    const Arrays r = arrays();
    alignas(64) double f[6 * corners * lanes], k[dofs * dofs * lanes];
    REQUIRE(kernels.tangent(section, law::Step{}, {geometry.data(), r.x, r.d, r.b, s0.data(), s1.data()}, f,
                            k) == 0);
    if (force_out != nullptr) *force_out = project(f);
    Eigen::MatrixXd K(dofs, dofs);
    for (int i = 0; i < dofs; ++i)
      for (int j = 0; j < dofs; ++j) K(i, j) = k[(dofs * j + i) * lanes + lane];
    return K;
  }
  Eigen::MatrixXd project(const double* f) const {
    Eigen::MatrixXd out(dofs, lanes);
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < corners; ++a) {
        Vec3 fd;
        for (int i = 0; i < 3; ++i) {
          out(5 * a + i, l) = f[(3 * a + i) * lanes + l];
          fd[i] = f[(3 * (corners + a) + i) * lanes + l];
        }
        out(5 * a + 3, l) = b1[l][a].dot(fd);
        out(5 * a + 4, l) = d[l][a].cross(b1[l][a]).dot(fd);
      }
    return out;
  }
  std::vector<double> strains() {
    const Arrays r = arrays();
    std::vector<double> E(in_plane * section.points.size() * 5 * lanes);
    kernels.strain(section, {geometry.data(), r.x, r.d, nullptr, nullptr, nullptr}, E.data());
    return E;
  }
  // Stored plus dissipated energy of one lane at the trial state of the last force() or tangent(), J.
  double energy(int lane) {
    const auto E = strains();
    const int points = static_cast<int>(section.points.size());
    const typename Element::Layout layout(points);
    double sum = 0;
    std::vector<double> state(section.state_size + 1);
    for (int g = 0; g < in_plane; ++g)
      for (int k = 0; k < points; ++k) {
        double e[5];
        for (int i = 0; i < 5; ++i) e[i] = E[((g * points + k) * 5 + i) * lanes + lane];
        const auto& p = section.points[k];
        for (int i = 0; i < law::state_size(*p.law); ++i)
          state[i] = s1[(g * section.state_size + p.state + i) * lanes + lane];
        const auto energy = law::energy(*p.law, e, state.data());
        sum += geometry[(layout.point(g, k) + 7) * lanes + lane] * (energy.stored + energy.dissipated());
      }
    return sum;
  }
};

}  // namespace fabricsh::test
