#include <omp.h>

#include <random>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/cloth.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using test::svk;

namespace {

model::Components along_x(double value) {
  model::Components c;
  c[0] = history::History::constant(value);
  return c;
}

model::FixedFreedoms tied(const char* words) { return model::parse_freedoms(words, "tie"); }

// Every other element (or each, with 1) becomes two triangles.
void cut_some(mesh::Mesh& mesh, std::size_t every) {
  const auto whole = mesh.elements;
  mesh.elements.clear();
  for (std::size_t e = 0; e < whole.size(); ++e) {
    const auto& [a, b, c, d] = whole[e];
    if (e % every != 0) {
      mesh.elements.push_back(whole[e]);
      continue;
    }
    mesh.elements.push_back({a, b, c, -1});
    mesh.elements.push_back({a, c, d, -1});
  }
}

// A warped sheet with every kind of load and support that has a stiffness or a frame.
std::shared_ptr<model::Model> loaded_sheet(const std::function<void(model::Model&)>& load, double offset = 0,
                                           double height = 0.004, bool triangles = false) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.03, 0.03, 3, 3));
  mesh->map([=](const Vec3& X) {
    return Vec3(X.x(), X.y(), height * std::sin(150 * X.x()) * std::cos(90 * X.y()));
  });
  if (triangles) cut_some(*mesh, 2);
  model::Options options;
  options.offset = offset;
  options.warp = [](const Vec3&) { return model::Direction(20.0); };
  auto m = std::make_shared<model::Model>(mesh, svk(), options);
  load(*m);
  return m;
}

// Residual of the unknowns at a step from the sheet's reference.
std::vector<double> residual_at(mechanics::Assembly& a, const std::vector<double>& step, double scale) {
  a.rollback();
  a.begin_iterate();
  a.apply_increment(step, scale, a.dofs().targets(0));
  REQUIRE(a.forces({}));
  std::vector<double> external, r(a.dofs().unknowns());
  a.terms().external(0, external);
  a.residual(external, r);
  return r;
}

// Compares K with differences of the residual about a displaced configuration. Returns the errors for three
// step sizes.
std::vector<double> tangent_errors(mechanics::Assembly& a) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto n = static_cast<std::size_t>(a.dofs().unknowns());
  std::vector<bool> turns(n, false);
  for (const auto& node : a.dofs().freedoms().nodes)
    for (int i = 3; i < 5; ++i)
      if (node.equation[i] >= 0) turns[node.equation[i]] = true;
  for (const auto& body : a.dofs().freedoms().bodies)
    for (int i = 3; i < 6; ++i) turns[body.equation + i] = true;
  std::vector<double> start(n), direction(n);
  for (std::size_t i = 0; i < n; ++i) {
    start[i] = number(random) * (turns[i] ? 0.05 : 2e-4);
    direction[i] = number(random) * (turns[i] ? 1 : 0.01);
  }
  a.apply_increment(start, 1, a.dofs().targets(0));
  a.commit(0);
  a.begin_iterate();
  linear::Matrix K;
  REQUIRE(a.tangent({}, K, {}, {}));
  std::vector<double> product(n, 0), external, r(n);
  for (std::size_t c = 0; c < n; ++c)
    for (auto k = K.pattern->column[c]; k < K.pattern->column[c + 1]; ++k)
      product[K.pattern->row[k]] += K.value[k] * direction[c];
  a.terms().external(0, external);
  a.residual(external, r);
  // A body's tangent is that of the exponential map: its moment residual r turns under the spin's, by half.
  for (const auto& body : a.dofs().freedoms().bodies) {
    const auto first = static_cast<std::size_t>(body.equation) + 3;
    const Eigen::Map<const Vec3> spin(direction.data() + first), moment(r.data() + first);
    Eigen::Map<Vec3>(product.data() + first) -= spin.cross(moment) / 2;
  }
  std::vector<double> errors;
  for (const double h : {1e-4, 1e-5}) {
    const auto up = residual_at(a, direction, h), down = residual_at(a, direction, -h);
    double worst[2] = {0, 0}, scale[2] = {0, 0};
    for (std::size_t i = 0; i < n; ++i) {
      const double want = -(up[i] - down[i]) / (2 * h);
      worst[turns[i]] = std::max(worst[turns[i]], std::abs(product[i] - want));
      scale[turns[i]] = std::max(scale[turns[i]], std::abs(product[i]));
    }
    errors.push_back(std::max(worst[0] / scale[0], worst[1] / scale[1]));
  }
  return errors;
}

}  // namespace

