// The guard of the directors: its forces and tangent are derivatives of its energy, it is zero in ordinary
// deformation, and a director that is turned over is told from an element that is.
#include <algorithm>
#include <random>

#include "catch.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/directors.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using mechanics::Index;

namespace {

// Bending along the warp is ten times as stiff as across it, so that directors would splay soon.
card::Card easily_splayed() {
  auto card = test::svk();
  card.bending = card::Bending{15e-6, 1.5e-6, 5e-6, {}, {}};
  return card;
}

std::shared_ptr<model::Model> make_sheet(bool triangles,
                                         const std::function<void(model::Model&)>& hold = {}) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.03, 4, 3));
  mesh->map([](const Vec3& X) {
    return Vec3(X.x() + 0.1 * X.y(), X.y() - 2 * X.x() * X.y(), 0.003 * std::sin(120 * X.x() + 50 * X.y()));
  });
  if (triangles) {
    const auto whole = mesh->elements;
    mesh->elements.clear();
    for (const auto& [a, b, c, d] : whole) {
      mesh->elements.push_back({a, b, c, -1});
      mesh->elements.push_back({a, c, d, -1});
    }
  }
  model::Options options;
  options.warp = [](const Vec3&) { return model::Direction(12.0); };
  auto m = std::make_shared<model::Model>(mesh, easily_splayed(), options);
  if (hold) hold(*m);
  return m;
}

// Gathers a tangent by nodes, five rows and columns each.
struct Gathered final : mechanics::TangentSink {
  explicit Gathered(std::size_t nodes) : K(Eigen::MatrixXd::Zero(5 * nodes, 5 * nodes)) {}
  void on_positions(Index a, Index b, const Mat3& k) override { K.block<3, 3>(5 * a, 5 * b) += k; }
  void on_director(Index a, const Eigen::Matrix2d& k) override { K.block<2, 2>(5 * a + 3, 5 * a + 3) += k; }
  void on_nodes(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k) override {
    K.block<5, 5>(5 * a, 5 * b) += k;
  }
  void on_lead(Index, const Vec3&) override {}
  Eigen::MatrixXd K;
};

// A sheet, and the guard alone of all its terms.
struct Guarded {
  explicit Guarded(std::shared_ptr<model::Model> m) : model(std::move(m)), assembly(*model) {
    for (const auto& term : assembly.terms())
      if (std::string(term->name()) == "directors") guard = term.get();
    REQUIRE(guard != nullptr);
  }
  mechanics::Trial trial() { return {std::as_const(assembly).state(), assembly.dofs().reference()}; }
  std::size_t nodes() const { return assembly.dofs().reference().size(); }
  double energy() {
    std::vector<mechanics::Energy> all;
    guard->add_energies(trial(), all);
    REQUIRE(all.size() == 1);
    CHECK(all[0].name == "directors");
    CHECK(all[0].account == mechanics::Account::stored);
    return all[0].value;
  }
  // Forces on positions and rotations, five per node.
  Eigen::VectorXd forces() {
    std::vector<double> x(3 * nodes()), d(3 * nodes());
    mechanics::Forces sums{x, d};
    REQUIRE(guard->add_forces({}, trial(), sums).ok());
    const mechanics::Configuration& now = assembly.state();
    Eigen::VectorXd f(5 * nodes());
    for (Index n = 0; n < static_cast<Index>(nodes()); ++n) {
      f.segment<3>(5 * n) = at(x, n);
      f[5 * n + 3] = at(d, n).dot(at(now.b1(), n));
      f[5 * n + 4] = at(d, n).dot(at(now.d(), n).cross(at(now.b1(), n)));
    }
    return f;
  }
  void move(const Eigen::VectorXd& by, double scale) {
    assembly.rollback();
    assembly.begin_iterate();
    std::vector<double> delta(static_cast<std::size_t>(assembly.dofs().unknowns()));
    for (std::size_t n = 0; n < nodes(); ++n)
      for (int i = 0; i < 5; ++i)
        if (const auto eq = assembly.dofs().freedoms().nodes[n].equation[i]; eq >= 0)
          delta[eq] = by[5 * n + i];
    assembly.apply_increment(delta, scale, assembly.dofs().targets(0));
  }
  // Numbers at random for all unknowns, zero where there are none.
  Eigen::VectorXd random(double positions, double rotations, int seed) const {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    Eigen::VectorXd v(5 * nodes());
    for (Index i = 0; i < v.size(); ++i) {
      v[i] = number(engine) * (i % 5 < 3 ? positions : rotations);
      if (assembly.dofs().freedoms().nodes[i / 5].equation[i % 5] < 0) v[i] = 0;
    }
    return v;
  }
  std::shared_ptr<model::Model> model;
  mechanics::Assembly assembly;
  mechanics::Term* guard = nullptr;
};

