#include "model/fingerprint.hpp"

#include <algorithm>

#include "base/hash.hpp"
#include "base/number.hpp"

namespace fabricsh::model {

namespace {

constexpr int kTimes = 33;

// Collects what belongs to one part of the fingerprint.
class PartCollector {
 public:
  PartCollector(const Model& model, double duration) : model_(model), duration_(duration) {}

  template <class... T>
  PartCollector& add(T... values) {
    bytes_(values...);
    return *this;
  }
  PartCollector& add_vector(const Vec3& v) { return add(v.x(), v.y(), v.z()); }
  PartCollector& add_frame(const Mat3& m) {
    for (int i = 0; i < 3; ++i) add_vector(m.row(i).transpose());
    return *this;
  }
  PartCollector& add_set(const std::string& set) {
    return set.empty() ? add(set) : add(model_.mesh().set(set));
  }
  PartCollector& add_history(const History& h) {
    for (int i = 0; i < (h.is_constant() ? 1 : kTimes); ++i) add(h.value(duration_ * i / (kTimes - 1)));
    for (const double t : h.kinks()) add(t, h.value(t));
    return *this;
  }
  PartCollector& add_components(const Components& c) {
    for (const auto& history : c) {
      add(history.has_value());
      if (history) add_history(*history);
    }
    return *this;
  }
  PartCollector& add_freedoms(const FixedFreedoms& f) {
    for (const bool b : f.translation) add(b);
    for (const bool b : f.axis) add(b);
    return add(f.rotation);
  }
  std::uint64_t hash() const { return fabricsh::hash(bytes_.bytes()); }

