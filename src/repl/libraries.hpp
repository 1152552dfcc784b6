// What the prompt and the language stand on.
#pragma once
#include <vector>

#include "base/version.hpp"

namespace fabricsh::repl {

std::vector<Library> libraries();  // Lua, libedit

}  // namespace fabricsh::repl
