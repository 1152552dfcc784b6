// Settings of libraries before the program's work begins: environment variables that they read when they
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

// --- Reports output that did not reach standard output.

// After this call every end of the program checks standard output: if it is full or closed, that is reported,
// and the exit code 0 becomes 1.
void watch_output();

// --- Standard input, output and error that the caller has closed.

// Fills standard streams that are closed with /dev/null, standard input for writing and the outputs for
// reading: using them fails as before, but no file that is opened later gets their number, and so the output.
// To be called before any file is opened.
void hold_standard_streams();

// --- The version of this program and its environment.

std::string headline();  // "fabricsh 0.2.0 (Release, GNU 12.2.0)"
// The headline, then versions of the libraries, the instruction set, the threads, and the locations of the
// drawing programs.
std::string about();

}  // namespace fabricsh::app
