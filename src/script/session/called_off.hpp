// After Ctrl-C no further run of the same input or deck starts, even if a pcall has caught the first error.
#pragma once
#include "script/session/session.hpp"

namespace fabricsh::script {

// To be called when Ctrl-C has ended something; effective until the next input.
void call_off(Session& session);
void begin_input(Session& session);
bool is_called_off(Session& session);

}  // namespace fabricsh::script