TEST_CASE(
    "the tangent of a woven law is the derivative of the residual, flat and warped, with several points") {
  for (const double height : {0.0, 0.004})
    for (const int points : {2, 3, 5})
      for (const bool bends_apart : {false, true}) {
        auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.05, 0.04, 5, 4));
        mesh->map([=](const Vec3& X) {
          return Vec3(X.x(), X.y(), height * std::sin(150 * X.x()) * std::cos(90 * X.y()));
        });
        auto card = test::blend();
        if (bends_apart) card.bending = card::Bending{15e-6, 12e-6, 5e-6, {}, {}};
        model::Options options;
        options.warp = [](const Vec3&) { return model::Direction(30.0); };
        if (!bends_apart) options.points = points;
        const model::Model m(mesh, card, options);
        mechanics::Assembly a(m);
        const auto errors = tangent_errors(a);
        INFO("height " << height << ", " << points << " points, errors " << errors[0] << " " << errors[1]);
        // In these directions no point passes a switch of the law within the smaller step.
        // The rest of the error falls with the square of the step.
        CHECK(errors[1] < std::max(1e-8, errors[0] / 100));
      }
}

TEST_CASE("the assembled tangent is the derivative of the residual, with every kind of load") {
  const Mat3 frame = model::frame_from(Vec3(1, 0.5, 0.2), Vec3(0, 1, -0.3));
  const std::pair<const char*, std::function<void(model::Model&)>> loads[] = {
      {"none", [](model::Model&) {}},
      {"pressure", [](model::Model& m) { m.pressure("all", history::History::constant(2e5)); }},
      {"little pressure", [](model::Model& m) { m.pressure("all", history::History::constant(40)); }},
      {"moment",
       [](model::Model& m) {
         m.add<model::MomentLoad>({"right", along_x(0.3), model::frame_from(Vec3(1, 2, 3), Vec3(0, 1, 0))});
       }},
      {"spring",
       [&](model::Model& m) {
         m.add<model::GroundSpring>({"top", {1e5, 2e5, 3e5}, frame});
       }},
      {"oblique support", [&](model::Model& m) { m.fix("left", model::parse_freedoms("x z ry"), frame); }},
      {"symmetry", [](model::Model& m) { m.add(model::symmetry("left", 0)); }},
      {"equal",
       [](model::Model& m) {
         m.add<model::Tie>({model::TieKind::equal, "top", {}, tied("x z")});
       }},
      {"rigid",
       [&](model::Model& m) {
         m.add<model::Tie>({model::TieKind::rigid, "top", {}, {}});
         m.gravity(model::steady({1e4, 2e5, -3e5}));
         m.force("top", along_x(30), frame);
         m.pressure("all", history::History::constant(2e5));
         m.add<model::MomentLoad>({"top", along_x(0.3), model::frame_from(Vec3(1, 2, 3), Vec3(0, 1, 0))});
       }},
      {"driven", [&](model::Model& m) { m.move("left", along_x(0), frame); }},
  };
  for (const bool triangles : {false, true})
    for (const auto& [name, load] : loads) {
      const auto m = loaded_sheet(load, 0, 0.004, triangles);
      mechanics::Assembly a(*m);
      const auto errors = tangent_errors(a);
      INFO(name << (triangles ? ", mixed mesh" : "") << ": " << errors[0] << " " << errors[1]);
      // Central differences at h = 1e-5: h^2 times the third derivative, and 1e-16 / h of rounding.
      CHECK(errors[1] < 1e-9);
      CHECK(std::log10(errors[0] / errors[1]) > 1.95);
    }
  using Kind = model::TieKind;
  const std::pair<const char*, std::function<void(model::Model&)>> flat[] = {
      {"straight",
       [&](model::Model& m) {
         m.move("corners", along_x(0), frame);
         m.add<model::Tie>({Kind::straight, "right", {}, tied("x y z")});
         m.pressure("all", history::History::constant(2e5));
       }},
      {"periodic",
       [](model::Model& m) {
         m.add<model::Tie>({Kind::periodic, "left", "right", tied("x y z rotation")});
         m.add<model::Tie>({Kind::periodic, "bottom", "top", tied("x y z rotation")});
       }},
  };
  for (const auto& [name, load] : flat) {
    const auto m = loaded_sheet(load, 0.3, 0);
    m->validate();
    mechanics::Assembly a(*m);
    const auto errors = tangent_errors(a);
    INFO(name << ": " << errors[0] << " " << errors[1]);
    CHECK(errors[1] < 1e-9);
    CHECK(std::log10(errors[0] / errors[1]) > 1.95);
  }
  // Gravity off the middle surface loads the directors; strong enough here to be seen.
  const auto m = loaded_sheet(
      [](model::Model& sheet) {
        sheet.gravity(model::steady({3e5, -1e6, 2e6}));
      },
      0.8);
  mechanics::Assembly a(*m);
  CHECK(tangent_errors(a)[1] < 1e-9);
}

