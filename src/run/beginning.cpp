// Beginning from the state of another run.
#include "run/beginning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "card/fields.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/release.hpp"
#include "model/fingerprint.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

// Imbalance of an equilibrium that a run found, over the largest force; above it, something was let go.
constexpr double kBalanced = 1e-6;

// Whether the part says what the cloth is, and not what is done to it.
bool is_of_cloth(const model::FingerprintPart& part) {
  for (const char* name : {"mesh", "region", "thickness", "warp direction", "ties", "tearable zones",
                           "strengths", "seams", "bands", "gas", "reference", "creases"})
    if (part.name.starts_with(name)) return true;
  return false;
}

bool is_of_contact(const model::FingerprintPart& part) {
  return part.name.starts_with("contact of ") || part.name.starts_with("rigid body ");
}

template <class Wanted>
model::Fingerprint parts_that(const model::Model& model, double duration, Wanted wanted) {
  model::Fingerprint parts = model::fingerprint(model, duration);
  std::erase_if(parts, [&](const auto& part) { return !wanted(part); });
  return parts;
}

void add_cards_of(const model::Model& model, model::Fingerprint& parts) {
  for (const auto& region : model.regions()) {
    std::string cards = card::lua_text(region.card);
    for (const auto& ply : region.options.plies) cards += card::lua_text(ply.card);
    parts.push_back({"card" + model::of_region(model, region), region.card.name, hash(cards)});
  }
}

void report_beginning(const Run& from, Run& run) {
  if (!from.moves()) return;
  if (!run.moves())
    run.notices().remark("static: the velocities of the other run, with " + number(from.energy().kinetic) +
                         " J, are left out");
  else if (run.shared_model() != from.shared_model() && !run.model().all<model::InitialVelocity>().empty())
    run.warn(
        "dropped",
        "dynamic: the velocities of the model are dropped, since the run goes on with those of the other "
        "run");
}

// Sets to zero the part of a force that is along freedoms for which `drops` is true.
template <class Drops>
void drop_along(const mechanics::NodeFreedoms& node, Drops drops, Eigen::Ref<Vec3> force) {
  Vec3 f = node.frame * Vec3(force);
  for (int c = 0; c < 3; ++c)
    if (drops(node.equation[c])) f[c] = 0;
  force = node.frame.transpose() * f;
}

}  // namespace

std::string cloth_differs(const model::Model& there, const model::Model& here, double duration) {
  if (&there == &here) return {};
  const auto all = [duration](const model::Model& model) {
    auto parts = parts_that(model, duration, is_of_cloth);
    add_cards_of(model, parts);
    return parts;
  };
  auto one = all(there), other = all(here);
  if (one.front().hash != other.front().hash) one.resize(1), other.resize(1);  // another mesh
  return model::difference(one, other);
}

std::string contact_differs(const model::Model& there, const model::Model& here, double duration) {
  return model::difference(parts_that(there, duration, is_of_contact),
                           parts_that(here, duration, is_of_contact));
}

void Run::check_beginning(const char* kind) const {
  if (const std::string differs = cloth_differs(beginning_.from->model(), *model_, duration_);
      !differs.empty())
    throw Error(std::string(kind) + ": field 'from': expected a run of the same cloth; it differs in " +
                differs);
}

bool Run::same_contact() const {
  return contact_differs(beginning_.from->model(), *model_, duration_).empty();
}

// The strain between the stress-free shape and the mesh is there at the start, in a step of no time.
void Run::take_rest_shape() {
  if (!model_->has_rest()) return;
  for (const std::string& words : assembly_->cloth().rest().told()) notices_->remark(words);
  assembly_->set_time(0);
  if (!assembly_->forces({}))
    throw Error(std::string(kind()) + ": the law fails at the strain of the start, of element " +
                model_->element_name(assembly_->outcome().element));
  assembly_->commit(0);
  double stored = 0;
  for (const auto& energy : assembly_->energies())
    if (energy.account == mechanics::Account::stored) stored += energy.value;
  notices_->remark(std::string(kind()) + ": at the start " + number(stored) +
                   " J are stored in strains from the stress-free shape");
}

