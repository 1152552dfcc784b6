// Draws a picture off-screen with VTK.
#pragma once
#include "plot/picture.hpp"

namespace fabricsh::render {

// Writes picture.png. Needs the display that the variable DISPLAY names. Error: no panel, an
// unreadable file, or a field that the file does not have (the message lists those that it has).
void draw(const plot::Picture& picture);

}  // namespace fabricsh::render