TEST_CASE("a tangent that keeps its upper triangle has the whole one's entries, to the bit") {
  const Mat3 frame = model::frame_from(Vec3(1, 0.5, 0.2), Vec3(0, 1, -0.3));
  const std::pair<const char*, std::function<void(model::Model&)>> sheets[] = {
      {"none", [](model::Model&) {}},
      {"supports",
       [&](model::Model& m) {
         m.fix("left", model::parse_freedoms("x z ry"), frame);
         m.move("right", along_x(0));
         m.fix("top", model::parse_freedoms("y"));
       }},
      {"ties",
       [](model::Model& m) {
         m.add<model::Tie>({model::TieKind::rigid, "top", {}, {}});
         m.add<model::Tie>({model::TieKind::equal, "bottom", {}, tied("x z")});
       }},
  };
  for (const bool triangles : {false, true})
    for (const auto& [name, load] : sheets) {
      INFO(name << (triangles ? ", mixed mesh" : ""));
      const auto m = loaded_sheet(load, 0.2, 0.004, triangles);
      mechanics::Assembly whole(*m), upper(*m);
      upper.keep_upper();
      linear::Matrix K[2];
      for (auto* a : {&whole, &upper}) {
        std::vector<double> step(static_cast<std::size_t>(a->dofs().unknowns()));
        for (std::size_t i = 0; i < step.size(); ++i) step[i] = 1e-4 * std::sin(7.0 * static_cast<double>(i));
        a->begin_iterate();
        a->apply_increment(step, 1, a->dofs().targets(0));
        REQUIRE(a->tangent({}, K[a == &upper], {}, {}));
      }
      CHECK(K[1].pattern->upper);
      CHECK(K[1].pattern->entries() < 0.65 * static_cast<double>(K[0].pattern->entries()));
      for (mechanics::Index c = 0; c < K[0].size(); ++c)
        for (auto k = K[0].pattern->column[c]; k < K[0].pattern->column[c + 1]; ++k) {
          const auto r = K[0].pattern->row[k];
          if (r <= c && K[0].value[k] != K[1].value[K[1].pattern->slot(r, c)])
            FAIL("row " << r << ", column " << c);
        }
    }
}

