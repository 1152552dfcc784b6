// Reading a run: nodes, elements, reactions, energies.
#include "run/readings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/result_fields.hpp"

namespace fabricsh::run {

namespace {

void check_index(mesh::Index i, std::size_t size, const char* what) {
  if (i < 0 || i >= static_cast<mesh::Index>(size))
    throw Error(std::string(what) + ": expected a number from 1 to " + std::to_string(size) + ", got " +
                std::to_string(i + 1));
}

// Components in axes turned back by an angle: v = 11, 22, 23, 13, 12 of a tensor.
void turn_back(double angle, double v[5]) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double a = v[0], b = v[1], d = v[4], e23 = v[2], e13 = v[3];
  v[0] = c * c * a + s * s * b - 2 * c * s * d;
  v[1] = s * s * a + c * c * b + 2 * c * s * d;
  v[2] = c * e23 + s * e13;
  v[3] = c * e13 - s * e23;
  v[4] = c * s * (a - b) + (c * c - s * s) * d;
}

// turn: rad, from the axes of the sum to those of the point.
void add_point(ElementValues& v, double w, double turn, const law::Law& law, const double* E,
               const double* state) {
  double S[5], e[5] = {E[0], E[1], E[2] / 2, E[3] / 2, E[4] / 2};
  law::stress(law, E, state, S);
  if (turn != 0) {
    turn_back(turn, e);
    turn_back(turn, S);
  }
  const auto energy = law::energy(law, E, state);
  const auto in = law::internal(law, E, state);
  v.E11 += w * e[0];
  v.E22 += w * e[1];
  v.E23 += w * e[2];
  v.E13 += w * e[3];
  v.E12 += w * e[4];
  v.S11 += w * S[0];
  v.S22 += w * S[1];
  v.S23 += w * S[2];
  v.S13 += w * S[3];
  v.S12 += w * S[4];
  v.stored += w * energy.stored;
  v.dissipated += w * energy.dissipated();
  for (std::size_t i = 0; i < energy.lost.size(); ++i) v.lost[i] += w * energy.lost[i];
  v.residual1 += w * in.residual1;
  v.residual2 += w * in.residual2;
  v.slack1 += w * in.slack1;
  v.slack2 += w * in.slack2;
  v.folded += w * law::folded(law, E, state);
}

// Of an element without the ply that was asked for.
ElementValues no_values() {
  ElementValues out;
  for (const auto member : element_members()) out.*member = std::nan("");
  out.lost.fill(std::nan(""));
  return out;
}

}  // namespace

Vec3 Readings::reaction(const std::string& set) const {
  Vec3 sum = Vec3::Zero();
  const auto& nodes = model_->mesh().set(set);
  for (const auto n : nodes) sum += reaction_at(n);
  return sum;
}

Vec3 Readings::reaction_at(mesh::Index node) const {
  if (dead_.empty()) return Vec3::Zero();  // before the first step no forces have been computed
  Vec3 force = assembly_->dofs().support_force(node, assembly_->internal().on_x, dead_) + inertia(node);
  for (const auto* const term : assembly_->terms().on_motion())
    if (const auto more = term->on_supports(); !more.empty()) force += at(more, node);
  return force;
}

const mechanics::Contacts& Readings::contact() const {
  const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
  if (contact == nullptr)
    throw Error("nothing touches in this model: expected m:contact{...} before the run");
  return *contact;
}

std::size_t Readings::body_number(const model::Rigid& body) const {
  const int number = contact().surfaces().find_body(body);
  if (number < 0) throw Error("the " + body.kind() + " touches nothing in the model of this run");
  return static_cast<std::size_t>(number);
}

Vec3 Readings::force_of_body(std::size_t i) const {
  read_forces_ = true;
  return shown_forces_ == nullptr ? Vec3(-contact().bodies().readings().force(i))
                                  : Vec3(at(*shown_forces_, static_cast<std::ptrdiff_t>(i)));
}

NodeValues Readings::node(mesh::Index i) const {
  check_index(i, model_->mesh().nodes.size(), "node");
  const auto& state = std::as_const(*assembly_).state();
  NodeValues v;
  v.x = at(state.x(), i);
  v.n = at(state.d(), i);
  v.X = assembly_->dofs().reference()[i];
  v.u = v.x - v.X;
  v.v = velocity(i);
  return v;
}

