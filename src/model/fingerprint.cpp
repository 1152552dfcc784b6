#include "model/fingerprint.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace fabricsh::model {

namespace {

constexpr int kTimes = 33;

// Collects what belongs to one part of the fingerprint.
class Part {
 public:
  Part(const Model& model, double duration) : model_(model), duration_(duration) {}

  template <class... T>
  Part& add(T... values) {
    bytes_(values...);
    return *this;
  }
  Part& add_vector(const Vec3& v) { return add(v.x(), v.y(), v.z()); }
  Part& add_frame(const Mat3& m) {
    for (int i = 0; i < 3; ++i) add_vector(m.row(i).transpose());
    return *this;
  }
  Part& add_set(const std::string& set) { return set.empty() ? add(set) : add(model_.mesh().set(set)); }
  Part& add_history(const History& h) {
    for (int i = 0; i < (h.is_constant() ? 1 : kTimes); ++i) add(h.value(duration_ * i / (kTimes - 1)));
    for (const double t : h.kinks()) add(t, h.value(t));
    return *this;
  }
  Part& add_components(const Components& c) {
    for (const auto& history : c) {
      add(history.has_value());
      if (history) add_history(*history);
    }
    return *this;
  }
  Part& add_freedoms(const Freedoms& f) {
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

void add_mesh(Part& part, const Model& model) {
  for (const Vec3& node : model.mesh().nodes) part.add_vector(node);
  for (const auto& element : model.mesh().elements)
    for (const mesh::Index n : element) part.add(n);
}

void add_regions(Part& part, const Model& model) {
  for (Index e = 0; e < static_cast<Index>(model.mesh().elements.size()); ++e) part.add(model.region_of(e));
}

// Of one region. The warp direction before it is projected; on a flat mesh without one it is the default.
void add_warp(Part& part, const Model& model, std::size_t region) {
  const auto& o = model.regions()[region].options;
  part.add(model.sections()[region].thickness, o.points, o.offset, o.plies.size(), o.warp.has_value());
  for (const section::Ply& ply : o.plies) part.add(ply.thickness, ply.angle);
  if (!o.warp) return;
  for (const Vec3& node : model.mesh().nodes) {
    const Direction d = (*o.warp)(node);
    if (const auto* angle = std::get_if<double>(&d))
      part.add(*angle);
    else
      part.add_vector(std::get<Vec3>(d));
  }
}

void add_loads(Part& part, const Model& model) {
  for (const auto& f : model.forces()) part.add_set(f.set).add_components(f.total).add_frame(f.frame);
  part.add(1).add_components(model.gravity());
  for (const auto& m : model.moments()) part.add_set(m.set).add_components(m.total).add_frame(m.frame);
  part.add(2);
  for (const auto& t : model.tractions()) part.add_set(t.set).add_components(t.intensity).add_frame(t.frame);
  part.add(3);
  for (const auto& p : model.pressures()) part.add_set(p.set).add_history(p.value);
  part.add(4);
  for (const auto& s : model.springs()) {
    part.add_set(s.set).add_frame(s.frame);
    for (const double k : s.stiffness) part.add(k);
  }
}

void add_motions(Part& part, const Model& model) {
  for (const auto& m : model.motions()) part.add_set(m.set).add_components(m.displacement).add_frame(m.frame);
  part.add(1);
  for (const auto& t : model.turns()) {
    part.add_set(t.set).add_vector(t.axis).add_history(t.angle).add(t.centre.has_value());
    if (t.centre) part.add_vector(*t.centre);
  }
}

void add_body(Part& part, const Interactions& all, const Rigid& body) {
  const Facets shape = shown(body, 1);
  for (const Vec3& v : shape.vertices) part.add_vector(v);
  for (const auto& t : shape.triangles) part.add(t[0], t[1], t[2]);
  part.add(body.shape().index(), body.mass().value_or(0));
  if (const auto* moving = body.moving()) {
    for (const double t : moving->times) part.add(t);
    for (const auto& vertices : moving->shapes)
      for (const Vec3& v : vertices) part.add_vector(v);
  }
  if (const auto* v = all.velocity_of(body)) part.add_vector(v->linear).add_vector(v->spin);
  const auto* motion = all.motion_of(body);
  if (motion == nullptr) return;
  part.add_components(motion->displacement);
  if (!motion->turn) return;
  part.add_vector(motion->turn->axis).add_history(motion->turn->angle);
  part.add_vector(motion->turn->centre.value_or(body.centre()));
}

void add_interactions(Part& part, const Model& model) {
  const Interactions& all = model.interactions();
  for (const auto& body : all.bodies()) add_body(part, all, *body);
  const Surfaces surfaces = work_out_surfaces(all, model.mesh());
  for (const auto& elements : surfaces.elements)
    for (const Index e : elements) part.add(e);
  for (const Meeting& m : surfaces.meetings) {
    const ContactGiven& c = all.contacts()[m.contact];
    part.add(m.first, m.second, c.friction, c.thickness.value_or(0), c.stiffness.value_or(0),
             c.settle.value_or(0));
  }
}

}  // namespace

Fingerprint fingerprint(const Model& model, double duration) {
  Fingerprint parts;
  const auto add = [&](const std::string& name, const std::string& text, const auto& fill) {
    Part part(model, duration);
    fill(part, model);
    parts.push_back({name, text, part.hash()});
  };
  const auto& mesh = model.mesh();
  add("mesh",
      std::to_string(mesh.nodes.size()) + " nodes and " + std::to_string(mesh.elements.size()) + " elements",
      add_mesh);
  if (model.regions().size() > 1)
    add("regions", std::to_string(model.regions().size()) + " bodies and regions", add_regions);
  for (std::size_t r = 0; r < model.regions().size(); ++r)
    add("warp direction, thickness or plies" + of_region(model, model.regions()[r]), "",
        [r](Part& part, const Model& m) { add_warp(part, m, r); });
  add("supports", "", [](Part& part, const Model& m) {
    for (const auto& s : m.supports()) part.add_set(s.set).add_freedoms(s.fixed).add_frame(s.frame);
  });
  add("motions", "", add_motions);
  add("loads", "", add_loads);
  add("ties", "", [](Part& part, const Model& m) {
    for (const auto& t : m.ties())
      part.add(static_cast<int>(t.kind)).add_set(t.set).add_set(t.partner).add_freedoms(t.freedoms);
  });
  add("velocities", "", [](Part& part, const Model& m) {
    for (const auto& v : m.velocities()) {
      part.add_set(v.set).add_vector(v.linear).add_vector(v.spin).add_vector(v.centre);
      if (!v.place) continue;
      for (const auto n : m.mesh().set(v.set)) {
        const RigidVelocity here = v.at(m.mesh().nodes[n]);
        part.add_vector(here.linear).add_vector(here.spin).add_vector(here.centre);
      }
    }
  });
  if (model.interactions().any()) add("contacts and rigid bodies", "", add_interactions);
  return parts;
}

std::string of_region(const Model& model, const Region& region) {
  return model.regions().size() == 1 ? "" : " of '" + (region.name.empty() ? "the rest" : region.name) + "'";
}

std::string difference(const Fingerprint& there, const Fingerprint& here) {
  const auto lacks = [](const Fingerprint& all, const std::string& name) {
    return std::none_of(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
  };
  std::vector<std::string> names;
  for (const auto& part : here) {
    const auto other =
        std::find_if(there.begin(), there.end(), [&](const auto& p) { return p.name == part.name; });
    if (other != there.end() && other->hash == part.hash) continue;
    std::string name = "the " + part.name;
    if (other != there.end() && other->text != part.text)
      name += " (" + other->text + " there, " + part.text + " here)";
    if (other == there.end()) name += " (none there)";
    names.push_back(name);
  }
  for (const auto& part : there)
    if (lacks(here, part.name)) names.push_back("the " + part.name + " (none here)");
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

}  // namespace fabricsh::model
