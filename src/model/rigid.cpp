#include "model/rigid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/utf8.hpp"
#include "contact/scene.hpp"

namespace fabricsh::model {

namespace {

std::string text(const Vec3& v) {
  return "(" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
}

const char* kind_of(const RigidShape& shape) {
  constexpr const char* kinds[] = {"sphere", "plane", "cylinder", "disc", "surface", "moving surface"};
  return kinds[shape.index()];
}

// Checks the fields of a shape and throws the errors of its constructor.
class Checks {
 public:
  explicit Checks(std::string call) : call_(std::move(call)) {}
  [[noreturn]] void refuse(const std::string& field, const std::string& why) const {
    throw Error(call_ + ": field '" + field + "': " + why);
  }
  void length(const char* field, double value) const {
    if (!(value > 0) || !std::isfinite(value))
      refuse(field, "expected a positive length in m, got " + number(value));
  }
  void point(const char* field, const Vec3& v) const {
    if (!v.allFinite()) refuse(field, "expected a finite place {x, y, z} in m, got " + text(v));
  }
  void direction(const char* field, const Vec3& v) const {
    if (!v.allFinite() || !(v.norm() > 0)) refuse(field, "expected a direction {x, y, z}, got " + text(v));
  }
  void facets(const Facets& f, const std::optional<double>& mass) const {
    if (f.triangles.empty()) refuse("mesh", "expected a surface of at least one facet, got none");
    for (const Vec3& v : f.vertices)
      if (!v.allFinite()) refuse("mesh", "expected finite vertices in m, got " + text(v));
    if (!f.closed && !mass) return;
    try {
      contact::solid_mass(f.vertices, f.triangles, mass.value_or(1));
    } catch (const Error& error) {
      refuse(mass ? "mass" : "closed", error.what());
    }
  }
  void times(const std::vector<double>& times) const {
    for (std::size_t i = 0; i < times.size(); ++i)
      if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1])))
        refuse("times", "expected finite times in s that ascend, got " + number(times[i]) + " as number " +
                            std::to_string(i + 1));
  }
  void moving(const MovingFacets& m) const {
    times(m.times);
    if (m.times.size() != m.shapes.size())
      refuse("times", "expected as many times as shapes, got " + std::to_string(m.times.size()) + " and " +
                          std::to_string(m.shapes.size()));
    for (std::size_t i = 0; i < m.shapes.size(); ++i) {
      if (m.shapes[i].size() != m.first.vertices.size())
        refuse("files", "expected the same facets in every shape, got " + std::to_string(m.shapes[i].size()) +
                            " vertices in shape " + std::to_string(i + 1) + " and " +
                            std::to_string(m.first.vertices.size()) + " in the first");
      for (const Vec3& v : m.shapes[i])
        if (!v.allFinite()) refuse("files", "shape " + std::to_string(i + 1) + ": expected finite vertices");
      if (i > 0 && m.first.closed) solid(m, i);
    }
  }
  // Facets whose order was right in the first shape may be turned inside out in a later one.
  void solid(const MovingFacets& m, std::size_t i) const {
    try {
      contact::solid_mass(m.shapes[i], m.first.triangles, 1);
    } catch (const Error& error) {
      refuse("closed", "shape " + std::to_string(i + 1) + ": " + error.what());
    }
  }

 private:
  std::string call_;
};

// Of its area, whatever axes it is given in.
Vec3 centre_of(const Facets& f) {
  const auto x = [&f](std::int32_t i) -> const Vec3& { return f.vertices[static_cast<std::size_t>(i)]; };
  const Vec3& origin = x(f.triangles.front()[0]);
  double area = 0;
  Vec3 moment = Vec3::Zero();
  for (const auto& [i, j, k] : f.triangles) {
    const Vec3 a = x(i) - origin, b = x(j) - origin, c = x(k) - origin;
    const double twice = (b - a).cross(c - a).norm();
    area += twice;
    moment += twice / 3 * (a + b + c);
  }
  return area > 0 ? Vec3(origin + moment / area) : origin;
}

