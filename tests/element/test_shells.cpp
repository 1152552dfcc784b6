#include "catch.hpp"
#include "one_batch.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using test::largest;
using test::Quadrilateral;
using test::RandomBatch;
using test::svk;
using test::Triangle;

namespace {

// The largest error of any lane, of the largest entry of its kind: displacement rows (N) and rotation rows
// (N m) are measured apart.
double relative_error(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want) {
  double worst = 0;
  for (int l = 0; l < got.cols(); ++l)
    for (const int kind : {0, 3}) {
      double error = 0, scale = 0;
      for (int i = 0; i < got.rows(); ++i) {
        if ((i % 5 < 3 ? 0 : 3) != kind) continue;
        error = std::max(error, std::abs(got(i, l) - want(i, l)));
        scale = std::max(scale, std::abs(got(i, l)));
      }
      worst = std::max(worst, error / scale);
    }
  return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("the force is the derivative of the energy of a virgin step", "", Quadrilateral,
                   Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  // Stored plus dissipated, from the state after the step, is a potential of the force as long as every
  // branch is virgin or slack from the start: central differences, second order, down to 1e-7 of the largest
  // force.
  for (const auto& card : {svk(), test::blend()}) {
    RandomBatch<TestType> shells(card, 3);
    shells.deform(0.02);
    const Eigen::MatrixXd f = shells.force();
    for (int dof = 0; dof < dofs; ++dof) {
      Eigen::MatrixXd step = Eigen::MatrixXd::Zero(dofs, lanes);
      step.row(dof).setConstant(1);
      const double h = dof % 5 < 3 ? 1e-8 : 1e-6;
      RandomBatch<TestType> up = shells.moved(h * step), down = shells.moved(-h * step);
      up.force();
      down.force();
      for (int l = 0; l < lanes; ++l) {
        const double want = (up.energy(l) - down.energy(l)) / (2 * h);
        const int kind = dof % 5 < 3 ? 0 : 3;
        double scale = 0;
        for (int a = 0; a < TestType::corners; ++a)
          scale = std::max(scale, f.col(l).segment(5 * a + kind, kind == 0 ? 3 : 2).cwiseAbs().maxCoeff());
        CHECK(std::abs(f(dof, l) - want) <
              2e-6 * scale);  // difference quotient of an energy: cancellation at 1e-16 / h
      }
    }
  }
}

TEMPLATE_TEST_CASE("the tangent is the derivative of the force: error falls with the square of the step", "",
                   Quadrilateral, Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  for (const auto& card : {svk(), test::blend(), test::duck()}) {
    for (const double offset : {0.0, 0.7}) {
      RandomBatch<TestType> shells(card, 3, offset);
      shells.deform(0.02);
      Eigen::MatrixXd direction(dofs, lanes), got(dofs, lanes);
      for (int i = 0; i < direction.size(); ++i)
        direction.data()[i] = shells.number() * (i % 5 < 3 ? 0.01 : 1.0);
      for (int l = 0; l < lanes; ++l) got.col(l) = shells.tangent(l) * direction.col(l);
      const auto difference = [&](double h) -> Eigen::MatrixXd {
        return (shells.moved(h * direction).force() - shells.moved(-h * direction).force()) / (2 * h);
      };
      // Rounding is some 1e-15 / h of the tangent, truncation from 6 h^2 (svk) to 2000 h^2 (duck). A law with
      // kinks is smooth only where no point switches between the two differences: by 1e-5 none does. St.
      // Venant and Kirchhoff's has none, and larger steps keep its truncation far above rounding.
      const double h = card.name == "svk" ? 1e-4 : 1e-5;
      const Eigen::MatrixXd wide = difference(10 * h), near = difference(h), half = difference(h / 2);
      const double errors[] = {relative_error(got, wide), relative_error(got, near)};
      INFO(card.name << " offset " << offset << ": " << errors[0] << " " << errors[1]);
      CHECK(std::log10(errors[0] / errors[1]) > 1.99);
      // Without the part that goes with the square of the step what is left goes with its fourth power, and
      // is rounding.
      CHECK(relative_error(got, (4 * half - near) / 3) < 1e-9);
    }
  }
}

TEMPLATE_TEST_CASE("a rigid motion by any angle makes no strain and no force", "", Quadrilateral, Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  RandomBatch<TestType> shells(test::denim(), 3);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat3 R = Eigen::AngleAxisd(3.1 * shells.number(), shells.vector().normalized()).toRotationMatrix();
    const Vec3 shift = 0.01 * shells.vector();
    shells.rest();
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < TestType::corners; ++a) {
        shells.x[l][a] = R * shells.X[l][a] + shift;
        shells.d[l][a] = R * shells.D[l][a];
      }
    shells.basis();
    for (const double e : shells.strains()) REQUIRE(std::abs(e) < 1e-12);
    // 7 MPa times the section of an edge, 1.12 mm x 10 mm, would be 80 N.
    REQUIRE(largest(shells.force()) < 1e-12 * 80);
  }
}

