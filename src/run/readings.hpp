// Readings of a run at its present state: nodes, elements, reactions, fields, energies.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "run/run_state.hpp"

namespace fabricsh::mechanics {
class Contacts;
}

namespace fabricsh::run {

struct ResultField;

class Readings : public RunState {
 public:
  // N, global: force of the supports on the cloth; zero before the run has begun.
  Vec3 reaction(const std::string& set) const;
  Vec3 reaction_at(mesh::Index node) const;
  // The contacts of the model, and the number of a body in it. Error: there is no contact, or no such body.
  const mechanics::Contacts& contact() const;
  std::size_t body_number(const model::Rigid& body) const;
  Vec3 force_of_body(std::size_t i) const;  // N, on the cloth
  // While it lives, forces of bodies are read as these (N, 3 numbers a body), or with null as they are.
  class ForcesOfBodies {
   public:
    ForcesOfBodies(const Readings& run, const std::vector<double>* shown) : run_(run) {
      run.shown_forces_ = shown;
      run.read_forces_ = false;
    }
    ForcesOfBodies(const ForcesOfBodies&) = delete;
    ~ForcesOfBodies() { run_.shown_forces_ = nullptr; }
    bool read() const { return run_.read_forces_; }  // whether any was

   private:
    const Readings& run_;
  };
  NodeValues node(mesh::Index i) const;        // from 0; Error outside
  ElementValues element(mesh::Index i) const;  // from 0; Error outside
  double mean(const std::string& name, const std::string& set = "all") const;
  std::vector<double> field(const std::string& name) const;  // see result_fields.hpp
  // The fields that added terms show, besides those of result_fields().
  const std::vector<std::shared_ptr<const ResultField>>& shown() const { return shown_; }
  // Of the present state, computed once per state. ply: see Model::ply_of; an element without that ply has no
  // numbers (NaN). Without one all plies together, their components in the axes that they have in common,
  // or else in those of the section.
  const std::vector<ElementValues>& elements(const std::string& ply = {}) const;
  EnergyAccount energy() const;
  double elements_beyond() const;  // the fraction that has exceeded the tested range, 0 to 1
  // The largest fraction so far of the kinetic energy that is in scaled rotary inertia.
  virtual double scaled_share() const { return 0; }

 protected:
  using RunState::RunState;
  // --- what a kind of run adds to the energies
  // J, the part of the kinetic energy in rotary inertia beyond that of the thickness; 0 if rotary inertia is
  // not scaled.
  virtual double scaled_kinetic() const { return 0; }
  virtual double driven_kinetic() const { return 0; }  // J, of driven displacements
  virtual double scheme_loss() const { return 0; }     // J, dissipated by the time scheme
  // J: by how much the sum of the energies is below the one that the time scheme conserves; 0: it is that.
  virtual double hidden_energy() const { return 0; }
  // J, of an energy that is made or lost. Where the sum is off by more than a thousandth of `scale`, what
  // only swings between the ends of the steps is left out.
  virtual double imbalance(const EnergyAccount& sum, double scale) const;
  virtual double relaxed() const { return 0; }      // J, taken away by relaxation
  virtual double driven_work() const { return 0; }  // J, external work not contained in work_
  virtual Vec3 inertia(mesh::Index) const {
    return Vec3::Zero();
  }  // N, to be overcome by the support of a driven node
  virtual Vec3 velocity(mesh::Index) const { return Vec3::Zero(); }  // m/s
  // J, the weight of the cloth over its thickness: an energy below which cloth that meets something is at
  // rest. 0 without contact or gravity.
  double energy_of_rest() const;

  std::vector<std::shared_ptr<const ResultField>> shown_;
  struct Averages {
    std::uint64_t version = 0;
    std::vector<ElementValues> values;
  };
  mutable std::map<std::string, Averages> averages_;  // by ply

 private:
  mutable const std::vector<double>* shown_forces_ = nullptr;
  mutable bool read_forces_ = false;
  ElementValues average(mesh::Index element, int ply) const;
};

}  // namespace fabricsh::run
