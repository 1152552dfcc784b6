// Rigid bodies that forces place, in statics.
#include <Eigen/Eigenvalues>

#include "base/error.hpp"
#include "linear/linear_solver.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/static.hpp"

namespace fabricsh::run {

void Static::check_bodies() const {
  const mechanics::Contacts* contact = assembly_->terms().find<mechanics::Contacts>();
  if (contact == nullptr) return;
  for (const auto& given : model().interactions().contacts())
    if (given.viscosity)
      throw Error(
          "static: contact: field 'film': nothing slides with a speed in a static run, so that a film would "
          "do "
          "nothing: expected none, or fabric.dynamic");
  if (contact->bodies().any_free() &&
      (options_.control == Control::arc || options_.stabilise > 0 || options_.method == Method::relaxation))
    throw Error(
        "static: a rigid body that forces place (a mass, m:force, m:spring, m:fix of a part) is sought by "
        "Newton's method alone: expected control=\"load\", no stabilise and no method=\"relaxation\"");
  if (options_.control == Control::arc && contact->bodies().any_driven())
    throw Error("static: field 'control': \"arc\" does not work with moved rigid bodies: expected \"load\"");
}

// With the factors of judging_.
Eigen::MatrixXd Static::stiffness_of_bodies(const linear::Matrix& K) {
  return assembly_->own_stiffness([&](std::span<const double> b, std::span<double> x) {
    return judging_->solve(K, b, x) && linear::all_finite(x);
  });
}

// Of cloth that is stable while the bodies stand: bodies and cloth together are so if the stiffness of the
// bodies, cloth following them, has no negative eigenvalue.
solver::Stability Static::judge_bodies(const linear::Matrix& K) {
  constexpr double kNothing = 1e-9;  // of the largest: of what turns or rolls freely
  if (K.size() > 0 && !judging_->factorise(K)) return solver::Stability::unchecked;
  const Eigen::MatrixXd A = stiffness_of_bodies(K);
  if (A.size() == 0 || !A.allFinite()) return solver::Stability::unchecked;
  const Eigen::VectorXd values = A.eigenvalues().real();
  return values.minCoeff() < -kNothing * values.cwiseAbs().maxCoeff() ? solver::Stability::unstable
                                                                      : solver::Stability::stable;
}

// Motions of bodies that nothing holds: where their stiffness, cloth following them, is nothing or negative.
std::string Static::loose_bodies() {
  constexpr double kNothing = 1e-9;  // of the largest of its kind
  const auto* contact = assembly_->terms().find<mechanics::Contacts>();
  if (!places_bodies_ || contact == nullptr || !contact->bodies().any_free()) return {};
  if (!judging_) judging_ = make_solver(options_.solver, !takes_unsymmetric());
  linear::Matrix K;
  if (problem_->tangent(K) != Answer::ok || (K.size() > 0 && !judging_->factorise(K))) return {};
  const Eigen::MatrixXd A = stiffness_of_bodies(K);
  if (A.size() == 0 || !A.allFinite()) return {};
  const mechanics::Bodies& bodies = contact->bodies();
  double largest[2] = {0, 0};  // N/m of places, N m of turns
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    double& most = largest[k % 6 / 3];
    most = std::max(most, std::abs(A(k, k)));
  }
  std::string words;
  for (std::size_t i = 0; i < bodies.count(); ++i) {
    const auto [first, end] = bodies.vertices(i);
    if (first == end || bodies.state().free_of[first] < 0) continue;
    std::string ways;
    for (int c = 0; c < 6; ++c) {
      const Eigen::Index k = 6 * bodies.state().free_of[first] + c;
      if (A(k, k) > kNothing * largest[c / 3]) continue;
      ways +=
          (ways.empty() ? "" : " and ") + std::string(c < 3 ? "move along " : "turn about ") + "xyz"[c % 3];
    }
    if (ways.empty()) continue;
    words += (words.empty() ? "" : "; ") + std::string("nothing holds the ") +
             model_->interactions().name_of(bodies.body(i)) + " that forces place, which may " + ways +
             ": m:fix or m:spring of the body, or m:tie(\"rigid\", set, body)";
  }
  return words;
}

}  // namespace fabricsh::run
