#include "catch.hpp"
#include "run/rising.hpp"

using namespace fabricsh::run;

namespace {
EnergyAccount account(double damping, double friction, double warp, double more_warp = 0) {
  EnergyAccount e;
  e.damping = damping;
  e.lost = {{"warp", warp}, {"friction", friction}, {"warp", more_warp}};
  return e;
}
std::string name_of(const std::optional<RisingAccounts::Fall>& fall) { return fall ? fall->name : "none"; }
}  // namespace

TEST_CASE("an account that can only rise and falls is found, with its name, by how much, and since when") {
  RisingAccounts accounts;
  CHECK(!accounts.look(account(1, 2, 3), 0.1, 1e-6, 1e-6));
  CHECK(!accounts.look(account(1.5, 2, 3.5), 0.2, 1e-6, 1e-6));
  CHECK(!accounts.look(account(1.5, 2 - 9e-7, 3.5), 0.3, 1e-6, 1e-6));
  const auto fall = accounts.look(account(1.4, 1.75, 3.4), 0.4, 1e-6, 0.2);
  REQUIRE(fall);
  CHECK(fall->name == "friction");
  CHECK(fall->by == 0.25);
  CHECK(fall->to == 1.75);
  CHECK(fall->since == 0.2);
}

TEST_CASE("accounts of one name are one, and a loss of the scheme may swing by what is allowed to it") {
  RisingAccounts accounts;
  CHECK(!accounts.look(account(1, 0, 1, 2), 0, 1e-6, 0.2));
  CHECK(!accounts.look(account(0.9, 0, 2, 1), 1, 1e-6, 0.2));
  CHECK(name_of(accounts.look(account(0.9, 0, 2, 0.5), 2, 1e-6, 0.2)) == "warp");
  CHECK(name_of(accounts.look(account(0.7, 0, 2, 1), 3, 1e-6, 0.2)) == "damping");
  CHECK(!RisingAccounts().look(account(0.1, 0, 0, 0), 4, 1e-6, 0.2));
  fabricsh::Archive kept;
  accounts.keep(kept);
  RisingAccounts restored;
  fabricsh::Archive read(kept.bytes());
  restored.keep(read);
  CHECK(name_of(restored.look(account(0.7, 0, 2, 1), 4, 1e-6, 0.2)) == "damping");
}
