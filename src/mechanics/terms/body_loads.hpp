// Forces, moments, springs and dampers on free rigid bodies.
#pragma once
#include <vector>

#include "base/archive.hpp"
#include "mechanics/step_work.hpp"
#include "mechanics/terms/body_state.hpp"

namespace fabricsh::mechanics {

class BodyLoads {
 public:
  struct Spring {
    std::size_t body = 0;  // in BodyState::bodies
    int to = -1;           // there, too; -1: the ground
    // N/m or N s/m; m, the displacement of the body from the other end at which it is slack
    Vec3 stiffness = Vec3::Zero(), slack = Vec3::Zero();
    bool damper = false;
    Vec3 force = Vec3::Zero(), trial_force = Vec3::Zero();  // N, of a damper on the body
    double lost = 0;                                        // J, up to the committed state
  };
  explicit BodyLoads(BodyState& state) : state_(state) {}
  void add();  // those of the model, once the bodies are known
  bool any() const { return !loads_.empty() || !springs_.empty(); }
  const std::vector<Spring>& springs() const { return springs_; }
  // Adds them to the forces of contact at the start of the run; and at the end of the step, their means in
  // the step in implicit steps.
  void begin();
  void apply();
  void commit();
  void keep(Archive& archive);

  void add_forces_on(std::size_t i, Vec3& force) const;  // N, on body i in the present state
  double spring_energy() const;                          // J, stored
  double damped() const;                                 // J, lost in dampers so far
  double spring_work() const;  // J, of the changes of the springs' forces in the step, on their stretch
  StepWork work() const;       // in the step, of loads, and of what drives the far ends of springs
  double stable_step() const;  // s, of explicit steps, for springs and dampers

 private:
  struct Load {
    std::size_t body;  // in BodyState::bodies
    const model::BodyLoad* given;
  };
  Vec3 displacement_of(std::size_t body, bool end) const;  // m, of its centre since time 0
  Vec3 stretch(const Spring& spring, bool end) const;
  Vec3 total(const Load& load, double time) const;
  Vec3 pull(const Spring& spring) const;
  void push(const Spring& spring, const Vec3& force);
  void push(const Load& load, const Vec3& total);
  double lost_in(const Spring& spring) const;

  BodyState& state_;
  std::vector<Load> loads_;
  std::vector<Spring> springs_;
};

}  // namespace fabricsh::mechanics
