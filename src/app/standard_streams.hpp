// Standard input, output and error that the caller has closed.
#pragma once

namespace fabricsh::app {

// Fills those that are closed with /dev/null, opened the wrong way round: using them fails as before, but no
// file that is opened later gets their number and with it what is printed. To be called before any file is
// opened.
void hold_standard_streams();

}  // namespace fabricsh::app
