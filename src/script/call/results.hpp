// The result types of registered functions, for completion without calling them.
#pragma once
#include <string>
#include <string_view>

namespace fabricsh::script {

// Class of the object that a function, method or property returns; "self": the object on which the method was
// called; empty: not an object, or not fixed.
std::string result_class(std::string_view entry);

}  // namespace fabricsh::script
