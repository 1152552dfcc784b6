// Newmark's method for nodes and directors, with Hilbert, Hughes and Taylor's alpha as an option:
//
//   x+ = x + dt v + dt^2 ((1/2 - beta) a + beta a+),   v+ = v + dt ((1 - gamma) a + gamma a+)
//   M a+ = (1 + alpha) f(x+) - alpha f(x),   f = f_ext - f_int - C v
//
// The forces of contact act with their value at the end of the step alone [kane1999]: their part of the
// acceleration counts 1/gamma times at its end and not at all at its beginning, so that
//
//   v+ = ... + dt M^-1 f_contact(x+),   x+ = ... + dt^2 beta / gamma M^-1 f_contact(x+).
//
// Without other losses (gamma = 1/2, beta = 1/4) their work is f_contact(x+) (x+ - x), which a convex energy
// never exceeds: contact cannot make energy, whatever the step.
//
// On the sphere of directors the increment is an arc from d to d+, along which vectors are moved by
// parallel_transport().
//
// The nodes of rigid bodies have accelerations towards the axis of rotation that no force on the unknowns
// shows, and the formulas above would make energy of their errors. Bodies therefore follow the midpoint's
// rule with their momentum P (six numbers) and the forces F on their unknowns:
//
//   x+ = x + dt (v + v+) / 2,   (P+ - P) / dt = (1 - gamma) F^ + gamma F^+,   F^+ = (1 + alpha) F+ - alpha F
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"
#include "mechanics/terms/inertia.hpp"

namespace fabricsh::run {

struct NewmarkScheme {
  double gamma = 0.5, beta = 0.25, hht = 0;

  // Second order accurate and damping high frequencies most [hilbert1977].
  static NewmarkScheme of_hht(double alpha) { return {0.5 - alpha, (1 - alpha) * (1 - alpha) / 4, alpha}; }
};

// Velocities and accelerations of all nodes, 3 per node, global; those of directors are tangent to the
// sphere.
struct NodalMotion {
  mechanics::NodalRates v, a;  // m/s and 1/s; m/s^2 and 1/s^2
  void keep(Archive& archive) { archive(v.x, v.d, a.x, a.d); }
};

class Newmark final : public mechanics::Motion {
 public:
  Newmark(mechanics::Assembly& assembly, const mechanics::Inertia& inertia, const NewmarkScheme& scheme);

  const NewmarkScheme& scheme() const { return scheme_; }
  void set_scheme(const NewmarkScheme& scheme) { scheme_ = scheme; }  // from the next step on
  const mechanics::Inertia& inertia() const { return inertia_; }
  const NodalMotion& committed() const { return before_; }
  const NodalMotion& trial() const { return trial_; }
  // Of the forces of contact in the scheme's balance, with which they count once at the step's end.
  double weight_at_step_end() const { return 1 / (scheme_.gamma * (1 + scheme_.hht)); }
  // Whether velocities are those of a complete trial step, to be read before the commit.
  void show_trial(bool tried) { tried_ = tried; }
  const mechanics::NodalRates& velocities() const { return (tried_ ? trial_ : before_).v; }
  // Starts a run with these velocities; the trial state is the committed one.
  void start(const mechanics::NodalRates& velocities);
  void set_accelerations(mechanics::NodalRates a) { before_.a = std::move(a); }  // at the start
  // N and N m: the change of a rigid body's momentum and angular momentum in the step, over its length.
  std::array<double, 6> rate_of_momentum(const mechanics::RigidBody& body) const;
  // Computes the trial motion after dt() from the increment between committed and trial configuration.
  void update();
  // Commits the trial motion. targets: of the driven freedoms at `time`; their displacements get the rate of
  // the step just made, because Newmark's formulas would oscillate after a kink.
  void commit(double time, std::span<const double> targets);
  // Subtracts accelerations from the committed ones, which the next step then begins without.
  void take_off(const mechanics::NodalRates& a);
  // Sets the rates of the driven degrees of freedom in the present step.
  void drive(std::vector<double> rates) { driven_ = std::move(rates); }
  // N: the largest component of an inertia force on a node.
  double largest_inertia() const;
  void keep(Archive& archive) { archive(before_); }

  std::span<const double> rates() const override;
  std::vector<double> driven_rates() const override { return driven_; }
  double damping_weight() const override { return (1 + scheme_.hht) * scheme_.gamma / scheme_.beta / dt(); }
  double work(std::span<const double> before, std::span<const double> after) const override;
  double work_of_velocity(double factor) const override { return work_on_mass(factor, before_.v, trial_.v); }
  double work_of_acceleration() const override { return work_on_mass(1, before_.a, trial_.a); }
  double kinetic() const override;

 private:
  // J, work of forces equal to mass times `factor` times these rates, without driven displacements.
  double work_on_mass(double factor, const mechanics::NodalRates& before,
                      const mechanics::NodalRates& after) const;
  void update_rigid(std::size_t node, std::span<const double> now, std::span<const double> old);
  double along(const mechanics::DrivenFreedom& m, std::span<const double> v) const;

  mechanics::Assembly& assembly_;
  const mechanics::Inertia& inertia_;
  NewmarkScheme scheme_;
  NodalMotion before_, trial_;
  std::vector<double> driven_;
  mutable std::vector<double> rates_;
  bool tried_ = false;
};

// Parallel transport of the tangent vector u from d to e along their arc; unit vectors, e != -d.
Vec3 parallel_transport(const Vec3& u, const Vec3& d, const Vec3& e);
// The arc from d to e as a tangent vector at d, rad.
Vec3 arc(const Vec3& d, const Vec3& e);

}  // namespace fabricsh::run
