#include "app/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace fabricsh::app {

// open() returns the smallest free number.
void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace fabricsh::app
