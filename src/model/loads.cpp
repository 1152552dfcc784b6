#include "model/loads.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::model {

Mat3 frame_from(const Vec3& e1, const Vec3& e2) {
  const Vec3 third = e1.cross(e2);
  if (!(third.norm() > 1e-9 * e1.norm() * e2.norm()) || !std::isfinite(third.norm()))
    throw Error("frame: expected two directions {e1, e2} that are not parallel");
  Mat3 frame;
  frame.row(0) = e1.normalized().transpose();
  frame.row(2) = third.normalized().transpose();
  frame.row(1) = frame.row(2).cross(frame.row(0));
  return frame;
}

void LoadCheck::components(const Components& value, const char*) const {
  if (!value[0] && !value[1] && !value[2])
    throw Error(call_ + ": expected at least one of x, y, z, got none");
}

void LoadCheck::stiffness(const std::array<double, 3>& value, const char* unit) const {
  for (const double k : value)
    if (!(k >= 0) || !std::isfinite(k))
      throw Error(call_ + ": expected stiffnesses of 0 or more in " + unit + ", got " + number(k));
}

void LoadCheck::elements(const mesh::Mesh& mesh, const std::string& set) const {
  if (mesh.elements_in(mesh.set(set)).empty())
    throw Error(call_ + ": set '" + set + "' holds no whole element");
}

}  // namespace fabricsh::model
