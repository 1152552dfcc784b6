#include "mechanics/terms/tears.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

namespace {

// The stiffness with which a cohesive spring unloads in explicit motion, as a share of m / dt^2, m being the
// mass of both crack faces taken together. Waves in the cloth have 1.96 of the 4 that central differences
// bear; two springs that meet at a corner add twice this share each.
constexpr double kStiffest = 0.5;

// Distance of the origin from closed crack faces over the opening at which a spring carries nothing more,
// where steps are not explicit: unloading is a thousand times stiffer than loading, and the direction of the
// force is that at the opening as long as the crack faces part less than this.
constexpr double kOrigin = 1e-3;

// Share of the opening left at which a spring ends in steps along a path.
constexpr double kLast = 1e-3;

// Share of its strength from which a line is measured at each explicit step.
constexpr double kNearEdge = 0.9;

const char* const kYarn[] = {"warp", "weft"};

Vec3 sum(const std::vector<Index>& nodes, std::span<const double> x) {
  Vec3 all = Vec3::Zero();
  for (const Index n : nodes) all += at(x, n);
  return all;
}

Vec3 mean(const std::vector<Index>& nodes, std::span<const double> x) {
  return sum(nodes, x) / static_cast<double>(nodes.size());
}

// The part of a force that crossing yarns carry: along them, and across the sheet. A yarn that is pulled out
// of the sheet turns there within less than an element, so that all of that force is along it; what acts
// along the line shears the crossings and pulls no yarn.
double carried(const Vec3& force, const Vec3& yarn, const Vec3& line) {
  const Vec3 along = yarn.normalized(), normal = along.cross(line);
  const double size = normal.norm(), out = size > 0 ? force.dot(normal) / size : 0;
  return std::hypot(std::max(0.0, force.dot(along)), out);
}

}  // namespace

// --- one spring

Vec3 CohesiveSpring::way(std::span<const double> x) const {
  return at(x, b) - at(x, a) + offset * force.normalized();
}

double CohesiveSpring::vanishes() const { return 2 * energy / force.norm(); }

double CohesiveSpring::strength() const { return force.norm() * std::max(0.0, 1 - widest / vanishes()); }

Vec3 CohesiveSpring::pull(const Vec3& way) {
  const double opening = way.norm() - offset;
  widest = std::max(committed, opening);
  return strength() / (widest + offset) * way;
}

double CohesiveSpring::stored(const Vec3& way) const {
  return strength() / (widest + offset) * (way.squaredNorm() - offset * offset) / 2;
}

// The work on the way to the largest opening, less what comes back on the way from there to closed crack
// faces.
double CohesiveSpring::lost() const {
  const double w = std::min(widest, vanishes());
  const double work = force.norm() * w * (1 - w / (2 * vanishes()));
  return work - strength() * w * (w + 2 * offset) / (2 * (w + offset));
}

// On the way out a spring softens along itself; on the way back, and across itself, it is linear.
Mat3 CohesiveSpring::stiffness(const Vec3& way, bool onwards) const {
  const double held = strength();
  if (held == 0) return Mat3::Zero();
  Mat3 k = held / (widest + offset) * Mat3::Identity();
  const bool there = way.norm() - offset > committed - 1e-9 * vanishes();
  if (widest > committed || (onwards && outwards && there)) {
    const Vec3 along = way.normalized();
    k -= (held / (widest + offset) + force.norm() / vanishes()) * along * along.transpose();
  }
  return k;
}

// --- forces

Outcome Tears::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const auto x = trial.configuration.x();
  for (CohesiveSpring& spring : springs_) {
    const Vec3 pull = spring.pull(spring.way(x));
    at(forces.on_x, spring.a) -= pull;
    at(forces.on_x, spring.b) += pull;
  }
  measure(x, forces.on_x);
  return {};
}

// Both sides of a line have the acceleration of their joint: what one hands to the other is what keeps them
// together, T = (m2 f1 - m1 f2) / (m1 + m2) with the internal forces f. Without motion it is f1 = -f2.
void Tears::measure(const Line& line, std::span<const double> x, std::span<const double> on_x) const {
  const Vec3 force = (line.mass[1] * sum(line.nodes[0], on_x) - line.mass[0] * sum(line.nodes[1], on_x)) /
                     (line.mass[0] + line.mass[1]);
  const Vec3 yarn = mean(line.far[1], x) - mean(line.far[0], x);
  const Vec3 way = mean(line.ends[0], x) - mean(line.ends[1].empty() ? line.nodes[0] : line.ends[1], x);
  line.force = force;
  line.share = carried(force, yarn, way) /
               (line.length * sites_[line.site].strength[static_cast<std::size_t>(line.family)]);
}

