// Patch tests on a distorted mesh, flat and turned in space: the tangent at rest times a displacement of
// constant membrane strain, constant curvature or constant transverse shear leaves no force on the nodes
// inside and gives the exact energy.
#include <random>

#include "catch.hpp"
#include "strip.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

constexpr double kYoung = 2e6, kNu = 0.3, kThickness = 0.2, kG = 5.0 / 6 * kYoung / (2 * (1 + kNu));

card::Card plate() {
  card::Card c;
  c.name = "plate";
  c.density = 1000;
  c.thickness = kThickness;
  card::Svk law;
  law.warp = law.weft = kYoung;
  law.nu12 = law.nu21 = kNu;
  law.shear = kYoung / (2 * (1 + kNu));
  c.law = law;
  return c;
}

// 4 x 4 elements of a unit square, inner nodes moved by up to 0.35 of an element.
mesh::Mesh distorted() {
  mesh::Mesh mesh = mesh::rectangle(1, 1, 4, 4);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.35 / 4, 0.35 / 4);
  for (auto& X : mesh.nodes) {
    if (X.x() < 1e-9 || X.x() > 1 - 1e-9 || X.y() < 1e-9 || X.y() > 1 - 1e-9) continue;
    X += Vec3(shift(random), shift(random), 0);
  }
  return mesh;
}

// A small displacement and change of the director at a point of the flat plate.
using Field = std::function<std::pair<Vec3, Vec3>(const Vec3& X)>;

struct Patch {
  double
      inside;  // largest force or moment on the nodes inside, over the largest anywhere (lengths are near 1)
  double energy;  // J, u K u / 2
};

Patch run(const Field& field, const Mat3& turn, bool moments, const mesh::Mesh& patch_of, int points) {
  auto mesh = std::make_shared<mesh::Mesh>(patch_of);
  const auto flat = mesh->nodes;
  mesh->map([&](const Vec3& X) { return Vec3(turn * X); });
  model::Options options;
  options.points = points;
  options.warp = [&](const Vec3&) { return model::Direction(Vec3(turn * Vec3::UnitX())); };
  model::Model m(mesh, plate(), options);
  mechanics::Assembly a(m);
  linear::Matrix K;
  REQUIRE(a.forces({}));
  REQUIRE(a.tangent({}, K, {}, {}));
  const Vec3 normal = turn * Vec3::UnitZ();
  std::vector<double> u(a.dofs().unknowns(), 0.0), r(a.dofs().unknowns(), 0.0);
  const auto& state = std::as_const(a).state();
  for (std::size_t n = 0; n < flat.size(); ++n) {
    const auto& equation = a.dofs().freedoms().nodes[n].equation;
    const auto [move, tilt] = field(flat[n]);
    const Vec3 U = turn * move, D = turn * tilt;
    const auto& kinematics = state.committed_kinematics();
    const Vec3 b1 = Eigen::Map<const Vec3>(kinematics.data() + 6 * flat.size() + 3 * n);
    const Vec3 b2 = normal.cross(b1);
    for (int i = 0; i < 3; ++i) u[equation[i]] = U[i];
    u[equation[3]] = D.dot(b1);
    u[equation[4]] = D.dot(b2);
  }
  for (linear::Index j = 0; j < K.size(); ++j)
    for (auto k = K.pattern->column[j]; k < K.pattern->column[j + 1]; ++k)
      r[K.pattern->row[k]] += K.value[k] * u[j];
  Patch patch{0, 0};
  double largest = 0;
  for (std::size_t n = 0; n < flat.size(); ++n) {
    const auto& X = flat[n];
    const bool inner = X.x() > 1e-9 && X.x() < 1 - 1e-9 && X.y() > 1e-9 && X.y() < 1 - 1e-9;
    for (int i = 0; i < 5; ++i) {
      const auto e = a.dofs().freedoms().nodes[n].equation[i];
      patch.energy += u[e] * r[e] / 2;
      largest = std::max(largest, std::abs(r[e]));
      if (inner && (i < 3 || moments)) patch.inside = std::max(patch.inside, std::abs(r[e]));
    }
  }
  patch.inside /= largest;
  return patch;
}

