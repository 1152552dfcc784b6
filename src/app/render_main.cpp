// fabricsh-render: reads the description of a picture from its input and writes a PNG. Used by fabric.render.
#include <iostream>

#include "render/complaints.hpp"
#include "render/display.hpp"
#include "render/draw.hpp"

int main() {
  using namespace fabricsh;
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
