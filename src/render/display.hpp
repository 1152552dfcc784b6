// A display for machines without a screen.
#pragma once
#include <sys/types.h>

namespace fabricsh::render {

// A virtual display (Xvfb) that exists as long as the object and sets the variable DISPLAY.
// If Xvfb is not installed, the display named by DISPLAY is used. Error: neither exists.
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
