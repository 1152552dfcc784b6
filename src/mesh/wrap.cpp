#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/lattice.hpp"
#include "mesh/panel.hpp"

namespace fabricsh::mesh {

namespace {

constexpr double degree = std::numbers::pi / 180;

[[noreturn]] void refuse(const std::string& words) { throw Error("wrap: " + words); }

// Directions of the surface: outward at `towards`, around, along the axis.
struct Frame {
  Vec3 out, around, along;
};

Frame frame_of(const Wrap& shape) {
  if (!shape.axis.allFinite() || shape.axis.norm() == 0)
    refuse("field 'axis': expected a direction, got one without length");
  const Vec3 along = shape.axis.normalized();
  Vec3 wanted = shape.towards;
  if (wanted.isZero(0)) wanted = std::abs(along.x()) > 0.999 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitX());
  const Vec3 out = wanted - wanted.dot(along) * along;
  if (!wanted.allFinite() || out.norm() <= 1e-6 * wanted.norm())
    refuse("field 'towards': expected a direction across the axis, got one along it");
  return {out.normalized(), along.cross(out.normalized()), along};
}

// A point of the plane on the surface: angle about the axis, rad; distance from the axis and height, m.
struct Polar {
  double angle, radius, height;
};

class UnrolledSurface {
 public:
  explicit UnrolledSurface(const Wrap& shape)
      : shape_(shape), sine_(std::sin(std::abs(shape.angle) * degree)) {
    if (sine_ > 0) slant_ = shape.radius / sine_;
  }
  bool cone() const { return sine_ > 0; }
  // The apex in the plane of the panel.
  Vec2 apex() const { return shape_.at - Vec2(0, shape_.angle > 0 ? slant_ : -slant_); }

  Polar place(const Vec3& x) const {
    const double right = x.x() - shape_.at.x(), up = x.y() - shape_.at.y();
    if (!cone()) return {right / shape_.radius, shape_.radius, up};
    const double way = shape_.angle > 0 ? 1 : -1;  // from the apex to the opening, along the axis
    const double down = slant_ + way * up;         // from the apex in the plane
    const double s = std::hypot(right, down), cosine = std::sqrt(1 - sine_ * sine_);
    return {std::atan2(right, down) / sine_, s * sine_, way * (s - slant_) * cosine};
  }

 private:
  const Wrap& shape_;
  double sine_, slant_ = 0;  // of the angle; from the apex to the point `at`, m
};

void check_flat(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i].z() != 0)
      refuse("expected a mesh in the x-y plane, got node " + std::to_string(i + 1) +
             " at z = " + number(mesh.nodes[i].z()) + " m (a mesh is wrapped once)");
}

// Whether an element in the plane encloses a point or has it on its border.
bool encloses(const Mesh& mesh, const std::array<Index, 4>& ids, const Vec2& x) {
  const std::size_t n = ids[3] < 0 ? 3 : 4;
  bool left = true, right = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &a = mesh.nodes[static_cast<std::size_t>(ids[i])],
               &b = mesh.nodes[static_cast<std::size_t>(ids[(i + 1) % n])];
    const double side = (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

// The apex of a cone is in no element, and the panel does not reach around it: then the angle about it would
// jump within an element.
void check_apex(const Mesh& mesh, const UnrolledSurface& surface) {
  for (std::size_t e = 0; surface.cone() && e < mesh.elements.size(); ++e)
    if (encloses(mesh, mesh.elements[e], surface.apex()))
      refuse("field 'cone': its apex lies in the panel, at (" + number(surface.apex().x()) + ", " +
             number(surface.apex().y()) + ") in element " + std::to_string(e + 1) +
             ": expected a larger radius or a smaller angle");
}

// No element bends by more than 60 degrees.
void check_elements(const Mesh& mesh, const std::vector<Polar>& places, const UnrolledSurface& surface) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& ids = mesh.elements[e];
    const auto angle = [&](std::size_t i) { return places[static_cast<std::size_t>(ids[i])].angle; };
    double low = angle(0), high = low;
    for (std::size_t i = 1; i < (ids[3] < 0 ? 3U : 4U); ++i) {
      low = std::min(low, angle(i));
      high = std::max(high, angle(i));
    }
    if (high - low <= 60 * degree) continue;
    if (surface.cone() && high - low > 180 * degree)
      refuse("field 'cone': the panel runs around its apex, at element " + std::to_string(e + 1) +
             ": expected a larger radius or a smaller angle");
    refuse("element " + std::to_string(e + 1) + " spans " + number((high - low) / degree, 3) +
           " degrees: expected at most 60 (smaller elements, or a larger radius)");
  }
}

void check_once(const std::vector<Polar>& places) {
  const auto [low, high] = std::minmax_element(
      places.begin(), places.end(), [](const Polar& a, const Polar& b) { return a.angle < b.angle; });
  const double angle = (high->angle - low->angle) / degree;
  if (angle > 360 * (1 + 1e-9))
    refuse("the panel goes around by " + number(angle) +
           " degrees: expected at most 360 (overlap=true allows more)");
}

}  // namespace

void wrap(Mesh& mesh, const Wrap& shape) {
  check_unused(mesh, "wrap");
  check_length("wrap", "radius", shape.radius);
  if (!(std::abs(shape.angle) < 90))
    refuse("field 'angle': expected an angle between -90 and 90 degrees, got " + number(shape.angle));
  if (!shape.from.allFinite()) refuse("field 'from': expected finite coordinates, m");
  check_flat(mesh);
  const Frame frame = frame_of(shape);
  const UnrolledSurface surface(shape);
  std::vector<Polar> places;
  for (const Vec3& x : mesh.nodes) places.push_back(surface.place(x));
  check_apex(mesh, surface);
  check_elements(mesh, places, surface);
  if (!shape.overlap) check_once(places);
  mesh.map([&](const Vec3& x) -> Vec3 {
    const Polar p = surface.place(x);
    return shape.from + p.height * frame.along +
           p.radius * (std::cos(p.angle) * frame.out + std::sin(p.angle) * frame.around);
  });
  mesh.origin += shape.angle == 0 ? " around a cylinder" : " around a cone";
}

}  // namespace fabricsh::mesh
