// Held and driven bodies that face each other across cloth, nearer than the cloth between them needs.
//
// From each body the way through the plies is summed: gap by gap, from node to node. Where it arrives at
// another body that looks the other way, the sum is the distance of the two along the cloth's normal.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mechanics/terms/contact_readings.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kOpposite = -0.9;  // cosine between the normals of bodies that face each other
constexpr double kTight = 0.01;     // of the thickness: less is as good as fitting
constexpr int kHalvings = 100;

// A way from a body through plies to a node.
struct Reach {
  double length = 0, need = 0, floor = 0;  // m
  Vec3 normal = Vec3::Zero();              // of the body, towards the cloth
  std::vector<std::int32_t> through;       // interactions
};
using Reaches = std::map<std::pair<std::int32_t, std::int32_t>, Reach>;  // by node and surface of the body

// The gap at which a law has a pressure, m. The pressure falls with the gap.
double gap_at(const contact::ContactLaw& law, double pressure) {
  double low = law.floor(), high = law.gap();
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (law(middle).pressure > pressure ? low : high) = middle;
  }
  return (low + high) / 2;
}

// Pa: with it the gaps of all contacts of the way add up to its length; infinite if their floors do not fit.
double pressure_on(const Reach& way, const std::vector<contact::Interaction>& all) {
  if (way.length <= way.floor) return std::numeric_limits<double>::infinity();
  double low = 0, high = 1;
  const auto longer = [&](double pressure) {
    double sum = 0;
    for (const std::int32_t i : way.through) sum += gap_at(all[static_cast<std::size_t>(i)].law, pressure);
    return sum > way.length;
  };
  constexpr double most = 1e15;
  while (longer(high) && high < most) high *= 10;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (longer(middle) ? low : high) = middle;
  }
  return high;
}

// m, by how much the way is too short.
double lacks(const Reach& way) { return way.need - way.length; }

// Of two ways the one that lacks more stays: it goes through all plies.
void put(Reaches& reaches, std::pair<std::int32_t, std::int32_t> at, const Reach& found) {
  const auto [place, is_new] = reaches.try_emplace(at, found);
  if (!is_new && lacks(found) > lacks(place->second)) place->second = found;
}

Reach joined(Reach way, const Reach& part) {
  way.length += part.length;
  way.need += part.need;
  way.floor += part.floor;
  way.through.push_back(part.through.front());
  return way;
}

// Two plies that meet: a node of one, `to`, over a corner of the other.
struct Over {
  std::int32_t from, to;
  Reach part;
};

// Goes on from the nodes that the bodies reach to those of further plies, away from the body.
Reaches lengthened(Reaches reaches, const std::vector<Over>& links, std::int32_t plies) {
  for (std::int32_t ply = 1; ply < plies && !links.empty(); ++ply) {
    Reaches longer = reaches;
    const auto follow = [&](std::int32_t from, std::int32_t to, const Reach& part, double sense) {
      for (auto at = reaches.lower_bound({from, 0}); at != reaches.end() && at->first.first == from; ++at) {
        if (sense * at->second.normal.dot(part.normal) < -kOpposite) continue;
        put(longer, {to, at->first.second}, joined(at->second, part));
      }
    };
    for (const Over& link : links) {
      follow(link.from, link.to, link.part, 1);
      follow(link.to, link.from, link.part, -1);
    }
    reaches = std::move(longer);
  }
  return reaches;
}

// Of each two bodies, by their surfaces, the way that lacks most, if it does not fit.
struct Tightest {
  Reach way;
  Index node;
};
std::map<std::pair<std::int32_t, std::int32_t>, Tightest> tightest(const Reaches& reaches,
                                                                   const Reaches& direct) {
  std::map<std::pair<std::int32_t, std::int32_t>, Tightest> found;
  for (const auto& [at, last] : direct)
    for (auto from = reaches.lower_bound({at.first, 0});
         from != reaches.end() && from->first.first == at.first; ++from) {
      if (from->first.second >= at.second || from->second.normal.dot(last.normal) > kOpposite) continue;
      const Tightest here{joined(from->second, last), static_cast<Index>(at.first)};
      if (!(here.way.length < (1 - kTight) * here.way.need)) continue;
      const auto [place, is_new] = found.try_emplace({from->first.second, at.second}, here);
      if (!is_new && lacks(here.way) > lacks(place->second.way)) place->second = here;
    }
  return found;
}

}  // namespace

std::vector<Nip> ContactReadings::nips() const {
  const ContactSurfaces& surfaces = state_.surfaces;
  const contact::Scene& scene = surfaces.scene();
  const auto is_given = [&](std::int32_t surface) {
    const int body = surfaces.body_of(surface);
    return body >= 0 &&
           surfaces.bodies().readings().inverse_mass_pressed(static_cast<std::size_t>(body)) <= 0;
  };
  std::vector<std::int32_t> given;
  double skin = 0;
  for (const auto& it : scene.interactions()) {
    skin = std::max(skin, it.law.gap());
    if (!it.rigid && is_given(it.second)) given.push_back(it.second);
  }
  std::sort(given.begin(), given.end());
  if (!state_.overlaps.empty() || std::unique(given.begin(), given.end()) - given.begin() < 2) return {};

  std::vector<Vec3> x(state_.x.size());
  state_.positions(state_.configuration.x(), 0, x);
  std::vector<Over> links;
  Reaches direct;
  for (const contact::Candidate& c : contact::find_pairs(scene, x, skin)) {
    const auto& it = scene.interactions()[static_cast<std::size_t>(c.interaction)];
    const bool facet = c.pair.kind == contact::PairKind::facet,
               plane = c.pair.kind == contact::PairKind::plane,
               ball = c.pair.kind == contact::PairKind::centre;
    if (it.rigid || c.spot.any() || !(facet || plane || ball)) continue;
    if (static_cast<std::size_t>(c.point[0]) >= surfaces.nodes()) continue;
    const contact::Corners corners = contact::corners_of(c, x);
    const contact::Touch touch = facet   ? contact::point_triangle(corners).touch
                                 : plane ? contact::point_plane(corners)
                                         : contact::point_point(corners, 0, 1);
    const Reach part{
        touch.distance - c.pair.offset, it.law.gap(), it.law.floor(), touch.normal, {c.interaction}};
    if (is_given(it.second))
      put(direct, {c.point[0], it.second}, part);
    else if (it.first != it.second && surfaces.body_of(it.second) < 0)
      for (int k = 1; k < 4; ++k) links.push_back({c.point[k], c.point[0], part});
  }

  const auto worst = tightest(lengthened(direct, links, surfaces.sheets()), direct);
  std::vector<Nip> found;
  for (const auto& [bodies, w] : worst) {
    Nip nip{surfaces.name_of(bodies.first),
            surfaces.name_of(bodies.second),
            w.way.through.size() - 1,
            w.way.length,
            w.way.need,
            w.way.floor,
            pressure_on(w.way, scene.interactions()),
            0,
            w.node};
    nip.carried = std::numeric_limits<double>::infinity();
    for (const std::int32_t i : w.way.through) {
      const auto& law = scene.interactions()[static_cast<std::size_t>(i)].law;
      nip.carried = std::min(nip.carried, law(law.guard_gap()).pressure);
    }
    found.push_back(std::move(nip));
  }
  return found;
}

}  // namespace fabricsh::mechanics