TEST_CASE("a tangent after the forces of its place leaves their law states, and is the same without them") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.03, 0.03, 3, 3));
  const model::Model m(mesh, test::blend(), {});
  const auto states = [](const mechanics::Assembly& a) {
    std::vector<double> all;
    for (mechanics::Index e = 0; e < a.cloth().elements(); ++e)
      a.cloth().readings().visit(e, [&](double, const law::Law& law, const double*, const double* state) {
        all.insert(all.end(), state, state + law::state_size(law));
      });
    return all;
  };
  mechanics::Assembly plain(m), between(m), alone(m), late(m);
  const auto step_of = [](const mechanics::Assembly& a, double scale) {
    std::vector<double> step(static_cast<std::size_t>(a.dofs().unknowns()));
    for (std::size_t i = 0; i < step.size(); ++i)
      step[i] = scale * 3e-4 * std::sin(7.0 * static_cast<double>(i));
    return step;
  };
  linear::Matrix K[2];
  for (const double scale : {1.0, 0.6, 1.4}) {  // loading, unloading, loading beyond
    for (auto* a : {&plain, &between, &alone}) {
      a->begin_iterate();
      a->apply_increment(step_of(*a, scale), 1, a->dofs().targets(0));
      if (a == &alone) REQUIRE(a->tangent({}, K[0], {}, {}));
      REQUIRE(a->forces({}));
      if (a == &between) REQUIRE(a->tangent({}, K[1], {}, {}));
      a->commit(scale);
    }
    CHECK(states(between) == states(plain));
    // States of forces at another place are not taken for those of this one.
    late.begin_iterate();
    const auto step = step_of(late, scale);
    late.apply_increment(step, 0.5, late.dofs().targets(0));
    REQUIRE(late.forces({}));
    late.apply_increment(step, 1, late.dofs().targets(0));
    linear::Matrix unused;
    REQUIRE(late.tangent({}, unused, {}, {}));
    late.commit(scale);
    const auto reached = states(late), want = states(plain);
    for (std::size_t i = 0; i < want.size(); ++i)
      CHECK(std::abs(reached[i] - want[i]) <= 1e-12 + 1e-9 * std::abs(want[i]));
    CHECK(K[0].value == K[1].value);
  }
}

TEST_CASE("directors on the edge of a cut lie in its plane of symmetry, at a corner in both planes") {
  // A quarter of a sphere's cap between the planes x = 0 and y = 0.
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.5, 0.5, 4, 4));
  mesh->map([](const Vec3& X) { return Vec3(X.x(), X.y(), std::sqrt(1 - X.x() * X.x() - X.y() * X.y())); });
  const auto directors = [&](const std::function<void(model::Model&)>& hold) {
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(0.0); };
    model::Model m(mesh, svk(), options);
    hold(m);
    const mechanics::Assembly a(m);
    std::vector<Vec3> d;
    const auto all = std::as_const(a).state().d();
    for (std::size_t i = 0; i < all.size(); i += 3) d.emplace_back(all[i], all[i + 1], all[i + 2]);
    return d;
  };
  const auto cut = directors([](model::Model& m) {
    m.add(model::symmetry("left", 0));
    m.add(model::symmetry("bottom", 1));
  });
  const auto bare = directors([](model::Model&) {});
  for (const auto n : mesh->set("left")) {
    CHECK(std::abs(bare[n].x()) > 0.01);
    CHECK(cut[n].x() == 0);
  }
  for (const auto n : mesh->set("bottom")) CHECK(cut[n].y() == 0);
  CHECK((cut[0] - Vec3::UnitZ()).norm() < 1e-15);
  CHECK(cut[24] == bare[24]);
  // The same by words, and a clamp, which leaves the mesh's own normals.
  CHECK(directors([](model::Model& m) { m.fix("left", model::parse_freedoms("x ry rz")); })[5] == cut[5]);
  CHECK(directors([](model::Model& m) { m.fix("left", model::parse_freedoms("x y z rotation")); })[5] ==
        bare[5]);
}

