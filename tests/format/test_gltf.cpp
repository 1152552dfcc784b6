// Content that a .glb may not have; what it is: tests/lua/export_gltf.lua.
#include "format/gltf.hpp"
#include "message_of.hpp"

using namespace fabricsh;
using namespace fabricsh::format;

namespace {

GltfScene scene() {
  GltfScene s;
  s.times = {0, 1};
  const std::vector<Vec3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, bent = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}};
  s.surfaces = {{"sheet", {{0, 1, 2, -1}}, {flat, bent}, {}}};
  return s;
}

}  // namespace

TEST_CASE("glTF: lists of other lengths than the frames and points are refused by name", "[files]") {
  CHECK(glb(scene()).starts_with("glTF"));
  auto s = scene();
  s.times = {0, 1, 2};
  says(message_of([&] { glb(s); }),
       "surface 'sheet': expected as many points, and colours, in each of 3 frames");
  s = scene();
  s.surfaces[0].frames[1].pop_back();
  says(message_of([&] { glb(s); }), "in each of 2 frames");
  s = scene();
  s.surfaces[0].colours = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  says(message_of([&] { glb(s); }), "in each of 2 frames");
  s = scene();
  s.surfaces[0].cells.clear();
  says(message_of([&] { glb(s); }), "surface 'sheet' has no cell");
  s.surfaces.clear();
  says(message_of([&] { glb(s); }), "at least one frame of a surface");
}

TEST_CASE("glTF: the same scene is the same bytes, of a length that is a multiple of 4", "[files]") {
  for (const bool morph : {false, true}) {
    auto s = scene();
    s.morph = morph;
    const std::string bytes = glb(s);
    CHECK(bytes == glb(s));
    CHECK(bytes.size() % 4 == 0);
  }
}
