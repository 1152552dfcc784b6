#include "mechanics/assembly.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/bands.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/directors.hpp"
#include "mechanics/terms/loads.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"

namespace fabricsh::mechanics {

template <class T, class... Arguments>
T* Assembly::make(Arguments&&... arguments) {
  return &add(std::make_unique<T>(std::forward<Arguments>(arguments)...));
}

Assembly::Assembly(const model::Model& model)
    : configuration_(model.mesh().nodes.size()), dofs_(model, configuration_) {
  cloth_ = make<Cloth>(model, configuration_, dofs_.reference_directors());
  // The second term, which sees the forces of the cloth alone.
  if (Tears::possible(model)) tears_ = make<Tears>(model, std::as_const(configuration_), *cloth_, dofs_);
  if (!model.seams().empty()) seams_ = make<Seams>(model, std::as_const(configuration_), *cloth_, dofs_);
  directors_ = make<Directors>(model, std::as_const(configuration_), *cloth_, dofs_);
  if (std::any_of(model.gravity().begin(), model.gravity().end(), [](const auto& g) { return bool(g); }))
    make<Gravity>(model, cloth_->mass(), cloth_->mass_moment());
  if (!model.forces().empty() || !model.tractions().empty()) make<DeadLoads>(model);
  if (!model.pressures().empty()) make<Pressure>(model);
  if (!model.moments().empty()) moments_ = make<Moments>(model)->moments();
  if (!model.springs().empty()) make<Springs>(model);
  if (!model.bands().empty()) make<Bands>(model);
  if (model.interactions().any())
    contact_ = make<Contacts>(model, std::as_const(configuration_), *cloth_, dofs_);
  force_x_.assign(3 * configuration_.nodes(), 0);
  force_d_.assign(3 * configuration_.nodes(), 0);
}

Assembly::~Assembly() = default;

void Assembly::begin_iterate() {
  dofs_.begin_iterate();
  for (auto& term : terms_) term->begin_iterate();
}

void Assembly::apply_increment(std::span<const double> delta, double scale, std::span<const double> targets) {
  dofs_.apply_increment(delta, scale, targets);
  for (auto& term : terms_) term->move(scale);
}

void Assembly::advance_explicit(std::span<const double> rates, double time, std::span<const double> targets) {
  dofs_.apply_increment(rates, time, targets);
  for (auto& term : terms_) term->move(1);
}

// Supports go to their targets whatever the fraction is; if that is not safe either, the result is 0.
double Assembly::limit(std::span<const double> delta, std::span<const double> targets) {
  constexpr int tries = 5;
  double fraction = limit_of_terms(delta, targets);
  if (contact_ == nullptr || !(fraction > 0)) return fraction;
  contact_->mark(trial());
  apply_increment(delta, 1, targets);
  // A step across many elements would have to be checked against everything; only its beginning is checked.
  const double near = contact_->near_share(trial());
  if (near < 1) {
    fraction = std::min(fraction, near);
    apply_increment(delta, fraction, targets);
    fraction *= contact_->safe_share(trial());
  } else {
    fraction = std::min(fraction, contact_->safe_share(trial()));
  }
  for (int i = 0; fraction < 1 && fraction > 0; ++i) {
    apply_increment(delta, fraction, targets);
    const double again = contact_->safe_share(trial());
    if (again >= 1) return fraction;
    fraction = i == tries ? 0 : fraction * again;
  }
  if (fraction > 0) return fraction;
  // The forces of the whole step say why there is none, for a run that ends here.
  apply_increment(delta, 1, targets);
  Forces sums = this->sums();
  take(contact_->add_forces({}, trial(), sums));
  return 0;
}

bool Assembly::at_target() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->at_target(); });
}

// The forces w on free bodies are unknowns beside those of the matrix: K delta = r - B w, w = R + C delta + D
// w. With Z = K^-1 B this is a small system for w, six equations for each body.
bool Assembly::finish_direction(const Solve& solve, double weight, std::span<double> delta) {
  const std::size_t m = contact_ == nullptr ? 0 : contact_->body_unknowns();
  if (m == 0) return true;
  const std::vector<double> zero(3 * reference().size(), 0), still(dofs_.targets(trial_time_).size(), 0);
  const auto answer = [&](std::span<const double> move) {
    NodalRates nodal;
    dofs_.spread_rates(move, still, nodal);
    return contact_->body_answer(nodal.x);
  };
  std::vector<std::vector<double>> Z(m, std::vector<double>(delta.size()));
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(static_cast<Index>(m), static_cast<Index>(m));
  A -= contact_->body_response();
  std::vector<double> push(3 * reference().size()), r(delta.size());
  for (std::size_t j = 0; j < m; ++j) {
    if (!contact_->body_push(j, push)) continue;
    dofs_.residual(push, zero, zero, {}, nullptr, r);
    for (double& x : r) x *= weight;
    if (!r.empty() && !solve(r, Z[j])) return false;
    A.col(static_cast<Index>(j)) += answer(Z[j]);
  }
  const Eigen::VectorXd w = A.partialPivLu().solve(contact_->body_residual() + answer(delta));
  if (!w.allFinite()) return false;
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < delta.size(); ++i) delta[i] -= w[static_cast<Index>(j)] * Z[j][i];
  contact_->direct_bodies({w.data(), m});
  return true;
}