TEST_CASE("the first element turned inside out is named, none while all are whole") {
  for (const bool triangles : {false, true}) {
    const auto m = loaded_sheet([](model::Model&) {}, 0, 0.004, triangles);
    mechanics::Assembly a(*m);
    CHECK(a.cloth().readings().inverted_element({}) == -1);
    std::vector<double> step(a.dofs().unknowns(), 0.0);
    // The middle node of the last row of elements goes past its neighbours on the left.
    step[a.dofs().freedoms().nodes[10].equation[0]] = -0.025;
    a.begin_iterate();
    a.apply_increment(step, 1, {});
    const auto first = a.cloth().readings().inverted_element({});
    REQUIRE(first >= 0);
    const auto& nodes = m->mesh().elements[first];
    CHECK(std::find(nodes.begin(), nodes.end(), 10) != nodes.end());
  }
}

TEST_CASE("pressure pushes along the normal: the resultant on a flat sheet is p times its area") {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.1, 4, 3));
  model::Model m(mesh, svk(), {});
  m.pressure("all", history::History::constant(50));
  mechanics::Assembly a(m);
  std::vector<double> f(3 * mesh->nodes.size()), on_d(f.size());
  a.terms().find<mechanics::FollowerLoad>()->add_follower(0, a.trial(), f, on_d);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < f.size(); i += 3) sum += Vec3(f[i], f[i + 1], f[i + 2]);
  CHECK((sum - Vec3(0, 0, 50 * 0.02)).norm() < 1e-14);
}

TEST_CASE("pressure works on the volume between triangles and the arcs along their edges, up to a limit") {
  const double curvature = 0.3, h = 0.04;
  const auto work = [&](double pressure, bool triangles) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.2, 0.1, 5, 4));
    if (triangles) cut_some(*mesh, 1);
    model::Model m(mesh, svk(), {});
    m.pressure("all", history::History::constant(pressure));
    mechanics::Assembly a(m);
    std::vector<double> f(3 * mesh->nodes.size()), on_d(f.size());
    a.terms().find<mechanics::FollowerLoad>()->add_follower(0, a.trial(), f, on_d);
    double sum = 0;
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) sum += on_d[3 * n] * curvature * mesh->nodes[n].x();
    return sum;
  };
  const double wanted = curvature * h * h / 12 * 0.02;  // of a flat arc over each cell
  CHECK(std::abs(work(1e-5, true) / (1e-5 * wanted) - 1) < 1e-9);
  CHECK(work(1e-3, false) == 0);
  CHECK(std::abs(work(1e9, true)) < 1e-3 * 1e9 * wanted);
}

TEST_CASE("patch test of mixed meshes: a homogeneous strain leaves no force inside") {
  for (const std::size_t every : {1u, 2u, 100u}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 4, 4));
    for (const mesh::Index n : {6, 7, 8, 11, 12, 13, 16, 17, 18}) {
      const auto k = static_cast<double>(n);
      mesh->nodes[n] += 0.005 * Vec3(std::sin(5 * k), std::cos(3 * k), 0);
    }
    cut_some(*mesh, every);
    model::Model m(mesh, svk(), {});
    mechanics::Assembly a(m);
    Mat3 F;
    F << 1.1, 0.07, 0, -0.03, 0.95, 0, 0, 0, 1;
    std::vector<double> step(a.dofs().unknowns(), 0.0);
    for (std::size_t n = 0; n < mesh->nodes.size(); ++n) {
      const Vec3 u = F * mesh->nodes[n] - mesh->nodes[n];
      for (int i = 0; i < 3; ++i) step[a.dofs().freedoms().nodes[n].equation[i]] = u[i];
    }
    a.begin_iterate();
    a.apply_increment(step, 1, {});
    REQUIRE(a.forces({}));
    double inside = 0;
    for (const int n : {6, 7, 8, 11, 12, 13, 16, 17, 18})
      for (int i = 0; i < 3; ++i) inside = std::max(inside, std::abs(a.internal().on_x[3 * n + i]));
    CHECK(inside < 1e-12 * a.largest_force());
  }
}

