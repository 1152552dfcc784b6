#include "model/interaction.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/scene.hpp"
#include "model/declaration_rows.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

using mesh::Index;

namespace {

std::string quoted_name(const std::string& s) { return "'" + s + "'"; }

// The elements of a side; one of several bodies goes by its name. Error: unknown set, no whole element.
std::vector<Index> elements_of(const std::string& set, const mesh::Mesh& mesh) {
  for (const auto& part : mesh.parts) {
    if (part.name != set) continue;
    std::vector<Index> all(part.mesh->elements.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = part.first_element + static_cast<Index>(i);
    return all;
  }
  auto inside = mesh.elements_in(mesh.set(set));
  if (inside.empty()) throw Error("set " + quoted_name(set) + " holds no whole element, and so no surface");
  return inside;
}

void check_side(const Party& party, const mesh::Mesh& mesh) {
  if (party.body) return;
  try {
    elements_of(party.set, mesh);
  } catch (const Error& error) {
    throw Error(std::string("contact: ") + error.what());
  }
}

contact::Shape shape_of(const Rigid& body) {
  using contact::Shape;
  if (std::holds_alternative<Sphere>(body.shape())) return Shape::ball;
  if (std::holds_alternative<Plane>(body.shape())) return Shape::wall;
  return std::holds_alternative<Cylinder>(body.shape()) ? Shape::rod : Shape::solid;
}

// Bodies whose places are all given need no contact, and meet nothing but cloth.
bool bodies_meet(const Party& a, const Party& b) {
  return a.body && b.body && (a.body->free() || b.body->free());
}

// Which bodies of a contact meet each other, and whether they can.
void check_bodies(const ContactGiven& contact) {
  const auto& all = contact.between;
  bool any = std::any_of(all.begin(), all.end(), [](const Party& p) { return !p.body; });
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!bodies_meet(all[i], all[j])) continue;
      any = true;
      const std::string words = "the " + all[j].body->kind() + " and the " + all[i].body->kind();
      if (all[i].body == all[j].body)
        throw Error("contact: field 'between': expected each body once, got the " + all[i].body->kind() +
                    " twice");
      if (!contact::can_meet(shape_of(*all[i].body), shape_of(*all[j].body)) ||
          all[i].body->moving() != nullptr || all[j].body->moving() != nullptr)
        throw Error(
            "contact: field 'between': " + words +
            " do not meet each other: expected a sphere and any body that keeps its shape, or a cylinder "
            "and a sphere or plane; each of them may touch cloth in a contact of its own");
      if (contact.friction > 0 || contact.sticking.value_or(0) > 0)
        throw Error(
            "contact: field 'friction': expected 0 between " + words + ", got " + number(contact.friction) +
            ": bodies meet each other without friction (give cloth that touches them a contact of its "
            "own)");
      if (contact.across || contact.viscosity)
        throw Error("contact: field '" + std::string(contact.across ? "friction" : "film") + "': " + words +
                    " meet each other without friction and without a film (give cloth that touches them a "
                    "contact of its own)");
      if (contact.settle)
        throw Error("contact: field 'settle': " + words + ": expected bodies that begin apart");
    }
  if (!any)
    throw Error(
        "contact: field 'between': expected cloth or a body with a mass on one side at least: bodies whose "
        "places are given do not meet each other");
}

void check_positive(const char* field, const std::optional<double>& value, const char* what) {
  if (value && (!(*value > 0) || !std::isfinite(*value)))
    throw Error(std::string("contact: field '") + field + "': expected a positive " + what + ", got " +
                number(*value));
}

}  // namespace

void check(const Model& model, const ContactGiven& contact) {
  if (contact.between.empty()) throw Error("contact: expected between={...} or self=, got neither");
  for (const Party& party : contact.between) check_side(party, model.mesh());
  check_bodies(contact);
  if (!(contact.friction >= 0) || !std::isfinite(contact.friction))
    throw Error("contact: field 'friction': expected a number of at least 0, got " +
                number(contact.friction));
  if (contact.sticking && !(*contact.sticking >= contact.friction && std::isfinite(*contact.sticking)))
    throw Error("contact: field 'friction.static': expected at least the kinetic friction of " +
                number(contact.friction) + ", got " + number(*contact.sticking));
  check_positive("friction.weft", contact.across, "number");
  if (contact.across) check_positive("friction.warp", contact.friction, "number");
  if (contact.viscosity.has_value() != contact.film.has_value())
    throw Error("contact: field 'film': expected a viscosity and a thickness");
  field::require("contact", contact_rows(), contact);
}

