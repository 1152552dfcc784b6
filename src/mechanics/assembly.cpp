#include "mechanics/assembly.hpp"

#include <algorithm>

#include "mechanics/terms/loads.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::mechanics {

template <class T, class... Arguments>
T* Assembly::add(Arguments&&... arguments) {
  auto term = std::make_unique<T>(std::forward<Arguments>(arguments)...);
  T* made = term.get();
  terms_.push_back(std::move(term));
  return made;
}

Assembly::Assembly(const model::Model& model)
    : model_(model), configuration_(model.mesh().nodes.size()), dofs_(model, configuration_) {
  cloth_ = add<Cloth>(model, configuration_, dofs_.reference_directors());
  if (std::any_of(model.gravity().begin(), model.gravity().end(), [](const auto& g) { return bool(g); }))
    add<Gravity>(model, cloth_->mass(), cloth_->mass_moment());
  if (!model.forces().empty() || !model.tractions().empty()) add<DeadLoads>(model);
  if (!model.pressures().empty()) add<Pressure>(model);
  if (!model.moments().empty()) moments_ = add<Moments>(model)->moments();
  if (!model.springs().empty()) add<Springs>(model);
  force_x_.assign(3 * configuration_.nodes(), 0);
  force_d_.assign(3 * configuration_.nodes(), 0);
}

Assembly::~Assembly() = default;

void Assembly::commit(double time) {
  configuration_.commit(time);
  for (auto& term : terms_) term->commit();
}

void Assembly::rollback() {
  configuration_.rollback();
  for (auto& term : terms_) term->rollback();
}

void Assembly::aim(double time) {
  aimed_ = time;
  for (auto& term : terms_) term->aim(time);
}

// The forces of all terms but the cloth.
Outcome Assembly::add_rest(const fabric::Step& step, Forces& forces) {
  Outcome outcome;
  for (std::size_t i = 1; i < terms_.size(); ++i) {
    const Outcome one = terms_[i]->add_forces(step, trial(), forces);
    outcome.failed_element = std::max(outcome.failed_element, one.failed_element);
  }
  return outcome;
}

bool Assembly::forces(const fabric::Step& step) {
  Forces sums = this->sums();
  const Outcome cloth = cloth_->add_forces(step, trial(), sums), rest = add_rest(step, sums);
  failed_element_ = std::max(cloth.failed_element, rest.failed_element);
  return failed_element_ < 0;
}

void Assembly::need_stiffness() {
  if (stiffness_) return;
  std::vector<std::pair<Index, Index>> pairs;
  for (const auto& term : terms_) term->couple(pairs);
  stiffness_ = std::make_unique<Stiffness>(dofs_, cloth_->batches(), cloth_->places(), pairs);
}

const std::shared_ptr<const linear::Pattern>& Assembly::pattern() {
  need_stiffness();
  return stiffness_->pattern();
}

bool Assembly::tangent(const fabric::Step& step, linear::Matrix& K, std::span<const double> lead,
                       std::span<double> product) {
  K.follow(pattern());
  K.clear();
  std::fill(product.begin(), product.end(), 0.0);
  const Stiffness::Target to{K, lead, product};
  const Outcome cloth = cloth_->scatter_tangents(step, false, *stiffness_, to);
  Forces sums = this->sums();
  cloth_->sum_forces(sums);
  const Outcome rest = add_rest(step, sums);
  failed_element_ = std::max(cloth.failed_element, rest.failed_element);
  stiffness_->scatter_tied(to);
  Stiffness::Sink sink(*stiffness_, to);
  for (const auto& term : terms_) term->add_tangent(trial(), sink);
  if (!freedoms().bodies.empty()) {
    std::vector<double> dead;
    external(aimed_, dead);
    stiffness_->add_body_stiffness(configuration_, force_x_, force_d_, dead, moments_, to);
  }
  return failed_element_ < 0;
}

bool Assembly::material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product) {
  K.follow(pattern());
  K.clear();
  std::fill(product.begin(), product.end(), 0.0);
  const Stiffness::Target to{K, lead, product};
  failed_element_ = cloth_->scatter_tangents({}, true, *stiffness_, to).failed_element;
  stiffness_->scatter_tied(to);
  return failed_element_ < 0;
}

void Assembly::add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K) {
  need_stiffness();
  stiffness_->add_diagonal(c_x, c_d, K);
}

bool Assembly::symmetric() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& t) { return t->symmetric(); });
}

bool Assembly::symmetric_loads() const {
  return std::all_of(terms_.begin() + 1, terms_.end(), [](const auto& t) { return t->symmetric(); });
}

void Assembly::external(double time, std::vector<double>& out) const {
  out.assign(3 * configuration_.nodes(), 0.0);
  for (const auto& term : terms_) term->add_dead(time, out);
}

void Assembly::follower(double time, std::vector<double>& on_x) const {
  on_x.assign(3 * configuration_.nodes(), 0);
  std::vector<double> on_d(3 * configuration_.nodes());
  for (const auto& term : terms_) term->add_follower(time, trial(), on_x, on_d);
}

bool Assembly::constant_loads() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& t) { return t->constant(); });
}

bool Assembly::constant_work() const {
  return dofs_.driven_nodes().empty() && std::all_of(terms_.begin(), terms_.end(), [](const auto& t) {
           return t->constant() && !t->follows_positions() && !t->follows_directors();
         });
}

void Assembly::working_forces(std::span<const double> dead, WorkingForces& out) {
  out.on_x.assign(dead.begin(), dead.end());
  const bool on_directors =
      std::any_of(terms_.begin(), terms_.end(), [](const auto& t) { return t->follows_directors(); });
  bool turns = false;
  for (const Index n : dofs_.driven_nodes()) turns = turns || freedoms().nodes[n].turn_axis;
  if (turns || on_directors)
    out.on_d.assign(3 * configuration_.nodes(), 0);
  else
    out.on_d.clear();
  for (const auto& term : terms_) term->add_follower(aimed_, trial(), out.on_x, out.on_d);
  for (const Index n : dofs_.driven_nodes()) {
    at(out.on_x, n) += support_force(n, dead);
    if (freedoms().nodes[n].turn_axis) at(out.on_d, n) += at(force_d_, n);
  }
}

std::vector<Energy> Assembly::energies() const {
  std::vector<Energy> all;
  for (const auto& term : terms_) term->add_energies(trial(), all);
  return all;
}

double Assembly::stable_step(bool scaled) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& term : terms_) shortest = std::min(shortest, term->stable_step(scaled));
  return shortest;
}

void Assembly::keep(Archive& archive) {
  configuration_.keep(archive);
  for (auto& term : terms_) term->keep(archive);
  archive.filled(force_x_);
  archive.filled(force_d_);
  if (archive.reading()) rollback();
}

}  // namespace fabricsh::mechanics