 private:
  const Model& model_;
  double duration_;
  Archive bytes_;
};

void add_mesh(PartCollector& part, const Model& model) {
  for (const Vec3& node : model.mesh().nodes) part.add_vector(node);
  for (const auto& element : model.mesh().elements)
    for (const mesh::Index n : element) part.add(n);
}

Index elements_of(const Model& model, std::size_t region) {
  Index count = 0;
  for (Index e = 0; e < static_cast<Index>(model.mesh().elements.size()); ++e)
    count += static_cast<std::size_t>(model.region_of(e)) == region ? 1 : 0;
  return count;
}

void add_region(PartCollector& part, const Model& model, std::size_t region) {
  for (Index e = 0; e < static_cast<Index>(model.mesh().elements.size()); ++e)
    part.add(static_cast<std::size_t>(model.region_of(e)) == region);
}

// Of one region. The warp direction before it is projected; without one it is that of
// the mesh, or the default.
void add_warp(PartCollector& part, const Model& model, std::size_t region) {
  const auto& o = model.regions()[region].options;
  part.add(o.warp.has_value());
  for (const section::Ply& ply : o.plies) part.add(ply.angle);
  if (!o.warp) {
    for (const Vec3& direction : model.mesh().warp) part.add_vector(direction);
    return;
  }
  for (Index n = 0; n < static_cast<Index>(model.mesh().nodes.size()); ++n) {
    const Direction d = (*o.warp)(model.rest_node(model.mesh().place_of(n)));
    if (const auto* angle = std::get_if<double>(&d))
      part.add(*angle);
    else
      part.add_vector(std::get<Vec3>(d));
  }
}

void add_thickness(PartCollector& part, const Model& model, std::size_t region) {
  const auto& o = model.regions()[region].options;
  part.add(model.sections()[region].thickness, o.points, o.offset, o.plies.size());
  if (o.membrane) part.add(o.membrane);
  if (o.folds) part.add(static_cast<int>(*o.folds));
  if (o.full_yarns) part.add(2);
  for (const section::Ply& ply : o.plies) part.add(ply.thickness);
}

void add_reference(PartCollector& part, const Model& model) {
  for (const BodyGiven& body : model.bodies()) {
    const ReferenceGiven& given = body.reference;
    part.add(static_cast<int>(given.rest), given.prestress.has_value());
    if (given.prestress) part.add((*given.prestress)[0], (*given.prestress)[1]);
    part.add(given.mesh != nullptr);
    if (!given.mesh) continue;
    for (const Vec3& node : given.mesh->nodes) part.add_vector(node);
    for (const Vec3& direction : given.mesh->warp) part.add_vector(direction);
  }
}

std::string reference_text(const Model& model) {
  std::string text;
  for (const BodyGiven& body : model.bodies())
    text += body.reference.any() ? rest_text(body.reference) : "that of the mesh; ";
  return text.substr(0, text.size() - 2);
}

std::string thickness_text(const Model& model, std::size_t region) {
  const auto& o = model.regions()[region].options;
  std::string text = number(model.sections()[region].thickness) + " m with " + std::to_string(o.points) +
                     (o.points == 1 ? " point" : " points");
  if (o.membrane) text += " as a membrane";
  if (o.folds) text += std::string(", folds ") + card::fold_words[static_cast<std::size_t>(*o.folds)];
  if (o.full_yarns) text += " with the strain of yarns as interpolated";
  if (o.offset != 0) text += " and offset " + number(o.offset);
  if (!o.plies.empty()) text += " in each of " + std::to_string(o.plies.size()) + " plies";
  return text;
}

// Whatever is told of a declaration, in its order.
struct TellPart : DeclarationVisitor {
  explicit TellPart(PartCollector& to) : part(to) {}
  PartCollector& part;
  using DeclarationVisitor::set;
  void set(const std::string& name, const char* = "") { part.add_set(name); }
  void freedoms(const FixedFreedoms& value) { part.add_freedoms(value); }
  void components(const Components& value, auto...) { part.add_components(value); }
  void history(const char*, const std::optional<History>& h, auto...) {
    if (h) part.add_history(*h);
  }
  void number(const char*, const std::optional<double>& value, auto...) { part.add(value.value_or(-1)); }
  void time(const char*, const std::optional<double>& value, auto...) { part.add(value.value_or(-1)); }
  void flag(const char*, const std::optional<bool>& value, auto...) {
    part.add(value ? static_cast<int>(*value) : -1);
  }
  void text(const char*, const std::string& value, auto...) { part.add(fabricsh::hash(value)); }
  void vector(const char*, const std::optional<Vec3>& v, auto...) {
    part.add(v.has_value());
    if (v) part.add_vector(*v);
  }
  void frame(const Mat3& value) { part.add_frame(value); }
  void stiffness(const std::array<double, 3>& value, auto...) {
    for (const double k : value) part.add(k);
  }
};

template <class D>
void add_all(PartCollector& part, const Model& model) {
  TellPart told(part);
  for (const D& one : model.all<D>()) D::tell(one, told);
}

void add_loads(PartCollector& part, const Model& model) {
  add_all<ForceLoad>(part, model);
  part.add(1).add_components(model.gravity());
  add_all<MomentLoad>(part, model);
  part.add(2);
  add_all<TractionLoad>(part, model);
  part.add(3);
  add_all<PressureLoad>(part, model);
  part.add(4);
  add_all<GroundSpring>(part, model);
}

// A function of the pressure is known by some of its values.
void add_gas(PartCollector& part, const Model& model, const GasGiven& g) {
  for (const auto& set : g.sets) part.add_set(set);
  for (const auto& set : g.lids) part.add_set(set);
  part.add(g.initial, g.mass.value_or(-1), g.temperature, g.molar, g.cp, g.exponent, g.outside);
  if (g.inflow) part.add_history(*g.inflow);
  for (const GasVent& v : g.vents) {
    const auto to = std::find(model.all<GasPointer>().begin(), model.all<GasPointer>().end(), v.to);
    part.add(static_cast<int>(to - model.all<GasPointer>().begin()));
    if (!v.set.empty()) part.add_set(v.set);
    part.add(v.area, v.coefficient, v.opens);
  }
  const auto bodies = model.interactions().bodies();
  for (const RigidPointer& body : g.bodies)
    part.add(static_cast<int>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin()));
  for (double p = 1; g.leakage && p < 1e6; p *= 10) part.add(g.leakage(p));
}

void add_motions(PartCollector& part, const Model& model) {
  add_all<PrescribedMotion>(part, model);
  part.add(1);
  for (const auto& t : model.all<PrescribedTurn>()) {
    part.add_set(t.set).add_vector(t.axis).add_history(t.angle).add(t.centre.has_value());
    if (t.centre) part.add_vector(*t.centre);
  }
}

// place: in the order in which forces are summed and states are kept.
void add_body(PartCollector& part, const Rigid& body, std::size_t place) {
  const Facets shape = shown(body, 1);
  for (const Vec3& v : shape.vertices) part.add_vector(v);
  for (const auto& t : shape.triangles) part.add(t[0], t[1], t[2]);
  part.add(body.shape().index(), body.mass().value_or(0), place);
  if (const auto* moving = body.moving()) {
    for (const double t : moving->times) part.add(t);
    for (const auto& vertices : moving->shapes)
      for (const Vec3& v : vertices) part.add_vector(v);
  }
}

void add_motion(PartCollector& part, const Rigid& body, const BodyMotion& motion) {
  part.add_components(motion.displacement);
  if (!motion.turn) return;
  part.add_vector(motion.turn->axis).add_history(motion.turn->angle);
  part.add_vector(motion.turn->centre.value_or(body.centre()));
}

// Of what loads and holds a body; the numbers of the other bodies of springs.
void add_held(PartCollector& part, const Interactions& all, const Rigid& body) {
  const auto bodies = all.bodies();
  for (const BodyLoad& load : all.all<BodyLoad>())
    if (load.body.get() == &body) part.add(load.moment).add_components(load.total);
  for (const BodySpring& spring : all.all<BodySpring>()) {
    if (spring.body.get() != &body) continue;
    part.add(spring.damper).add_vector(spring.stiffness).add(spring.place.has_value());
    if (spring.place) part.add_vector(*spring.place);
    if (spring.to) part.add(std::find(bodies.begin(), bodies.end(), spring.to) - bodies.begin());
  }
  const BodySupport held = all.held(body);
  for (std::size_t i = 0; i < 3; ++i) part.add(held.moves[i], held.turns[i]);
}

bool is_held(const Interactions& all, const Rigid& body) {
  return all.first<BodyLoad>(body) != nullptr || all.first<BodySpring>(body) != nullptr ||
         all.first<BodySupport>(body) != nullptr;
}

// "contact of 'front', 'back' and sphere"
std::string contact_name(const Interactions& all, const ContactGiven& contact) {
  const auto& sides = contact.between;
  std::string text = "contact of ";
  for (std::size_t i = 0; i < sides.size(); ++i)
    text += (i == 0                  ? ""
             : i + 1 == sides.size() ? " and "
                                     : ", ") +
            (sides[i].body ? all.name_of(*sides[i].body) : "'" + sides[i].set + "'");
  return text + (sides.size() == 1 ? " with itself" : "");
}

std::string contact_text(const ContactGiven& c) {
  std::string text = "friction " + number(c.friction);
  if (c.sticking) text += ", static " + number(*c.sticking);
  if (c.across) text += " along the warp, " + number(*c.across) + " across";
  if (c.viscosity) text += ", film of " + number(*c.viscosity) + " Pa s, " + number(*c.film) + " m";
  if (c.film_speed > 0)
    text += ", thinned above " + number(c.film_speed) + " m/s, exponent " + number(c.film_exponent);
  if (c.thickness) text += ", thickness " + number(*c.thickness) + " m";
  if (c.stiffness) text += ", stiffness " + number(*c.stiffness) + " Pa/m";
  if (c.restitution != ContactGiven::usual_restitution) text += ", restitution " + number(c.restitution);
  if (c.settle) text += ", settled in " + number(*c.settle) + " s";
  return text;
}

void add_contact(PartCollector& part, const ContactGiven& c, const Surfaces& surfaces, std::size_t place) {
  part.add(place, c.friction, c.thickness.value_or(0), c.stiffness.value_or(0), c.settle.value_or(0),
           c.restitution);
  if (c.sticking) part.add(*c.sticking);
  if (c.across) part.add(*c.across);
  if (c.viscosity) part.add(*c.viscosity, *c.film);
  if (c.film_speed > 0) part.add(c.film_speed, c.film_exponent);
  for (const SurfacePair& m : surfaces.meetings) {
    if (m.contact != place) continue;
    part.add(m.first, m.second);
    for (const int side : {m.first, m.second})
      if (static_cast<std::size_t>(side) < surfaces.elements.size())
        for (const Index e : surfaces.elements[static_cast<std::size_t>(side)]) part.add(e);
  }
}

template <class Add>
void add_interactions(const Model& model, const Add& add) {
  const Interactions& all = model.interactions();
  const auto bodies = all.bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Rigid& body = *bodies[b];
    const std::string name = "rigid body '" + all.name_of(body) + "'";
    add(name, body.describe(), [&](PartCollector& part) { add_body(part, body, b); });
    if (const auto* motion = all.motion_of(body))
      add("motion of " + name, "", [&](PartCollector& part) { add_motion(part, body, *motion); });
    if (is_held(all, body))
      add("loads and supports of " + name, "", [&](PartCollector& part) { add_held(part, all, body); });
    if (const auto* v = all.velocity_of(body))
      add("velocity of " + name, "",
          [&](PartCollector& part) { part.add_vector(v->linear).add_vector(v->spin); });
  }
  const Surfaces surfaces = work_out_surfaces(all, model.mesh().uncut());
  for (std::size_t c = 0; c < all.contacts().size(); ++c) {
    const ContactGiven& contact = all.contacts()[c];
    add(contact_name(all, contact), contact_text(contact),
        [&](PartCollector& part) { add_contact(part, contact, surfaces, c); });
  }
}

