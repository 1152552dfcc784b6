// What libraries are given before the program's work begins: environment variables that they read when they
// are loaded, and how memory is returned.
#pragma once
#include <string>

namespace fabricsh::app {

// An invalid setting: "FABRICSH_ISA: expected ...". Empty: none.
std::string environment_error();

// Sets the variables below unless they are set already, and restarts the program if it has set any.
// Returns if there is nothing to do or a restart is impossible. GOMP_SPINCOUNT: how long a thread
// spins before it sleeps; by default some milliseconds, which on a busy machine takes the processor
// from the thread that is waited for. OPENBLAS_CORETYPE: for an unknown processor OpenBLAS uses
// kernels of 2004.
void settle_environment(char** words);

// Freed memory of up to 16 MB stays with the program.
void keep_freed_memory();

}  // namespace fabricsh::app