void Tears::measure(std::span<const double> x, std::span<const double> on_x) {
  if (sparing_) return measure_near(x, on_x);
  for (const Line& line : lines_) measure(line, x, on_x);
  all_are_near();
  all_known_ = true;
}

void Tears::go_explicit() {
  sparing_ = true;
  set_limits();
}

// |T| is at most the mean of the sums of |f| on both sides, weighted by the masses of the other one. With n
// nodes on the side that has more, whose forces have no component above c, it is below sqrt(3) n c.
void Tears::set_limits() {
  if (!sparing_) return;
  const std::size_t nodes = model_.mesh().nodes.size();
  limits_.assign(3 * nodes, std::numeric_limits<double>::infinity());
  std::vector<std::vector<std::uint32_t>> at(nodes);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& line = lines_[i];
    const double strength = line.length * sites_[line.site].strength[static_cast<std::size_t>(line.family)];
    const auto most = static_cast<double>(std::max(line.nodes[0].size(), line.nodes[1].size()));
    const double limit = kNearEdge * strength / (std::sqrt(3.0) * most);
    for (const auto& side : line.nodes)
      for (const Index n : side) {
        at[static_cast<std::size_t>(n)].push_back(static_cast<std::uint32_t>(i));
        for (std::size_t c = 0; c < 3; ++c) {
          double& least = limits_[3 * static_cast<std::size_t>(n) + c];
          least = std::min(least, limit);
        }
      }
  }
  first_line_.assign(1, 0);
  lines_at_.clear();
  for (const auto& lines : at) {
    lines_at_.insert(lines_at_.end(), lines.begin(), lines.end());
    first_line_.push_back(lines_at_.size());
  }
  listed_.assign(lines_.size(), 0);
}

void Tears::measure_near(std::span<const double> x, std::span<const double> on_x) {
  constexpr std::size_t block = 192;
  for (const std::size_t i : near_) listed_[i] = 0;
  near_.clear();
  all_known_ = false;
  for (std::size_t from = 0; from < on_x.size(); from += block) {
    const std::size_t to = std::min(on_x.size(), from + block);
    int above = 0;
    for (std::size_t k = from; k < to; ++k) above |= std::abs(on_x[k]) > limits_[k] ? 1 : 0;
    if (above == 0) continue;
    for (std::size_t k = from; k < to; ++k) {
      if (!(std::abs(on_x[k]) > limits_[k])) continue;
      for (std::size_t i = first_line_[k / 3]; i < first_line_[k / 3 + 1]; ++i)
        if (char& listed = listed_[lines_at_[i]]; listed == 0) {
          listed = 1;
          near_.push_back(lines_at_[i]);
        }
    }
  }
  std::sort(near_.begin(), near_.end());  // the first of equal ones is the worst, whatever was found first
  for (const std::size_t i : near_) measure(lines_[i], x, on_x);
}

std::vector<double> Tears::last_forces() const {
  std::vector<double> on_x(3 * model_.mesh().nodes.size()), on_d(on_x.size());
  Forces forces{on_x, on_d};
  cloth_.sum_forces(forces);
  for (CohesiveSpring spring : springs_) {
    const Vec3 pull = spring.pull(spring.way(configuration_.x()));
    at(forces.on_x, spring.a) -= pull;
    at(forces.on_x, spring.b) += pull;
  }
  return on_x;
}

void Tears::know_all() const {
  if (all_known_) return;
  const std::vector<double> on_x = last_forces();
  for (const Line& line : lines_) measure(line, configuration_.x(), on_x);
  all_known_ = true;
}

Tears::WorstPlace Tears::at_support() const {
  WorstPlace worst;
  if (grips_.empty()) return worst;
  const std::vector<double> on_x = last_forces();
  const auto x = configuration_.x();
  for (const Grip& grip : grips_) {
    const Site& site = sites_[grip.site];
    const Vec3 yarn = sum(grip.far, x) / static_cast<double>(grip.far.size()) - at(x, grip.nodes.front());
    const double strength = site.strength[static_cast<std::size_t>(grip.family)];
    const double share = -sum(grip.nodes, on_x).dot(yarn.normalized()) / (grip.length * strength);
    if (share > worst.share)
      worst = {share, strength, kYarn[grip.family], dofs_.reference()[static_cast<std::size_t>(site.place)]};
  }
  return worst;
}

void Tears::add_tangent(const Trial& trial, TangentSink& sink) const {
  for (const CohesiveSpring& spring : springs_) {
    const Mat3 k = spring.stiffness(spring.way(trial.configuration.x()), onwards_);
    sink.on_positions(spring.a, spring.a, k);
    sink.on_positions(spring.b, spring.b, k);
    sink.on_positions(spring.a, spring.b, -k);
    sink.on_positions(spring.b, spring.a, -k);
  }
}

