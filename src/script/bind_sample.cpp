// card:sample.
#include <algorithm>

#include "fabric/check.hpp"
#include "lab/statistics.hpp"
#include "script/bind.hpp"
#include "script/bind_run.hpp"

namespace fabricsh::script {

namespace {

using card::Band;
using card::Woven;

// loading..., unloading, and poisson where there is one.
template <class Part>
std::vector<double*> parameters(Part& part) {
  std::vector<double*> out;
  for (double& d : part.loading.coefficients) out.push_back(&d);
  out.push_back(&part.unloading);
  if constexpr (requires { part.poisson; }) out.push_back(&part.poisson);
  return out;
}

template <class Part>
void draw(Part& part, const Band& band, double level, std::mt19937_64& random) {
  if (band.low.empty()) return;
  const auto places = parameters(part);
  std::vector<double> value, half;
  for (std::size_t i = 0; i < places.size(); ++i) {
    value.push_back(*places[i]);
    half.push_back((band.high[i] - band.low[i]) / 2);
  }
  const auto drawn = lab::draw_around(value, half, band.covariance, level, random);
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = drawn[i];
}

// One usable card; the bands may reach into what a card cannot be.
std::shared_ptr<card::Card> drawn_card(const card::Card& from, std::mt19937_64& random) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    auto copy = std::make_shared<card::Card>(from);
    auto& law = std::get<Woven>(copy->law);
    const card::Bands bands = *law.bands;
    draw(law.warp, bands.warp, bands.level, random);
    draw(law.weft, bands.weft, bands.level, random);
    draw(law.shear, bands.shear, bands.level, random);
    law.bands.reset();
    if (fabric::check(*copy, 0.1).ok()) return copy;
  }
  throw Error("sample: of 1000 cards within the bands none is usable; card:check() says what is wrong");
}

int sample(Call& call) {
  lua_State* L = call.L();
  const auto card = call.self<card::Card>();
  const auto* law = std::get_if<Woven>(&card->law);
  if (law == nullptr || !law->bands) throw Error("sample: expected a woven card with bands, got one without");
  std::mt19937_64 random(static_cast<std::uint64_t>(call.integer("seed")));
  const int n = call.count("n");
  lua_createtable(L, std::min(n, 1000), 0);
  for (lua_Integer i = 1; i <= n; ++i) {
    push_object(L, drawn_card(*card, random));
    lua_rawseti(L, -2, i);
  }
  return 1;
}

}  // namespace

void bind_sample(Session& session) {
  install(session,
          {{"card:sample",
            Style::positional,
            {integer_("n", from_one, "of cards"), integer_("seed", not_negative, "of the draw").or_else(1.0)},
            "Cards drawn from the card's confidence bands, for the uncertainty of any answer; cards that "
            "could not be are drawn "
            "again.",
            "local fabric = require 'fabric'\n"
            "local card = fabric.card 'blend':with{ bands={ warp={ low={7e6, 800e6, 850e6, 0.2}, high={9e6, "
            "852e6, 878e6, 0.3},\n"
            "  covariance={2.6e11,0,0,0, 0,1.8e14,0,0, 0,0,5.1e13,0, 0,0,0,6.5e-4} } } }\n"
            "local cards = card:sample(5)\nassert(#cards == 5 and cards[1].warp.poisson ~= 0.25 and "
            "cards[1].shear.unloading == 12e6)",
            sample}});
}

}  // namespace fabricsh::script
