// Draws a picture off-screen with VTK.
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "plot/picture.hpp"

namespace fabricsh::render {

// Writes picture.png. Needs the display that the variable DISPLAY names. Returns warnings about texts that do
// not fit. Error: no panel, an unreadable file, or a field that the file does not have (the message lists
// those that it has).
std::vector<std::string> draw(const plot::Picture& picture);

// --- A display for machines without a screen, and the messages that VTK would print.

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

// After this call VTK prints nothing.
void collect_complaints();
// The first message since the last call, without
// its position in VTK's sources; empty: no message.
std::string take_complaint();

}  // namespace fabricsh::render
