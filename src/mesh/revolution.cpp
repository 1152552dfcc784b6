// Surfaces of revolution: annulus, cylinder, hemisphere.
#include <string>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/generators.hpp"
#include "mesh/lattice.hpp"

namespace fabricsh::mesh {

namespace {

// A closed ring of two elements would collapse, as would one element over half a turn or more.
void check_around(const char* call, Index around, double angle) {
  check_angle(call, "angle", angle, 360);
  check_count(call, "around", around, angle > 180 ? 3 : angle == 180 ? 2 : 1);
}

std::string named(const char* call, Index around, Index along, double angle) {
  const std::string name = std::string(call) + " " + std::to_string(around) + "x" + std::to_string(along);
  return angle < 360 ? name + ", " + number(angle, 10) + " degrees" : name;
}

}  // namespace

Mesh annulus(const Annulus& shape) {
  check_length("annulus", "inner", shape.inner);
  check_length("annulus", "outer", shape.outer);
  if (shape.outer <= shape.inner)
    throw Error("annulus: field 'outer': expected a radius larger than 'inner'");
  check_around("annulus", shape.around, shape.angle);
  check_count("annulus", "across", shape.across);
  check_product("annulus", "around * across", shape.around, shape.across);
  const Lattice lattice{shape.around, shape.across, shape.angle == 360 && !shape.slit, true};
  Mesh mesh = fill(lattice, [&](double s, double t) -> Vec3 {
    return ((1 - t) * shape.inner + t * shape.outer) * direction(shape.angle * s);
  });
  add_sets(mesh, lattice, "inner", "outer");
  mesh.flat = true;
  mesh.origin = named("annulus", shape.around, shape.across, shape.angle);
  return mesh;
}

Mesh cylinder(const CylinderSurface& shape) {
  check_length("cylinder", "radius", shape.radius);
  check_length("cylinder", "length", shape.length);
  check_around("cylinder", shape.around, shape.angle);
  check_count("cylinder", "along", shape.along);
  check_product("cylinder", "around * along", shape.around, shape.along);
  const Lattice lattice{shape.around, shape.along, shape.angle == 360};
  Mesh mesh = fill(lattice, [&](double s, double t) -> Vec3 {
    return shape.radius * direction(shape.angle * s) + Vec3(0, 0, shape.length * t);
  });
  add_sets(mesh, lattice, "bottom", "top");
  mesh.origin = named("cylinder", shape.around, shape.along, shape.angle);
  return mesh;
}

Mesh hemisphere(const Hemisphere& shape) {
  check_length("hemisphere", "radius", shape.radius);
  if (!(shape.hole > 0 && shape.hole < 90))
    throw Error("hemisphere: field 'hole': expected a polar angle above 0 and below 90 degrees");
  check_around("hemisphere", shape.around, shape.angle);
  check_count("hemisphere", "along", shape.along);
  check_product("hemisphere", "around * along", shape.around, shape.along);
  const Lattice lattice{shape.around, shape.along, shape.angle == 360};
  Mesh mesh = fill(lattice, [&](double s, double t) -> Vec3 {
    const Vec3 meridian = direction((90 - shape.hole) * t);  // cosine and sine of the latitude
    return shape.radius * (meridian.x() * direction(shape.angle * s) + Vec3(0, 0, meridian.y()));
  });
  add_sets(mesh, lattice, "bottom", "top");
  mesh.origin = named("hemisphere", shape.around, shape.along, shape.angle);
  return mesh;
}

}  // namespace fabricsh::mesh
