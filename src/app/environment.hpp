// What the libraries below read from the environment when they are loaded, before main() can speak to them.
#pragma once
#include <string>

namespace fabricsh::app {

// What cannot be in the environment: "FABRICSH_ISA: expected ...". Empty: nothing.
std::string environment_trouble();

// Sets what nobody has set, and starts the program anew if that was anything; returns when there is nothing
// to do or it can't be done.
// GOMP_SPINCOUNT: how long a thread spins before it sleeps. By default for milliseconds, which on a busy
// machine takes the processor from the very thread that it waits for.
// OPENBLAS_CORETYPE: OpenBLAS falls back on kernels of 2004 where it doesn't know a processor.
void settle_environment(char** words);

}  // namespace fabricsh::app
