// Declarations of a model: one list, whose numbers are checked by rows of fields.
#include "catch.hpp"
#include "message_of.hpp"
#include "model/declaration_rows.hpp"
#include "model/model.hpp"
#include "model/sheet.hpp"

using namespace fabricsh;
using namespace fabricsh::test;
using model::Model;

namespace {

model::RigidPointer ball() {
  return std::make_shared<const model::Rigid>(model::Sphere{0.01, Vec3(0.02, 0.03, 0.02)}, std::nullopt, "",
                                              "sphere");
}

bool about(const std::string& message, const std::string& field) {
  return message.find("field '" + field + "': expected") != std::string::npos;
}

}  // namespace

TEST_CASE("numbers of declarations are checked by their rows") {
  Model m = make_model();
  CHECK(message_of([&] {
          m.add(model::EdgeBand{"top", -3});
        }) == "band: field 'stiffness': expected a positive number in N, got -3");
  CHECK(about(message_of([&] { m.add(model::EdgeBand{"top", 20, 1.25}); }), "ease"));
  model::Seam seam{"top", "bottom"};
  seam.strength = -40;
  CHECK(about(message_of([&] { m.add(seam); }), "strength"));
  const std::vector<model::Party> sides{{"", ball()}, {"all", nullptr}};
  CHECK(about(message_of([&] { m.add(model::ContactGiven{.between = sides, .restitution = 0.1}); }),
              "restitution"));
  CHECK(message_of([&] { m.add(model::ContactGiven{.between = sides, .viscosity = 5, .film = -1e-4}); }) ==
        "contact: field 'film.thickness': expected a positive number in m, got -0.0001");
  model::GasGiven gas;
  gas.temperature = 0;
  CHECK(about(message_of([&] { m.add(std::make_shared<const model::GasGiven>(gas)); }), "temperature"));
  CHECK(m.all<model::EdgeBand>().empty());
  CHECK(m.all<model::ContactGiven>().empty());
}

TEST_CASE("a declaration of any kind is taken back, and the last gravity is that of the model") {
  Model m = make_model();
  const auto body = ball();
  m.gravity(model::steady({0, 0, -9.81}));
  m.gravity(model::steady({0, 0, -1.62}));
  CHECK(m.all<model::Gravity>().size() == 1);
  CHECK(m.gravity()[2]->value(0) == -1.62);
  m.add(model::ContactGiven{{{"", body}, {"all", nullptr}}, 0.2});
  m.add(model::BodyMotion{body, model::steady({0, 0, -0.001}), {}});
  CHECK(m.interactions().motion_of(*body) != nullptr);
  CHECK(message_of([&] {
          m.add(model::BodyLoad{body, model::steady({0, 0, 1})});
        }).starts_with("force: the sphere is moved by m:move"));
  m.remove<model::BodyMotion>(0);
  CHECK(m.interactions().motion_of(*body) == nullptr);
  m.add(model::BodyLoad{body, model::steady({0, 0, 1}), true});
  CHECK(m.interactions().floats(*body));
  m.remove<model::BodyLoad>(0);
  m.remove<model::ContactGiven>(0);
  CHECK(m.interactions().bodies().empty());
  m.remove<model::Gravity>(0);
  CHECK_FALSE(m.gravity()[2].has_value());
  CHECK(message_of([&] { m.remove<model::Gravity>(0); }) == "remove: there is no such support or load");
}
