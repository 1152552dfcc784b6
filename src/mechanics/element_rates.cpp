#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "mechanics/terms/cloth_rates.hpp"

namespace fabricsh::mechanics {

namespace {

using element::shell4_dofs;

constexpr double kNudge = 1e-3;  // rad, and of an edge: central differences of strains, which are quadratic

// State at which a batch is evaluated, as the kernels read it.
struct Nudged {
  alignas(64) double x[12 * lanes], d[12 * lanes];
};

// m: a length of the element in each lane.
std::array<double, lanes> lengths(const double* x) {
  std::array<double, lanes> all{};
  for (int l = 0; l < lanes; ++l)
    for (int i = 0; i < 3; ++i) all[l] = std::hypot(all[l], x[(3 + i) * lanes + l] - x[i * lanes + l]);
  return all;
}

// Moves degree of freedom c of corner a in all lanes: a displacement by a share of `length`, a rotation along
// the director's great circle.
void nudge(Nudged& at, int a, int c, double share, const std::array<double, lanes>& length, const double* d,
           const double* b) {
  for (int l = 0; l < lanes; ++l) {
    if (c < 3) {
      at.x[(3 * a + c) * lanes + l] += share * length[l];
      continue;
    }
    for (int i = 0; i < 3; ++i)
      at.d[(3 * a + i) * lanes + l] = std::cos(share) * d[(3 * a + i) * lanes + l] +
                                      std::sin(share) * b[(6 * a + 3 * (c - 3) + i) * lanes + l];
  }
}

// Strains and curvatures of a batch.
struct Deformation {
  std::vector<double> strain, curvature;
};

void deform(const Batch& batch, const Nudged& at, Deformation& out) {
  const auto& section = *batch.section;
  const element::ShellBatch data{batch.geometry, at.x, at.d, nullptr, nullptr, nullptr};
  const auto points = section.points.size() * static_cast<std::size_t>(batch.kind->in_plane);
  out.strain.resize(5 * points * lanes);
  batch.kind->kernels.strain(section, data, out.strain.data());
  if (!section.bends_apart) return;
  out.curvature.resize(3 * static_cast<std::size_t>(batch.kind->in_plane) * lanes);
  batch.kind->kernels.curvature(section, data, out.curvature.data());
}

// The columns of the derivatives: one deformation for each degree of freedom.
std::vector<Deformation> derivatives(const Batch& batch, const double* x, const double* d, const double* b) {
  const auto length = lengths(x);
  std::vector<Deformation> columns;
  Deformation behind;
  for (int a = 0; a < batch.kind->corners; ++a)
    for (int c = 0; c < 5; ++c) {
      const auto deform_at = [&](double share, Deformation& out) {
        Nudged at;
        std::copy_n(x, 12 * lanes, at.x);
        std::copy_n(d, 12 * lanes, at.d);
        nudge(at, a, c, share, length, d, b);
        deform(batch, at, out);
      };
      Deformation ahead;
      deform_at(kNudge, ahead);
      deform_at(-kNudge, behind);
      const auto subtract = [&](std::vector<double>& from, const std::vector<double>& less) {
        for (std::size_t i = 0; i < from.size(); ++i)
          from[i] = (from[i] - less[i]) / (c < 3 ? 2 * kNudge * length[i % lanes] : 2 * std::sin(kNudge));
      };
      subtract(ahead.strain, behind.strain);
      subtract(ahead.curvature, behind.curvature);
      columns.push_back(std::move(ahead));
    }
  return columns;
}

// Adds stiffness * row^T row, where the row is entry i of lane l of all columns.
class RowProducts {
 public:
  RowProducts(const std::vector<Deformation>& columns, ElementMatrix& sum) : columns_(columns), sum_(sum) {}
  void add(std::vector<double> Deformation::*part, std::size_t i, double stiffness) {
    const auto n = static_cast<Eigen::Index>(columns_.size());
    Eigen::Matrix<double, shell4_dofs, 1> row;
    for (Eigen::Index k = 0; k < n; ++k) row[k] = (columns_[static_cast<std::size_t>(k)].*part)[i];
    sum_.topLeftCorner(n, n).noalias() += (stiffness * row.head(n)) * row.head(n).transpose();
  }

