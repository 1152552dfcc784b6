// Newmark's method for nodes and directors, with Hilbert, Hughes and Taylor's alpha as an option:
//
//   x+ = x + dt v + dt^2 (delta a + beta a+),   v+ = v + dt ((1 - gamma) a + gamma a+)
//   M a+ = (1 + alpha) f(x+) - alpha f(x),   f = f_ext - f_int - C v
//
// with delta = 1/2 - beta. The generalised trapezoidal rule is of the same form,
//
//   x+ = x + dt ((1 - theta) v + theta v+),   v+ = v + dt ((1 - theta) a + theta a+),
//
// with gamma = theta, beta = theta^2 and delta = theta (1 - theta). Every mode of a linear system decays in
// it as in Newmark's method with gamma' = 2 theta - 1/2 and beta' = (1/2 + gamma')^2 / 4, but its velocities
// are those of the motion, and of a linear system it only takes energy, in every step:
//
//   change of energy = -(theta - 1/2) ((v+ - v) M (v+ - v) + (x+ - x) K (x+ - x)).
//
// The forces of contact act with their value at the end of the step alone [kane1999], with the impulse and
// the way of a constant force:
//
//   v+ = ... + dt M^-1 f_contact(x+),   x+ = ... + dt^2 (delta + beta) M^-1 f_contact(x+).
//
// So what is pressed at rest has no velocity. In the generalised trapezoidal rule, of which theta = 1/2 is
// that of average acceleration, their work is f_contact(x+) (x+ - x), which a convex energy never exceeds:
// contact cannot make energy, whatever the step.
//
// On the sphere of directors the increment is an arc from d to d+, along which vectors are moved by
// parallel_transport().
//
// The nodes of rigid bodies have accelerations towards the axis of rotation that no force on the unknowns
// shows, and the formulas above would make energy of their errors. Bodies therefore follow the midpoint's
// rule with their momentum P (six numbers) and the forces F on their unknowns:
//
//   x+ = x + dt (v + v+) / 2,   (P+ - P) / dt = (1 - gamma) F^ + gamma F^+,   F^+ = (1 + alpha) F+ - alpha F
//
// or, where the generalised trapezoidal rule has been asked for, its x+ = x + dt ((1 - theta) v + theta v+).
#pragma once
#include <array>
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"
#include "mechanics/terms/inertia.hpp"

namespace fabricsh::run {

struct NewmarkScheme {
  double gamma = 0.5, beta = 0.25, hht = 0, delta = 0.25;
  double late = 0.5;  // of a rigid body's velocity at the end of a step in its mean

  // Second order accurate and damping high frequencies most [hilbert1977].
  static NewmarkScheme of_hht(double alpha) {
    return of_newmark(0.5 - alpha, (1 - alpha) * (1 - alpha) / 4, alpha);
  }
  static NewmarkScheme of_newmark(double gamma, double beta, double alpha = 0) {
    return {gamma, beta, alpha, 0.5 - beta};
  }
  static NewmarkScheme trapezoidal(double theta, bool bodies_too = true) {
    return {theta, theta * theta, 0, theta * (1 - theta), bodies_too ? theta : 0.5};
  }

  bool is_trapezoidal() const { return beta == gamma * gamma && delta == gamma * (1 - gamma); }
  // Of a force at the step's end alone, in the acceleration there, so that it has the way of a constant one;
  // and the share of its impulse that is then missing in the velocity.
  double weight_at_end() const { return (delta + beta) / beta; }
  double missing_at_end() const { return is_trapezoidal() ? 0 : 1 - gamma * weight_at_end(); }
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
  double weight_at_step_end() const { return scheme_.weight_at_end() / (1 + scheme_.hht); }
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
  // Commits the trial motion. The displacements of driven freedoms get their rates of drive(), because
  // Newmark's formulas would oscillate after a kink.
  void commit();
  // Subtracts accelerations from the committed ones, which the next step then begins without. The committed
  // velocities get `impulse` (s) times them.
  void take_off(const mechanics::NodalRates& a, double impulse = 0);
  // Sets the rates of the driven degrees of freedom at the end of the present step.
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
  double weight_of_end() const override { return scheme_.is_trapezoidal() ? scheme_.gamma : 0.5; }
  double kinetic() const override;

 private:
  // J, work of forces equal to mass times `factor` times these rates, without driven displacements.
  double work_on_mass(double factor, const mechanics::NodalRates& before,
                      const mechanics::NodalRates& after) const;
  std::vector<double> mean_rates() const;
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
