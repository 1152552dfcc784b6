#include "mechanics/terms/contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kFibre = 1500;       // kg/m3, density of fibres (cotton 1540, polyester 1380)
constexpr double kLeast = 0.75;       // largest floor, as a share of the thickness
constexpr double kOfCloth = 0.6;      // largest step with contact, as a share of the cloth's stable step
constexpr double kCarried = 0.2;      // stiffness * step^2 / areal mass
constexpr double kInGuard = 1;        // the same while the guard acts
constexpr double kCreep = 2e-4;       // sliding over which friction rises, as a share of the mean edge
constexpr std::size_t kShare = 4096;  // number of nodes from which loops use several threads
constexpr std::size_t kTold = 5;      // number of overlaps named in a message

contact::Scene scene_of(const model::Model& model, const model::Surfaces& surfaces) {
  const auto& mesh = model.mesh();
  contact::Scene scene(mesh.nodes);
  for (const auto& elements : surfaces.elements) {
    std::vector<std::array<mesh::Index, 4>> rows;
    for (const Index e : elements) rows.push_back(mesh.elements[e]);
    scene.add_cloth(rows);
  }
  return scene;
}

double mean_edge(const contact::Scene& scene) {
  double sum = 0;
  for (const auto& edge : scene.edges()) sum += edge.length;
  return scene.edges().empty() ? 0 : sum / static_cast<double>(scene.edges().size());
}

}  // namespace

Contacts::Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                   const Freedoms& freedoms)
    : Contacts(model, configuration, cloth, freedoms,
               model::work_out_surfaces(model.interactions(), model.mesh())) {}

Contacts::Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                   const Freedoms& freedoms, const model::Surfaces& surfaces)
    : model_(model),
      configuration_(configuration),
      cloth_(cloth),
      scene_(scene_of(model, surfaces)),
      bodies_(model, scene_),
      least_areal_(std::numeric_limits<double>::infinity()),
      step_(kOfCloth * cloth.stable_step(true)),
      nodes_(model.mesh().nodes.size()) {
  for (const auto& elements : surfaces.elements) {
    sheets_.push_back(sheet(elements));
    least_areal_ = std::min(least_areal_, sheets_.back().areal);
  }
  creep_ = kCreep * mean_edge(scene_);
  for (const model::Meeting& m : surfaces.meetings) {
    const double friction = model.interactions().contacts()[m.contact].friction;
    scene_.meet(m.first, m.second, law_of(m), friction);
    friction_ = friction_ || friction > 0;
  }
  moves_ = bodies_.any_free() || bodies_.any_driven();
  contact_ = std::make_unique<contact::Contact>(scene_);
  x_ = start_ = scene_.reference();
  force_.assign(x_.size(), Vec3::Zero());
  velocity_ = force_;
  find_masses(freedoms);
  refuse_overlaps();
}

Contacts::Sheet Contacts::sheet(const std::vector<Index>& elements) const {
  Sheet out{0, 0, std::numeric_limits<double>::infinity()};
  for (const Index e : elements) {
    const auto& section = model_.sections()[model_.region_of(e)];
    out.thickness = std::max(out.thickness, section.thickness);
    out.areal = std::min(out.areal, section.areal_mass);
    out.floor = std::max(out.floor, std::min(section.areal_mass / kFibre, kLeast * section.thickness));
  }
  return out;
}

void Contacts::find_masses(const Freedoms& freedoms) {
  inverse_mass_.assign(x_.size(), 0);
  for (std::size_t n = 0; n < nodes_; ++n) {
    const auto& eq = freedoms.nodes[n].equation;
    const bool moves = std::any_of(eq.begin(), eq.begin() + 3, [](Index e) { return e >= 0 || e == tied; });
    if (moves && cloth_.mass()[n] > 0) inverse_mass_[n] = 1 / cloth_.mass()[n];
  }
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    for (std::size_t v = first; v < last; ++v) inverse_mass_[nodes_ + v] = bodies_.inverse_mass(b);
  }
}