 private:
  const std::vector<Deformation>& columns_;
  ElementMatrix& sum_;
};

void add_lane(const Batch& batch, const Stiffest& stiffest, const std::vector<Deformation>& columns,
              std::size_t lane, ElementMatrix& sum) {
  const auto& section = *batch.section;
  const int points = static_cast<int>(section.points.size());
  RowProducts rows(columns, sum);
  for (int g = 0; g < batch.kind->in_plane; ++g) {
    double area = 0;  // m^2
    for (int k = 0; k < points; ++k) {
      const double w =
          batch.geometry[static_cast<std::size_t>(batch.kind->point(g, k, points) + 7) * lanes + lane];
      const law::Bound& most = stiffest.points[static_cast<std::size_t>(k)];
      const double stiffness[5] = {most.axial, most.axial, most.transverse, most.transverse, most.shear};
      const auto first = static_cast<std::size_t>(g * points + k) * 5;
      for (std::size_t i = 0; i < 5; ++i)
        rows.add(&Deformation::strain, (first + i) * lanes + lane, w * stiffness[i]);
      area += w / section.thickness;
    }
    for (std::size_t m = 0; m < 3 && section.bends_apart; ++m)
      rows.add(&Deformation::curvature, (3 * static_cast<std::size_t>(g) + m) * lanes + lane,
               area * stiffest.bending[m]);
  }
}

// The degrees of freedom in the order displacements, rotations.
Eigen::MatrixXd sorted(const ElementMatrix& k, int corners) {
  std::vector<int> order;
  for (const bool turns : {false, true})
    for (int a = 0; a < corners; ++a)
      for (int c = turns ? 3 : 0; c < (turns ? 5 : 3); ++c) order.push_back(5 * a + c);
  return k(order, order);
}

double largest(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

}  // namespace

// Where points have axes of their own, the stiffness is the same in all directions, and no less.
Stiffest::Stiffest(const section::Section& section) {
  double mass = 0;
  for (const auto& p : section.points) {
    law::Bound most = law::bound(*p.law);
    points.push_back(most);
    if (p.angle != 0) {
      most.axial = std::max(most.axial, 2 * most.shear);
      most.shear = most.axial / 2;
    }
    axial += p.weight * most.axial;
    shear += p.weight * most.shear;
    mass += p.weight * p.density;
  }
  axial /= mass;
  shear /= mass;
  for (std::size_t m = 0; m < 3 && section.bends_apart; ++m) bending[m] = law::stiffest(section.bending[m]);
}

std::array<ElementMatrix, lanes> stiffest_matrices(const Batch& batch, const Stiffest& stiffest,
                                                   const double* x, const double* d, const double* b) {
  std::array<ElementMatrix, lanes> all;
  const auto columns = derivatives(batch, x, d, b);
  for (std::size_t l = 0; l < lanes; ++l) {
    all[l].setZero();
    add_lane(batch, stiffest, columns, l, all[l]);
  }
  return all;
}

double highest_rate(const ElementMatrix& stiffness, int corners, const CornerMasses& mass, double inertia) {
  Eigen::VectorXd scale(5 * corners);
  for (int i = 0; i < 5 * corners; ++i)
    scale[i] = 1 / std::sqrt(i % 5 < 3 ? mass[static_cast<std::size_t>(i / 5)] : inertia);
  return largest(scale.asDiagonal() * stiffness.topLeftCorner(5 * corners, 5 * corners) * scale.asDiagonal());
}

namespace {

// Of the displacements, in the order of sorted().
Eigen::VectorXd masses(const CornerMasses& mass, int corners) {
  Eigen::VectorXd all(3 * corners);
  for (int i = 0; i < 3 * corners; ++i) all[i] = mass[static_cast<std::size_t>(i / 3)];
  return all;
}

}  // namespace

double rate_of_displacements(const ElementMatrix& stiffness, int corners, const CornerMasses& mass) {
  const int u = 3 * corners;
  const Eigen::VectorXd scale = masses(mass, corners).cwiseSqrt().cwiseInverse();
  return largest(scale.asDiagonal() * sorted(stiffness, corners).topLeftCorner(u, u) * scale.asDiagonal());
}

namespace {

// Adds what a point with these derivatives of the shape functions has, times its area, m^2.
void add_plane(const Eigen::Matrix<double, 4, 2>& by, double area, double shear, PlaneMatrix& sum) {
  Eigen::Matrix<double, 3, 8> strain = Eigen::Matrix<double, 3, 8>::Zero();
  for (int a = 0; a < 4; ++a) {
    strain(0, 2 * a) = strain(2, 2 * a + 1) = by(a, 0);
    strain(1, 2 * a + 1) = strain(2, 2 * a) = by(a, 1);
  }
  sum.noalias() += area * strain.transpose() * Vec3(1, 1, shear).asDiagonal() * strain;
}

}  // namespace

PlaneMatrix plane_matrix(std::span<const Eigen::Vector2d> x, double shear) {
  const auto n = static_cast<int>(x.size());
  PlaneMatrix sum = PlaneMatrix::Zero();
  double area = 0;
  const auto add = [&](const Eigen::Matrix<double, 4, 2>& by_own, double weight) {
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for (int a = 0; a < n; ++a) J += by_own.row(a).transpose() * x[static_cast<std::size_t>(a)].transpose();
    const double part = weight * std::abs(J.determinant());
    add_plane(by_own * J.inverse().transpose(), part, shear, sum);
    area += part;
  };
  Eigen::Matrix<double, 4, 2> by = Eigen::Matrix<double, 4, 2>::Zero();
  if (n == 3) {
    by.topRows<3>() << -1, -1, 1, 0, 0, 1;
    add(by, 0.5);
  } else {
    const double g = 1 / std::sqrt(3.0);
    for (const double s : {-g, g})
      for (const double t : {-g, g}) {
        by << t - 1, s - 1, 1 - t, -1 - s, 1 + t, 1 + s, -1 - t, 1 - s;
        add(by / 4, 1);
      }
  }
  return sum * (n / area);
}

// rate * M - K must have no negative eigenvalue. With its part of the displacements eliminated what remains
// for the rotations is rate * inertia - S, S = K_qq + K_qu (rate m - K_uu)^-1 K_uq.
double inertia_for(const ElementMatrix& stiffness, int corners, const CornerMasses& mass, double rate) {
  const Eigen::MatrixXd k = sorted(stiffness, corners);
  const int u = 3 * corners, q = 2 * corners;
  const Eigen::LLT<Eigen::MatrixXd> left(Eigen::MatrixXd((rate * masses(mass, corners)).asDiagonal()) -
                                         k.topLeftCorner(u, u));
  if (left.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd S =
      k.bottomRightCorner(q, q) + k.bottomLeftCorner(q, u) * left.solve(k.topRightCorner(u, q));
  return largest(S) / rate;
}

}  // namespace fabricsh::mechanics
