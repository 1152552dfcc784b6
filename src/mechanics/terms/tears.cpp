#include "mechanics/terms/tears.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

namespace {

// Share of m / dt^2 that a string's way back may have in explicit motion, m being the mass of both lips taken
// together. Waves in the cloth have 1.96 of the 4 that central differences bear; two strings that meet at a
// corner add twice this share each.
constexpr double kStiffest = 0.5;

// Distance of the origin from closed lips over the opening at which a string carries nothing more, where
// steps are not explicit: the way back is a thousand times stiffer than the way out, and the direction of the
// force is that at the opening as long as the lips part less than this.
constexpr double kOrigin = 1e-3;

const char* const kYarn[] = {"warp", "weft"};

Vec3 sum(const std::vector<Index>& nodes, std::span<const double> x) {
  Vec3 all = Vec3::Zero();
  for (const Index n : nodes) all += at(x, n);
  return all;
}

}  // namespace

// --- one string

Vec3 BridgingString::way(std::span<const double> x) const {
  return at(x, b) - at(x, a) + offset * force.normalized();
}

double BridgingString::vanishes() const { return 2 * energy / force.norm(); }

double BridgingString::strength() const { return force.norm() * std::max(0.0, 1 - widest / vanishes()); }

Vec3 BridgingString::pull(const Vec3& way) {
  const double opening = way.norm() - offset;
  widest = std::max(committed, opening);
  return strength() / (widest + offset) * way;
}

double BridgingString::stored(const Vec3& way) const {
  return strength() / (widest + offset) * (way.squaredNorm() - offset * offset) / 2;
}

// The work on the way to the largest opening, less what comes back on the way from there to closed lips.
double BridgingString::lost() const {
  const double w = std::min(widest, vanishes());
  const double work = force.norm() * w * (1 - w / (2 * vanishes()));
  return work - strength() * w * (w + 2 * offset) / (2 * (w + offset));
}

// On the way out a string softens along itself; on the way back, and across itself, it is a spring.
Mat3 BridgingString::stiffness(const Vec3& way) const {
  const double held = strength();
  if (held == 0) return Mat3::Zero();
  Mat3 k = held / (widest + offset) * Mat3::Identity();
  if (widest > committed) {
    const Vec3 along = way.normalized();
    k -= (held / (widest + offset) + force.norm() / vanishes()) * along * along.transpose();
  }
  return k;
}

// --- forces

Outcome Tears::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const auto x = trial.configuration.x();
  for (BridgingString& string : strings_) {
    const Vec3 pull = string.pull(string.way(x));
    at(forces.on_x, string.a) -= pull;
    at(forces.on_x, string.b) += pull;
  }
  measure(x, forces.on_x);
  return {};
}

// Both sides of a line have the acceleration of their joint: what one hands to the other is what keeps them
// together, T = (m2 f1 - m1 f2) / (m1 + m2) with the internal forces f. Without motion it is f1 = -f2.
void Tears::measure(std::span<const double> x, std::span<const double> on_x) {
  for (Line& line : lines_) {
    const Vec3 force = (line.mass[1] * sum(line.nodes[0], on_x) - line.mass[0] * sum(line.nodes[1], on_x)) /
                       (line.mass[0] + line.mass[1]);
    const Vec3 yarn = sum(line.far[1], x) / static_cast<double>(line.far[1].size()) -
                      sum(line.far[0], x) / static_cast<double>(line.far[0].size());
    line.force = force;
    line.share = std::max(0.0, force.dot(yarn.normalized())) /
                 (line.length * sites_[line.site].strength[static_cast<std::size_t>(line.family)]);
  }
}

void Tears::add_tangent(const Trial& trial, TangentSink& sink) const {
  for (const BridgingString& string : strings_) {
    const Mat3 k = string.stiffness(string.way(trial.configuration.x()));
    sink.on_positions(string.a, string.a, k);
    sink.on_positions(string.b, string.b, k);
    sink.on_positions(string.a, string.b, -k);
    sink.on_positions(string.b, string.a, -k);
  }
}

