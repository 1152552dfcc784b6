#include "base/version.hpp"

#include "fabricsh_config.hpp"

namespace fabricsh {

std::string version() { return config::version; }
std::string build_kind() { return config::build_kind; }
std::string compiler() { return config::compiler; }

}  // namespace fabricsh
