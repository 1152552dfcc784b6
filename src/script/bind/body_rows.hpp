// The arguments of fabric.model: one mesh, or several with names, each with a card or plies, and with regions
// of other cards.
#pragma once
#include <vector>

#include "script/call/call.hpp"

namespace fabricsh::script {

std::vector<Argument> model_rows();  // of fabric.model
int make_model(Call& call);          // pushes the model

}  // namespace fabricsh::script