// A sheet occupies half of its thickness on either side of its midsurface.
contact::Law Contacts::law_of(const model::Meeting& m) {
  const auto& given = model_.interactions().contacts()[m.contact];
  double gap = 0, floor = 0, areal = std::numeric_limits<double>::infinity();
  for (const int side : {m.first, m.second}) {
    if (side >= static_cast<int>(sheets_.size())) continue;
    const Sheet& sheet = sheets_[side];
    const double thickness = given.thickness.value_or(sheet.thickness);
    gap += thickness / 2;
    floor += std::min(sheet.floor, kLeast * thickness) / 2;
    areal = std::min(areal, sheet.areal);
  }
  const double stiffness = given.stiffness.value_or(kCarried * areal / (step_ * step_));
  const auto name = [&](int side) {
    return side < static_cast<int>(sheets_.size())
               ? std::string(sheets_.size() > 1 ? "cloth " + std::to_string(side + 1) : "the cloth")
               : model_.interactions().name_of(bodies_.body(side - sheets_.size()));
  };
  words_.push_back(
      (m.first == m.second ? name(m.first) + " on itself" : name(m.second) + " on " + name(m.first)) +
      ": from a gap of " + number(gap) + " m, floor " + number(floor) + " m, stiffness " + number(stiffness) +
      " Pa/m" + (given.stiffness ? "" : " (default)") + ", friction " + number(given.friction));
  return contact::Law({gap, floor, stiffness, {}});
}

std::vector<std::string> Contacts::describe() const { return words_; }

double Contacts::largest_step(bool scaled) const {
  double stiffest = 0;
  for (const auto& it : scene_.interactions()) stiffest = std::max(stiffest, it.law.stiffest());
  return std::min(kOfCloth * cloth_.stable_step(scaled), std::sqrt(kCarried * least_areal_ / stiffest));
}

bool Contacts::may_have_passed() {
  if (blocked_ || contact::cannot_meet(moved_, trial_.gap)) return blocked_;
  by_.resize(x_.size());
  for (std::size_t i = 0; i < x_.size(); ++i) by_[i] = x_[i] - start_[i];
  return contact_->safe_share(start_, by_) < 1;
}

double Contacts::carried_step() const {
  double stiffest = 0;
  for (const auto& it : scene_.interactions())
    stiffest = std::max(stiffest, it.law(it.law.floor() + trial_.gap).stiffness);
  return std::sqrt(kInGuard * least_areal_ / stiffest);
}

int Contacts::surface_of(std::int32_t point) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b) {
    const auto [first, last] = bodies_.vertices(b);
    const auto p = static_cast<std::size_t>(point) - nodes_;
    if (p >= first && p < last) return static_cast<int>(b);
  }
  return -1;
}

std::string Contacts::words(const std::array<std::int32_t, 4>& points) const {
  std::string nodes, body;
  int count = 0;
  for (const std::int32_t p : points) {
    if (p < 0) continue;
    if (static_cast<std::size_t>(p) >= nodes_) {
      body = model_.interactions().name_of(bodies_.body(surface_of(p)));
      continue;
    }
    nodes += (count++ > 0 ? ", " : "") + std::to_string(p + 1);
  }
  std::string words = count > 1 ? "nodes " + nodes : "node " + nodes;
  return body.empty() ? words : words + " and the " + body;
}

void Contacts::refuse_overlaps() {
  positions(configuration_.x(), 0, x_);
  const auto overlaps = contact_->overlaps(x_);
  if (overlaps.empty()) return;
  std::string text = "contact: " + std::to_string(overlaps.size()) +
                     (overlaps.size() == 1 ? " pair overlaps" : " pairs overlap") + " at the start:";
  for (std::size_t i = 0; i < std::min(kTold, overlaps.size()); ++i)
    text += (i > 0 ? "; " : " ") + words(overlaps[i].point) +
            (overlaps[i].gap > 0 ? ", " + number(overlaps[i].gap) + " m apart" : ", one through the other");
  if (overlaps.size() > kTold) text += "; ...";
  throw Error(text + "; expected all of it apart");
}