namespace {

std::string named_body(const char* call, const Rigid& body) {
  return std::string(call) + ": the " + body.kind() +
         (body.name().empty() ? "" : " " + quoted_name(body.name()));
}

void want_one_shape(const char* call, const Rigid& body) {
  if (body.moving() != nullptr)
    throw Error(named_body(call, body) +
                " moves from shape to shape by itself: expected a body that keeps its shape");
}

void want_floating(const Model& model, const auto& declaration) {
  const Rigid& body = *declaration.body;
  want_one_shape(declaration.call(), body);
  if (model.interactions().motion_of(body) != nullptr)
    throw Error(named_body(declaration.call(), body) +
                " is moved by m:move, which gives its whole place: expected a body that is not moved");
}

}  // namespace

void check(const Model& model, const BodyMotion& motion) {
  const Rigid& body = *motion.body;
  const Interactions given = model.interactions();
  const std::string what = named_body("move", body);
  if (body.free())
    throw Error(what +
                " has a mass and moves freely: expected a body without a mass (m:velocity gives a free one "
                "its start)");
  if (body.moving() != nullptr)
    throw Error(what + " moves from shape to shape by itself and cannot be moved");
  if (given.floats(body) || given.first<BodySupport>(body) != nullptr)
    throw Error(what +
                " has forces, springs or supports of its own, which decide where it is: expected these, or "
                "m:move, which gives its whole place");
  if (given.motion_of(body) != nullptr)
    throw Error(
        what +
        " is moved already: expected one call with x, y, z and turn (a copy of a model leaves out the "
        "move it has with m:copy{without=\"move " +
        given.name_of(body) + "\"})");
  const auto& u = motion.displacement;
  if (!u[0] && !u[1] && !u[2] && !motion.turn)
    throw Error("move: expected at least one of x, y, z, turn, got none");
  if (motion.turn && (!motion.turn->axis.allFinite() || !(motion.turn->axis.norm() > 0)))
    throw Error("move: field 'turn.axis': expected a direction {x, y, z}");
}

void check(const Model& model, const BodyVelocity& velocity) {
  const Rigid& body = *velocity.body;
  const std::string what = named_body("velocity", body);
  if (!body.free()) throw Error(what + " has no mass: expected a free body (m:move drives one that is not)");
  if (model.interactions().velocity_of(body) != nullptr) throw Error(what + " has a velocity already");
  if (!velocity.linear.allFinite() || !velocity.spin.allFinite())
    throw Error("velocity: expected finite numbers in m/s and degrees/s");
}

void check(const Model& model, const BodyLoad& load) {
  want_floating(model, load);
  if (!load.total[0] && !load.total[1] && !load.total[2])
    throw Error(std::string(load.call()) + ": expected at least one of x, y, z, got none");
}

void check(const Model& model, const BodySpring& spring) {
  const char* const call = spring.call();
  want_floating(model, spring);
  if (spring.to) want_one_shape(call, *spring.to);
  if (spring.to == spring.body)
    throw Error(named_body(call, *spring.body) + ": field 'to': expected another body than itself");
  if (!(spring.stiffness.minCoeff() >= 0) || !(spring.stiffness.maxCoeff() > 0) ||
      !spring.stiffness.allFinite())
    throw Error(std::string(call) + ": expected at least one of x, y, z above 0, got none");
  if (spring.place && !spring.place->allFinite())
    throw Error(std::string(call) + ": field 'to': expected a finite place {x, y, z} in m");
}

void check(const Model& model, const BodySupport& support) {
  want_floating(model, support);
  const auto held_axes = std::count(support.turns.begin(), support.turns.end(), true);
  if (held_axes == 1)
    throw Error(named_body("fix", *support.body) +
                " would turn about two axes: expected all of rx ry rz (\"rotation\"), two of them or none");
}

