// The table of a card's fields: what every row must be able to do, whichever rows there are.
#include <functional>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "card/full_card.hpp"
#include "catch.hpp"
#include "message_of.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::card;

namespace {

void each(const FieldTable& table, const std::string& path,
          const std::function<void(const std::string&, const Field&)>& visit) {
  for (const Field& field : table) {
    visit(path + field.name, field);
    each(field.rows, path + field.name + ".", visit);
  }
}

}  // namespace

TEST_CASE("every row has a sentence, a name of its own, and keeps what is put into it", "[card]") {
  for (const std::string kind : {"woven", "svk", "linear"}) {
    const Card full = test::full_card(kind);
    CHECK(card::kind(full) == kind);
    std::set<std::string> paths;
    each(fields(kind), "", [&](const std::string& path, const Field& field) {
      INFO(kind << ": " << path);
      CHECK(paths.insert(path).second);
      CHECK_FALSE(field.sentence.empty());
      CHECK(find_field(fields(kind), path) == &field);
      if (field.holds == FieldType::group || !field.get) return;
      const Value value = field.get(full);
      CHECK_FALSE(std::holds_alternative<std::monostate>(value));
      if (path != "law") CHECK_FALSE(value == field.fallback);  // no other law takes all the parts
      Card copy = full;
      field.set(copy, value);
      CHECK(lua_text(copy) == lua_text(full));
    });
    CHECK(paths.size() > 8);
    CHECK(find_field(fields(kind), "warp.heigth") == nullptr);
  }
}

TEST_CASE("two cards that differ in one field have different texts", "[card]") {
  for (const std::string kind : {"woven", "svk", "linear"}) {
    const Card full = test::full_card(kind);
    each(fields(kind), "", [&](const std::string& path, const Field& field) {
      if (field.holds != FieldType::number || !field.get) return;
      INFO(kind << ": " << path);
      Card other = full;
      field.set(other, std::get<double>(field.get(full)) * (1 + 1e-15));
      CHECK(lua_text(other) != lua_text(full));
      CHECK(lua_text(full).find(field.name + " = ") != std::string::npos);
    });
  }
}

TEST_CASE("a zero byte in a card's words is written so that a digit behind it stays one", "[card]") {
  card::Card c = test::blend();
  c.source = std::string(
      "a\0"
      "29",
      4);
  CHECK(card::lua_text(c).find("\"a\\00029\"") != std::string::npos);
}

TEST_CASE("a number out of its row's range is refused by its path", "[card]") {
  for (const std::string kind : {"woven", "svk", "linear"})
    each(fields(kind), "", [&](const std::string& path, const Field& field) {
      if (field.holds != FieldType::number || !field.get || !std::isfinite(field.range.low)) return;
      for (const double bad : {field.range.low - 1, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Card card = test::full_card(kind);
        card.name = "mine";
        field.set(card, bad);
        const std::string message = message_of([&] { require(card); });
        INFO(path << ": " << message);
        CHECK(message.find("card 'mine': field '" + path + "': expected a ") == 0);
      }
    });
  CHECK_NOTHROW(require(test::full_card("woven")));
}

TEST_CASE("numbers far from cloth are doubted, the others are not", "[card]") {
  Card card;
  card.density = 0.59;
  card.thickness = 0.38e-3;
  auto& woven = std::get<Woven>(card.law);
  woven.warp.loading.coefficients = {8, 826};
  woven.weft.loading.points = {{0, 0}, {0.1, 5e5}};
  std::set<std::string> doubted;
  for (const auto& doubt : doubts(card)) {
    doubted.insert(doubt.field);
    CHECK_FALSE(doubt.question.empty());
  }
  CHECK(doubted == std::set<std::string>{"density", "warp.loading"});
}

TEST_CASE("subjects of a band: coefficients, unloading, poisson, in this order", "[card]") {
  Card card = test::full_card("woven");
  auto& woven = std::get<Woven>(card.law);
  woven.warp = {{{1, 2, 3}, {}}, 4, 5};
  woven.shear.loading = {{6}, {}};
  woven.shear.unloading = 7;
  const Field& warp = *find_field(fields(card), "warp");
  CHECK(parameters(warp, card) == std::vector<double>{1, 2, 3, 4, 5});
  CHECK(parameters(*find_field(fields(card), "shear"), card) == std::vector<double>{6, 7});
  set_parameters(warp, card, {10, 20, 30, 40, 50});
  CHECK(woven.warp.loading.coefficients == std::vector<double>{10, 20, 30});
  CHECK(woven.warp.unloading == 40);
  CHECK(woven.warp.poisson == 50);
  // Of measured points, the stresses beyond zero strain.
  woven.warp.loading = {{}, {{0, 0}, {0.1, 1}, {0.2, 3}}};
  CHECK(parameters(warp, card) == std::vector<double>{1, 3, 40, 50});
  set_parameters(warp, card, {2, 4, 60, 70});
  CHECK(woven.warp.loading.points == Points{{0, 0}, {0.1, 2}, {0.2, 4}});
  CHECK(woven.warp.poisson == 70);
}