// Kinds of declarations after the first ones, which are named above, have a part each where a model has any.
template <class Add>
void add_later_kinds(const Model& model, const Add& add) {
  constexpr int first_kinds = 23;
  int kind = 0;
  model.declarations().each_kind([&](const auto& all) {
    if (++kind <= first_kinds || all.empty()) return;
    add(plain(all.front()).call(), "", [&](PartCollector& part) {
      TellPart told(part);
      for (const auto& one : all) tell(one, told);
    });
  });
}

}  // namespace

Fingerprint fingerprint(const Model& model, double duration) {
  Fingerprint parts;
  const auto add = [&](const std::string& name, const std::string& text, const auto& fill) {
    PartCollector part(model, duration);
    fill(part);
    parts.push_back({name, text, part.hash()});
  };
  const auto& mesh = model.mesh();
  add("mesh",
      std::to_string(mesh.nodes.size()) + " nodes and " + std::to_string(mesh.elements.size()) + " elements",
      [&](PartCollector& part) { add_mesh(part, model); });
  for (std::size_t r = 0; r < model.regions().size(); ++r) {
    const std::string of = of_region(model, model.regions()[r]);
    if (!of.empty())
      add("region" + of.substr(std::string(" of").size()),
          std::to_string(elements_of(model, r)) + " elements",
          [&](PartCollector& part) { add_region(part, model, r); });
    add("thickness" + of, thickness_text(model, r),
        [&](PartCollector& part) { add_thickness(part, model, r); });
    add("warp direction" + of, "", [&](PartCollector& part) { add_warp(part, model, r); });
  }
  add("supports", "", [&](PartCollector& part) { add_all<Support>(part, model); });
  add("motions", "", [&](PartCollector& part) { add_motions(part, model); });
  add("loads", "", [&](PartCollector& part) { add_loads(part, model); });
  add("ties", "", [&](PartCollector& part) {
    for (const auto& t : model.all<Tie>()) {
      part.add(static_cast<int>(t.kind)).add_set(t.set).add_freedoms(t.freedoms);
      if (t.kind == TieKind::periodic) part.add_set(t.partner);
      if (t.kind == TieKind::rigid && !t.partner.empty()) part.add(hash(t.partner));
    }
  });
  if (!model.all<Zone>().empty())
    add("tearable zones", "", [&](PartCollector& part) {
      for (const auto& zone : model.all<Zone>()) {
        part.add_set(zone.set).add(static_cast<int>(zone.lower)).add(zone.seed);
        if (!zone.path.empty()) part.add_set(zone.path);
        if (zone.keep) part.add(zone.keep);
      }
    });
  if (std::any_of(model.bodies().begin(), model.bodies().end(),
                  [](const BodyGiven& body) { return body.reference.any(); }))
    add("reference", reference_text(model), [&](PartCollector& part) { add_reference(part, model); });
  if (!model.all<CreaseGiven>().empty())
    add("creases", "", [&](PartCollector& part) {
      for (const CreaseEdge& edge : crease_edges(model)) {
        part.add(edge.from, edge.to, edge.angle);
        if (edge.stiffness) part.add(*edge.stiffness);
      }
    });
  if (!model.all<StrengthGiven>().empty())
    add("strengths", "", [&](PartCollector& part) {
      for (const auto& s : model.all<StrengthGiven>())
        part.add_set(s.set).add(s.factor, s.modulus).add(s.seed);
    });
  if (!model.all<Seam>().empty())
    add("seams", "", [&](PartCollector& part) {
      for (const auto& s : model.all<Seam>()) {
        part.add_set(s.first).add_set(s.second).add(s.ease);
        part.add(s.reverse ? static_cast<int>(*s.reverse) : -1)
            .add(s.hinge ? static_cast<int>(*s.hinge) : -1);
        for (const auto& value : {s.over, s.stiffness, s.strength, s.energy}) part.add(value.value_or(-1));
      }
    });
  if (!model.all<EdgeBand>().empty())
    add("bands", "", [&](PartCollector& part) { add_all<EdgeBand>(part, model); });
  if (!model.all<GasPointer>().empty())
    add("gas", "", [&](PartCollector& part) {
      for (const auto& g : model.all<GasPointer>()) add_gas(part, model, *g);
    });
  add("velocities", "", [&](PartCollector& part) {
    for (const auto& v : model.all<InitialVelocity>()) {
      part.add_set(v.set).add_vector(v.linear).add_vector(v.spin).add_vector(v.centre);
      if (!v.place) continue;
      for (const auto n : model.mesh().set(v.set)) {
        const RigidVelocity here = v.at(model.mesh().nodes[n]);
        part.add_vector(here.linear).add_vector(here.spin).add_vector(here.centre);
      }
    }
  });
  if (model.interactions().any()) add_interactions(model, add);
  add_later_kinds(model, add);
  return parts;
}

