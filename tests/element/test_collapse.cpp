// Quadrilaterals that fold until their base vectors in the middle are parallel. With m1, m2 these base
// vectors and t the twist, x = xi m1 + eta m2 + xi eta t.
#include "catch.hpp"
#include "draws.hpp"
#include "one_batch.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using test::largest;
using test::Quadrilateral;

namespace {

using Shells = test::RandomBatch<Quadrilateral>;

constexpr double kHalf = 0.004;     // m, half the side of the square reference
constexpr double kCollapse = 0.03;  // det G over its reference value, below which it is replaced

// Eight squares with one point through the thickness, whose strains do not depend on bending.
Shells squares(Isa isa = best_isa()) {
  Shells shells(test::svk(), 1, 0, isa);
  for (int l = 0; l < lanes; ++l) {
    for (int a = 0; a < 4; ++a) {
      shells.X[l][a] = kHalf * (2 * Shells::square[a] - Vec3(1, 1, 0));
      shells.D[l][a] = Vec3::UnitZ();
    }
    element::shell4_geometry(
        shells.section, shells.X[l], shells.D[l], [](const Vec3&, const Vec3&) { return Vec3::UnitX(); },
        shells.geometry.data(), l, lanes);
  }
  shells.rest();
  return shells;
}

void place(Shells& shells, int lane, const Vec3& m1, const Vec3& m2, const Vec3& t) {
  for (int a = 0; a < 4; ++a) {
    const double xi = 2 * Shells::square[a].x() - 1, eta = 2 * Shells::square[a].y() - 1;
    shells.x[lane][a] = xi * m1 + eta * m2 + xi * eta * t;
  }
}

// Places with a det G of a given share of its reference value.
void fold(Shells& shells, int lane, double det) {
  const Vec3 m1 = kHalf * Vec3(0.9, 0.3, -0.2), along = 0.8 * m1;
  const Vec3 across = Vec3(0.2, 0.5, 0.7).cross(m1).normalized();
  place(shells, lane, m1, along + std::sqrt(det) * kHalf * kHalf / m1.norm() * across,
        kHalf * Vec3(0.2, -0.35, 0.4));
}

std::vector<Isa> instruction_sets() {
  std::vector<Isa> all;
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512})
    if (isa <= best_isa()) all.push_back(isa);
  return all;
}

// The largest force on a node (N) of one of the squares whose m1, m2 and t are no longer than R each. A node
// moves by u: the half chords change by u/2 at most, m1, m2 and t by u/4. Edges' chords are as long as 2 R.
//   samples:     (2R)^2 / 2 for the chords, R^2 / 2, R^2 / 2, R^2 in the middle, 0 <= q <= R^2 / 2
//   their rates: 2R / 2 for the chords; R / 4, R / 4, R / 2; and of q, by t at most R, by m1 and m2 at most
//                1.43 R^3 / sqrt(det): below the switch det = y det_s, q = chi(y) p, chi = 3y - 3y^2 + y^3,
//                and |dq/dm1| <= |t|^2 |m2| / sqrt(det_s) (chi' sqrt(y) + chi / (2 sqrt(y))) <= 1.43 ...
// The strains are these through the interpolation, the enhanced modes and 1 / A^2; the forces are stress
// times rate of strain times volume, with the transverse shears R / A and 1 / A, whose modulus is G.
double force_bound(const Shells& shells, double R) {
  const double half_chord = 2 * R, root = std::sqrt(kCollapse) * kHalf * kHalf;
  const std::array<double, 8> sample{half_chord * half_chord / 2,
                                     half_chord * half_chord / 2,
                                     half_chord * half_chord / 2,
                                     half_chord * half_chord / 2,
                                     R * R / 2,
                                     R * R / 2,
                                     R * R,
                                     R * R / 2};
  const double edge = half_chord / 2, q = R / 4 + 2 * 1.43 * R * R * R / root / 4;
  const std::array<double, 8> rate{edge, edge, edge, edge, R / 4, R / 4, R / 2, q};
  const auto strain = [&](const std::array<double, 8>& s) {
    std::array<double, 4> alpha{};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 8; ++k)
        alpha[i] += std::abs(shells.geometry[(element::Shell4Layout::modes + 8 * i + k) * lanes]) * s[k];
    const double g = 1 / std::sqrt(3.0), area = kHalf * kHalf;
    return std::array<double, 3>{
        (s[0] + 2.0 / 3 * s[7] + g * alpha[0]) / area, (s[2] + 2.0 / 3 * s[7] + g * alpha[1]) / area,
        (s[6] + g * s[0] + g * s[2] + 2.0 / 3 * s[7] + g * (alpha[2] + alpha[3])) / area};
  };
  double E[5] = {}, S[5], C[25];
  law::evaluate(*shells.section.points[0].law, law::Step{}, E, nullptr, nullptr, S, C);
  const auto e = strain(sample), de = strain(rate);
  const double stress[3] = {C[0] * e[0] + C[1] * e[1], C[5] * e[0] + C[6] * e[1], C[24] * e[2]};
  double work = (C[12] + C[18]) * (half_chord / kHalf) * (0.5 / kHalf);
  for (int i = 0; i < 3; ++i) work += stress[i] * de[i];
  return work * 4 * kHalf * kHalf * shells.section.thickness;
}

}  // namespace

