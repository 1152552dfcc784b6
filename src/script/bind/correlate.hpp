// Rows of what is done with regions and speckles of photographs.
#pragma once
#include <vector>

#include "format/image.hpp"
#include "lab/correlation.hpp"
#include "script/call/call.hpp"
#include "script/session/entry.hpp"

namespace fabricsh::script {

// The optional argument `region` of a photograph, and its value: all of the picture by default. Error: it is
// empty or does not lie in the picture.
Argument region_();
lab::PixelRegion region_of(const Call& call, const format::Image& image);

// The names in the argument `files`.
std::vector<std::string> file_names(const Call& call);

std::vector<Entry> correlation_rows();

}  // namespace fabricsh::script
