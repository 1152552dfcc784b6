#include "mechanics/terms/contact_readings.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "contact/touch.hpp"

namespace fabricsh::mechanics {

namespace {

// A third of each facet for each of its corners, as a vector along the facet's normal, m2.
std::vector<Vec3> areas(const std::vector<contact::Triangle>& triangles, std::span<const Vec3> at) {
  std::vector<Vec3> all(at.size(), Vec3::Zero());
  for (const auto& t : triangles) {
    const auto corner = [&](int c) { return at[static_cast<std::size_t>(t[static_cast<std::size_t>(c)])]; };
    const Vec3 third = (corner(1) - corner(0)).cross(corner(2) - corner(0)) / 6;
    for (const auto c : t) all[static_cast<std::size_t>(c)] += third;
  }
  return all;
}

}  // namespace

const ContactReadings::Reading& ContactReadings::read() const {
  const Configuration& cloth = state_.configuration;
  Reading& r = reading_;
  if (r.version == cloth.version() && !r.x.empty()) return r;
  r.version = cloth.version();
  r.x.resize(state_.x.size());
  state_.positions(cloth.x(), state_.share, r.x);
  settling_.open_to(cloth.time());
  r.force.assign(r.x.size(), Vec3::Zero());
  if (!state_.surfaces.any()) {
    r.at_points.gap.assign(r.x.size(), std::numeric_limits<double>::infinity());
    r.at_points.pressure.assign(r.x.size(), 0);
    return r;
  }
  r.totals = state_.pairs.add_forces(r.x, r.force);
  r.at_points = state_.pairs.at_points(r.x);
  return r;
}

ContactReadings::NearestPair ContactReadings::nearest() const {
  const auto found = state_.pairs.nearest(read().x);
  return {found.gap, found.point};
}

std::vector<contact::Contact::Overlap> ContactReadings::crossings() const {
  constexpr double least = 0.1;
  return state_.pairs.crossings(read().x, least);
}

double ContactReadings::gap(Index node) const {
  return read().at_points.gap[static_cast<std::size_t>(state_.surfaces.point_of(node))];
}

double ContactReadings::pressure(Index node) const {
  return read().at_points.pressure[static_cast<std::size_t>(state_.surfaces.point_of(node))];
}

// m: how near a node has to be to a body's surface to be pressed by it; below 0 where the two do not meet.
double ContactReadings::touches_within(Index node, int of_body) const {
  double most = -1;
  const contact::Scene& scene = state_.surfaces.scene();
  const auto& surfaces = scene.surfaces();
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].shape != contact::Shape::cloth ||
        !std::binary_search(surfaces[s].points.begin(), surfaces[s].points.end(), node))
      continue;
    const auto* meets = scene.between(static_cast<std::int32_t>(s), of_body);
    if (meets != nullptr)
      most = std::max(most, meets->law.gap() + surfaces[static_cast<std::size_t>(of_body)].radius);
  }
  return most;
}

OnSkin ContactReadings::on_skin(std::size_t i) const {
  const Reading& now = read();
  const Bodies& bodies = state_.surfaces.bodies();
  const model::Rigid& body = bodies.body(i);
  const std::size_t nodes = state_.surfaces.nodes(), first = nodes + bodies.vertices(i).first;
  const auto begin = static_cast<std::int32_t>(first),
             end = begin + static_cast<std::int32_t>(body.facets()->vertices.size());
  OnSkin out;
  out.at.assign(now.x.begin() + begin, now.x.begin() + end);
  const std::vector<Vec3> across = areas(body.facets()->triangles, out.at);
  for (std::size_t v = 0; v < across.size(); ++v) {
    const double area = across[v].norm();
    const Vec3& force = now.force[first + v];
    out.area.push_back(area);
    out.pressure.push_back(area > 0 ? -force.dot(across[v]) / (area * area) : 0);
  }
  // The nearest facet of the body to each node that is near to any.
  struct NearestVertex {
    double distance = std::numeric_limits<double>::infinity();
    std::array<std::int32_t, 3> corner{};
    std::array<double, 3> weight{};
  };
  std::map<std::int32_t, NearestVertex> nearest;
  state_.pairs.couples(now.x, [&](const std::array<std::int32_t, 4>& p) {
    const bool facet = p[0] >= 0 && p[0] < static_cast<std::int32_t>(nodes) &&
                       std::all_of(p.begin() + 1, p.end(), [&](auto c) { return c >= begin && c < end; });
    if (!facet) return;
    const auto touch = contact::point_triangle(
                           {now.x[static_cast<std::size_t>(p[0])], now.x[static_cast<std::size_t>(p[1])],
                            now.x[static_cast<std::size_t>(p[2])], now.x[static_cast<std::size_t>(p[3])]})
                           .touch;
    NearestVertex& best = nearest[p[0]];
    if (touch.distance < best.distance)
      best = {touch.distance,
              {p[1] - begin, p[2] - begin, p[3] - begin},
              {-touch.weight[1], -touch.weight[2], -touch.weight[3]}};
  });
  const std::vector<Vec3>& reference = body.facets()->vertices;
  for (const auto& [node, best] : nearest) {
    if (!(best.distance < touches_within(node, bodies.state().bodies[i].surface))) continue;
    Vec3 place = Vec3::Zero();
    for (std::size_t c = 0; c < 3; ++c)
      place += best.weight[c] * reference[static_cast<std::size_t>(best.corner[c])];
    out.node.push_back(node);
    out.place.push_back(place);
  }
  return out;
}

}  // namespace fabricsh::mechanics
