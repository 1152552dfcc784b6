// The key of a figure: how large it is, where it lies on no curve, and its words.
#pragma once
#include "plot/layout.hpp"

namespace fabricsh::plot {

struct KeySize {
  int rows = 0, columns = 1;
  double column = 0;             // width of a column, points
  double width = 0, height = 0;  // of all
};

// Below the axes in columns, as many as the width holds; elsewhere in one.
KeySize key_size(const Figure& figure, double letter, double width, Key place);

// The box for a key of this size. false: Key::best, and none of the corners is free of curves.
bool key_box(const Figure& figure, const PlacedPanel& panel, const KeySize& size, double letter, Key place,
             Box& box);

// Adds the words and samples of the key in panel.key.
void fill_key(const Figure& figure, PlacedPanel& panel, const KeySize& size, double letter);

}  // namespace fabricsh::plot
