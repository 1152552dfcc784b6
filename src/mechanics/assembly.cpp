#include "mechanics/assembly.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "linear/vector.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/directors.hpp"
#include "mechanics/terms/gas.hpp"
#include "mechanics/terms/hinges.hpp"
#include "mechanics/terms/loads.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"

namespace fabricsh::mechanics {

template <class T, class... Arguments>
T& Assembly::make(Arguments&&... arguments) {
  return terms_.add(std::make_unique<T>(std::forward<Arguments>(arguments)...));
}

Assembly::Assembly(const model::Model& model)
    : configuration_(model.mesh().nodes.size()), dofs_(model, configuration_) {
  auto& cloth = make<Cloth>(model, configuration_, dofs_.reference_directors());
  cloth.read_leaders_of(dofs_.joints());
  // The second term, which sees the forces of the cloth alone.
  if (Tears::possible(model)) make<Tears>(model, std::as_const(configuration_), cloth, dofs_);
  if (!model.all<model::Seam>().empty()) make<Seams>(model, std::as_const(configuration_), cloth, dofs_);
  make<Directors>(model, std::as_const(configuration_), cloth, dofs_);
  for (auto& load : loads_of({model, cloth, dofs_.freedoms()})) terms_.add(std::move(load));
  if (Hinges::possible(model)) make<Hinges>(model, std::as_const(configuration_));
  Gas* const gas = model.all<model::GasPointer>().empty() ? nullptr : &make<Gas>(model);
  if (model.interactions().any()) {
    auto& contacts = make<Contacts>(model, std::as_const(configuration_), cloth, dofs_);
    if (gas != nullptr) gas->press_on(contacts.gas(), trial());
  }
  force_x_.assign(3 * configuration_.nodes(), 0);
  force_d_.assign(3 * configuration_.nodes(), 0);
}

const Cloth& Assembly::cloth() const { return *terms_.find<Cloth>(); }

void Assembly::begin_iterate() {
  dofs_.begin_iterate();
  for (auto* const mover : terms_.movers()) mover->begin_iterate();
}

void Assembly::apply_increment(std::span<const double> delta, double scale, std::span<const double> targets,
                               std::optional<double> share) {
  dofs_.apply_increment(delta, scale, targets);
  for (auto* const mover : terms_.movers()) mover->move(share.value_or(scale));
}

bool Assembly::limits() const {
  const auto& all = terms_.limiters();
  return std::any_of(all.begin(), all.end(), [](const auto* limiter) { return limiter->limits(); });
}

// Supports go to their targets whatever the fraction is; if that is not safe either, the result is 0. Bodies
// that turn take another way to a part of the step than to all of it: what such a way then allows is taken
// with some room, since it would come nearer to the same limit by ever less.
double Assembly::limit(std::span<const double> delta, std::span<const double> targets, double way) {
  constexpr int tries = 5;
  constexpr double room = 0.9;
  std::vector<StepLimiter*> limiters;
  for (auto* const limiter : terms_.limiters())
    if (limiter->limits()) limiters.push_back(limiter);
  if (limiters.empty()) return 1;
  const auto least = [&](double (StepLimiter::*share)(const Trial&)) {
    double smallest = 1;
    for (auto* const limiter : limiters) smallest = std::min(smallest, (limiter->*share)(trial()));
    return smallest;
  };
  for (auto* const limiter : limiters) limiter->mark(trial());
  apply_increment(delta, way, targets);
  // A step across many elements would have to be checked against everything; only its beginning is checked.
  double fraction = least(&StepLimiter::near_share);
  if (fraction < 1) apply_increment(delta, way * fraction, targets);
  fraction *= least(&StepLimiter::safe_fraction);
  for (int i = 0; fraction < 1 && fraction > 0; ++i) {
    apply_increment(delta, way * fraction, targets);
    const double again = least(&StepLimiter::safe_fraction);
    if (again >= 1) return fraction;
    fraction = i == tries ? 0 : room * fraction * again;
  }
  if (fraction > 0) return fraction;
  // The forces of the whole step say why there is none, for a run that ends here.
  apply_increment(delta, way, targets);
  Forces sums = this->sums();
  Outcome worst;
  for (const auto& term : terms_) {
    if (TermList::facet_of<StepLimiter>(*term) == nullptr) continue;
    Outcome one = term->add_forces({}, trial(), sums);
    if (one.answer > worst.answer) worst = std::move(one);
  }
  take(std::move(worst));
  return 0;
}

bool Assembly::is_safe(std::span<const double> delta, double part, std::span<const double> targets) {
  apply_increment(delta, part, targets);
  return all_safe();
}

bool Assembly::all_safe() {
  const auto& all = terms_.limiters();
  return std::all_of(all.begin(), all.end(), [this](auto* limiter) {
    return !limiter->limits() || limiter->safe_fraction(trial()) >= 1;
  });
}

bool Assembly::parts_leave_way() const {
  return std::any_of(terms_.movers().begin(), terms_.movers().end(),
                     [](const auto* mover) { return mover->parts_leave_way(); });
}

void Assembly::save_iterate() {
  const auto k = std::as_const(configuration_).kinematics();
  saved_.assign(k.begin(), k.end());
  for (auto* const mover : terms_.movers()) mover->save();
}

// What moves of itself stays where it has come since, if what it has passed leaves the cloth the way back.
void Assembly::restore_iterate() {
  for (auto* const limiter : terms_.limiters())
    if (limiter->limits()) limiter->mark(trial());
  std::copy(saved_.begin(), saved_.end(), configuration_.kinematics().begin());
  configuration_.touch();
  if (!all_safe())
    for (auto* const mover : terms_.movers()) mover->restore();
}

namespace {

// The equations of all terms' own unknowns w beside those of the matrix: K delta = r - B w, and for each term
// w = residual + answer(delta) + response w of its own. With Z = K^-1 B this is a small system for w.
class OwnSystem {
 public:
  explicit OwnSystem(const std::vector<OwnUnknowns*>& terms) : terms_(terms) {
    first_.push_back(0);
    for (const auto* term : terms_) first_.push_back(first_.back() + term->own_unknowns());
  }
  std::size_t size() const { return first_.back(); }
  Eigen::VectorXd residual() const {
    return stacked([](const OwnUnknowns& term) { return term.own_residual(); });
  }
  Eigen::VectorXd answer(std::span<const double> move) const {
    return stacked([&](const OwnUnknowns& term) { return term.own_answer(move); });
  }
  // The identity less the responses.
  Eigen::MatrixXd matrix() const {
    const auto m = static_cast<Index>(size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(m, m);
    for (std::size_t t = 0; t < terms_.size(); ++t)
      if (own(t) > 0) A.block(from(t), from(t), own(t), own(t)) -= terms_[t]->own_response();
    return A;
  }
  // Empty if a term has unknowns without.
  Eigen::MatrixXd stiffness() const {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(static_cast<Index>(size()), static_cast<Index>(size()));
    for (std::size_t t = 0; t < terms_.size(); ++t) {
      if (own(t) == 0) continue;
      const Eigen::MatrixXd part = terms_[t]->own_stiffness();
      if (part.size() == 0) return {};
      A.block(from(t), from(t), own(t), own(t)) = part;
    }
    return A;
  }
  bool push(std::size_t j, std::span<double> on_x) const {
    std::size_t t = 0;
    while (j >= first_[t + 1]) ++t;
    return terms_[t]->own_push(j - first_[t], on_x);
  }
  void direct(const Eigen::VectorXd& w) const {
    for (std::size_t t = 0; t < terms_.size(); ++t)
      if (own(t) > 0) terms_[t]->direct({w.data() + from(t), static_cast<std::size_t>(own(t))});
  }

 private:
  Index from(std::size_t t) const { return static_cast<Index>(first_[t]); }
  Index own(std::size_t t) const { return from(t + 1) - from(t); }
  template <class Of>
  Eigen::VectorXd stacked(Of of) const {
    Eigen::VectorXd all(static_cast<Index>(size()));
    for (std::size_t t = 0; t < terms_.size(); ++t)
      if (own(t) > 0) all.segment(from(t), own(t)) = of(*terms_[t]);
    return all;
  }
  const std::vector<OwnUnknowns*>& terms_;
  std::vector<std::size_t> first_;  // unknown of each term
};

// m, of the nodes, by a change of the matrix's unknowns.
std::vector<double> moved(const Dofs& dofs, double time, std::span<const double> change) {
  NodalRates nodal;
  dofs.spread_rates(change, std::vector<double>(dofs.targets(time).size()), nodal);
  return std::move(nodal.x);
}

// Z = K^-1 B, and A with the answers to it. coordinates: of all nodes. False: no solution.
bool condense(const OwnSystem& own, const Dofs& dofs, double time, std::size_t coordinates,
              const Assembly::Solve& solve, double weight, std::vector<std::vector<double>>& Z,
              Eigen::MatrixXd& A) {
  const std::vector<double> zero(coordinates, 0);
  std::vector<double> push(coordinates), r(static_cast<std::size_t>(dofs.unknowns()));
  Z.assign(own.size(), std::vector<double>(r.size()));
  for (std::size_t j = 0; j < own.size(); ++j) {
    if (!own.push(j, push)) continue;
    dofs.residual(push, zero, zero, {}, nullptr, r);
    for (double& x : r) x *= weight;
    if (!r.empty() && !solve(r, Z[j])) return false;
    A.col(static_cast<Index>(j)) += own.answer(moved(dofs, time, Z[j]));
  }
  return true;
}

}  // namespace

bool Assembly::finish_direction(const Solve& solve, double weight, std::span<double> delta) {
  const OwnSystem own(terms_.movers());
  if (own.size() == 0) return true;
  std::vector<std::vector<double>> Z;
  Eigen::MatrixXd A = own.matrix();
  if (!condense(own, dofs_, trial_time_, force_x_.size(), solve, weight, Z, A)) return false;
  const Eigen::VectorXd w =
      A.partialPivLu().solve(own.residual() + own.answer(moved(dofs_, trial_time_, delta)));
  if (!w.allFinite()) return false;
  for (std::size_t j = 0; j < own.size(); ++j)
    for (std::size_t i = 0; i < delta.size(); ++i) delta[i] -= w[static_cast<Index>(j)] * Z[j][i];
  own.direct(w);
  return true;
}

Eigen::MatrixXd Assembly::own_stiffness(const Solve& solve) {
  const OwnSystem own(terms_.movers());
  std::vector<std::vector<double>> Z;
  Eigen::MatrixXd A = own.stiffness();
  if (A.size() == 0 || !condense(own, dofs_, trial_time_, force_x_.size(), solve, 1, Z, A)) return {};
  return A;
}

void Assembly::commit(double time) {
  configuration_.commit(time);
  terms_.commit();
  committed_coupled_ = coupled_;
}

void Assembly::rollback() {
  configuration_.rollback();
  terms_.rollback();
  if (coupled_ != committed_coupled_) couple(committed_coupled_);
}

void Assembly::set_time(double time) {
  trial_time_ = time;
  terms_.set_time(time);
}

bool Assembly::take(Outcome outcome) {
  outcome_ = std::move(outcome);
  return outcome_.ok();
}

bool Assembly::forces(const law::Step& step) { return take(terms_.add_forces(0, {}, step, trial(), sums())); }

void Assembly::couple(std::vector<NodePair> pairs) {
  if (stiffness_) stiffness_->couple(pairs);
  coupled_ = std::move(pairs);
}

// Makes the pattern hold the pairs that the terms couple at the trial configuration.
void Assembly::couple() {
  if (!stiffness_) {
    stiffness_ =
        std::make_unique<Stiffness>(dofs_, terms_.elements().batches(), terms_.elements().places(), upper_);
    stiffness_->couple(coupled_);
  }
  std::vector<NodePair> wanted;
  for (const auto& term : terms_) term->couple(trial(), wanted);
  for (auto& [a, b] : wanted)
    if (a > b) std::swap(a, b);
  if (!std::is_sorted(wanted.begin(), wanted.end())) std::sort(wanted.begin(), wanted.end());
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
  Outcome elements = terms_.elements().scatter_tangents(
      step, false, *stiffness_, to, extrapolated ? dofs_.iterate() : std::span<const double>());
  Forces sums = this->sums();
  terms_.elements().sum_forces(sums);
  outcome_ = terms_.add_forces(1, std::move(elements), step, trial(), sums);
  stiffness_->scatter_tied(to);
  Stiffness::Sink sink(*stiffness_, to, apart_ ? &kept_apart_ : nullptr);
  for (const auto& term : terms_) term->add_tangent(trial(), sink);
  if (sink.has_apart()) std::swap(K.apart, kept_apart_.value);
  for (const auto* const term : terms_.all<FewRankTerm>()) add_ranks(*term, K, lead, product);
  if (!dofs_.freedoms().bodies.empty()) {
    std::vector<double> dead;
    terms_.external(trial_time_, dead);
    stiffness_->add_body_stiffness(configuration_, force_x_, force_d_, dead, terms_.moments(), to);
  }
  return outcome_.ok();
}

// Columns by nodes become columns by unknowns as forces do. The driven degrees of freedom change what the
// columns measure, too.
void Assembly::add_ranks(const FewRankTerm& term, linear::Matrix& K, std::span<const double> lead,
                         std::span<double> product) {
  NodalRanks nodal;
  term.add_ranks(trial(), nodal);
  const auto before = static_cast<Index>(K.ranks.columns.size()),
             more = static_cast<Index>(nodal.on_x.size());
  const std::vector<double> zero(force_x_.size(), 0);
  for (const auto& on_x : nodal.on_x) {
    K.ranks.columns.emplace_back(static_cast<std::size_t>(dofs_.unknowns()));
    dofs_.residual(on_x, zero, zero, {}, nullptr, K.ranks.columns.back());
  }
  Eigen::MatrixXd core = Eigen::MatrixXd::Zero(before + more, before + more);
  if (before > 0) core.topLeftCorner(before, before) = K.ranks.core;
  core.bottomRightCorner(more, more) = nodal.core;
  K.ranks.core = std::move(core);
  if (lead.empty() || product.empty()) return;
  NodalRates led;
  dofs_.spread_rates(std::vector<double>(static_cast<std::size_t>(dofs_.unknowns()), 0), lead, led);
  Eigen::VectorXd along(more);
  for (Index i = 0; i < more; ++i) along[i] = linear::dot(nodal.on_x[static_cast<std::size_t>(i)], led.x);
  const Eigen::VectorXd weight = nodal.core * along;
  for (Index i = 0; i < more; ++i) {
    const auto& column = K.ranks.columns[static_cast<std::size_t>(before + i)];
    for (std::size_t n = 0; n < product.size(); ++n) product[n] += weight[i] * column[n];
  }
}

bool Assembly::material_tangent(linear::Matrix& K, std::span<const double> lead, std::span<double> product,
                                const Stiffness::Reader* read) {
  K.follow(pattern());
  K.clear();
  std::fill(product.begin(), product.end(), 0.0);
  const Stiffness::Target to{K, lead, product, read};
  const bool turned = motion_ != nullptr && configuration_.moved();
  outcome_ = terms_.elements().scatter_tangents(
      {}, true, *stiffness_, to, turned ? configuration_.committed_kinematics() : std::span<const double>());
  stiffness_->scatter_tied(to);
  return outcome_.ok();
}

void Assembly::add_diagonal(std::span<const double> c_x, std::span<const double> c_d, linear::Matrix& K) {
  pattern();
  stiffness_->add_diagonal(c_x, c_d, K);
}

void Assembly::residual(std::span<const double> external, std::span<double> r, std::span<const double> on_d) {
  dofs_.residual(external, force_x_, force_d_, on_d, terms_.moments(), r);
  if (motion_ == nullptr) return;
  for (auto* const term : terms_.on_motion()) term->resist(trial(), r);
}

std::pair<double, Index> Assembly::largest_residual(std::span<const double> r) const {
  auto largest = dofs_.largest_residual(r);
  for (const auto* const mover : terms_.movers())
    if (const double own = mover->largest_own_residual(); own > largest.first) largest = {own, -1};
  return largest;
}

std::vector<Energy> Assembly::energies() const {
  std::vector<Energy> all;
  for (const auto& term : terms_) term->add_energies(trial(), all);
  if (dofs_.joints().any() || !dofs_.seams().empty()) all.push_back({"joints", Account::dissipated, lost_});
  return all;
}

bool Assembly::begin_step() { return take(terms_.begin_step(*motion_)); }

// Where nodes of a joint that closes were apart, the forces at their mean are computed, in a step of no time.
std::optional<Transfer> Assembly::open(std::vector<Joints::Edge> edges, double within) {
  const std::uint64_t before = configuration_.version();
  auto transfer =
      dofs_.open(std::move(edges), terms_.elements().mass(), terms_.elements().rotary_inertia(false), within);
  if (!transfer) return {};
  renumbered();
  if (configuration_.version() != before) balance("join");
  return transfer;
}

// Where stitches close, their threads no longer act.
std::optional<Transfer> Assembly::sew(Sewn next, double within) {
  const std::uint64_t before = configuration_.version();
  auto transfer =
      dofs_.sew(std::move(next), terms_.elements().mass(), terms_.elements().rotary_inertia(false), within);
  if (!transfer) return {};
  renumbered();
  if (configuration_.version() != before) balance("seam");
  return transfer;
}

// Computes the forces at the committed time where nodes have been moved.
void Assembly::balance(const char* call) {
  const double now = configuration_.time();
  set_time(now);
  if (!forces({now, 0})) {
    const std::string why = outcome_.why.empty() ? "the law failed" : outcome_.why;
    rollback();
    throw Error(std::string(call) + ": " + why + ", where the nodes of a joint meet");
  }
  commit(now);
}

void Assembly::renumbered() {
  stiffness_.reset();
  Forces sums = this->sums();
  for (auto& term : terms_) term->renumbered(sums);
}

bool Assembly::keep_joints(Archive& archive) {
  std::vector<Index> ends;
  for (const auto& [a, b] : dofs_.joints().opened()) ends.insert(ends.end(), {a, b});
  archive.section("joints", [&] { archive(ends, lost_); });
  if (!archive.reading()) return false;
  std::vector<Joints::Edge> edges;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) edges.emplace_back(ends[i], ends[i + 1]);
  return dofs_.reopen(std::move(edges));
}

bool Assembly::keep_seams(Archive& archive) {
  Sewn sewn = dofs_.sewn();
  archive.section("sewn", [&] { archive(sewn, lost_); });
  return archive.reading() && dofs_.resew(std::move(sewn));
}

bool Assembly::keep(Archive& archive) {
  const bool joined = dofs_.joints().any() && keep_joints(archive);
  if (joined) renumbered();
  const bool sewn = !dofs_.seams().empty() && keep_seams(archive);
  if (sewn) renumbered();
  archive.section("configuration", [&] { configuration_.keep(archive); });
  terms_.keep(archive);
  archive.section("forces", [&] {
    archive.filled(force_x_);
    archive.filled(force_d_);
  });
  std::vector<Index> pairs;  // the pairs of the pattern, on which the rounding of a solution depends
  for (const auto& [a, b] : coupled_) pairs.insert(pairs.end(), {a, b});
  archive.section("couplings", [&] { archive(pairs); });
  if (!archive.reading()) return false;
  committed_coupled_.clear();
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
    committed_coupled_.emplace_back(pairs[i], pairs[i + 1]);
  rollback();
  return joined || sewn;
}

}  // namespace fabricsh::mechanics