// In a plane of symmetry the frame is the global one, so that nodes' blocks need no turn.
void symmetric_left(model::Model& m) { m.fix("left", model::parse_freedoms("x ry rz")); }

}  // namespace

TEST_CASE("guard of the directors: forces and tangent are the derivatives of its energy") {
  for (const bool triangles : {false, true})
    for (const bool symmetric : {false, true}) {
      Guarded sheet(make_sheet(triangles, symmetric ? symmetric_left : nullptr));
      sheet.move(sheet.random(1e-3, 1.2, 5), 1);
      sheet.assembly.commit(0);
      const Eigen::VectorXd way = sheet.random(0.004, 1, 6);
      INFO((triangles ? "triangles" : "quadrilaterals") << (symmetric ? ", symmetric" : ""));
      CHECK(sheet.energy() > 0);
      const Eigen::VectorXd f = sheet.forces();
      Gathered tangent(sheet.nodes());
      sheet.guard->add_tangent(sheet.trial(), tangent);
      CHECK((tangent.K - tangent.K.transpose()).norm() < 1e-13 * tangent.K.norm());
      const Eigen::VectorXd K = tangent.K * way;
      std::vector<double> errors_f, errors_K;
      for (const double h : {1e-3, 1e-4}) {
        sheet.move(way, h);
        const double up = sheet.energy();
        const Eigen::VectorXd fu = sheet.forces();
        sheet.move(way, -h);
        const double down = sheet.energy();
        const Eigen::VectorXd fd = sheet.forces();
        errors_f.push_back(std::abs((up - down) / (2 * h) - f.dot(way)) / std::abs(f.dot(way)));
        Eigen::VectorXd D = (fu - fd) / (2 * h);
        for (Index i = 0; i < D.size(); ++i)
          if (sheet.assembly.dofs().freedoms().nodes[i / 5].equation[i % 5] < 0) D[i] = K[i];
        errors_K.push_back((D - K).norm() / K.norm());
      }
      CHECK(std::log10(errors_f[0] / errors_f[1]) > 1.9);
      CHECK(std::log10(errors_K[0] / errors_K[1]) > 1.9);
      CHECK(errors_f[1] < 1e-6);
      CHECK(errors_K[1] < 1e-5);
    }
}

// A motion of the half model and its mirror image. Nodes on the plane of symmetry are in elements whose
// normals leave the plane, to opposite sides.
TEST_CASE("guard of the directors: a half model has half of the energy of the whole") {
  const auto flat = [](int nx, double shift) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.01 * nx, 0.03, nx, 3));
    mesh->map([shift](const Vec3& X) { return Vec3(X.x() + shift, X.y(), 0); });
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(0.0); };
    return std::make_shared<model::Model>(mesh, easily_splayed(), options);
  };
  auto half_model = flat(4, 0);
  symmetric_left(*half_model);
  Guarded half(half_model), whole(flat(8, -0.04));
  double energy = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const Eigen::VectorXd by = half.random(4e-3, 1.2, seed);
    Eigen::VectorXd mirrored = Eigen::VectorXd::Zero(5 * static_cast<Index>(whole.nodes()));
    half.assembly.rollback();
    whole.assembly.rollback();
    const auto &from = half.assembly.state(), &to = whole.assembly.state();
    for (Index n = 0; n < static_cast<Index>(half.nodes()); ++n)
      for (Index m = 0; m < static_cast<Index>(whole.nodes()); ++m) {
        const Vec3 &X = half_model->mesh().nodes[n], &Y = whole.model->mesh().nodes[m];
        const double side = Y.x() < -1e-9 ? -1 : 1;
        if ((Vec3(side * Y.x(), Y.y(), 0) - X).norm() > 1e-9) continue;
        const Vec3 mirror(side, 1, 1), d = at(from.d(), n), b = at(from.b1(), n);
        const Vec3 turn = mirror.cwiseProduct(by[5 * n + 3] * b + by[5 * n + 4] * d.cross(b));
        mirrored.segment<3>(5 * m) = mirror.cwiseProduct(by.segment<3>(5 * n));
        mirrored[5 * m + 3] = turn.dot(at(to.b1(), m));
        mirrored[5 * m + 4] = turn.dot(at(to.d(), m).cross(at(to.b1(), m)));
      }
    half.move(by, 1);
    whole.move(mirrored, 1);
    CHECK(whole.energy() == Approx(2 * half.energy()).epsilon(1e-12));
    energy += half.energy();
  }
  CHECK(energy > 0);
}