void Tears::couple(const Trial&, std::vector<NodePair>& pairs) {
  for (const BridgingString& string : strings_) pairs.emplace_back(string.a, string.b);
}

void Tears::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  double stored = 0, lost = 0;
  for (const BridgingString& string : strings_) {
    stored += string.stored(string.way(trial.configuration.x()));
    lost += string.lost();
  }
  out.push_back({"bridges", Account::stored, stored});
  out.push_back({"fracture", Account::dissipated, lost});
}

// --- opening

Tears::Worst Tears::worst() const {
  Worst worst;
  const auto most = std::max_element(lines_.begin(), lines_.end(),
                                     [](const Line& a, const Line& b) { return a.share < b.share; });
  if (most == lines_.end()) return worst;
  const Site& site = sites_[most->site];
  return {most->share, site.strength[static_cast<std::size_t>(most->family)], kYarn[most->family],
          dofs_.reference()[static_cast<std::size_t>(site.place)]};
}

// The strings share the force of their line by the lengths for which they stand.
std::vector<Joints::Edge> Tears::let_go(double step) {
  std::vector<Joints::Edge> ends;
  for (const Line& line : lines_) {
    if (!(line.share >= 1)) continue;
    const Site& site = sites_[line.site];
    const double mass = line.mass[0] * line.mass[1] / (line.mass[0] + line.mass[1]);
    for (const Line::Spoke& spoke : line.spokes) {
      ends.emplace_back(site.place, spoke.place);
      const double part = spoke.length / line.length;
      BridgingString string;
      string.a = spoke.a;
      string.b = spoke.b;
      string.family = line.family;
      string.force = part * line.force;
      string.energy = site.energy[static_cast<std::size_t>(line.family)] * spoke.length;
      string.offset =
          step > 0 ? line.force.norm() * step * step / (kStiffest * mass) : kOrigin * string.vanishes();
      ready_.push_back(string);
    }
  }
  return ends;
}

// The forces of strings that begin are those that the closed joint carried.
void Tears::renumbered(Forces& forces) {
  for (const BridgingString& string : ready_) {
    at(forces.on_x, string.a) -= string.force;
    at(forces.on_x, string.b) += string.force;
  }
  strings_.insert(strings_.end(), ready_.begin(), ready_.end());
  ready_.clear();
  find_lines();
  measure(configuration_.x(), forces.on_x);
  committed_share_ = worst().share;
}

void Tears::commit() {
  for (BridgingString& string : strings_) string.committed = string.widest;
  committed_share_ = worst().share;
}

void Tears::rollback() {
  for (BridgingString& string : strings_) string.widest = string.committed;
}

void Tears::keep(Archive& archive) {
  archive(strings_);
  for (Line& line : lines_) archive(line.share);
  if (!archive.reading()) return;
  rollback();
  committed_share_ = worst().share;
}

// Sites ascend by their places, and lines by their sites.
double Tears::share(Index element, int family) const {
  double most = 0;
  const auto& nodes = cloth_.mesh_elements()[static_cast<std::size_t>(element)];
  for (const Index node : nodes) {
    if (node < 0) continue;
    const Index place = model_.mesh().place_of(node);
    const auto site = std::lower_bound(sites_.begin(), sites_.end(), place,
                                       [](const Site& s, Index at) { return s.place < at; });
    if (site == sites_.end() || site->place != place) continue;
    const auto number = static_cast<std::size_t>(site - sites_.begin());
    auto line = std::lower_bound(lines_.begin(), lines_.end(), number,
                                 [](const Line& l, std::size_t at) { return l.site < at; });
    for (; line != lines_.end() && line->site == number; ++line)
      if (line->family == family) most = std::max(most, line->share);
  }
  for (const BridgingString& string : strings_)
    if (std::find(nodes.begin(), nodes.end(), string.a) != nodes.end() ||
        std::find(nodes.begin(), nodes.end(), string.b) != nodes.end())
      most = std::max(most, string.family == family ? 1.0 : 0.0);
  return most;
}

}  // namespace fabricsh::mechanics
