// Collects the messages that VTK would print, so that they can be reported in plain words.
#pragma once
#include <string>

namespace fabricsh::render {

// After this call VTK prints nothing.
void collect_complaints();
// The first message since the last call, without
// its position in VTK's sources; empty: no message.
std::string take_complaint();

}  // namespace fabricsh::render