double Assembly::largest_body_residual() const {
  return contact_ == nullptr ? 0 : contact_->largest_body_residual();
}

void Assembly::commit(double time) {
  configuration_.commit(time);
  for (auto& term : terms_) term->commit();
  committed_coupled_ = coupled_;
}

void Assembly::rollback() {
  configuration_.rollback();
  for (auto& term : terms_) term->rollback();
  if (coupled_ != committed_coupled_) couple(committed_coupled_);
}

void Assembly::set_time(double time) {
  trial_time_ = time;
  for (auto& term : terms_) term->set_time(time);
}

// Adds the forces of all terms but the cloth; returns the worst of all outcomes.
Outcome Assembly::with_rest(Outcome worst, const law::Step& step, Forces& forces) {
  for (std::size_t i = 1; i < terms_.size(); ++i) {
    Outcome one = terms_[i]->add_forces(step, trial(), forces);
    if (one.answer > worst.answer) worst = std::move(one);
  }
  return worst;
}

bool Assembly::take(Outcome outcome) {
  outcome_ = std::move(outcome);
  return outcome_.ok();
}

bool Assembly::forces(const law::Step& step) {
  Forces sums = this->sums();
  return take(with_rest(cloth_->add_forces(step, trial(), sums), step, sums));
}

bool Assembly::limits() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const auto& t) { return t->limits(); });
}

// If a term limits steps, the trial configuration is reset to the iterate.
double Assembly::limit_of_terms(std::span<const double> delta, std::span<const double> targets) {
  if (!limits()) return 1;
  dofs_.apply_increment(delta, 1, targets);
  const auto end = std::as_const(configuration_).x();
  std::vector<double> way(end.begin(), end.end());
  dofs_.return_to_iterate();
  const auto from = std::as_const(configuration_).x();
  for (std::size_t i = 0; i < way.size(); ++i) way[i] -= from[i];
  double fraction = 1;
  for (const auto& term : terms_) fraction = std::min(fraction, term->limit(trial(), way));
  return fraction;
}

void Assembly::couple(std::vector<NodePair> pairs) {
  if (stiffness_) stiffness_->couple(pairs);
  coupled_ = std::move(pairs);
}

// Makes the pattern hold the pairs that the terms couple at the trial configuration.
void Assembly::couple() {
  if (!stiffness_) {
    stiffness_ = std::make_unique<Stiffness>(dofs_, cloth_->batches(), cloth_->places(), upper_);
    stiffness_->couple(coupled_);
  }
  std::vector<NodePair> wanted;
  for (const auto& term : terms_) term->couple(trial(), wanted);
  for (auto& [a, b] : wanted)
    if (a > b) std::swap(a, b);
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  if (!std::includes(coupled_.begin(), coupled_.end(), wanted.begin(), wanted.end()))
    couple(std::move(wanted));
}

const std::shared_ptr<const linear::Pattern>& Assembly::pattern() {
  if (!stiffness_) couple();
  return stiffness_->pattern();
}

bool Assembly::tangent(const law::Step& step, linear::Matrix& K, std::span<const double> lead,
                       std::span<double> product, bool extrapolated) {
  couple();
  K.follow(pattern());
  K.clear();
  std::fill(product.begin(), product.end(), 0.0);
  const Stiffness::Target to{K, lead, product};
  Outcome cloth = cloth_->scatter_tangents(step, false, *stiffness_, to,
                                           extrapolated ? dofs_.iterate() : std::span<const double>());
  Forces sums = this->sums();
  cloth_->sum_forces(sums);
  outcome_ = with_rest(std::move(cloth), step, sums);
  stiffness_->scatter_tied(to);
  Stiffness::Sink sink(*stiffness_, to);
  for (const auto& term : terms_) term->add_tangent(trial(), sink);
  if (!freedoms().bodies.empty()) {
    std::vector<double> dead;
    external(trial_time_, dead);
    stiffness_->add_body_stiffness(configuration_, force_x_, force_d_, dead, moments_, to);
  }
  return outcome_.ok();
}

bool Assembly::material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product) {
  K.follow(pattern());
  K.clear();
  std::fill(product.begin(), product.end(), 0.0);
  const Stiffness::Target to{K, lead, product};
  outcome_ = cloth_->scatter_tangents({}, true, *stiffness_, to);
  stiffness_->scatter_tied(to);
  return outcome_.ok();
}

