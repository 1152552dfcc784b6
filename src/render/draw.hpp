// Draws a picture off-screen with VTK.
#pragma once
#include <string>
#include <vector>

#include "plot/picture.hpp"

namespace fabricsh::render {

// Writes picture.png. Needs the display that the variable DISPLAY names. Returns warnings about texts that do
// not fit. Error: no panel, an unreadable file, or a field that the file does not have (the message lists
// those that it has).
std::vector<std::string> draw(const plot::Picture& picture);

}  // namespace fabricsh::render
