// What the functions of the registry return, for who must know without calling them.
#pragma once
#include <string>
#include <string_view>

namespace fabricsh::script {

// Class of the object that a function or method returns, or that a property is; "self": the object that the
// method was called on; empty: no object, or it depends.
std::string result_class(std::string_view entry);

}  // namespace fabricsh::script
