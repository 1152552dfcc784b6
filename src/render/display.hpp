// A display to draw on where there is no screen.
#pragma once
#include <sys/types.h>

namespace fabricsh::render {

// A virtual display (Xvfb) for as long as the object lives, named by DISPLAY. Where Xvfb is not installed,
// the display that DISPLAY names already. Error: neither.
class Display {
 public:
  Display();
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

 private:
  pid_t server_ = 0;
};

}  // namespace fabricsh::render
