#include "mechanics/term_list.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace fabricsh::mechanics {
namespace {

void keep_worse(Outcome& worst, Outcome one) {
  if (one.answer > worst.answer) worst = std::move(one);
}

}  // namespace

// The term is entered in the list of each facet that it has. The first term is the cloth: masses are its.
void TermList::append(std::unique_ptr<Term> term) {
  const auto list = [&](auto& facets) {
    if (auto* const facet = facet_of<std::remove_reference_t<decltype(*facets.front())>>(*term))
      facets.push_back(facet);
  };
  if (terms_.empty()) elements_ = dynamic_cast<ElementTerm*>(term.get());
  list(limiters_);
  list(movers_);
  list(followers_);
  list(on_motion_);
  terms_.push_back(std::move(term));
}

Outcome TermList::add_forces(std::size_t first, Outcome worst, const law::Step& step, const Trial& trial,
                             Forces sums) const {
  for (std::size_t i = first; i < terms_.size(); ++i)
    keep_worse(worst, terms_[i]->add_forces(step, trial, sums));
  return worst;
}

void TermList::external(double time, std::vector<double>& out) const {
  out.assign(3 * elements_->mass().size(), 0.0);
  for (const auto& term : terms_) term->add_dead(time, out);
}

const std::vector<Vec3>* TermList::moments() const {
  for (const auto* const load : followers_)
    if (load->moments() != nullptr) return load->moments();
  return nullptr;
}

bool TermList::symmetric() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->symmetric(); });
}

bool TermList::symmetric_but_apart() const {
  return std::all_of(terms_.begin(), terms_.end(),
                     [](const auto& term) { return term->symmetric_but_apart(); });
}

bool TermList::constant_loads() const {
  return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->constant(); });
}

bool TermList::at_target() const {
  return std::all_of(movers_.begin(), movers_.end(), [](const auto* mover) { return mover->at_target(); });
}

void TermList::expect_energies(bool expected) {
  for (auto& term : terms_) term->expect_energies(expected);
}

StepWork TermList::step_work() const {
  StepWork sum;
  for (const auto& term : terms_) sum += term->step_work();
  return sum;
}

MassFactors TermList::on_mass() const {
  MassFactors sum;
  for (const auto* const term : on_motion_) {
    const MassFactors one = term->on_mass();
    sum.acceleration += one.acceleration;
    sum.velocity += one.velocity;
  }
  return sum;
}

Outcome TermList::begin_step(const Motion& motion) {
  Outcome worst;
  for (auto* const term : on_motion_) keep_worse(worst, term->begin_step(motion));
  return worst;
}

void TermList::add_resistance(const Trial& trial, linear::Matrix& K) const {
  for (auto* const term : on_motion_) term->add_resistance(trial, K);
}

void TermList::finish_step(const Motion& motion) {
  for (auto* const term : on_motion_) term->finish_step(motion);
}

double TermList::stable_step(bool scaled) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& term : terms_) shortest = std::min(shortest, term->stable_step(scaled));
  return shortest;
}

void TermList::set_time(double time) {
  for (auto& term : terms_) term->set_time(time);
}

void TermList::commit() {
  for (auto& term : terms_) term->commit();
}

void TermList::rollback() {
  for (auto& term : terms_) term->rollback();
}

void TermList::keep(Archive& archive) {
  for (auto& term : terms_) archive.section(term->name(), [&] { term->keep(archive); });
}

}  // namespace fabricsh::mechanics