TEST_CASE("guard of the directors: nothing at all below its limits, whatever else the sheet does") {
  for (const bool triangles : {false, true}) {
    Guarded sheet(make_sheet(triangles));
    // Directors turned by less than 45 degrees together, which all shear sees, in a stretched and turned
    // sheet.
    Eigen::VectorXd v = sheet.random(5e-4, 0.02, 3);
    for (std::size_t n = 0; n < sheet.nodes(); ++n) v[5 * n + 3] += 0.5;
    sheet.move(v, 1);
    CHECK(sheet.energy() == 0);
    CHECK(sheet.forces() == Eigen::VectorXd::Zero(v.size()));
    std::vector<mechanics::NodePair> pairs;
    sheet.guard->couple(sheet.trial(), pairs);
    CHECK(pairs.empty());
    // Beyond it the guard pushes back.
    for (std::size_t n = 0; n < sheet.nodes(); ++n) v[5 * n + 3] += 0.6;
    sheet.move(v, 1);
    CHECK(sheet.energy() > 0);
    CHECK(sheet.forces().dot(v) > 0);
  }
}

TEST_CASE("guard of the directors: a fold that closes has no guard, and no force as it closes") {
  // Two elements that share an edge fold onto each other. The directors of the edge stay in the middle.
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.02, 0.01, 2, 1));
  auto m = std::make_shared<model::Model>(mesh, test::svk(), model::Options{});
  Guarded sheet(m);
  const auto fold = [&](double angle) {  // of each half from the plane
    sheet.assembly.rollback();
    auto x = sheet.assembly.state().x();
    auto d = sheet.assembly.state().d();
    for (Index n = 0; n < 6; ++n) {
      const double X = mesh->nodes[n].x() - 0.01, side = X < 0 ? -1 : 1;
      at(x, n) = Vec3(X * std::cos(angle), mesh->nodes[n].y(), -std::abs(X) * std::sin(angle));
      at(d, n) = X == 0 ? Vec3(0, 0, 1) : Vec3(side * std::sin(angle), 0, std::cos(angle));
    }
    sheet.assembly.state().touch();
    return sheet.energy();
  };
  for (const double angle : {0.0, 0.7, 1.2, 1.5, 1.57, 1.5707}) CHECK(fold(angle) == 0);
  // With a director on the wrong side the energy goes to zero with the cube of the normal that is left.
  const auto wrong = [&](double left) {
    fold(std::acos(left));
    auto d = sheet.assembly.state().d();
    for (const Index n : {Index{1}, Index{4}}) at(d, n) = Vec3(0, 0, -1);
    sheet.assembly.state().touch();
    return sheet.energy();
  };
  CHECK(std::log10(wrong(1e-2) / wrong(1e-3)) > 2.99);
  CHECK(wrong(1e-3) > 0);
}

