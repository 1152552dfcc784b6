// fabricsh-render: reads the description of a picture from its input and writes a PNG. Used by fabric.render.
#include <cstdlib>
#include <iostream>

#include "render/draw.hpp"

int main() {
  using namespace fabricsh;
  // On several threads the order of polygons, and with it some pixels, would differ from one drawing of the
  // same state to the next.
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  try {
    render::collect_complaints();
    const plot::Picture picture = plot::read_picture(std::cin);
    const render::Display display;
    for (const std::string& words : render::draw(picture)) std::cout << words << "\n";
    return 0;
  } catch (const std::exception& trouble) {
    std::cerr << trouble.what() << std::endl;
    return 1;
  }
}
