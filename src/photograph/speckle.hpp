// Photographs of speckled cloth under a known map, for trying the correlation.
#pragma once
#include "lab/photographs.hpp"
#include "photograph/image.hpp"

namespace fabricsh::photograph {

using lab::Speckles;

// Every blot lets 1 - exp(-r^2 / (2 size^2)) of the light through, so the brightness is a smooth function
// that is known at every place, and a map of the cloth is exact: no picture is interpolated. 8 bits.
Image draw(const Speckles& speckles);

}  // namespace fabricsh::photograph