TEST_CASE("a quadrilateral that folds flat onto a line: the energy does not depend on the way in") {
  // The base vectors are d apart, in a plane that turns by half a circle over the lanes: the nodes differ by
  // 2 d at most and the energies by a multiple of it, which a force without bound would not permit.
  Shells shells = squares();
  const auto spread = [&](double d) {
    const Vec3 m1 = kHalf * Vec3(1.05, 0, 0);
    for (int l = 0; l < lanes; ++l) {
      const double angle = 3.14 * l / lanes;
      place(shells, l, m1, 0.93 * m1 + d * kHalf * Vec3(0, std::cos(angle), std::sin(angle)),
            kHalf * Vec3(0.1, 0.45, 0.2));
    }
    shells.force();
    double least = 1e9, most = 0;
    for (int l = 0; l < lanes; ++l) {
      least = std::min(least, shells.energy(l));
      most = std::max(most, shells.energy(l));
    }
    return (most - least) / most;
  };
  CHECK(spread(1e-2) < 2e-2);
  CHECK(spread(1e-3) < 2e-3);
  CHECK(spread(1e-4) < 2e-4);
}

TEST_CASE("where the metric's replacement begins, force and tangent are the derivatives on both sides") {
  for (const Isa isa : instruction_sets()) {
    Shells shells = squares(isa);
    // From the collapsed state to well above the switch, two lanes close to it on either side.
    const double share[lanes] = {0, 0.01, 0.3, 0.9, 0.9999, 1.0001, 1.2, 3};
    for (int l = 0; l < lanes; ++l) fold(shells, l, kCollapse * share[l]);
    const Eigen::MatrixXd f = shells.force();
    for (int l = 0; l < lanes; ++l) {
      INFO("det of " << share[l] << " of the switch, instruction set " << static_cast<int>(isa));
      Eigen::MatrixXd taken;
      const Eigen::MatrixXd K = shells.tangent(l, &taken);
      CHECK(largest(taken.col(l) - f.col(l)) < 1e-12 * largest(f.col(l)));
      for (int dof = 0; dof < Shells::dofs; ++dof) {
        if (dof % 5 > 2) continue;
        Eigen::MatrixXd step = Eigen::MatrixXd::Zero(Shells::dofs, lanes);
        step(dof, l) = 1;
        const double h = 2e-4 * kHalf;
        const auto energy = [&](double by) {
          Shells moved = shells.moved(by * step);
          moved.force();
          return moved.energy(l);
        };
        const auto force = [&](double by) -> Eigen::VectorXd {
          return shells.moved(by * step).force().col(l);
        };
        // Differences of fourth order. Across the switch the second derivative of the force jumps, which
        // leaves an error of the order of the step.
        const double slope = (8 * (energy(h) - energy(-h)) - energy(2 * h) + energy(-2 * h)) / (12 * h);
        CHECK(std::abs(f(dof, l) - slope) < 1e-6 * largest(f.col(l)));
        const double k = 1e-5 * kHalf;
        const Eigen::VectorXd bend = (8 * (force(k) - force(-k)) - force(2 * k) + force(-2 * k)) / (12 * k);
        CHECK(largest(K.col(dof) - bend) < (std::abs(share[l] - 1) < 0.01 ? 5e-5 : 1e-8) * largest(K));
      }
    }
  }
}

TEST_CASE("the tangent does not jump where the metric's replacement begins") {
  Shells shells = squares();
  const double near = 1e-9;
  for (int l = 0; l < lanes; ++l) fold(shells, l, kCollapse * (l % 2 == 0 ? 1 - near : 1 + near));
  const Eigen::MatrixXd below = shells.tangent(0), above = shells.tangent(1);
  CHECK(largest(below - above) < 1e-6 * largest(above));
}

TEST_CASE("no folded quadrilateral has a force beyond the bound of its size") {
  for (const Isa isa : instruction_sets()) {
    Shells shells = squares(isa);
    const double R = 1.3 * kHalf, bound = force_bound(shells, R);
    double most = 0;
    for (int draw = 0; draw < test::draws(2000); ++draw) {
      for (int l = 0; l < lanes; ++l) {
        const Vec3 m1 = R * shells.vector() / std::sqrt(3.0);
        const double apart = std::pow(10, 5 * (shells.number() - 1));  // 1 to 1e-10
        const Vec3 m2 = 0.8 * shells.number() * m1 + 0.2 * apart * R * shells.vector();
        place(shells, l, shells.number() > 0 ? m1 : Vec3(apart * m1), m2,
              R * shells.vector() / std::sqrt(3.0));
        for (Vec3& d : shells.d[l]) d = shells.vector().normalized();
      }
      shells.basis();
      const Eigen::MatrixXd f = shells.force();
      for (int l = 0; l < lanes; ++l)
        for (int a = 0; a < 4; ++a) most = std::max(most, f.col(l).segment<3>(5 * a).norm());
    }
    INFO("largest force " << most << " N, bound " << bound << " N");
    CHECK(most < bound);
    CHECK(most > bound / 1000);
  }
}