bool Interactions::floats(const Rigid& body) const {
  if (body.free() || first<BodyLoad>(body) != nullptr || first<BodySpring>(body) != nullptr) return true;
  if (first<BodySupport>(body) == nullptr) return false;
  const BodySupport all = held(body);
  const auto whole = [](const auto& three) { return three[0] && three[1] && three[2]; };
  return !(whole(all.moves) && whole(all.turns));
}

BodySupport Interactions::held(const Rigid& body) const {
  BodySupport out;
  for (const BodySupport& one : all<BodySupport>())
    for (std::size_t i = 0; i < 3 && one.body.get() == &body; ++i) {
      out.moves[i] = out.moves[i] || one.moves[i];
      out.turns[i] = out.turns[i] || one.turns[i];
    }
  return out;
}

bool Interactions::any() const {
  const auto& gases = all<GasPointer>();
  return !contacts().empty() ||
         std::any_of(gases.begin(), gases.end(), [](const auto& gas) { return !gas->bodies.empty(); });
}

std::vector<RigidPointer> Interactions::bodies() const {
  std::vector<RigidPointer> all;
  const auto add = [&](const RigidPointer& body) {
    if (body && std::find(all.begin(), all.end(), body) == all.end()) all.push_back(body);
  };
  for (const ContactGiven& contact : contacts())
    for (const Party& party : contact.between) add(party.body);
  for (const GasPointer& gas : declared_.all<GasPointer>())
    for (const RigidPointer& body : gas->bodies) add(body);
  return all;
}

std::string Interactions::name_of(const Rigid& body) const {
  const auto given = [](const Rigid& r) { return r.name().empty() ? r.kind() : r.name(); };
  const std::string name = given(body);
  int number = 0, count = 0;
  for (const RigidPointer& other : bodies()) {
    if (given(*other) != name) continue;
    ++count;
    if (other.get() == &body) number = count;
  }
  return count < 2 || number == 0 ? name : name + " " + std::to_string(number);
}

void Interactions::validate(const mesh::Mesh& mesh) const {
  const auto known = bodies();
  const auto touches = [&](const RigidPointer& body) {
    return std::find(known.begin(), known.end(), body) != known.end();
  };
  const auto want_touching = [&](const RigidPointer& body, const std::string& what) {
    if (!touches(body))
      throw Error("model: the " + body->kind() + " that " + what +
                  " touches nothing: expected m:contact{between={it, ...}}");
  };
  // A value that is not finite at time 0 is reported with its call and body.
  const auto want_values = [&](const auto& declaration, const Components& histories, const History* turn) {
    try {
      for (const auto& h : histories)
        if (h) h->value(0);
      if (turn != nullptr) turn->value(0);
    } catch (const Error& error) {
      throw Error(std::string(declaration.call()) + ": the " + name_of(*declaration.body) + ": " +
                  error.what());
    }
  };
  for (const auto& motion : all<BodyMotion>()) {
    want_touching(motion.body, "is moved");
    want_values(motion, motion.displacement, motion.turn ? &motion.turn->angle : nullptr);
  }
  for (const auto& velocity : all<BodyVelocity>()) want_touching(velocity.body, "has a velocity");
  for (const auto& load : all<BodyLoad>()) {
    want_touching(load.body, std::string("has a ") + load.call());
    want_values(load, load.total, nullptr);
  }
  for (const auto& spring : all<BodySpring>()) {
    want_touching(spring.body, std::string("has a ") + spring.call());
    if (spring.to) want_touching(spring.to, std::string("has a ") + spring.call());
  }
  for (const auto& support : all<BodySupport>()) want_touching(support.body, "is held");
  for (const auto& body : known)
    if (std::holds_alternative<Plane>(body->shape()) && floats(*body)) {
      const auto turns = held(*body).turns;
      if (!(turns[0] && turns[1] && turns[2]))
        throw Error("model: the " + name_of(*body) +
                    " is loaded, and a plane has no end about which it could turn: expected "
                    "m:fix(body, \"rotation\")");
    }
  work_out_surfaces(*this, mesh);
}

