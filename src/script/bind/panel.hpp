// fabric.mesh.panel: the reading of outlines, holes, darts and notches from a deck.
#pragma once
#include "script/bind/rooms.hpp"

namespace fabricsh::script {

std::vector<Entry> panel_rows();

}  // namespace fabricsh::script