void Tears::couple(const Trial&, std::vector<NodePair>& pairs) {
  for (const CohesiveSpring& spring : springs_) pairs.emplace_back(spring.a, spring.b);
}

void Tears::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  double stored = 0, lost = 0;
  for (const CohesiveSpring& spring : springs_) {
    stored += spring.stored(spring.way(trial.configuration.x()));
    lost += spring.lost();
  }
  out.push_back({"bridges", Account::stored, stored});
  out.push_back({"fracture", Account::dissipated, lost});
}

// --- opening

Tears::WorstPlace Tears::worst() const {
  const Line* most = nullptr;
  for (const std::size_t i : near_)
    if (most == nullptr || most->share < lines_[i].share) most = &lines_[i];
  if (most == nullptr) return {};
  const Site& site = sites_[most->site];
  return {most->share, site.strength[static_cast<std::size_t>(most->family)], kYarn[most->family],
          dofs_.reference()[static_cast<std::size_t>(site.place)]};
}

// The springs share the force of their line by the lengths for which they stand.
std::vector<Joints::Edge> Tears::let_go(double step) {
  std::vector<Joints::Edge> ends;
  for (const std::size_t i : near_) {
    const Line& line = lines_[i];
    if (!(line.share >= 1)) continue;
    const Site& site = sites_[line.site];
    const double mass = line.mass[0] * line.mass[1] / (line.mass[0] + line.mass[1]);
    for (const Line::Spoke& spoke : line.spokes) {
      ends.emplace_back(site.place, spoke.place);
      const double part = spoke.length / line.length;
      CohesiveSpring spring;
      spring.a = spoke.a;
      spring.b = spoke.b;
      spring.family = line.family;
      spring.force = part * line.force;
      spring.energy = site.energy[static_cast<std::size_t>(line.family)] * spoke.length;
      spring.offset =
          step > 0 ? line.force.norm() * step * step / (kStiffest * mass) : kOrigin * spring.vanishes();
      ready_.push_back(spring);
    }
  }
  return ends;
}

// The forces of springs that begin are those that the closed joint carried.
void Tears::renumbered(Forces& forces) {
  for (const CohesiveSpring& spring : ready_) {
    at(forces.on_x, spring.a) -= spring.force;
    at(forces.on_x, spring.b) += spring.force;
  }
  springs_.insert(springs_.end(), ready_.begin(), ready_.end());
  ready_.clear();
  find_lines();
  know_all();
  all_are_near();
  committed_share_ = worst().share;
}

void Tears::all_are_near() {
  near_.resize(lines_.size());
  std::iota(near_.begin(), near_.end(), std::size_t{0});
}

void Tears::commit() {
  for (CohesiveSpring& spring : springs_) {
    spring.outwards = spring.widest > spring.committed && spring.committed < spring.vanishes();
    // A path turns where the spring is gone. Steps along it end before such a place or well beyond, and from
    // before it ever nearer: from the last millionth of its energy on the spring is gone.
    if (onwards_ && spring.outwards && spring.widest > (1 - kLast) * spring.vanishes())
      spring.widest = std::max(spring.widest, spring.vanishes());
    spring.committed = spring.widest;
  }
  committed_share_ = worst().share;
}

bool Tears::opens() const {
  return std::any_of(springs_.begin(), springs_.end(), [](const CohesiveSpring& s) { return s.outwards; });
}

double Tears::opening(const NodalRates& moved) const {
  double sum = 0;
  const auto x = configuration_.x();
  for (const CohesiveSpring& spring : springs_)
    if (spring.outwards)
      sum +=
          spring.way(x).normalized().dot(at(std::span(moved.x), spring.b) - at(std::span(moved.x), spring.a));
  return sum;
}

void Tears::rollback() {
  for (CohesiveSpring& spring : springs_) spring.widest = spring.committed;
}

void Tears::keep(Archive& archive) {
  archive(springs_, commits_);
  know_all();
  for (Line& line : lines_) archive(line.share);
  if (!archive.reading()) return;
  all_are_near();
  rollback();
  committed_share_ = worst().share;
}

// Sites ascend by their places, and lines by their sites.
double Tears::share(Index element, int family) const {
  know_all();
  double most = 0;
  const auto& nodes = cloth_.model().mesh().elements[static_cast<std::size_t>(element)];
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
  for (const CohesiveSpring& spring : springs_)
    if (std::find(nodes.begin(), nodes.end(), spring.a) != nodes.end() ||
        std::find(nodes.begin(), nodes.end(), spring.b) != nodes.end())
      most = std::max(most, spring.family == family ? 1.0 : 0.0);
  return most;
}

}  // namespace fabricsh::mechanics
