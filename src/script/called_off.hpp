// Ctrl-C stops all that one input or deck does: where a pcall has caught it, no further run goes on.
#pragma once
#include "script/session.hpp"

namespace fabricsh::script {

// Said where Ctrl-C has ended something; lasts until the next input.
void call_off(Session& session);
void begin_input(Session& session);
bool is_called_off(Session& session);

}  // namespace fabricsh::script
