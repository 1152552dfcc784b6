// Refusals by the machine in the calls of a session.
#pragma once

namespace fabricsh::script {

// In the Lua registry: how often a file could not be written, or memory was not given.
inline constexpr const char* refusals_key = "fabricsh.refusals";

}  // namespace fabricsh::script
