// Description of a picture of sheets with a field. The drawing is done by the program
// fabricsh-render (room render), so that fabricsh starts without the rendering libraries.
#pragma once
#include <istream>
#include <string>
#include <vector>

namespace fabricsh::plot {

struct PicturePanel {
  std::string vtu;                     // path of the file
  std::string label = {};              // shown above the panel
  double azimuth = 0, elevation = 90;  // viewing direction, degrees: 0, 90 from above; 0, 0 along +y
};

struct Picture {
  std::string png;                   // path of the file to write
  std::vector<PicturePanel> panels;  // arranged in `columns` columns
  int columns = 0;                   // 0: chosen by the shape of the picture
  std::string title;
  std::string array,
      component;      // field of cells, else of points; without a component its magnitude; empty: none
  double factor = 1;  // the colour bar shows factor times the value
  std::string bar;    // title of the colour bar, with the unit
  bool fixed_range = false;
  double low = 0, high = 0;        // range of the colour bar if fixed
  int width = 1200, height = 900;  // pixels
  bool edges = true, axes = true;  // of the elements; axes with tick labels
  bool smooth = false;             // interpolates field and shading between nodes
  double dpi = 0;                  // resolution on paper; 0: a picture for the screen
  bool fit = false;                // no wider than the things in its panels need
  double bodies = 1;               // opacity of rigid bodies
  double font_size = 7;            // points on paper; on a screen it depends on the size of the picture
};

// The description as text for fabricsh-render, and the reverse. Error: a line that is not valid.
std::string picture_text(const Picture& picture);
Picture read_picture(std::istream& text);

// Replaces the PNG. `program`: path of fabricsh-render. Returns warnings about texts that do not fit. Error:
// the program is missing, there is no display and no Xvfb to create one, or a file or field is missing, with
// the program's message.
std::vector<std::string> render(const Picture& picture, const std::string& program);

}  // namespace fabricsh::plot
