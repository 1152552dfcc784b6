// The law of contact: smooth where its pieces meet, exact in its linear part, without bound at the floor.
#include <cmath>

#include "catch.hpp"
#include "contact/law.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::contact;

namespace {

LawData blend() { return {0.38e-3, 0.15e-3, 2e10, {}}; }

double energy(const ContactLaw& law, double d) { return law(d).contact + law(d).guard; }

// Pressure and stiffness are derivatives of the energy, by slope.
void check_derivatives(const ContactLaw& law, double d) {
  INFO("gap " << d);
  const double h = 0.02 * (d - law.floor());
  const auto error = [&](double step) {
    return std::fabs((energy(law, d - step) - energy(law, d + step)) / (2 * step) - law(d).pressure);
  };
  const auto error2 = [&](double step) {
    return std::fabs((law(d - step).pressure - law(d + step).pressure) / (2 * step) - law(d).stiffness);
  };
  CHECK((error(h / 2) < 0.3 * error(h) || error(h) < 1e-11 * law(d).pressure));
  CHECK((error2(h / 2) < 0.3 * error2(h) || error2(h) < 1e-11 * law(d).stiffness));
}

}  // namespace

TEST_CASE("law: linear beyond its onset, with the stiffness asked for", "[contact]") {
  const ContactLaw law(blend());
  const double crush = 0.23e-3;
  CHECK(law(0.38e-3).pressure == 0);
  CHECK(law(0.5).pressure == 0);
  const double d = law.gap() - 0.5 * crush;
  CHECK(law(d).stiffness == Approx(2e10).epsilon(1e-14));
  CHECK(law(d).pressure == Approx(2e10 * (0.5 - 0.1) * crush).epsilon(1e-13));
  CHECK(law(d).guard == 0);
}

TEST_CASE("law: two continuous derivatives where its pieces meet", "[contact]") {
  const ContactLaw law(blend());
  const double crush = law.gap() - law.floor();
  for (const double knot : {law.gap(), law.gap() - 0.2 * crush, law.guard_gap()}) {
    const double h = 1e-9 * crush;
    CHECK(law(knot - h).pressure == Approx(law(knot + h).pressure).epsilon(1e-7).margin(1e-8 * 2e10 * crush));
    CHECK(law(knot - h).stiffness == Approx(law(knot + h).stiffness).epsilon(1e-7).margin(1e-7 * 2e10));
  }
}

TEST_CASE("law: pressure and stiffness are the energy's derivatives", "[contact]") {
  const ContactLaw law(blend());
  const double crush = law.gap() - law.floor();
  for (const double share : {0.02, 0.1, 0.15, 0.2, 0.4, 0.6, 0.9})
    check_derivatives(law, law.floor() + share * crush);
}

TEST_CASE("law: the guard has an account of its own and rises without bound", "[contact]") {
  const ContactLaw law(blend());
  CHECK(law(law.guard_gap()).guard == 0);
  CHECK(law(law.guard_gap() + 1e-7).guard == 0);
  const double quarter = law.guard_gap() - law.floor();
  CHECK(law(law.floor() + quarter / 2).guard == Approx(2e10 * quarter * quarter / 4).epsilon(1e-12));
  double last = 0;
  for (double y = 0.1; y > 1e-6; y /= 10) {
    const double guard = law(law.floor() + y * quarter).guard;
    CHECK(guard > 5 * last);
    last = guard;
  }
  CHECK(std::isinf(law(law.floor()).pressure));
  CHECK(std::isinf(law(0).contact));
}

TEST_CASE("law: a measured curve is met at its points, monotone and smooth between them", "[contact]") {
  LawData data;
  data.floor = 0.15e-3;
  data.curve = {{0.3e-3, 5000}, {0.35e-3, 1200}, {0.45e-3, 300}, {0.6e-3, 49}};
  const ContactLaw law(data);
  for (const auto& [gap, pressure] : data.curve) {
    INFO(gap);
    CHECK(law(gap).pressure == Approx(pressure).epsilon(1e-12));
  }
  CHECK(law.gap() > 0.6e-3);
  double last = 0;
  for (double d = law.gap(); d > 0.2e-3; d -= 1e-6) {
    CHECK(law(d).pressure >= last);
    CHECK(law(d).stiffness >= 0);
    last = law(d).pressure;
  }
  for (const double d : {0.21e-3, 0.28e-3, 0.32e-3, 0.41e-3, 0.55e-3, 0.61e-3}) check_derivatives(law, d);
}

