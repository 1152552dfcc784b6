// What the rendering library would print: kept, and told in plain words where it matters.
#pragma once
#include <string>

namespace fabricsh::render {

// From now on nothing is printed by the library itself.
void collect_complaints();
// The first complaint since the last call, without the place in the library's sources where it was made;
// empty: there was none.
std::string take_complaint();

}  // namespace fabricsh::render