namespace {

// Each named side of the cloth once, with its elements.
class Sides {
 public:
  Sides(const Interactions& interactions, const mesh::Mesh& mesh) {
    of_element_.resize(mesh.elements.size());
    for (const auto& contact : interactions.contacts())
      for (const Party& party : contact.between) {
        if (party.body || number_.count(party.set) != 0) continue;
        const auto number = static_cast<int>(number_.size());
        number_[party.set] = number;
        names_.push_back(party.set);
        for (const Index e : elements_of(party.set, mesh)) of_element_[e].push_back(number);
      }
  }
  const std::vector<int>& of(Index element) const { return of_element_[element]; }
  int number(const std::string& set) const { return number_.at(set); }
  std::string names(const std::vector<int>& sides) const {
    std::string words;
    for (const int s : sides) words += (words.empty() ? "" : " and ") + quoted_name(names_[s]);
    return words;
  }

 private:
  std::map<std::string, int> number_;
  std::vector<std::string> names_;
  std::vector<std::vector<int>> of_element_;
};

// Elements that belong to the same named sides form one surface.
std::vector<std::vector<int>> group(const Sides& sides, const mesh::Mesh& mesh, Surfaces& out) {
  std::vector<std::vector<int>> named;  // the sides of each surface
  std::vector<int> owner(mesh.nodes.size(), -1);
  for (Index e = 0; e < static_cast<Index>(mesh.elements.size()); ++e) {
    const auto& by = sides.of(e);
    if (by.empty()) continue;
    const auto found = std::find(named.begin(), named.end(), by);
    const auto surface = static_cast<int>(found - named.begin());
    if (found == named.end()) {
      named.push_back(by);
      out.elements.emplace_back();
    }
    out.elements[surface].push_back(e);
    for (const Index n : mesh.elements[e]) {
      if (n < 0) continue;
      if (owner[n] >= 0 && owner[n] != surface)
        throw Error("contact: node " + std::to_string(n + 1) + " belongs to the cloth of " +
                    sides.names(named[owner[n]]) + " and to that of " + sides.names(named[surface]) +
                    ": expected sides that are the same, or whole sheets that share no node (\"all\" is the "
                    "whole cloth)");
      owner[n] = surface;
    }
  }
  return named;
}

}  // namespace

Surfaces work_out_surfaces(const Interactions& interactions, const mesh::Mesh& mesh) {
  Surfaces out;
  const Sides sides(interactions, mesh);
  const auto named = group(sides, mesh, out);
  const auto bodies = interactions.bodies();
  const auto surfaces_of = [&](const Party& party) {
    std::vector<int> all;
    if (party.body) {
      const auto at = std::find(bodies.begin(), bodies.end(), party.body) - bodies.begin();
      return std::vector<int>{static_cast<int>(named.size() + at)};
    }
    for (std::size_t s = 0; s < named.size(); ++s)
      if (std::find(named[s].begin(), named[s].end(), sides.number(party.set)) != named[s].end())
        all.push_back(static_cast<int>(s));
    return all;
  };
  const auto cloth = static_cast<int>(named.size());
  const auto words = [&](int side) {
    return side < cloth ? sides.names(named[side]) : interactions.name_of(*bodies[side - cloth]);
  };
  const auto meet = [&](int a, int b, std::size_t contact) {
    if (a >= cloth && b >= cloth && !bodies[a - cloth]->free() && !bodies[b - cloth]->free()) return;
    const auto [first, second] = std::minmax(a, b);
    for (const SurfacePair& m : out.meetings)
      if (m.first == first && m.second == second)
        throw Error("contact: " + words(first) +
                    (first == second ? " touches itself" : " and " + words(second) + " touch") +
                    " by two calls: expected one");
    out.meetings.push_back({first, second, contact});
  };
  for (std::size_t c = 0; c < interactions.contacts().size(); ++c) {
    const auto& between = interactions.contacts()[c].between;
    for (std::size_t i = 0; i < between.size(); ++i) {
      const auto mine = surfaces_of(between[i]);
      if (between.size() == 1)
        for (std::size_t a = 0; a < mine.size(); ++a)
          for (std::size_t b = a; b < mine.size(); ++b) meet(mine[a], mine[b], c);
      for (std::size_t j = i + 1; j < between.size(); ++j)
        for (const int a : mine)
          for (const int b : surfaces_of(between[j])) {
            if (a == b)
              throw Error(
                  "contact: field 'between': " + quoted_name(between[i].set) + " and " +
                  quoted_name(between[j].set) +
                  " share elements: expected sets without common elements; self= lets a cloth touch itself");
            meet(a, b, c);
          }
    }
  }
  return out;
}

}  // namespace fabricsh::model