TEMPLATE_TEST_CASE("exactly six zero-energy modes in the virgin state", "", Quadrilateral, Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  for (const auto& card : {svk(), test::blend(), test::muslin()}) {
    RandomBatch<TestType> shells(card, 3);
    for (int l = 0; l < lanes; ++l) {
      Eigen::MatrixXd K = shells.tangent(l);
      // Rotations in units of 10 mm, so that all entries are N/m.
      for (int a = 0; a < TestType::corners; ++a)
        for (int i = 3; i < 5; ++i) {
          K.row(5 * a + i) /= 0.01;
          K.col(5 * a + i) /= 0.01;
        }
      const Eigen::VectorXd values =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>((K + K.transpose()) / 2).eigenvalues();
      const double largest = values[dofs - 1];
      CHECK(std::abs(values[5]) < 1e-12 * largest);
      CHECK(values[6] > 1e-8 * largest);
    }
  }
}

TEMPLATE_TEST_CASE("every instruction set gives the same answer to rounding", "", Quadrilateral, Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  const auto card = test::blend();
  RandomBatch<TestType> base(card, 3, 0, Isa::baseline);
  base.deform(0.05);
  const Eigen::MatrixXd want = base.force();
  for (const Isa isa : {Isa::avx2, Isa::avx512}) {
    if (isa > best_isa()) continue;
    RandomBatch<TestType> other = base;
    other.kernels = TestType::kernels(isa);
    CHECK(largest(other.force() - want) < 1e-13 * largest(want));
  }
}

TEMPLATE_TEST_CASE("elements whose points share a transform give the force of the general kernel", "",
                   Quadrilateral, Triangle) {
  using element::Sharing;
  auto bending = test::blend();
  bending.bending = card::Bending{10e-6, 20e-6, 5e-6, card::BendingFriction{1e-4, 20}, {}};
  for (const auto& card : {test::blend(), test::duck(), bending})
    for (const bool parallelograms : {true, false})
      for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
        if (isa > best_isa()) continue;
        RandomBatch<TestType> shared(card, 3, 0.4, isa);
        CHECK(TestType::sharing(shared.section, shared.geometry.data()) == Sharing::none);
        shared.flatten(parallelograms);
        const bool element = parallelograms && TestType::corners == 4;
        REQUIRE(shared.sharing == (element ? Sharing::element : Sharing::through));
        // Rounding of strains of order one, times the stiffest modulus and the section of an edge, N.
        CHECK(largest(shared.force()) < 16 * 2.2e-16 * 1.6e9 * 0.01 * card.thickness);
        // Any path, so that yarns load, unload and go slack and shear turns round.
        for (int step = 0; step < 8; ++step) {
          shared.deform(0.05);
          RandomBatch<TestType> general = shared;
          general.sharing = Sharing::none;
          const Eigen::MatrixXd want = general.force();
          CHECK(largest(shared.force() - want) < 1e-12 * largest(want));
          double worst = 0, size = 0;
          for (std::size_t i = 0; i < shared.s1.size(); ++i) {
            worst = std::max(worst, std::abs(shared.s1[i] - general.s1[i]) / (1 + std::abs(general.s1[i])));
            size = std::max(size, std::abs(general.s1[i]));
          }
          CHECK(worst < 1e-12);
          CHECK(size > 0);
          shared.s0 = shared.s1;
        }
      }
}