struct CentreOf {
  Vec3 operator()(const Sphere& s) const { return s.centre; }
  Vec3 operator()(const Plane& p) const { return p.point; }
  Vec3 operator()(const Cylinder& c) const { return (c.from + c.to) / 2; }
  Vec3 operator()(const Disc& d) const { return d.centre; }
  Vec3 operator()(const Facets& f) const { return centre_of(f); }
  Vec3 operator()(const MovingFacets& m) const { return centre_of(m.first); }
};

struct Check {
  const Checks& is;
  const std::optional<double>& mass;
  void operator()(const Sphere& s) const {
    is.length("radius", s.radius);
    is.point("centre", s.centre);
  }
  void operator()(const Plane& p) const {
    is.point("point", p.point);
    is.direction("normal", p.normal);
    if (mass) is.refuse("mass", "a plane has no end and cannot be free: expected nothing");
  }
  void operator()(const Cylinder& c) const {
    is.length("radius", c.radius);
    is.point("from", c.from);
    is.point("to", c.to);
    if (!((c.to - c.from).norm() > 0)) is.refuse("to", "expected another place than 'from'");
  }
  void operator()(const Disc& d) const {
    is.length("radius", d.radius);
    is.point("centre", d.centre);
    is.direction("normal", d.normal);
    if (!(d.edge > 0) || !(d.edge < d.radius))
      is.refuse("edge", "expected a length in m above 0 and below the radius of " + number(d.radius) +
                            " m, got " + number(d.edge));
  }
  void operator()(const Facets& f) const { is.facets(f, mass); }
  void operator()(const MovingFacets& m) const {
    is.facets(m.first, {});
    is.moving(m);
    if (mass) is.refuse("mass", "a surface that moves from shape to shape cannot be free: expected nothing");
  }
};

}  // namespace

Rigid::Rigid(RigidShape shape, std::optional<double> mass, std::string name, const std::string& call)
    : shape_(std::move(shape)), mass_(mass), name_(std::move(name)), kind_(kind_of(shape_)) {
  const Checks is(call);
  want_plain(name_, call + ": field 'name'");
  if (mass_ && (!(*mass_ > 0) || !std::isfinite(*mass_)))
    is.refuse("mass", "expected a positive number in kg, got " + number(*mass_));
  std::visit(Check{is, mass_}, shape_);
  centre_ = free() ? weigh().centre : std::visit(CentreOf{}, shape_);
}

const Facets* Rigid::facets() const {
  if (const auto* moving = std::get_if<MovingFacets>(&shape_)) return &moving->first;
  return std::get_if<Facets>(&shape_);
}

contact::Mass Rigid::weigh() const {
  const double mass = mass_.value_or(0);
  if (const auto* s = std::get_if<Sphere>(&shape_)) return contact::ball_mass(s->centre, s->radius, mass);
  if (const auto* c = std::get_if<Cylinder>(&shape_))
    return contact::rod_mass(c->from, c->to, c->radius, mass);
  if (const auto* d = std::get_if<Disc>(&shape_))
    return contact::disc_mass(d->centre, d->normal, d->radius, 2 * d->edge, mass);
  const Facets* f = facets();
  return f == nullptr ? contact::Mass{} : contact::solid_mass(f->vertices, f->triangles, mass);
}

std::string Rigid::describe() const {
  std::string words = kind_;
  if (const auto* s = std::get_if<Sphere>(&shape_))
    words += " of radius " + number(s->radius) + " m at " + text(s->centre) + " m";
  if (const auto* p = std::get_if<Plane>(&shape_))
    words += " through " + text(p->point) + " m, normal " + text(p->normal);
  if (const auto* c = std::get_if<Cylinder>(&shape_))
    words += " of radius " + number(c->radius) + " m from " + text(c->from) + " to " + text(c->to) + " m";
  if (const auto* d = std::get_if<Disc>(&shape_))
    words += " of radius " + number(d->radius) + " m and edge " + number(d->edge) + " m at " +
             text(d->centre) + " m, normal " + text(d->normal);
  if (const Facets* f = facets()) words += " of " + std::to_string(f->triangles.size()) + " facets";
  if (mass_) words += ", " + number(*mass_) + " kg";
  return words;
}