void check(const Field& field, double energy, bool moments = true, const mesh::Mesh& mesh = distorted(),
           int points = 3) {
  for (const Mat3& turn :
       {Mat3(Mat3::Identity()), Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.7).normalized()).toRotationMatrix()}) {
    const Patch p = run(field, turn, moments, mesh, points);
    INFO("force inside " << p.inside << ", energy " << p.energy << " wanted " << energy);
    CHECK(p.inside < 1e-12);
    CHECK(std::abs(p.energy / energy - 1) < 1e-12);
  }
}

// Energy per area of plane stress with strains (11, 22, 2 12), times a thickness factor.
double plane(double e1, double e2, double g) {
  return kYoung / (1 - kNu * kNu) * (e1 * e1 + e2 * e2 + 2 * kNu * e1 * e2) / 2 +
         kYoung / (4 * (1 + kNu)) * g * g;
}

}  // namespace

TEST_CASE("patch: constant membrane strain on a distorted mesh") {
  for (const auto& [e1, e2, g] :
       {std::array{1e-3, 0.0, 0.0}, {0.0, 1e-3, 0.0}, {0.0, 0.0, 1e-3}, {4e-4, -3e-4, 7e-4}})
    check(
        [e1 = e1, e2 = e2, g = g](const Vec3& X) {
          return std::pair(Vec3(e1 * X.x() + g / 2 * X.y(), e2 * X.y() + g / 2 * X.x(), 0), Vec3(0, 0, 0));
        },
        kThickness * plane(e1, e2, g));
}

TEST_CASE("patch: constant curvature on a distorted mesh") {
  const double bending = kThickness * kThickness * kThickness / 12;
  for (const auto& [k1, k2, k12] :
       {std::array{1e-3, 0.0, 0.0}, {0.0, 1e-3, 0.0}, {0.0, 0.0, 1e-3}, {4e-4, -3e-4, 7e-4}})
    check(
        [k1 = k1, k2 = k2, k12 = k12](const Vec3& X) {
          const double x = X.x(), y = X.y();
          // The director keeps normal to the surface: its tilt is minus the slope.
          return std::pair(Vec3(0, 0, -k1 * x * x / 2 - k2 * y * y / 2 - k12 * x * y / 2),
                           Vec3(k1 * x + k12 / 2 * y, k2 * y + k12 / 2 * x, 0));
        },
        bending * plane(k1, k2, k12));
}

// A constant shear force needs couples all over the plate, so that only forces vanish inside. A sheet with
// one point through the thickness does not bend, and its shear is that of the section.
TEST_CASE("patch: constant transverse shear on a distorted mesh") {
  for (const auto& [g1, g2] : {std::array{1e-3, 0.0}, {0.0, 1e-3}, {4e-4, -3e-4}})
    check([g1 = g1, g2 = g2](const Vec3&) { return std::pair(Vec3(0, 0, 0), Vec3(g1, g2, 0)); },
          kThickness * kG * (g1 * g1 + g2 * g2) / 2, false, distorted(), 1);
}

// In series with the shear of one that bends is an eighth of h^2 / (12 B).
TEST_CASE("patch: constant transverse shear of squares that bend") {
  const double B = kYoung * kThickness * kThickness * kThickness / (12 * (1 - kNu * kNu)),
               S = kThickness * kG;
  for (const int n : {4, 8, 16})
    for (const auto& [g1, g2] : {std::array{1e-3, 0.0}, {0.0, 1e-3}, {4e-4, -3e-4}})
      check([g1 = g1, g2 = g2](const Vec3&) { return std::pair(Vec3(0, 0, 0), Vec3(g1, g2, 0)); },
            (g1 * g1 + g2 * g2) / 2 / (1 / S + 1.0 / (8 * n * n) / (12 * B)), false,
            mesh::rectangle(1, 1, n, n));
}
