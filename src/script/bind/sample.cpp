// card:sample.
#include <algorithm>

#include "base/number.hpp"
#include "card/fields.hpp"
#include "lab/statistics.hpp"
#include "law/check.hpp"
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

// Makes the ordinates of points rise from zero on: neighbours that fall have their mean [barlow1972], each a
// little above the one before. Such a draw is moved to the nearest curve of a cloth, so that what lies below
// zero in the toe takes nothing away from the rest of the band.
void make_rise(card::Points& points) {
  struct Block {
    double sum;
    int n;
    double mean() const { return sum / n; }
  };
  std::vector<Block> blocks;
  for (const auto& [x, y] : points) {
    if (x == 0) continue;
    blocks.push_back({y, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back() = {blocks.back().sum + last.sum, blocks.back().n + last.n};
    }
  }
  if (blocks.empty() || blocks.back().mean() <= 0) return;  // no cloth is near
  const double step = 1e-4 * blocks.back().mean() / static_cast<double>(points.size());
  double before = 0;
  auto point = points.begin() + (points.front().first == 0 ? 1 : 0);
  for (const Block& block : blocks)
    for (int i = 0; i < block.n; ++i, ++point) before = point->second = std::max(block.mean(), before + step);
}

double steepest(const card::Curve& curve, double tested) {
  double most = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    most = std::max(most, (curve.points[i].second - curve.points[i - 1].second) /
                              (curve.points[i].first - curve.points[i - 1].first));
  for (int i = 0; i <= 200 && !curve.coefficients.empty(); ++i) {
    double modulus = 0;
    for (auto d = curve.coefficients.rbegin(); d != curve.coefficients.rend(); ++d)
      modulus = modulus * tested * i / 200 + *d;
    most = std::max(most, modulus);
  }
  return most;
}

// A draw of a yarn that no cloth has, though one is near: points that fall, unloading flatter than loading.
void mend(card::Yarn& drawn, const card::Yarn& from, double tested) {
  if (!drawn.loading.points.empty()) make_rise(drawn.loading.points);
  if (steepest(from.loading, tested) <= from.unloading)
    drawn.unloading = std::max(drawn.unloading, 1.001 * steepest(drawn.loading, tested));
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
    for (const auto& [part, place] : card::banded_parts) draw(*copy, part, bands.*place, bands.level, random);
    const auto& own = std::get<Woven>(from.law);
    mend(law.warp, own.warp, own.tested.warp);
    mend(law.weft, own.weft, own.tested.weft);
    if (!law.shear.loading.points.empty()) make_rise(law.shear.loading.points);
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
  put(L, "refused", refused.count);
  tell(call, n, refused);
  return 1;
}

}  // namespace

void bind_sample(Session& session) {
  install(session,
          {{"card:sample()",
            {integer_("n", Range{1, 1e5}, "of cards"),
             integer_("seed", not_negative, "of the draw").or_else(1.0)},
            "Cards drawn from the card's confidence bands, for the uncertainty of any answer, a list; a "
            "value at the end of its band is drawn on the band's side. Points of a yarn that fall are made "
            "to rise, and an unloading flatter than the loading is raised to it; other values that make no "
            "card are drawn again; `refused` says how often, and from one in fifty on there is a warning.",
            "local card = fabric.card 'blend':with{ bands={ warp={ low={7e6, 800e6, 850e6, 0.2}, high={9e6, "
            "852e6, 878e6, 0.3},\n"
            "  covariance={2.6e11,0,0,0, 0,1.8e14,0,0, 0,0,5.1e13,0, 0,0,0,6.5e-4} } } }\n"
            "local cards = card:sample(5)\nassert(#cards == 5 and cards[1].warp.poisson ~= 0.25 and "
            "cards[1].shear.unloading == 12e6)",
            sample}});
}

}  // namespace fabricsh::script
