#include "run/bodies.hpp"

#include "base/error.hpp"
#include "geometry/box.hpp"
#include "mechanics/terms/gas.hpp"

namespace fabricsh::run {

BodyState body_state(const Readings& run, const model::Rigid& body) {
  const std::size_t i = run.body_number(body);
  const auto& bodies = run.contact().bodies();
  const auto state = bodies.state().kinematics(i);
  return {state.place, state.velocity, state.spin, -bodies.readings().force(i), bodies.readings().held(i)};
}

// Of the pressures and slips on a skin, which facets alone have.
mechanics::OnSkin on_skin(const Readings& run, const model::Rigid& body) {
  const std::size_t i = run.body_number(body);
  if (body.facets() == nullptr)
    throw Error("the " + run.model().interactions().name_of(body) +
                " has no facets: expected a body of fabric.rigid.surface, motion, limb or torso");
  return run.contact().readings().on_skin(i);
}

Touching nearest_pair(const Readings& run) {
  const auto& contact = run.contact();
  const auto nearest = contact.readings().nearest();
  return {nearest.gap, nearest.point[0] < 0 ? std::string() : contact.surfaces().words(nearest.point)};
}

// Planes are drawn a little wider than the cloth.
std::vector<BodyShown> shown_bodies(const Readings& run) {
  std::vector<BodyShown> all;
  const mechanics::Contacts* contact = run.assembly().terms().find<mechanics::Contacts>();
  if (contact == nullptr) return all;
  const double across = box_of(run.assembly().dofs().reference()).size().norm();
  const auto& bodies = contact->bodies();
  for (std::size_t i = 0; i < bodies.count(); ++i) {
    const model::Facets facets = model::shown(bodies.body(i), 1.2 * across);
    all.push_back({run.model().interactions().name_of(bodies.body(i)),
                   bodies.state().moved(i, facets.vertices), facets.triangles,
                   bodies.body(i).facets() == nullptr ? std::vector<double>()
                                                      : contact->readings().on_skin(i).pressure});
  }
  return all;
}

GasReading gas_state(const Readings& run, const model::GasGiven& gas) {
  const auto* const term = run.assembly().terms().find<mechanics::Gas>();
  if (term == nullptr)
    throw Error("gas: the model of this run has no gas volume: expected one declared with m:gas");
  const auto now = term->read(gas);
  return {now.pressure, now.volume, now.mass, now.temperature};
}

}  // namespace fabricsh::run