ElementValues Readings::average(mesh::Index e, int ply) const {
  const auto& section = model_->sections()[static_cast<std::size_t>(model_->region_of(e))];
  const bool together = ply == mechanics::ClothReadings::all_plies;
  const double common = section.common_angle();
  double volume = 0;
  std::size_t visited = 0;
  ElementValues sum;
  assembly_->cloth().readings().visit(
      e, [&](double w, const law::Law& law, const double* E, const double* state) {
        const auto& point = section.points[visited++ % section.points.size()];
        if (!together && point.ply != ply) return;
        volume += w;
        add_point(sum, w, together ? point.angle - common : 0, law, E, state);
      });
  for (const auto member : element_members()) sum.*member /= volume;
  for (double& one : sum.lost) one /= volume;
  return sum;
}

const std::vector<ElementValues>& Readings::elements(const std::string& ply) const {
  const auto version = std::as_const(*assembly_).state().version();
  Averages& known = averages_[ply];
  if (known.version == version) return known.values;
  known.values.assign(assembly_->cloth().elements(), {});
#pragma omp parallel for schedule(static) if (assembly_->cloth().elements() >= 256)
  for (mesh::Index e = 0; e < assembly_->cloth().elements(); ++e) {
    const int number = ply.empty() ? mechanics::ClothReadings::all_plies : model_->ply_of(e, ply);
    if (ply.empty() || number >= 0)
      known.values[e] = average(e, number);
    else
      known.values[e] = no_values();
  }
  known.version = version;
  return known.values;
}

ElementValues Readings::element(mesh::Index i) const {
  check_index(i, model_->mesh().elements.size(), "element");
  return elements()[i];
}

double Readings::elements_beyond() const {
  if (!beyond()) return 0;
  const auto all = assembly_->cloth().elements();
  mesh::Index count = 0;
  for (mesh::Index e = 0; e < all; ++e) count += assembly_->cloth().strains().ratio(e) > 1 ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(all);
}

namespace {

// The nodes or elements of the set over which the mean of a field is taken.
std::vector<mesh::Index> inside(const model::Model& model, const ResultField& field, const std::string& set) {
  const auto& nodes = model.mesh().set(set);
  const bool nodal = field.place == FieldPlace::node;
  const std::vector<mesh::Index> all = nodal ? nodes : model.mesh().elements_in(nodes);
  if (all.empty()) throw Error("mean: set '" + set + "' holds no " + (nodal ? "node" : "whole element"));
  return all;
}

FieldPart number_of(const Readings& run, const std::string& name) {
  const FieldPart part = find_field(run, name);
  if (part.component < 0) throw Error("mean: expected a field of one number, got '" + name + "'");
  if (part.field->touching && !has(run, *part.field))
    throw Error("mean: nothing touches in this model, which the field '" + name +
                "' is of: expected m:contact{...} before the run");
  return part;
}

// The nodes or elements over which a mean of the field's part is taken.
std::vector<mesh::Index> all_of(const Readings& run, const FieldPart& part, const std::string& set) {
  std::vector<mesh::Index> all = inside(run.model(), *part.field, set);
  if (part.ply.empty()) return all;
  for (const mesh::Index e : all)
    if (run.model().ply_of(e, part.ply) < 0)
      throw Error("mean: element " + run.model().element_name(e) + " of set '" + set + "' has no ply '" +
                  part.ply + "'");
  return all;
}

// Each position counts once, whatever the number of its nodes.
double mean_of_places(const Readings& run, const FieldPart& part, const std::vector<mesh::Index>& nodes) {
  const mesh::Mesh& mesh = run.model().mesh();
  std::map<mesh::Index, std::pair<double, int>> at_place;
  double values[5];
  for (const auto n : nodes) {
    part.field->values(run, n, part.ply, values);
    auto& [sum, count] = at_place[mesh.place_of(n)];
    sum += values[part.component];
    ++count;
  }
  double sum = 0;
  for (const auto& [place, of] : at_place) sum += of.first / of.second;
  return sum / static_cast<double>(at_place.size());
}

}  // namespace

void check_mean(const Readings& run, const std::string& name, const std::string& set) {
  all_of(run, number_of(run, name), set);
}

double Readings::mean(const std::string& name, const std::string& set) const {
  const FieldPart part = number_of(*this, name);
  const auto all = all_of(*this, part, set);
  const mesh::Mesh& mesh = model_->mesh();
  if (mesh.whole && part.field->place == FieldPlace::node) return mean_of_places(*this, part, all);
  double sum = 0, values[5];
  for (const auto i : all) {
    part.field->values(*this, i, part.ply, values);
    sum += values[part.component];
  }
  return sum / static_cast<double>(all.size());
}