TEST_CASE("loads are shared by area, by length, equally, or taken whole") {
  const auto mesh = mesh::rectangle(1, 1, 2, 2);
  const auto area = mechanics::tributary(mesh, mesh.set("all"));
  CHECK(area.kind == mechanics::Tributary::MeasureKind::area);
  CHECK(area.total == Approx(1).epsilon(1e-14));
  CHECK(area.measure[4] == Approx(0.25).epsilon(1e-14));
  const auto edge = mechanics::tributary(mesh, mesh.set("left"));
  CHECK(edge.kind == mechanics::Tributary::MeasureKind::length);
  CHECK(edge.measure == std::vector<double>{0.25, 0.5, 0.25});
  CHECK(mechanics::tributary(mesh, {0, 8}).kind == mechanics::Tributary::MeasureKind::count);
}

TEST_CASE("plies: one card cut in three layers is that card; a crossed ply turns the axes") {
  const auto card = svk();
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 1, 1));
  const auto stretch = [&](std::vector<section::Ply> plies) {
    model::Options options;
    options.plies = std::move(plies);
    model::Model m(mesh, card, options);
    mechanics::Assembly a(m);
    std::vector<double> step(a.dofs().unknowns(), 0.0);
    for (std::size_t i = 0; i < mesh->nodes.size(); ++i)
      step[a.dofs().freedoms().nodes[i].equation[0]] = 1e-3 * mesh->nodes[i].x();
    a.apply_increment(step, 1, {});
    REQUIRE(a.forces({}));
    double pull = 0;
    for (const auto n : mesh->set("right")) pull += a.internal().on_x[3 * n];
    return pull;
  };
  const double t = card.thickness;
  const double whole = stretch({{card, t, 0}}),
               parts = stretch({{card, 0.2 * t, 0}, {card, 0.5 * t, 0}, {card, 0.3 * t, 0}});
  CHECK(std::abs(parts / whole - 1) < 1e-13);
  const double crossed = stretch({{card, t, 90}}), both = stretch({{card, t / 2, 0}, {card, t / 2, 90}});
  CHECK(std::abs(crossed / whole / (37.0 / 8) - 1) < 1e-12);  // E2 / E1: both lateral strains are held
  CHECK(std::abs(both / ((whole + crossed) / 2) - 1) < 1e-12);
  CHECK_THROWS_WITH(section::stacked({{card, t, 0}, {card, 0, 0}}, 3, 0),
                    "layers: layer 2: thickness: expected a positive length in m, got 0");
}

TEST_CASE("forces and tangent have the same bits for one, two and four threads") {
  const auto make = [](int threads) {
    omp_set_num_threads(threads);
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, 40, 40));
    model::Model m(mesh, test::blend(), {});
    m.add<model::Tie>({model::TieKind::periodic, "left", "right", tied("x y z rotation")});
    mechanics::Assembly a(m);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1e-3, 1e-3);
    std::vector<double> step(a.dofs().unknowns());
    for (double& s : step) s = number(random);
    a.apply_increment(step, 1, {});
    linear::Matrix K;
    REQUIRE(a.tangent({}, K, {}, {}));
    std::vector<double> all = K.value;
    const auto keep = [&] {
      for (const auto f : {a.internal().on_x, a.internal().on_d}) all.insert(all.end(), f.begin(), f.end());
    };
    keep();
    // Explicit steps through the law's branches: forces, commit, move on.
    for (int i = 1; i < 5; ++i) {
      REQUIRE(a.forces({}));
      keep();
      a.commit(i);
      a.begin_iterate();
      a.apply_increment(step, std::cos(2.0 * i), {});
    }
    Archive states;
    a.keep(states);
    for (const char byte : states.bytes()) all.push_back(byte);
    return all;
  };
  const auto one = make(1);
  CHECK(one == make(2));
  CHECK(one == make(4));
  omp_set_num_threads(omp_get_num_procs());
}