namespace {

struct AddTo {
  contact::Scene& scene;
  int operator()(const Sphere& s) const { return scene.add_ball(s.centre, s.radius); }
  int operator()(const Plane& p) const { return scene.add_wall(p.point, p.normal); }
  int operator()(const Cylinder& c) const { return scene.add_rod(c.from, c.to, c.radius); }
  int operator()(const Disc& d) const {
    return contact::add_disc(scene, d.centre, d.normal, d.radius, d.edge);
  }
  int operator()(const Facets& f, bool changes_shape = false) const {
    return scene.add_solid(f.vertices, f.triangles, 0, changes_shape);
  }
  int operator()(const MovingFacets& m) const { return (*this)(m.first, true); }
};

// Rings about an axis, each with a position along it and a radius; facets connect neighbours.
struct Ring {
  double along, radius;
};
Facets revolve(const Vec3& origin, const Vec3& axis, const std::vector<Ring>& rings) {
  constexpr int sides = 48;
  const Vec3 n = axis.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
  Facets out;
  out.closed = true;
  for (const Ring& ring : rings)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      out.vertices.push_back(origin + ring.along * n +
                             ring.radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  for (int r = 0; r + 1 < static_cast<int>(rings.size()); ++r)
    for (int i = 0; i < sides; ++i) {
      const int a = r * sides + i, b = r * sides + (i + 1) % sides, c = a + sides, d = b + sides;
      out.triangles.push_back({a, b, d});
      out.triangles.push_back({a, d, c});
    }
  return out;
}

// Adds a quarter of a circle about (along, radius), from angle a to b in degrees from the axis.
void add_arc(std::vector<Ring>& rings, double along, double radius, double r, double a, double b) {
  constexpr int parts = 12;
  for (int i = 0; i <= parts; ++i) {
    const double angle = (a + (b - a) * i / parts) * std::numbers::pi / 180;
    rings.push_back({along + r * std::cos(angle), std::max(1e-6 * r, radius + r * std::sin(angle))});
  }
}

struct FacetsOfShape {
  double extent;
  Facets operator()(const Sphere& s) const {
    std::vector<Ring> rings;
    add_arc(rings, 0, 0, s.radius, 180, 90);
    add_arc(rings, 0, 0, s.radius, 90, 0);
    return revolve(s.centre, Vec3::UnitZ(), rings);
  }
  Facets operator()(const Plane& p) const {
    const Vec3 n = p.normal.normalized(), u = n.unitOrthogonal(), v = n.cross(u);
    const double h = extent / 2;
    return {
        {p.point - h * u - h * v, p.point + h * u - h * v, p.point + h * u + h * v, p.point - h * u + h * v},
        {{0, 1, 2}, {0, 2, 3}},
        false};
  }
  Facets operator()(const Cylinder& c) const {
    std::vector<Ring> rings;
    add_arc(rings, 0, 0, c.radius, 180, 90);
    add_arc(rings, (c.to - c.from).norm(), 0, c.radius, 90, 0);
    return revolve(c.from, c.to - c.from, rings);
  }
  Facets operator()(const Disc& d) const {
    std::vector<Ring> rings{{-d.edge, 1e-6 * d.radius}};
    add_arc(rings, 0, d.radius - d.edge, d.edge, 180, 90);
    add_arc(rings, 0, d.radius - d.edge, d.edge, 90, 0);
    rings.push_back({d.edge, 1e-6 * d.radius});
    return revolve(d.centre, d.normal, rings);
  }
  Facets operator()(const Facets& f) const { return f; }
  Facets operator()(const MovingFacets& m) const { return m.first; }
};

}  // namespace

int add_to(contact::Scene& scene, const Rigid& body) { return std::visit(AddTo{scene}, body.shape()); }

Facets shown(const Rigid& body, double extent) { return std::visit(FacetsOfShape{extent}, body.shape()); }

}  // namespace fabricsh::model
