// Which pairs are near: a sorted uniform grid over the cloth.
#pragma once
#include "contact/scene.hpp"

namespace fabricsh::contact {

struct Candidate {
  std::array<std::int32_t, 4> point{-1, -1, -1, -1};  // corners; -1: none
  std::int32_t interaction = 0;
  Pair pair;
  std::int32_t facet = -1;   // row of Scene::triangles; -1: the pair has none whose sides and corners count
  std::uint8_t shared = 0;   // of TriangleRow::shared, what counts for the point in any of its triangles
  Spot spot;                 // where the first corner is a contact point inside a facet
  double whole = 1;          // pair.scale, once an overlap of the start has been opened
  double start = 1;          // the share of it with which such a pair begins (Interaction::opening)
  bool crack_faces = false;  // whether its sides were joined before; see Scene::set_apart
};

// All pairs that are nearer than their gap plus `skin` (m) at the positions `x` (cloth and rigid
// vertices). Their order depends on the surfaces only, so that it is the same for any skin and any number
// of threads. Pairs of one cloth that share a node are left out. For neighbours whose reference distance
// is smaller than the gap, the law's lengths are scaled down so that the gap is 0.9 of that distance. Crack
// faces that shared a node before are no neighbours. by: m, displacements of all points, with which no two
// that come nearer than the gap come nearer by more than `skin`; then only the pairs are found that
// safe_fraction() may stop on that way. Those with walls, which are larger than their corners show, stay.
std::vector<Candidate> find_pairs(const Scene& scene, std::span<const Vec3> x, double skin,
                                  std::span<const Vec3> by = {});

// A way ends where a pair has less than a tenth of its distance to the floor left (safe_fraction). So none
// stops a way that is shorter than that distance by more than this factor, rounding included.
constexpr double room_of_way = 1 / 0.89;
// m: from that distance on a pair is not looked at for the way `by` (m), on which near surfaces come nearer
// to each other by `most` (m): it does not stop it, or does not come within reach of the law. What is between
// its corners moves by means of these.
double reach_on_way(const Candidate& candidate, const ContactLaw& law, std::span<const Vec3> by, double most);

// Distance of a pair less its radii, m.
double gap_of(const Candidate& candidate, const Corners& x);
Corners corners_of(const Candidate& candidate, std::span<const Vec3> x);

}  // namespace fabricsh::contact
