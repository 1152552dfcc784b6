// A linear solver of one's own for a run's steps, in place of those of the room linear.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "linear/linear_solver.hpp"
#include "linear/near_symmetric.hpp"

namespace fabricsh::run {

// Of the direct solver's matrices. automatic: symmetric where law and loads are.
enum class Symmetry { automatic, symmetric, unsymmetric };

struct SolverChoice {
  std::string name;  // for checkpoints: a restart with another solver is refused, since results would differ
  // symmetric: whether the matrices are; both triangles are stored even if they are.
  std::function<std::unique_ptr<linear::LinearSolver>(bool symmetric)> make;
};

// Whether the solver takes the matrices for symmetric; symmetric: whether those of all terms are.
inline bool takes_symmetric(Symmetry wanted, bool symmetric) {
  return wanted == Symmetry::symmetric || (wanted == Symmetry::automatic && symmetric);
}

inline std::unique_ptr<linear::LinearSolver> make_solver(const std::optional<SolverChoice>& choice,
                                                         bool symmetric) {
  return linear::with_ranks(choice      ? choice->make(symmetric)
                            : symmetric ? linear::make_symmetric_solver()
                                        : linear::make_unsymmetric_solver());
}

// near: the matrices are symmetric but for what contact and loads add.
inline std::unique_ptr<linear::LinearSolver> make_solver(const std::optional<SolverChoice>& choice,
                                                         bool symmetric, bool near) {
  if (choice || symmetric || !near) return make_solver(choice, symmetric);
  return linear::with_ranks(linear::make_near_symmetric_solver());
}

// Ends the text of a run's method.
inline std::string solver_text(const std::optional<SolverChoice>& choice) {
  return choice ? ", solver " + choice->name : "";
}

}  // namespace fabricsh::run
