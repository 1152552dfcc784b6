// Photographs of cloth, of which the part that looks at them is loaded when it is first asked for.
#pragma once
#include <vector>

#include "lab/photographs.hpp"
#include "script/call/call.hpp"
#include "script/session/entry.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

// Error, in the name of the call: the part is missing.
const lab::Photographs& photographs(const Call& call);

// The optional argument `region` of a photograph: all of the picture by default.
Argument region_();
// The photographs in the argument `files`, and their `region`. Error: there are fewer than two; later: a
// region is empty or does not lie in the picture.
lab::PhotographSeries series_of(const Call& call);

// Replaces the `file` of the call by a picture of the scene.
template <class Scene>
int write_picture(const Call& call, const Scene& scene) {
  if (call.session().options().check) return 0;
  system::write_file(call.text("file"), photographs(call).picture(scene), system::Sync::no);
  return 0;
}

// Sets a field of the table on top of the stack to the values times the scale.
void set_scaled(lua_State* L, const char* name, std::vector<double> values, double scale = 1);

std::vector<Entry> correlation_rows();

}  // namespace fabricsh::script