void Assembly::add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K) {
  pattern();
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
  for (const auto& term : terms_) term->add_follower(trial_time_, trial(), out.on_x, out.on_d);
  for (const Index n : dofs_.driven_nodes()) {
    at(out.on_x, n) += support_force(n, dead);
    if (freedoms().nodes[n].turn_axis) at(out.on_d, n) += at(force_d_, n);
  }
}

Assembly::OverturnedParts Assembly::shape() const {
  const std::vector<Index> turned = directors_->turned_over(configuration_);
  return {cloth_->inverted_element(turned), turned.empty() ? -1 : turned.front()};
}

void Assembly::expect_energies(bool expected) {
  for (auto& term : terms_) term->expect_energies(expected);
}

double Assembly::step_work() const {
  double sum = 0;
  for (const auto& term : terms_) sum += term->step_work();
  return sum;
}

std::vector<Energy> Assembly::energies() const {
  std::vector<Energy> all;
  for (const auto& term : terms_) term->add_energies(trial(), all);
  if (joints().any() || seams_ != nullptr) all.push_back({"joints", Account::dissipated, lost_});
  return all;
}

OnMass Assembly::on_mass() const {
  OnMass sum;
  for (const auto& term : terms_) {
    const OnMass one = term->on_mass();
    sum.acceleration += one.acceleration;
    sum.velocity += one.velocity;
  }
  return sum;
}

bool Assembly::begin_step() {
  Outcome worst;
  for (auto& term : terms_) {
    Outcome one = term->begin_step(*motion_);
    if (one.answer > worst.answer) worst = std::move(one);
  }
  return take(std::move(worst));
}

void Assembly::resist(std::span<double> r) {
  for (auto& term : terms_) term->resist(trial(), r);
}

void Assembly::add_resistance(linear::Matrix& K) {
  for (auto& term : terms_) term->add_resistance(trial(), K);
}

void Assembly::finish_step() {
  for (auto& term : terms_) term->finish_step(*motion_);
}

double Assembly::stable_step(bool scaled) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& term : terms_) shortest = std::min(shortest, term->stable_step(scaled));
  return shortest;
}

// Where nodes of a joint that closes were apart, the forces at their mean are computed, in a step of no time.
std::optional<Transfer> Assembly::open(std::vector<Joints::Edge> edges, double within) {
  const std::uint64_t before = configuration_.version();
  auto transfer = dofs_.open(std::move(edges), cloth_->mass(), cloth_->rotary_inertia(false), within);
  if (!transfer) return {};
  renumbered();
  if (configuration_.version() != before) balance("join");
  return transfer;
}

// Where stitches close, their threads no longer act.
std::optional<Transfer> Assembly::sew(Sewn next, double within) {
  const std::uint64_t before = configuration_.version();
  auto transfer = dofs_.sew(std::move(next), cloth_->mass(), cloth_->rotary_inertia(false), within);
  if (!transfer) return {};
  renumbered();
  if (configuration_.version() != before) balance("seam");
  return transfer;
}

// Computes the forces at the committed time where nodes have been moved.
void Assembly::balance(const char* call) {
  const double now = configuration_.time();
  set_time(now);
  if (!forces({now, 0})) throw Error(std::string(call) + ": the law failed where the nodes of a joint meet");
  commit(now);
}

void Assembly::renumbered() {
  ++numbering_;
  stiffness_.reset();
  Forces sums = this->sums();
  for (auto& term : terms_) term->renumbered(sums);
}

void Assembly::keep_joints(Archive& archive) {
  std::vector<Index> ends;
  for (const auto& [a, b] : joints().opened()) ends.insert(ends.end(), {a, b});
  archive.section("joints", [&] { archive(ends, lost_); });
  if (!archive.reading()) return;
  std::vector<Joints::Edge> edges;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) edges.emplace_back(ends[i], ends[i + 1]);
  if (dofs_.reopen(std::move(edges))) renumbered();
}

void Assembly::keep_seams(Archive& archive) {
  Sewn sewn = dofs_.sewn();
  archive.section("sewn", [&] { archive(sewn, lost_); });
  if (archive.reading() && dofs_.resew(std::move(sewn))) renumbered();
}

void Assembly::keep(Archive& archive) {
  if (joints().any()) keep_joints(archive);
  if (seams_ != nullptr) keep_seams(archive);
  archive.section("configuration", [&] { configuration_.keep(archive); });
  for (auto& term : terms_) archive.section(term->name(), [&] { term->keep(archive); });
  archive.section("forces", [&] {
    archive.filled(force_x_);
    archive.filled(force_d_);
  });
  std::vector<Index> pairs;  // the pairs of the pattern, on which the rounding of a solution depends
  for (const auto& [a, b] : coupled_) pairs.insert(pairs.end(), {a, b});
  archive.section("couplings", [&] { archive(pairs); });
  if (!archive.reading()) return;
  committed_coupled_.clear();
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
    committed_coupled_.emplace_back(pairs[i], pairs[i + 1]);
  rollback();
}

}  // namespace fabricsh::mechanics