TEST_CASE("law: a curve's stiffness can be bounded", "[contact]") {
  LawData data;
  data.floor = 0.15e-3;
  data.curve = {{0.3e-3, 5000}, {0.35e-3, 1200}, {0.45e-3, 300}, {0.6e-3, 49}};
  data.stiffness = 2e7;
  const ContactLaw law(data);
  CHECK(law.stiffest() == 2e7);
  for (double d = law.gap(); d > law.guard_gap(); d -= 1e-6) CHECK(law(d).stiffness <= 2e7 * (1 + 1e-12));
  check_derivatives(law, 0.33e-3);
  CHECK(law(0.6e-3).pressure == Approx(49).epsilon(1e-12));  // soft there: untouched
}

TEST_CASE(
    "law: below a measured curve stiffness rises as what is left above the floor falls, down to a guard",
    "[contact]") {
  LawData data;
  data.floor = 0.15e-3;
  data.curve = {{0.2e-3, 5000}, {0.22e-3, 3000}, {0.4e-3, 300}, {0.6e-3, 49}};
  const ContactLaw law(data);
  CHECK(law.guard_gap() == Approx(0.175e-3).epsilon(1e-12));  // half of what is left below 0.2 mm
  const double stiffness = 2000 / 0.02e-3;
  CHECK(law(0.2e-3).stiffness == Approx(stiffness).epsilon(1e-12));
  CHECK(law(0.2e-3 - 1e-12).stiffness == Approx(stiffness).epsilon(1e-6));
  CHECK(law.stiffest() == Approx(4 * stiffness).epsilon(1e-12));
  for (const double d : {0.196e-3, 0.189e-3, 0.183e-3}) {
    const double left = (d - data.floor) / 0.05e-3;
    CHECK(law(d).stiffness == Approx(stiffness / (left * left)).epsilon(0.03));  // straight pieces
    CHECK(law(d).guard == 0);
    check_derivatives(law, d);
  }
  CHECK(law(0.2e-3).pressure == Approx(5000).epsilon(1e-12));
}

TEST_CASE("law: scaled lengths keep the stiffness", "[contact]") {
  const ContactLaw law(blend());
  const double d = 0.7 * law.gap(), scale = 0.5;
  CHECK(law.scaled(scale * d, scale).stiffness == law(d).stiffness);
  CHECK(law.scaled(scale * d, scale).pressure == Approx(scale * law(d).pressure).epsilon(1e-15));
  CHECK(law.scaled(scale * law.gap(), scale).pressure == 0);
}

TEST_CASE("law: impossible data are refused with what was expected", "[contact]") {
  const auto refusal = [](LawData data) { return message_of([&] { ContactLaw law(data); }); };
  CHECK(refusal({0.1e-3, 0.15e-3, 1, {}}) ==
        "contact: gap: expected more than the floor of 0.00015 m, got 0.0001 m");
  CHECK(refusal({0.3e-3, 0.15e-3, -1, {}}) ==
        "contact: stiffness: expected a positive number in Pa/m, got -1");
  CHECK(refusal({0.3e-3, 0, 1, {}}) == "contact: floor: expected a positive length in m, got 0");
  CHECK(refusal({0, 0.15e-3, 0, {{0.3e-3, 100}}}) ==
        "contact: compression: expected at least two points, got 1");
  CHECK(refusal({0, 0.15e-3, 0, {{0.1e-3, 100}, {0.2e-3, 50}}}) ==
        "contact: compression: expected gaps above the floor of 0.00015 m, got 0.0001 m");
  CHECK(refusal({0, 0.15e-3, 0, {{0.3e-3, 100}, {0.4e-3, 150}}}).find("as point 2") != std::string::npos);
}
