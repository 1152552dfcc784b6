#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "catch.hpp"
#include "mechanics/mass_shares.hpp"
#include "mechanics/terms/cloth_rates.hpp"

using namespace fabricsh;
using mechanics::CornerMasses;
using mechanics::PlaneMatrix;

namespace {

constexpr double kShear = 0.05;  // over the stiffness along the axes

// A skewed and uneven grid of unit density, with triangles; a side of the element in the middle is `narrow`.
struct Sheet {
  mesh::Mesh mesh;
  std::vector<PlaneMatrix> stiffness;
  std::vector<CornerMasses> equal;
  std::vector<double> rates;

  explicit Sheet(int across, double uneven, double narrow = 1) {
    const int row = across + 1;
    for (int j = 0; j < row; ++j)
      for (int i = 0; i < row; ++i)
        mesh.nodes.emplace_back(i + uneven * std::sin(7.1 * i + 3.3 * j),
                                j + uneven * std::cos(2.9 * i - 5.7 * j), 0);
    const auto middle = std::size_t(across / 2 + row * (across / 2));
    mesh.nodes[middle + 1] = mesh.nodes[middle] + narrow * (mesh.nodes[middle + 1] - mesh.nodes[middle]);
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        const mesh::Index a = i + row * j;
        if ((i + j) % 3 == 0) {
          mesh.elements.push_back({a, a + 1, a + 1 + row, -1});
          mesh.elements.push_back({a, a + 1 + row, a + row, -1});
        } else {
          mesh.elements.push_back({a, a + 1, a + 1 + row, a + row});
        }
      }
    for (const auto& e : mesh.elements) {
      std::vector<Eigen::Vector2d> x;
      for (const auto n : e)
        if (n >= 0) x.emplace_back(mesh.nodes[std::size_t(n)].head<2>());
      stiffness.push_back(mechanics::plane_matrix(x, kShear));
      rates.push_back(mechanics::largest_eigenvalue(stiffness.back()));
      equal.push_back({});
      equal.back().fill(mechanics::area(e, mesh.nodes) / double(x.size()));
    }
  }
  std::vector<double> sums(const std::vector<CornerMasses>& shares) const {
    std::vector<double> sum(mesh.nodes.size(), 0);
    for (std::size_t e = 0; e < shares.size(); ++e)
      for (std::size_t c = 0; c < 4; ++c)
        if (const auto n = mesh.elements[e][c]; n >= 0) sum[std::size_t(n)] += shares[e][c];
    return sum;
  }
  // 1/s^2, of the whole sheet.
  double highest(const std::vector<double>& times = {}) const {
    std::vector<double> mass = sums(equal);
    for (std::size_t n = 0; n < times.size(); ++n) mass[n] *= times[n];
    const auto size = Eigen::Index(2 * mesh.nodes.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t e = 0; e < stiffness.size(); ++e)
      for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b) {
          const auto m = mesh.elements[e][std::size_t(a / 2)], n = mesh.elements[e][std::size_t(b / 2)];
          if (m >= 0 && n >= 0)
            K(2 * m + a % 2, 2 * n + b % 2) +=
                equal[e][0] * stiffness[e](a, b) / std::sqrt(mass[std::size_t(m)] * mass[std::size_t(n)]);
        }
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  }
  mechanics::SharedMasses shared() const {
    return mechanics::share_masses(mesh, equal, rates,
                                   [this](mesh::Index e) { return stiffness[std::size_t(e)]; });
  }
};

}  // namespace

TEST_CASE("shares of the masses keep those of the nodes, and the bound stays above the highest frequency") {
  for (const double uneven : {0.1, 0.2, 0.3}) {
    CAPTURE(uneven);
    const Sheet sheet(8, uneven);
    const auto [shares, rates, highest] = sheet.shared();
    const auto mass = sheet.sums(sheet.equal), kept = sheet.sums(shares);
    for (std::size_t n = 0; n < mass.size(); ++n) CHECK(std::abs(kept[n] - mass[n]) <= 1e-12 * mass[n]);
    const auto means = mechanics::means_at_nodes(
        sheet.mesh, sheet.rates, [&](std::size_t e, std::size_t c) { return sheet.equal[e][c]; });
    const double before = *std::max_element(means.begin(), means.end()), least = sheet.highest();
    CHECK(highest >= least);
    // A good part of what lies between the bound with equal shares and the truth is gone.
    CHECK(highest - least < 0.6 * (before - least));
  }
}

TEST_CASE("squares keep equal shares") {
  Sheet sheet(1, 0);
  sheet.mesh.elements = {{0, 1, 3, 2}};
  sheet.equal = {{0.25, 0.25, 0.25, 0.25}};
  sheet.rates = {4};
  CHECK(sheet.shared().shares == sheet.equal);
  CHECK(sheet.shared().highest == 4);
}

TEST_CASE("nodes whose rates are far above the rest take mass from those about them") {
  // A strip of squares, two nodes across.
  mesh::Mesh mesh;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 2; ++j) mesh.nodes.emplace_back(i, j, 0);
  for (mesh::Index i = 0; i < 99; ++i) mesh.elements.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  const std::vector<double> mass(200, 2);
  std::vector<double> means(200, 1);
  means[50] = 1.5;
  const auto moved = mechanics::move_mass(mesh, means, mass);
  CHECK(moved.highest == Approx(1 / 0.9025));
  CHECK(moved.times[50] == Approx(1.5 * 0.9025));
  CHECK(moved.times[0] == 1);
  CHECK(moved.times[51] < 1);
  double sum = 0;
  for (std::size_t n = 0; n < 200; ++n) {
    sum += 2 * moved.times[n];
    CHECK(moved.times[n] >= 0.9 - 1e-12);
    CHECK(means[n] <= moved.highest * moved.times[n] * (1 + 1e-12));
  }
  CHECK(sum == Approx(400));
  // What is symmetric stays so.
  means[51] = 1.5;
  const auto both = mechanics::move_mass(mesh, means, mass);
  for (std::size_t n = 0; n < 200; ++n) CHECK(std::abs(both.times[n] - both.times[n ^ 1]) < 1e-12);
  means[51] = 1;
  // There is not enough about it for all that it wants: a part.
  means[50] = 4;
  const auto part = mechanics::move_mass(mesh, means, mass);
  CHECK(part.highest > 1.5);
  CHECK(part.highest < 4 * 0.85);
  CHECK(part.times[50] == Approx(4 / part.highest));
  // Where it would gain little, all stays.
  CHECK(mechanics::move_mass(mesh, std::vector<double>(200, 1), mass).times.empty());
  std::fill(means.begin(), means.begin() + 120, 4);
  CHECK(mechanics::move_mass(mesh, means, mass).times.empty());
  CHECK(mechanics::move_mass(mesh, means, mass).highest == 4);
}

TEST_CASE("with moved mass no frequency is above the bound") {
  const Sheet sheet(16, 0.02, 0.4);
  const auto found = sheet.shared();
  const auto means = mechanics::means_at_nodes(
      sheet.mesh, found.rates, [&](std::size_t e, std::size_t c) { return found.shares[e][c]; });
  const auto moved = mechanics::move_mass(sheet.mesh, means, sheet.sums(sheet.equal));
  REQUIRE_FALSE(moved.times.empty());
  CHECK(moved.highest < 0.9 * found.highest);
  CHECK(sheet.highest(moved.times) <= moved.highest);
  CHECK(sheet.highest() > moved.highest);
}
