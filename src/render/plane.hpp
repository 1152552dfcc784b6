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
// Uses a font smaller by up to a quarter if the room is too narrow; a text that is still too long is
// shortened and ends in three points. Returns whether the whole text was written.
bool write_fitted(vtkRenderer* renderer, const std::string& text, int size, const Point& centre, double room);

void add_line(vtkRenderer* renderer, const Point& from, const Point& to, double width);
// Fills the rectangle between these corners with the table's colours, from the lower end upwards.
void add_colours(vtkRenderer* renderer, vtkLookupTable* table, const Point& low, const Point& high);

}  // namespace fabricsh::render
