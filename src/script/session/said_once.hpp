// Warnings of processes that run in parallel.
#pragma once
#include "base/notice.hpp"

namespace fabricsh::script {

// A sink that shows a warning only once among all copies of this process and the process
// itself. Needed because the cases of a study, each computed in a copy, all warn of the same
// card.
Notices::Sink said_once_by_copies(Notices::Sink sink);

}  // namespace fabricsh::script
