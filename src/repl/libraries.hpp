// The libraries used by the prompt and by the language.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::repl {

std::vector<Library> libraries();  // Lua, libedit

}  // namespace fabricsh::repl
