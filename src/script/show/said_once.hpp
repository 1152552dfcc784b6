// Warnings of processes that work side by side.
#pragma once
#include "base/notice.hpp"

namespace fabricsh::script {

// A sink behind which a warning that one copy of this process has said is said by no other, nor by the
// process itself afterwards: the cases of a study warn of the same card, and each is computed in a copy of
// its own.
Notices::Sink said_once_by_copies(Notices::Sink sink);

}  // namespace fabricsh::script
