#include "mechanics/terms/contact.hpp"

#include <algorithm>

#include "base/shares.hpp"
#include "geometry/node_view.hpp"

namespace fabricsh::mechanics {

Contacts::Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                   const Dofs& dofs)
    : model_(model),
      cloth_(cloth),
      surfaces_(model, configuration, cloth, dofs),
      state_(surfaces_, configuration, cloth),
      joints_(model, cloth, dofs, state_),
      settling_(state_),
      passing_(state_, dofs.freedoms()),
      gas_(state_, joints_.inverse_masses()),
      unknowns_(state_, gas_),
      tangent_(state_, unknowns_, gas_),
      readings_(state_, settling_),
      barriers_(state_, cloth, dofs),
      static_(state_),
      implicit_(state_, settling_, joints_.inverse_masses()),
      explicit_(state_, joints_, barriers_, cloth, dofs) {
  find_overlaps(0);
  state_.begin();
}

ContactScheme& Contacts::scheme() {
  if (explicit_.used()) return explicit_;
  return implicit_.used() ? implicit_ : static_;
}

ExplicitContact& Contacts::go_explicit() {
  passing_.go_explicit();
  explicit_.use();
  return explicit_;
}

void Contacts::set_time(double time) {
  state_.time = time;
  passing_.begin_step();
  surfaces_.bodies().set_time(state_.configuration.time(), time);
  settling_.open_to(time);
}

Outcome Contacts::add_forces(const law::Step& step, const Trial& trial, Forces& forces) {
  ContactState& s = state_;
  s.place(trial);
  const bool room = settling_.find_work();
  // Newton's iterations ask for the forces, and then for forces and tangent of the same state.
  const ContactState::Moment now{trial.configuration.version(), s.time, s.share, step.dt};
  if (!s.evaluated || s.evaluated_at != now || settling_.opens() || explicit_.used()) {
    std::fill(s.force.begin(), s.force.end(), Vec3::Zero());
    std::fill(s.torque.begin(), s.torque.end(), Vec3::Zero());
    s.trial = s.add_forces(scheme().way(step.dt));
    s.trial_tied = s.ties.add_forces(s.x, s.force);
    s.evaluated = true;
    s.evaluated_at = now;
  }
  s.blocked = !(s.trial.gap > 0) || !room;
  if (passing_.given_motions_meet())
    return {Answer::cut, -1, "parts of the cloth whose motion is given pass through what is fixed or driven"};
  const std::size_t nodes = surfaces_.nodes();
  if (s.blocked) {
    Outcome passed{Answer::cut, -1, "surfaces that touch would pass through each other"};
    if (const auto pair = s.pairs.nearest(s.x); pair.point[0] >= 0)
      passed.why += ": " + surfaces_.words(pair.point);
    for (std::size_t n = 0; n < nodes && passed.element < 0; ++n)
      if (!s.force[n].allFinite()) passed.element = cloth_.element_at(static_cast<Index>(n));
    return passed;
  }
  surfaces_.bodies().load(std::span(s.force).subspan(nodes), std::span(s.torque).subspan(nodes));
  scheme().evaluated();
  if (!s.acts()) return {};
  for_each_index(nodes, nodes >= many_nodes,
                 [&](std::size_t n) { at(forces.on_x, static_cast<Index>(n)) -= s.force[n]; });
  return {};
}

std::vector<char> Contacts::pressed_by_bodies() const {
  const ContactState& s = state_;
  std::vector<char> marked(s.x.size());
  s.pairs.mark_pressed(static_cast<std::int32_t>(surfaces_.nodes()), static_cast<std::int32_t>(s.x.size()),
                       true, marked);
  marked.resize(surfaces_.nodes());
  return marked;
}

void Contacts::couple(const Trial& trial, std::vector<NodePair>& pairs) {
  state_.place(trial);
  tangent_.couple(scheme().way(state_.dt()), pairs);
}

StepWork Contacts::step_work() const {
  StepWork sum = bodies().readings().step_work();
  if (!state_.evaluated) return sum;
  sum += settling_.work();
  if (implicit_.used())
    sum.work += state_.ties.work_of_pressure(state_.start, state_.x, state_.force, state_.pairs);
  return sum;
}

void Contacts::add_energies(const Trial&, std::vector<Energy>& out) const {
  const ContactState& s = state_;
  out.push_back({"contact", Account::stored, s.totals().contact});
  out.push_back({"guard", Account::stored, s.totals().guard + barriers_.energy()});
  out.push_back({"stick", Account::stored, s.totals().stick});
  out.push_back({"friction", Account::dissipated, s.lost + s.lost_in_step()});
  out.push_back({"impact", Account::dissipated, s.impact + (s.evaluated ? scheme().impact() : 0)});
  if (s.ties.any())
    out.push_back({"springs", Account::stored, s.evaluated ? s.trial_tied : s.committed_tied});
  out.push_back({"rigid", Account::moving, bodies().readings().kinetic()});
  if (!bodies().loads().any()) return;
  out.push_back({"springs", Account::stored, bodies().loads().spring_energy()});
  out.push_back({"damping", Account::damping, bodies().loads().damped()});
}

void Contacts::commit() {
  ContactState& s = state_;
  if (s.evaluated) {
    s.lost += s.lost_in_step();
    s.impact += scheme().impact();
    s.committed = s.trial;
    s.committed_tied = s.trial_tied;
    barriers_.commit();
    if (surfaces_.any()) s.pairs.commit();
  }
  s.evaluated = false;
  s.share = s.iterate = 0;
  tangent_.commit();
  surfaces_.bodies().commit();
  if (joints_.follow_faces()) readings_.forget();
}

void Contacts::rollback() {
  state_.evaluated = state_.blocked = false;
  barriers_.rollback();
  if (surfaces_.any()) state_.pairs.rollback();
  state_.share = state_.iterate = 0;
  tangent_.rollback();
  surfaces_.bodies().rollback();
}

void Contacts::renumbered(Forces& forces) {
  joints_.renumbered(forces);
  readings_.forget();
}

void Contacts::keep(Archive& archive) {
  ContactState& s = state_;
  surfaces_.bodies().keep(archive);
  archive(s.committed.contact, s.committed.guard, s.committed.stick, s.committed.gap, s.lost, s.impact);
  tangent_.keep(archive);
  barriers_.keep(archive);
  if (s.ties.any()) archive(s.committed_tied);
  s.pairs.keep(archive);
  joints_.keep(archive);
  if (archive.reading()) readings_.forget();
}

}  // namespace fabricsh::mechanics
