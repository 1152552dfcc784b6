// The legend of a figure: its size, its position and its entries.
#pragma once
#include "plot/layout.hpp"

namespace fabricsh::plot {

struct KeySize {
  int rows = 0, columns = 1;
  double column = 0;             // column width, points
  double width = 0, height = 0;  // total
};

// Below the axes the legend has as many columns as fit into the width, elsewhere one.
KeySize key_size(const Figure& figure, double letter, double width, Key place);

// Box for a legend of this size. false: Key::best was asked for, and every corner is covered by a curve.
bool key_box(const Figure& figure, const PlacedPanel& panel, const KeySize& size, double letter, Key place,
             PageBox& box);

// Adds the texts and line samples of the legend in panel.key.
void fill_key(const Figure& figure, PlacedPanel& panel, const KeySize& size, double letter);

}  // namespace fabricsh::plot
