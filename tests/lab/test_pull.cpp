#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "catch.hpp"
#include "lab/pull.hpp"

using namespace fabricsh::lab;

TEST_CASE("appendix A's formulas are the tensors' [williams2010, A1, A8]", "[lab]") {
  const Specimen s{0.0762, 0.0254, 0.38e-3, 2};
  for (const double l1 : {0.8, 1.0, 1.3})
    for (const double l2 : {1.0, 1.1, 1.5}) {  // across and along the pull
      const double force = 40 * (l2 - 1);
      const auto t = stress_strain(std::vector{(l2 - 1) * s.gauge_length}, std::vector{force}, s);
      const Eigen::Matrix3d F = Eigen::Vector3d(l1, l2, 1).asDiagonal();
      const Eigen::Matrix3d E = (F.transpose() * F - Eigen::Matrix3d::Identity()) / 2;
      Eigen::Matrix3d cauchy = Eigen::Matrix3d::Zero();
      cauchy(1, 1) = force / (s.area() * l1);  // A = A0 lambda1
      const Eigen::Matrix3d S = F.determinant() * F.inverse() * cauchy * F.inverse().transpose();
      CHECK(std::abs(t.E[0] - E(1, 1)) < 1e-15);
      CHECK(std::abs(t.S[0] - S(1, 1)) <= 1e-12 * std::abs(S(1, 1)));
    }
}

TEST_CASE("the shear stress of a bias pull is half of the pull's [williams2010, 3.12-3.15]", "[lab]") {
  const double c = std::sqrt(0.5);
  Eigen::Matrix2d Q, S = Eigen::Vector2d(0, 7.5).asDiagonal();
  Q << c, -c, c, c;
  const Eigen::Matrix2d turned = Q.transpose() * S * Q;
  CHECK(std::abs(turned(0, 1) - 7.5 / 2) < 1e-14);
}

TEST_CASE("compliance is elastic, slip stays", "[lab]") {
  const std::vector<double> u{0, 1, 2, 1}, P{0, 10, 30, 10};
  const auto plain = end_displacement(u, P, {0.01, 0, 0}), slipped = end_displacement(u, P, {0, 0.01, 0});
  CHECK(plain[3] == 1 - 0.1);
  CHECK(slipped[3] == 1 - 0.3);
  CHECK(slipped[1] == 1 - 0.1);
}

TEST_CASE("first contact and a longer specimen", "[lab]") {
  const std::vector<double> u{0, 1, 2, 3, 4}, P{0, 0.2, 0, 2, 4};
  CHECK(*first_contact(u, P, 1) == 2.5);
  CHECK(*first_contact(u, P, 0.1) == 2.05);
  CHECK_FALSE(first_contact(u, P, 5));
  const auto t = stress_strain(u, P, {10, 1, 1, 1}, 2);
  const double e = 2.0 / 12;
  CHECK(std::abs(t.E[4] - (e + e * e / 2)) < 1e-15);
  CHECK(std::abs(t.S[4] - 4 / (1 + e)) < 1e-14);
}

TEST_CASE("branches of a cyclic test", "[lab]") {
  // up to 5, back to 3 with a twitch, up through 5 to 6, down
  const std::vector<double> u{0, 1, 0.99, 3, 5, 4, 4.01, 3, 4, 5, 6, 2, 0};
  const auto b = branches(u, 0.05);
  REQUIRE(b.size() == 5);
  const BranchKind kinds[] = {BranchKind::loading, BranchKind::unloading, BranchKind::reloading,
                              BranchKind::loading, BranchKind::unloading};
  const std::size_t ends[] = {5, 8, 9, 11, 13};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(b[i].kind == kinds[i]);
    CHECK(b[i].end == ends[i]);
    CHECK(b[i].begin == (i == 0 ? 0 : ends[i - 1]));
  }
  CHECK(branches(std::vector<double>{0, 1, 2}, 0.1).size() == 1);
}

TEST_CASE("a hold at the reversal belongs to neither side", "[lab]") {
  for (const double noise : {0.0, 2e-6}) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> u;
    for (int i = 0; i <= 300; ++i) u.push_back(5e-3 * i / 300);
    for (int i = 0; i < 100; ++i) u.push_back(5e-3);
    for (int i = 1; i <= 100; ++i) u.push_back(5e-3 - 1e-3 * i / 100);
    for (double& x : u) x += noise * normal(random);
    const auto b = branches(u, 5e-5);
    REQUIRE(b.size() == 3);
    CHECK(b[0].kind == BranchKind::loading);
    CHECK(b[1].kind == BranchKind::hold);
    CHECK(b[2].kind == BranchKind::unloading);
    CHECK(b[0].end >= 299);
    CHECK(b[0].end <= 302);
    CHECK(b[2].begin >= 401);
    CHECK(b[2].begin <= 404);  // 16 um of noise are two of its steps
    CHECK(b[2].end == u.size());
  }
  // a fast sampled turn without a hold loses what its noise hides, no more
  std::vector<double> sharp;
  for (int i = 0; i <= 20; ++i) sharp.push_back(i <= 10 ? i : 20 - i);
  CHECK(branches(sharp, 2).size() == 2);
}

TEST_CASE("slack and a wave are no yield", "[lab]") {
  std::vector<double> E, S;
  for (int i = 0; i <= 1000; ++i) {
    const double e = i * 1e-4, taut = std::max(0.0, e - 0.01);
    E.push_back(e);
    S.push_back(4e8 * taut * taut + 8e6 * taut + 2e3 * std::sin(40.0 * i));  // noise in the slack
  }
  CHECK_FALSE(yield_and_failure(E, S, E.size(), 0.8).yield);
  // the tangent falls below half of its largest and comes back
  for (int i = 0; i <= 900; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double wave = 2 * std::numbers::pi / 0.03;
    E[at] = i * 1e-4;
    S[at] = 1e7 * E[at] + 0.8e7 / wave * std::sin(wave * E[at]);
  }
  CHECK_FALSE(yield_and_failure(E, S, 901, 0.8).yield);
}

TEST_CASE("yield and failure of a monotonic test", "[lab]") {
  std::vector<double> E, S;
  for (int i = 0; i <= 400; ++i) {
    const double e = i * 0.001;
    E.push_back(e);
    S.push_back(e < 0.2 ? 50 * e * e : e < 0.35 ? 2 + 4 * (e - 0.2) : 0.5);
  }
  const auto marks = yield_and_failure(E, S, E.size(), 0.8);
  REQUIRE(marks.failure);
  REQUIRE(marks.yield);
  CHECK(*marks.failure == 349);
  CHECK(std::abs(E[*marks.yield] - 0.2) < 0.015);  // a window of a twentieth of the rows
  const auto none = yield_and_failure(E, S, 150, 0.8);
  CHECK_FALSE(none.failure);
  CHECK_FALSE(none.yield);
}
