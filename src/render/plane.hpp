// Text, lines and colours in a part of a picture; positions in pixels from its lower left corner.
#pragma once
#include <vtkLookupTable.h>
#include <vtkRenderer.h>

#include <string>

#include "render/layout.hpp"

namespace fabricsh::render {

// Width and height of a text in the given font size.
Point text_size(const std::string& text, int size);

void write(vtkRenderer* renderer, const std::string& text, int size, const Point& centre);
// In smaller letters where the room is narrower than the text, down to three quarters; what is too long even
// in these ends in three points. Returns whether all of it stands there.
bool write_fitted(vtkRenderer* renderer, const std::string& text, int size, const Point& centre, double room);

void add_line(vtkRenderer* renderer, const Point& from, const Point& to, double width);
// The table's colours from the lower end up, in the rectangle with these corners.
void add_colours(vtkRenderer* renderer, vtkLookupTable* table, const Point& low, const Point& high);

}  // namespace fabricsh::render
