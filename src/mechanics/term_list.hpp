// The terms of an assembly in their order, their facets (mechanics/facets.hpp), and the sums over them that
// need no unknowns.
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "mechanics/facets.hpp"

namespace fabricsh::mechanics {

class TermList {
 public:
  // Appends and returns a term; to be called before forces are first computed.
  template <class T>
  T& add(std::unique_ptr<T> term) {
    T& added = *term;
    append(std::move(term));
    return added;
  }
  auto begin() const { return terms_.begin(); }
  auto end() const { return terms_.end(); }
  // The first term of a type; null: there is none.
  template <class T>
  T* find() {
    for (const auto& term : terms_)
      if (auto* const found = dynamic_cast<T*>(term.get())) return found;
    return nullptr;
  }
  template <class T>
  const T* find() const {
    return const_cast<TermList*>(this)->find<T>();
  }
  // A facet of a term or of one of its parts; null: it has none.
  template <class F>
  static F* facet_of(Term& term) {
    if (auto* const own = dynamic_cast<F*>(&term)) return own;
    for (Facet* const part : term.parts())
      if (auto* const found = dynamic_cast<F*>(part)) return found;
    return nullptr;
  }
  // This facet of all terms that have it.
  template <class F>
  std::vector<F*> all() const {
    std::vector<F*> found;
    for (const auto& term : terms_)
      if (auto* const one = facet_of<F>(*term)) found.push_back(one);
    return found;
  }
  // The facets that every step needs, in the order of their terms. elements: of the first term.
  ElementTerm& elements() const { return *elements_; }
  const std::vector<StepLimiter*>& limiters() const { return limiters_; }
  const std::vector<OwnUnknowns*>& movers() const { return movers_; }
  const std::vector<OnMotion*>& on_motion() const { return on_motion_; }

  // The outcome of the terms from number `first` on, whose forces are added: the worst, also of `worst`.
  Outcome add_forces(std::size_t first, Outcome worst, const law::Step& step, const Trial& trial,
                     Forces sums) const;
  // Dead loads at the given time, 3 per node, N, global.
  void external(double time, std::vector<double>& out) const;
  const std::vector<Vec3>* moments() const;  // see FollowerLoad
  bool symmetric() const;                    // whether the tangents of all terms are symmetric
  bool symmetric_but_apart() const;          // but for what the matrix may keep apart
  bool constant_loads() const;               // whether the dead loads are constant in time
  bool at_target() const;  // whether everything that the step moves besides the supports is at its end
  void expect_energies(bool expected);       // see Term
  StepWork step_work() const;                // that is done neither by loads nor by supports
  MassFactors on_mass() const;               // the sum
  Outcome begin_step(const Motion& motion);  // see OnMotion; the worst
  void add_resistance(const Trial& trial, linear::Matrix& K) const;  // see OnMotion
  void finish_step(const Motion& motion);                            // before the commit
  // s: the largest stable step of central differences for the reference configuration, the smallest of all.
  double stable_step(bool scaled) const;

  void set_time(double time);
  void commit();
  void rollback();
  void keep(Archive& archive);

 private:
  void append(std::unique_ptr<Term> term);

  std::vector<std::unique_ptr<Term>> terms_;
  ElementTerm* elements_ = nullptr;
  std::vector<StepLimiter*> limiters_;
  std::vector<OwnUnknowns*> movers_;
  std::vector<FollowerLoad*> followers_;
  std::vector<OnMotion*> on_motion_;
};

}  // namespace fabricsh::mechanics
