// Whether two models are of the same cloth, so that the state of one is a state of the other.
#pragma once
#include <string>

#include "model/model.hpp"

namespace fabricsh::run {

// In what they differ; empty: in nothing. duration: s, over which histories are compared.
std::string cloth_differs(const model::Model& there, const model::Model& here, double duration);
std::string contact_differs(const model::Model& there, const model::Model& here, double duration);

}  // namespace fabricsh::run