std::vector<double> Readings::field(const std::string& name) const {
  return values_of(*this, find_field(*this, name));
}

double EnergyAccount::lost_in(std::string_view name) const {
  double sum = 0;
  for (const EnergyPart& part : lost)
    if (part.name == name) sum += part.value;
  return sum;
}

namespace {

bool is_of_cloth(const std::string& name) {
  return law::dissipation_names.index(name) >= 0 || name == "bending";
}

// The sum of all; what is neither of cloth nor of contact is added up apart, so that the rounding of a run
// does not depend on where among them a further term stands.
double sum_of(const std::vector<EnergyPart>& parts) {
  double sum = 0, others = 0;
  for (const EnergyPart& part : parts) {
    const bool usual = is_of_cloth(part.name) || part.name == "friction" || part.name == "impact";
    (usual ? sum : others) += part.value;
  }
  return sum + others;
}

}  // namespace

std::vector<EnergyPart> energies(const EnergyAccount& e) {
  std::vector<EnergyPart> out = {{"kinetic", e.kinetic},   {"scaled", e.scaled},
                                 {"stored", e.stored},     {"dissipated", e.dissipated},
                                 {"damping", e.damping},   {"relaxed", e.relaxed},
                                 {"external", e.external}, {"contact", e.contact},
                                 {"guard", e.guard},       {"directors", e.directors},
                                 {"stick", e.stick},       {"rigid", e.rigid},
                                 {"created", e.created},   {"internal", e.internal()},
                                 {"initial", e.initial},   {"error", e.error}};
  const auto add = [&out](const std::string& name, double value) {
    const auto there =
        std::find_if(out.begin(), out.end(), [&](const EnergyPart& p) { return p.name == name; });
    if (there == out.end())
      out.push_back({name, value});
    else
      there->value += value;
  };
  for (const EnergyPart& part : e.lost)
    add((is_of_cloth(part.name) ? "dissipated_" : "") + part.name, part.value);
  for (const char* name : {"friction", "impact", "joints", "fracture"}) add(name, 0);
  if (e.gas) add("gas", *e.gas);
  return out;
}

EnergyAccount Readings::energy() const {
  EnergyAccount sum;
  for (const auto& energy : assembly_->energies()) {
    if (energy.account == mechanics::Account::stored) sum.stored += energy.value;
    if (energy.account == mechanics::Account::created) sum.created += energy.value;
    if (energy.account == mechanics::Account::kinetic) sum.kinetic += energy.value;
    if (energy.account == mechanics::Account::damping) sum.damping += energy.value;
    if (energy.account == mechanics::Account::moving) sum.rigid += energy.value;
    if (energy.account == mechanics::Account::dissipated) sum.lost.push_back({energy.name, energy.value});
    if (energy.name == "contact") sum.contact += energy.value;
    if (energy.name == "guard") sum.guard += energy.value;
    if (energy.name == "gas") sum.gas = energy.value;
    if (energy.name == "stick") sum.stick += energy.value;
    if (energy.name == "directors") sum.directors += energy.value;
  }
  sum.dissipated = sum_of(sum.lost);
  sum.kinetic = sum.kinetic + driven_kinetic() + sum.rigid;
  sum.scaled = scaled_kinetic();
  sum.damping += scheme_loss();
  sum.relaxed = relaxed();
  sum.external = work_.total() + (started_ ? driven_work() : 0);
  sum.initial = started_ ? initial_energy_ : sum.taken_over();
  const double scale = std::max({work_.largest(), sum.initial, energy_of_rest()});
  if (scale > 0) sum.error = imbalance(sum, scale) / scale;
  return sum;
}

double Readings::energy_of_rest() const {
  const auto* const contact = assembly_->terms().find<mechanics::Contacts>();
  if (contact == nullptr) return 0;
  Vec3 g = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (const auto& h = model_->gravity()[static_cast<std::size_t>(c)]) g[c] = h->value(committed_time());
  double thickness = 0;
  for (const auto& section : model_->sections()) thickness = std::max(thickness, section.thickness);
  const auto& masses = assembly_->cloth().mass();
  return std::accumulate(masses.begin(), masses.end(), 0.0) * g.norm() * thickness;
}

double Readings::imbalance(const EnergyAccount& sum, double scale) const {
  constexpr double small = 1e-3;
  const double whole = std::abs(sum.surplus());
  return whole <= small * scale ? whole : std::min(whole, std::abs(sum.surplus() + hidden_energy()));
}

}  // namespace fabricsh::run