TEMPLATE_TEST_CASE("separate bending: moment B kappa on a rolled strip, none from the membrane", "",
                   Quadrilateral, Triangle) {
  [[maybe_unused]] constexpr int dofs = TestType::dofs;
  auto card = test::blend();
  card.bending = card::Bending{10e-6, 20e-6, 5e-6, {}, {}};
  RandomBatch<TestType> shells(card, 3);
  CHECK(shells.section.points.size() == 1);
  shells.deform(0.02);
  Eigen::MatrixXd direction(dofs, lanes);
  for (int i = 0; i < direction.size(); ++i) direction.data()[i] = shells.number() * (i % 5 < 3 ? 0.01 : 1.0);
  const double h = 1e-6;
  const Eigen::MatrixXd up = shells.moved(h * direction).force(), down = shells.moved(-h * direction).force();
  for (int l = 0; l < lanes; ++l) {
    const Eigen::VectorXd got = shells.tangent(l) * direction.col(l),
                          want = (up.col(l) - down.col(l)) / (2 * h);
    CHECK(largest(got - want) < 1e-7 * largest(got));
  }
}

TEMPLATE_TEST_CASE("an element turned inside out or crushed past zero length is seen", "", Quadrilateral,
                   Triangle) {
  RandomBatch<TestType> shells(svk(), 3);
  shells.deform(0.05);
  const auto lost = [&] {
    const auto r = shells.arrays();
    return shells.kernels.inverted({shells.geometry.data(), r.x, r.d, nullptr, nullptr, nullptr});
  };
  CHECK(lost() == 0);
  for (Vec3& d : shells.d[2]) d = -d;  // the director on the other side
  CHECK(lost() == 0b100u);
  const auto x = shells.x[5];  // mirrored in its own plane, past a line
  const Vec3 across = (x[1] - x[0]).normalized();
  for (Vec3& p : shells.x[5]) p -= 2.0 * (p - x[0]).dot(across) * across;
  CHECK(lost() == 0b100100u);
}

TEST_CASE("a triangle has no first corner: energy and forces are the same from each of the three") {
  RandomBatch<Triangle> shells(svk(), 3, 0.4);
  shells.deform(0.05);
  const Vec3 along = Vec3(1, 0.3, -0.2).normalized();
  const auto numbered = [&](int first) {
    RandomBatch<Triangle> turned = shells;
    for (int l = 0; l < lanes; ++l) {
      for (int a = 0; a < 3; ++a) {
        const int from = (a + first) % 3;
        turned.X[l][a] = shells.X[l][from];
        turned.D[l][a] = shells.D[l][from];
        turned.x[l][a] = shells.x[l][from];
        turned.d[l][a] = shells.d[l][from];
        turned.b1[l][a] = shells.b1[l][from];
      }
      element::shell3_geometry(
          turned.section, turned.X[l], turned.D[l], [&](const Vec3&, const Vec3&) { return along; },
          turned.geometry.data(), l, lanes);
    }
    return turned;
  };
  auto one = numbered(0);
  const Eigen::MatrixXd want = one.force();
  for (const int first : {1, 2}) {
    auto other = numbered(first);
    const Eigen::MatrixXd got = other.force();
    for (int l = 0; l < lanes; ++l) {
      CHECK(std::abs(other.energy(l) / one.energy(l) - 1) < 1e-12);
      for (int a = 0; a < 3; ++a)
        CHECK(largest(got.col(l).segment(5 * a, 5) - want.col(l).segment(5 * ((a + first) % 3), 5)) <
              1e-12 * largest(want.col(l)));
    }
  }
}
