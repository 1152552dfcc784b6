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

// Sets a field of the table on top of the stack to the values times the scale.
void set_scaled(lua_State* L, const char* name, std::vector<double> values, double scale = 1);

std::vector<Entry> correlation_rows();

}  // namespace fabricsh::script
