// Draws a picture off-screen with VTK.
#pragma once
#include <string>
#include <vector>

#include "plot/picture.hpp"

namespace fabricsh::render {

// Writes picture.png. Returns what is to be told of words that have no room. Needs a display that environment
// variable DISPLAY names. Error: no panel, a file that can't be read, a field that it doesn't hold (with
// those that it holds).
std::vector<std::string> draw(const plot::Picture& picture);

}  // namespace fabricsh::render