void Run::take_beginning() {
  if (beginning_.from == nullptr) {
    if (const auto* const here = std::as_const(*assembly_).terms().find<mechanics::Contacts>())
      here->check_start();
    return take_rest_shape();
  }
  const Run& from = *beginning_.from;
  const bool same = same_contact();
  const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
  if (!same && contact != nullptr && contact->bodies().any_free())
    throw Error(
        std::string(kind()) +
        ": field 'from': a rigid body with a mass goes on where it is only beside the same bodies and "
        "contacts: expected those of the run it begins from");
  if (beginning_.release > 0) release_ = &assembly_->terms().add(std::make_unique<mechanics::Release>());
  assembly_->begin_from(from.assembly(), same);
  trial_time_ = committed_time();
  if (const auto* const rates = from.nodal_rates()) left_rates_ = *rates;
  report_beginning(from, *this);
  release(from);
  Archive state;
  const_cast<mechanics::Assembly&>(from.assembly()).keep(state);  // which changes nothing when written
  double over = beginning_.release;
  state(left_rates_.x, left_rates_.d, over);
  origin_ = hash(state.bytes()) | 1;
  beginning_.from = nullptr;
}

std::string Run::jump_of_motions() const {
  constexpr double far = 1e-6;  // of the mean edge, by which elements are measured
  const auto targets = assembly_->dofs().targets(began_);
  const auto& freedoms = assembly_->dofs().freedoms();
  const auto& X = assembly_->dofs().reference();
  const auto x = std::as_const(*assembly_).state().x();
  double most = far * assembly_->cloth().rates().smallest_size();
  mechanics::Index node = -1;
  for (std::size_t m = 0; m < targets.size(); ++m) {
    const auto& motion = freedoms.motions[m];
    if (motion.component > 2) continue;
    const Vec3 u = freedoms.nodes[motion.node].frame * (at(x, motion.node) - X[motion.node]);
    const double jump = std::abs(targets[m] - u[motion.component]);
    if (jump > most) most = jump, node = motion.node;
  }
  if (node < 0) return {};
  return "the motion of node " + std::to_string(node + 1) + " begins " + number(most) + " m from";
}

// Forces that balanced the state of a run at rest and are gone: of supports, loads, contact. Of a run that
// moves, in which forces need not balance, those of its supports alone.
void Run::release(const Run& from) {
  const auto internal = assembly_->internal();
  std::vector<double> on_x, on_d(internal.on_d.begin(), internal.on_d.end());
  assembly_->terms().external(began_, on_x);
  for (std::size_t i = 0; i < on_x.size(); ++i) on_x[i] = internal.on_x[i] - on_x[i];
  const auto &now = assembly_->dofs().freedoms().nodes, &then = from.assembly().dofs().freedoms().nodes;
  const auto d = std::as_const(*assembly_).state().d();
  for (std::size_t n = 0; n < now.size(); ++n) {
    const auto i = static_cast<std::ptrdiff_t>(n);
    auto turning = at(std::span<double>(on_d), i);
    turning -= at(d, i).dot(turning) * at(d, i);
    drop_along(now[n], mechanics::is_prescribed, at(std::span<double>(on_x), i));
    if (mechanics::is_prescribed(now[n].equation[3])) turning.setZero();
    if (!from.moves()) continue;
    drop_along(
        then[n], [](mechanics::Index e) { return !mechanics::is_prescribed(e); },
        at(std::span<double>(on_x), i));
    if (!mechanics::is_prescribed(then[n].equation[3]) && !mechanics::is_prescribed(then[n].equation[4]))
      turning.setZero();
  }
  std::vector<double> r(static_cast<std::size_t>(assembly_->dofs().unknowns()));
  const std::vector<double> zero(on_x.size(), 0);
  assembly_->dofs().residual(on_x, zero, zero, on_d, nullptr, r);
  let_go_ = assembly_->largest_residual(r).first > kBalanced * assembly_->largest_force();
  if (release_ == nullptr) return;
  if (!let_go_)
    throw Error(
        std::string(kind()) +
        ": field 'release': nothing that held the cloth lets go here: expected a model without one of the "
        "supports or loads of the other run, or no release");
  release_->begin(std::move(on_x), std::move(on_d), began_, beginning_.release);
  assembly_->set_time(began_);
  if (!assembly_->forces({began_, 0})) throw Error("the law fails in the state from which it begins");
  assembly_->commit(began_);
  kinks_.push_back(began_ + beginning_.release);
  std::sort(kinks_.begin(), kinks_.end());
}

}  // namespace fabricsh::run
