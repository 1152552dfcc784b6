// Fields of elements at nodes: what is linear is exact, on distorted meshes of both kinds of elements, on
// each side of where cards meet; and nothing of the other side comes in.
#include <cmath>
#include <random>

#include "catch.hpp"
#include "message_of.hpp"
#include "run/problems.hpp"
#include "run/recovery.hpp"
#include "run/static.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

// m: a sheet of 7 x 5 cells whose inner nodes are moved at random, but for those on the line x = 3; cells on
// the right are cut into triangles.
std::shared_ptr<mesh::Mesh> shaken(double noise) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(7, 5, 7, 5));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-noise, noise);
  mesh->map([&](const Vec3& X) {
    const bool border = X.x() < 0.1 || X.x() > 6.9 || X.y() < 0.1 || X.y() > 4.9;
    const double a = number(random), b = number(random);
    if (border) return X;
    return Vec3(std::abs(X.x() - 3) < 0.1 ? X.x() : X.x() + a, X.y() + b, 0);
  });
  const auto whole = mesh->elements;
  mesh->elements.clear();
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const auto [a, b, c, d] = whole[i];
    if (i % 7 < 4) {
      mesh->elements.push_back(whole[i]);
    } else {
      mesh->elements.push_back({a, b, c, -1});
      mesh->elements.push_back({a, c, d, -1});
    }
  }
  mesh->define("right", [](const Vec3& X) { return X.x() > 2.99; });
  return mesh;
}

// Of two regions, left and right of x = 3.
std::shared_ptr<run::Static> halves(std::shared_ptr<mesh::Mesh> mesh) {
  model::Options along;
  along.warp = [](const Vec3&) { return model::Direction(0.0); };
  model::BodyGiven body{"", std::move(mesh), blend(), along, {}};
  body.regions.push_back({"right", duck(), along});
  auto m = std::make_shared<model::Model>(std::vector<model::BodyGiven>{body});
  m->fix("all", model::parse_freedoms("x y z rotation"));
  return std::make_shared<run::Static>(m, run::StaticOptions{.duration = 1, .step = 1}, quiet());
}

Vec3 centre_of_area(const mesh::Mesh& mesh, const std::array<mesh::Index, 4>& e) {
  const auto X = [&](int a) { return mesh.nodes[static_cast<std::size_t>(e[a])]; };
  const auto part = [&](int a, int b, int c) {
    return std::pair((X(b) - X(a)).cross(X(c) - X(a)).z() / 2, Vec3((X(a) + X(b) + X(c)) / 3));
  };
  const auto [first, at] = part(0, 1, 2);
  if (e[3] < 0) return at;
  const auto [second, other] = part(0, 2, 3);
  return (first * at + second * other) / (first + second);
}

double left(const Vec3& X) { return 3 + 0.7 * X.x() - 1.1 * X.y(); }
double right(const Vec3& X) { return -40 + 5 * X.x() + 2 * X.y(); }

}  // namespace

TEST_CASE("a linear field is recovered exactly at all nodes, inside and on borders, apart in each region") {
  for (const double noise : {0.0, 0.2}) {
    const auto mesh = shaken(noise);
    const auto a = halves(mesh);
    std::vector<double> values;
    const int on_left = a->model().region_of(0);
    for (std::size_t e = 0; e < mesh->elements.size(); ++e) {
      const Vec3 at = centre_of_area(*mesh, mesh->elements[e]);
      const bool on_right = a->model().region_of(static_cast<mesh::Index>(e)) != on_left;
      INFO("element " << e << " at " << at.transpose());
      REQUIRE(on_right == (at.x() > 3));
      values.push_back(on_right ? right(at) : left(at));
      values.push_back(7);
    }
    const run::Recovery recovery(*a);
    const auto of_right = recovery.at_nodes(values, 2, 1 - on_left),
               of_left = recovery.at_nodes(values, 2, on_left), of_both = recovery.at_nodes(values, 2);
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      const Vec3& X = mesh->nodes[n];
      INFO("noise " << noise << ", node at " << X.transpose());
      if (X.x() > 2.99) CHECK(std::abs(of_right[2 * n] - right(X)) < 1e-10);
      if (X.x() < 3.01) CHECK(std::abs(of_left[2 * n] - left(X)) < 1e-10);
      CHECK(std::isnan(of_right[2 * n]) == (X.x() < 2.99));
      CHECK(std::isnan(of_left[2 * n]) == (X.x() > 3.01));
      CHECK(std::abs(of_both[2 * n + 1] - 7) < 1e-10);
      if (X.x() > 3.01) CHECK(std::abs(of_both[2 * n] - right(X)) < 1e-10);
      if (std::abs(X.x() - 3) < 0.01) {
        CHECK(of_both[2 * n] > std::min(left(X), right(X)));
        CHECK(of_both[2 * n] < std::max(left(X), right(X)));
      }
    }
  }
}

TEST_CASE("strips that are one element wide, and single elements, have means at their nodes") {
  for (const int cells : {1, 4}) {
    const auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(cells, 1, cells, 1));
    model::Options along;
    along.warp = [](const Vec3&) { return model::Direction(0.0); };
    auto m = std::make_shared<model::Model>(mesh, blend(), along);
    m->fix("all", model::parse_freedoms("x y z rotation"));
    const run::Static a(m, {.duration = 1, .step = 1}, quiet());
    std::vector<double> values;
    for (int e = 0; e < cells; ++e) values.push_back(10 + e);
    const auto at = run::Recovery(a).at_nodes(values, 1);
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      const double x = mesh->nodes[n].x(), want = std::clamp(9.5 + x, 10.0, 9.0 + cells);
      CHECK(std::abs(at[n] - want) < 1e-12);
    }
  }
}

TEST_CASE("fields that are none of elements, and regions that are not there, are refused") {
  const auto a = halves(shaken(0));
  says(message_of([&] { run::recovered(*a, run::find_field(*a, "uz")); }), "has its values at the nodes");
  says(message_of([&] { run::recovered(*a, run::find_field(*a, "region")); }),
       "jumps from element to element");
  says(message_of([&] { run::recovered(*a, run::find_field(*a, "S11"), 2); }),
       "expected a region from 1 to 2, got 3");
}