TEST_CASE(
    "guard of the directors: a joint that opens in a fold makes no energy, and is guarded from there on") {
  constexpr double kFold = 1.2;  // of each half from the plane
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.02, 0.01, 2, 1));
  auto m = std::make_shared<model::Model>(mesh, test::svk(), model::Options{});
  m->add<model::Zone>({"all"});
  m->validate();
  m->divide_zones();
  Guarded sheet(m);
  const auto& first = m->mesh().elements[0];
  const auto& X = sheet.assembly.dofs().reference();
  // Directors of the fold stand in the middle, each turned about the fold towards its sheet.
  const auto fold = [&](double towards) {
    sheet.assembly.rollback();
    for (Index n = 0; n < static_cast<Index>(X.size()); ++n) {
      const bool left = std::find(first.begin(), first.end(), n) != first.end();
      const double s = X[n].x() - 0.01, side = s < 0 || (s == 0 && left) ? -1 : 1;
      at(sheet.assembly.state().x(), n) = Vec3(s * std::cos(kFold), X[n].y(), -std::abs(s) * std::sin(kFold));
      const double turned = s == 0 ? towards : kFold;
      at(sheet.assembly.state().d(), n) = Vec3(side * std::sin(turned), 0, std::cos(turned));
      at(sheet.assembly.state().b1(), n) = Vec3(0, 1, 0);
    }
    sheet.assembly.state().touch();
  };
  const auto stored = [&] {
    std::vector<mechanics::Energy> all;
    sheet.guard->add_energies(sheet.trial(), all);
    REQUIRE(all.size() == 2);
    CHECK(all[1].account == mechanics::Account::dissipated);
    CHECK(all[1].value == 0);  // the whole joint had nothing to lose
    return all[0].value;
  };
  fold(0);
  sheet.assembly.commit(0);
  CHECK(stored() == 0);
  REQUIRE(sheet.assembly.open({{1, 4}, {4, 1}}, 0).has_value());
  CHECK(stored() == 0);
  // Leaning on costs at once, and force and energy agree.
  fold(-0.2);
  CHECK(stored() > 0);
  const Eigen::VectorXd f = sheet.forces();
  const double step = 1e-6, low = (fold(-0.2 - step), stored()), high = (fold(-0.2 + step), stored());
  double turning = 0;
  fold(-0.2);
  for (std::size_t n = 0; n < sheet.nodes(); ++n)
    if (X[n].x() == 0.01) turning += std::hypot(f[5 * n + 3], f[5 * n + 4]);
  CHECK(turning == Approx((low - high) / (2 * step)).epsilon(1e-6));
  // A director that has come upright is guarded as any other.
  fold(kFold);
  sheet.assembly.commit(0);
  CHECK(stored() == 0);
  fold(0);
  CHECK(stored() > 0);
}

namespace {

mechanics::Directors::Overturned overturned(const mechanics::Assembly& a) {
  return a.terms().find<mechanics::Directors>()->overturned(a.state());
}

}  // namespace

TEST_CASE("a director that is turned over is told from an element that is turned inside out") {
  for (const bool triangles : {false, true}) {
    Guarded sheet(make_sheet(triangles));
    CHECK(overturned(sheet.assembly).inverted == -1);
    CHECK(overturned(sheet.assembly).turned == -1);
    auto d = sheet.assembly.state().d();
    at(d, 7) = -at(d, 7);
    sheet.assembly.state().touch();
    CHECK(overturned(sheet.assembly).turned == 7);
    CHECK(overturned(sheet.assembly).inverted == -1);
    // One of four directors turns the interpolated one at a point; one of three not their mean.
    CHECK((sheet.assembly.cloth().readings().inverted_element({}) >= 0) != triangles);
    // A node goes past its neighbours: its elements are inside out, and its director has no side.
    sheet.assembly.rollback();
    at(sheet.assembly.state().x(), 7).x() -= 0.025;
    sheet.assembly.state().touch();
    CHECK(overturned(sheet.assembly).turned == -1);
    REQUIRE(overturned(sheet.assembly).inverted >= 0);
    const auto& nodes = sheet.model->mesh().elements[overturned(sheet.assembly).inverted];
    CHECK(std::find(nodes.begin(), nodes.end(), 7) != nodes.end());
  }
}