// --- forces

void Contacts::positions(std::span<const double> x, double share, std::vector<Vec3>& out) const {
#pragma omp parallel for schedule(static) if (nodes_ >= kShare)
  for (std::size_t n = 0; n < nodes_; ++n) out[n] = at(x, static_cast<Index>(n));
  const auto from = bodies_.committed(), to = bodies_.target();
  for (std::size_t v = 0; v < from.size(); ++v)
    out[nodes_ + v] = share >= 1 ? to[v] : share <= 0 ? from[v] : Vec3(from[v] + share * (to[v] - from[v]));
}

// Velocities half a step ago, from the motion in the step, and the largest motion of any point.
void Contacts::find_motion(double dt) {
  positions(configuration_.committed_kinematics(), 0, start_);
  double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most) if (nodes_ >= kShare)
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const Vec3 moved = x_[i] - start_[i];
    most = std::max(most, moved.squaredNorm());
    if (friction_) velocity_[i] = moved / dt;
  }
  moved_ = std::sqrt(most);
}

Outcome Contacts::add_forces(const law::Step& step, const Trial& trial, Forces& forces) {
  positions(trial.configuration.x(), share_, x_);
  const bool steps = step.dt > 0;
  if (explicit_ && steps) find_motion(step.dt);
  const contact::Motion motion{velocity_, inverse_mass_, step.dt};
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  trial_ = contact_->add_forces(x_, force_, explicit_ && steps && friction_ ? &motion : nullptr);
  trial_lost_ = explicit_ ? step.dt * (power_ + trial_.lost) / 2 : 0;
  evaluated_ = true;
  blocked_ = !(trial_.gap > 0);
  if (blocked_) {
    Outcome passed{Answer::cut, -1, "surfaces that touch would pass through each other"};
    for (std::size_t n = 0; n < nodes_ && passed.element < 0; ++n)
      if (!force_[n].allFinite()) passed.element = cloth_.element_at(static_cast<Index>(n));
    return passed;
  }
  if (!explicit_ && friction_ && trial_.touching > 0) {
    positions(configuration_.committed_kinematics(), 0, start_);
    trial_lost_ = contact_->add_friction(x_, start_, creep_, force_);
  }
  bodies_.load(std::span(force_).subspan(nodes_));
  if (trial_.touching == 0) return {};
#pragma omp parallel for schedule(static) if (nodes_ >= kShare)
  for (std::size_t n = 0; n < nodes_; ++n) at(forces.on_x, static_cast<Index>(n)) -= force_[n];
  return {};
}

void Contacts::add_energies(const Trial&, std::vector<Energy>& out) const {
  const contact::Totals& totals = evaluated_ ? trial_ : committed_;
  out.push_back({"contact", Account::stored, totals.contact});
  out.push_back({"guard", Account::stored, totals.guard});
  out.push_back({"friction", Account::dissipated, lost_ + (evaluated_ ? trial_lost_ : 0)});
  out.push_back({"rigid", Account::moving, bodies_.kinetic()});
}

// --- tangent

// Computes the stiffness of the touching pairs. If it couples nodes not coupled so far, all pairs that
// are near are added, so that the pattern grows seldom. The coupled pairs depend only on the states
// visited.
void Contacts::prepare_tangent(const Trial& trial) {
  positions(trial.configuration.x(), share_, x_);
  positions(configuration_.committed_kinematics(), 0, start_);
  blocks_.clear();
  bool known = true;
  const auto add = [&](const std::array<std::int32_t, 4>& points, auto&& visit) {
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) {
        const std::int64_t p = points[a], q = points[b];
        if (p < 0 || q < 0) continue;
        const auto [low, high] = std::minmax(p, q);
        if (high < static_cast<std::int64_t>(nodes_)) visit(low * static_cast<std::int64_t>(nodes_) + high);
      }
  };
  contact_->stiffness(
      x_,
      [&](const std::array<std::int32_t, 4>& points, const contact::Matrix12& k) {
        blocks_.push_back({points, k});
        add(points, [&](std::int64_t pair) {
          known = known && std::binary_search(pairs_.begin(), pairs_.end(), pair);
        });
      },
      friction_ ? std::span<const Vec3>(start_) : std::span<const Vec3>(), creep_);
  if (known) return;
  const double skin = mean_edge(scene_) / 3;
  for (const auto& candidate : contact::find_pairs(scene_, x_, skin))
    add(candidate.point, [&](std::int64_t pair) { pairs_.push_back(pair); });
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

