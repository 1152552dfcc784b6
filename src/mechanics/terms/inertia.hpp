// The terms that are multiples of the mass: inertia, and Rayleigh's first part of damping.
#pragma once
#include "mechanics/facets.hpp"

namespace fabricsh::mechanics {

class Assembly;

// Forces M a. Energies: "kinetic", of the trial state.
class Inertia final : public Term, public OnMotion {
 public:
  // kg, kg m^2 per node; kept by reference.
  Inertia(const std::vector<double>& mass, const std::vector<double>& rotary)
      : mass_(mass), rotary_(rotary) {}
  const char* name() const override { return "inertia"; }
  MassFactors on_mass() const override { return {1, 0}; }
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override {
    out.push_back({"kinetic", Account::kinetic, trial.motion == nullptr ? 0 : trial.motion->kinetic()});
  }
  const std::vector<double>& mass() const { return mass_; }
  const std::vector<double>& rotary() const { return rotary_; }

 private:
  const std::vector<double>&mass_, &rotary_;
};

// Forces a M v. Energies: "mass damping", lost so far. On driven displacements it acts with their mean
// velocity in a step, so that a kink of their way does not matter.
class MassDamping final : public Term, public OnMotion {
 public:
  MassDamping(const Assembly& assembly, double rate) : assembly_(assembly), rate_(rate) {}  // a: 1/s
  const char* name() const override { return "mass damping"; }
  MassFactors on_mass() const override { return {0, rate_}; }
  void add_energies(const Trial&, std::vector<Energy>& out) const override {
    out.push_back({"mass damping", Account::damping, lost_});
  }
  StepWork step_work() const override { return {driven_, 0}; }
  void finish_step(const Motion& motion) override;
  void keep(Archive& archive) override { archive(lost_); }

 private:
  const Assembly& assembly_;
  double rate_, lost_ = 0, driven_ = 0;  // J, in committed steps; in the last one, of driven displacements
};

}  // namespace fabricsh::mechanics
