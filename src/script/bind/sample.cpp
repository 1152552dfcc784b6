// card:sample.
#include <algorithm>

#include "base/number.hpp"
#include "card/fields.hpp"
#include "lab/statistics.hpp"
#include "law/check.hpp"
#include "script/bind/rooms.hpp"
#include "script/bind/run.hpp"

namespace fabricsh::script {

namespace {

using card::ParameterBand;
using card::Woven;

// Draws the parameters of one part, for example "warp", from their confidence band.
void draw(card::Card& card, const char* part, const ParameterBand& band, double level,
          std::mt19937_64& random) {
  if (band.low.empty()) return;
  const card::Field& group = *card::find_field(card::fields(card), part);
  set_parameters(
      group, card,
      lab::draw_around(parameters(group, card), band.low, band.high, band.covariance, level, random));
}

// Why a drawn card cannot be used; empty for one that can.
std::string fault_of(const card::Card& card) {
  const law::CheckReport report = law::check(card, 0.1);
  for (const law::CheckItem& item : report.items)
    if (item.severity == Severity::error) return item.text;
  return report.ok() ? "" : "it is not valid";
}

struct Refused {  // drawn cards that are none
  int count = 0;
  std::string first;  // the reason of the first
};

// Draws until the card is valid, because the bands may include impossible parameters.
std::shared_ptr<card::Card> drawn_card(const card::Card& from, std::mt19937_64& random, Refused& refused) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    auto copy = std::make_shared<card::Card>(from);
    auto& law = std::get<Woven>(copy->law);
    const card::ParameterBands bands = *law.bands;
    draw(*copy, "warp", bands.warp, bands.level, random);
    draw(*copy, "weft", bands.weft, bands.level, random);
    draw(*copy, "shear", bands.shear, bands.level, random);
    law.bands.reset();
    const std::string fault = fault_of(*copy);
    if (fault.empty()) return copy;
    if (refused.count++ == 0) refused.first = fault;
  }
  throw Error("sample: of 1000 cards within the bands none is usable: " + refused.first);
}

// Bands of which a part makes no card are cut there, and the samples are those of narrower bands.
void tell(Call& call, int n, const Refused& refused) {
  if (refused.count * 50 < n) return;
  const double share = 100.0 * refused.count / (n + refused.count);
  call.session().warn(
      "card",
      "sample: " + std::to_string(refused.count) + " of " + std::to_string(n + refused.count) +
          " cards drawn from the bands (" + fabricsh::number(share, 2) +
          " %) make no card and were drawn again, so that the samples do not fill the bands; the first: " +
          refused.first);
}

int sample(Call& call) {
  lua_State* L = call.L();
  const auto card = call.self<card::Card>();
  const auto* law = std::get_if<Woven>(&card->law);
  if (law == nullptr || !law->bands) throw Error("sample: expected a woven card with bands, got one without");
  std::mt19937_64 random(static_cast<std::uint64_t>(call.integer("seed")));
  const int n = call.count("n");
  Refused refused;
  lua_createtable(L, std::min(n, 1000), 1);
  for (lua_Integer i = 1; i <= n; ++i) {
    push_object(L, drawn_card(*card, random, refused));
    lua_rawseti(L, -2, i);
  }
  lua_pushinteger(L, refused.count);
  lua_setfield(L, -2, "refused");
  tell(call, n, refused);
  return 1;
}

}  // namespace

void bind_sample(Session& session) {
  install(session,
          {{"card:sample",
            Style::positional,
            {integer_("n", Range{1, 1e5}, "of cards"),
             integer_("seed", not_negative, "of the draw").or_else(1.0)},
            "Cards drawn from the card's confidence bands, for the uncertainty of any answer, a list; a "
            "value at the "
            "end of its band is drawn on the band's side. Drawn values that make no card are drawn again; "
            "`refused` "
            "says how often, and from one in fifty on there is a warning.",
            "local fabric = require 'fabric'\n"
            "local card = fabric.card 'blend':with{ bands={ warp={ low={7e6, 800e6, 850e6, 0.2}, high={9e6, "
            "852e6, 878e6, 0.3},\n"
            "  covariance={2.6e11,0,0,0, 0,1.8e14,0,0, 0,0,5.1e13,0, 0,0,0,6.5e-4} } } }\n"
            "local cards = card:sample(5)\nassert(#cards == 5 and cards[1].warp.poisson ~= 0.25 and "
            "cards[1].shear.unloading == 12e6)",
            sample}});
}

}  // namespace fabricsh::script