void Contacts::couple(const Trial& trial, std::vector<NodePair>& pairs) {
  prepare_tangent(trial);
  for (const std::int64_t pair : pairs_)
    pairs.emplace_back(pair / static_cast<std::int64_t>(nodes_), pair % static_cast<std::int64_t>(nodes_));
}

void Contacts::add_tangent(const Trial&, TangentSink& sink) const {
  const auto from = bodies_.committed(), to = bodies_.target();
  for (const Block& block : blocks_)
    for (int a = 0; a < 4; ++a) {
      const std::int32_t p = block.point[a];
      if (p < 0 || p >= static_cast<std::int32_t>(nodes_)) continue;
      for (int b = 0; b < 4; ++b) {
        const std::int32_t q = block.point[b];
        if (q < 0) continue;
        const Mat3 k = block.k.block<3, 3>(3 * a, 3 * b);
        if (q < static_cast<std::int32_t>(nodes_))
          sink.on_positions(p, q, k);
        else if (moves_)
          sink.on_lead(p, k * (1 - share_) * (to[q - nodes_] - from[q - nodes_]));
      }
    }
}

// --- steps

void Contacts::mark(const Trial& trial) {
  marked_.resize(x_.size());
  by_.resize(x_.size());
  positions(trial.configuration.x(), share_, marked_);
}

double Contacts::safe_share(const Trial& trial) {
  positions(trial.configuration.x(), share_, by_);
  double most = 0;
  for (std::size_t i = 0; i < by_.size(); ++i) {
    by_[i] -= marked_[i];
    most = std::max(most, by_[i].squaredNorm());
  }
  if (evaluated_ && contact::cannot_meet(std::sqrt(most), trial_.gap)) return 1;
  return contact_->safe_share(marked_, by_);
}

void Contacts::commit() {
  if (evaluated_) {
    committed_ = trial_;
    lost_ += trial_lost_;
    power_ = trial_.lost;
  }
  trial_lost_ = 0;
  evaluated_ = false;
  share_ = at_ = 0;
  bodies_.commit();
}

void Contacts::rollback() {
  evaluated_ = blocked_ = false;
  share_ = at_ = 0;
  bodies_.rollback();
}

void Contacts::keep(Archive& archive) {
  bodies_.keep(archive);
  archive(committed_.contact, committed_.guard, committed_.lost, committed_.gap, lost_, power_, pairs_);
  if (!archive.reading()) return;
  reading_.version = 0;
}

// --- reading

int Contacts::find_body(const model::Rigid& body) const {
  for (std::size_t b = 0; b < bodies_.count(); ++b)
    if (&bodies_.body(b) == &body) return static_cast<int>(b);
  return -1;
}

const Contacts::Reading& Contacts::read() const {
  if (reading_.version == configuration_.version() && !reading_.x.empty()) return reading_;
  reading_.version = configuration_.version();
  reading_.x.resize(x_.size());
  positions(configuration_.x(), share_, reading_.x);
  std::vector<Vec3> force(x_.size(), Vec3::Zero());
  reading_.totals = contact_->add_forces(reading_.x, force);
  return reading_;
}

Contacts::Nearest Contacts::nearest() const {
  const auto found = contact_->nearest(read().x);
  return {found.gap, found.point};
}

double Contacts::gap(Index node) const {
  read();
  return contact_->gaps()[node];
}

double Contacts::pressure(Index node) const {
  read();
  return contact_->pressures()[node];
}

}  // namespace fabricsh::mechanics