std::string of_region(const Model& model, const Region& region) {
  return model.regions().size() == 1 ? "" : " of '" + (region.name.empty() ? "the rest" : region.name) + "'";
}

namespace {

Fingerprint missing(const Fingerprint& from, const Fingerprint& in) {
  Fingerprint all;
  for (const auto& part : in)
    if (std::none_of(from.begin(), from.end(), [&](const auto& p) { return p.name == part.name; }))
      all.push_back(part);
  return all;
}

// Removes the parts of what is missing as a whole: a region, a rigid body; and beside a missing region those
// of the sheet that has none.
void drop_parts_of(const Fingerprint& wholes, Fingerprint& parts) {
  const auto covered = [&](const FingerprintPart& part) {
    return std::any_of(wholes.begin(), wholes.end(), [&](const FingerprintPart& whole) {
      const bool region = whole.name.starts_with("region '");
      if (!region && !whole.name.starts_with("rigid body '")) return false;
      const bool bare = part.name == "card" || part.name == "thickness" || part.name == "warp direction";
      return (region && bare) || part.name.ends_with(" of " + whole.name) ||
             (region && part.name.ends_with(" of" + whole.name.substr(std::string("region").size())));
    });
  };
  std::erase_if(parts, covered);
}

}  // namespace

std::string difference(const Fingerprint& there, const Fingerprint& here) {
  std::vector<std::string> names;
  for (const auto& part : here) {
    const auto other =
        std::find_if(there.begin(), there.end(), [&](const auto& p) { return p.name == part.name; });
    if (other == there.end() || other->hash == part.hash) continue;
    names.push_back("the " + part.name +
                    (other->text == part.text ? "" : " (" + other->text + " there, " + part.text + " here)"));
  }
  const Fingerprint new_here = missing(there, here), gone_here = missing(here, there);
  for (const bool is_new : {true, false}) {
    Fingerprint parts = is_new ? new_here : gone_here;
    drop_parts_of(new_here, parts);
    drop_parts_of(gone_here, parts);
    for (const auto& part : parts)
      names.push_back("the " + part.name + (is_new ? " (none there)" : " (none here)"));
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

}  // namespace fabricsh::model
