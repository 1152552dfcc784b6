// Draws a picture with VTK, off-screen.
#pragma once
#include "plot/picture.hpp"

namespace fabricsh::render {

// Writes picture.png. Needs a display that environment variable DISPLAY names. Error: no panel, a file that
// can't be read, a field that it doesn't hold (with those that it holds).
void draw(const plot::Picture& picture);

}  // namespace fabricsh::render
