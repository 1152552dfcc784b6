// Sheets in motion that stay flat since nothing breaks their symmetry, where real ones buckle.
#pragma once
#include <optional>
#include <string>

#include "mechanics/assembly.hpp"
#include "run/values.hpp"
#include "solver/stability.hpp"

namespace fabricsh::run {

// Moments about fixed axes have no energy, and their tangent may yet be symmetric. Where the law has none,
// but all loads do, the second-order work decides.
solver::Judge judge_of(const model::Model& model, const mechanics::Assembly& assembly);

// Whether all nodes lie in one plane, to rounding.
bool is_flat(const mechanics::Assembly& assembly);

// Where a flat sheet that supports hold or move, in its committed state, leaves its plane by itself: words
// with the place that moves most. Empty: it does not, or nothing holds it, or contact or seams do. The state
// is judged by a model without the history of its law, so that nothing of the run is touched.
std::optional<std::string> leaves_its_plane(const model::Model& model, const mechanics::Assembly& assembly);

}  // namespace fabricsh::run
