#include "mechanics/terms/gas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "model/gas_planes.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kDifference = 1e-5;  // of a volume, for the change of the pressure where gas flows

using Ring = std::vector<Index>;

Vec3 centre_of(const Ring& ring, std::span<const double> x) {
  Vec3 sum = Vec3::Zero();
  for (const Index n : ring) sum += at(x, n);
  return sum / static_cast<double>(ring.size());
}

std::vector<double> positions(const mesh::Mesh& mesh) {
  std::vector<double> x;
  for (const Vec3& X : mesh.nodes) x.insert(x.end(), {X.x(), X.y(), X.z()});
  return x;
}

GasFlow flow_of(const model::Model& model) {
  const auto& mesh = model.mesh();
  const auto x = positions(mesh);
  std::vector<GasFlow::VolumeGiven> all;
  for (const auto& gas : model.all<model::GasPointer>()) {
    const auto area = [&](const std::string& set) {
      std::vector<FaceNodes> faces;
      for (const auto e : mesh.elements_in(mesh.set(set))) faces.push_back(mesh.elements[e]);
      return area_of(faces, x);
    };
    GasFlow::VolumeGiven given{gas, area_of(model::enclosure_of(model, *gas).cloth, x), {}};
    for (const auto& vent : gas->vents) given.vents.push_back(vent.set.empty() ? vent.area : area(vent.set));
    all.push_back(std::move(given));
  }
  return GasFlow(std::move(all));
}

constexpr double kPart = 0.02;  // of what can flow before pressures are equal: no part of a step moves more
constexpr double kSupplied = 5e-4;  // of the mass that there is, supplied in a part
constexpr int kParts = 200;         // of a step at most

// With p V^n constant.
GasState at_volume(const GasState& s, double volume, double exponent) {
  return {volume, s.pressure * std::pow(s.volume / volume, exponent), s.mass};
}
// After `mass` kg have left, the rest expands into their place; a negative one makes room for none.
GasState without(const GasState& s, double mass, double exponent) {
  return {s.volume, s.pressure * std::pow(1 - mass / s.mass, exponent), s.mass - mass};
}
// After `mass` kg of a temperature have come: V dp = n R T dm.
GasState with(const GasState& s, double mass, double temperature, const model::GasGiven& gas) {
  return {s.volume, s.pressure + gas.exponent * gas.specific() * temperature * mass / s.volume,
          s.mass + mass};
}

// The root of a function that rises from a negative value at `low` to one that is not negative at `high`.
template <class F>
double root(F f, double low, double high, double below, double above) {
  for (int i = 0; i < 200 && high - low > 1e-15 * std::abs(high) && below < 0 && above > 0; ++i) {
    // False position, halving where an end stays (Illinois); by bisection every third time.
    double x = i % 3 == 2 ? (low + high) / 2 : low - below * (high - low) / (above - below);
    if (!(x > low && x < high)) x = (low + high) / 2;
    if (x == low || x == high) break;
    const double value = f(x);
    if (value < 0) {
      low = x;
      below = value;
    } else {
      high = x;
      above = value;
    }
  }
  return above <= 0 ? high : below >= 0 ? low : low - below * (high - low) / (above - below);
}

}  // namespace

Gas::Gas(const model::Model& model)
    : nodes_(model.mesh().nodes.size()), flow_(flow_of(model)), open_(flow_.begin()) {
  auto x = positions(model.mesh());
  for (const auto& gas : model.all<model::GasPointer>()) add_volume(model, *gas, x);
  const auto V = volumes(x);
  for (std::size_t i = 0; i < V.size(); ++i) {
    const auto& gas = *model.all<model::GasPointer>()[i];
    const double of_one = gas.specific() * gas.temperature / V[i];  // Pa, of 1 kg
    const double pressure = gas.mass ? *gas.mass * of_one : gas.outside + gas.initial;
    states_.push_back({V[i], pressure, pressure / of_one});
  }
  rollback();
}

// The part of a body within a rim goes along with it: a ring of points of the body, which the cloth's rim
// joins by strips without width where it lies at the body.
void Gas::add_volume(const model::Model& model, const model::GasGiven& gas, std::vector<double>& x) {
  auto surface = model::enclosure_of(model, gas);
  const Vec3 first = model.mesh().nodes[static_cast<std::size_t>(surface.cloth.front()[0])];
  Volume volume{std::move(surface.cloth), std::move(surface.lids), model::apex_of_gas(model, first)};
  volume.faces.insert(volume.faces.end(), surface.strips.begin(), surface.strips.end());
  for (const model::BodyLid& lid : surface.bodies) {
    const auto count = static_cast<Index>(lid.rim.size()), seat = static_cast<Index>(x.size() / 3);
    Ring ring;
    for (Index i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i), next = (k + 1) % lid.rim.size();
      const Vec3 &here = model.mesh().nodes[static_cast<std::size_t>(lid.rim[k])], &at_body = lid.seats[k];
      const double edge = (model.mesh().nodes[static_cast<std::size_t>(lid.rim[next])] - here).norm();
      x.insert(x.end(), {at_body.x(), at_body.y(), at_body.z()});
      ring.push_back(seat + i);
      rims_.push_back({lid.rim[k], seat + i, lid.body.get(), (here - at_body).norm(), edge});
      // The lid runs along the rim as its face does, and so does the strip's edge at the rim.
      volume.faces.push_back({lid.rim[k], lid.rim[next], seat + static_cast<Index>(next), seat + i});
    }
    volume.lids.push_back(std::move(ring));
    volume.bulge += lid.bulge;
  }
  volumes_.push_back(std::move(volume));
}

void Gas::press_on(GasOnBodies& bodies, const Trial& start) {
  if (!on_bodies()) return;
  bodies_ = &bodies;
  const auto nodes = static_cast<Index>(nodes_);
  std::vector<Index> point;  // of each seat
  for (std::size_t g = 0; g < volumes_.size(); ++g) {
    std::size_t lid = 0;
    for (const Ring& ring : volumes_[g].lids) {
      if (ring.front() < nodes) continue;
      const auto first = static_cast<Index>(bodies.bodies().seats(g, lid++));
      for (std::size_t i = 0; i < ring.size(); ++i) point.push_back(nodes + first + static_cast<Index>(i));
    }
  }
  const auto move = [&](Index& n) {
    if (n >= nodes) n = point[static_cast<std::size_t>(n - nodes)];
  };
  for (Volume& volume : volumes_) {
    for (FaceNodes& face : volume.faces) std::for_each(face.begin(), face.end(), move);
    for (Ring& ring : volume.lids) std::for_each(ring.begin(), ring.end(), move);
  }
  for (Rim& rim : rims_) move(rim.seat);
  place(start, x_);
  push(trial_);
  bodies.begin(push_);
}

// N, on all points.
void Gas::push(const GasFlow::GasStep& step) {
  push_.assign(x_.size(), 0);
  for (std::size_t i = 0; i < volumes_.size(); ++i) volumes_[i].add_pressure(gauge(i, step), x_, push_);
}

// Of the bodies' rows of the tangent over the masses, as mechanics/rate_bound.hpp has those of the nodes.
double Gas::stable_step(bool) const {
  double most = 0;  // 1/s2
  if (bodies_ == nullptr) return std::numeric_limits<double>::infinity();
  const NodalRanks ranks = all_ranks(x_, aimed_);
  for (const model::Rigid* const body : closing()) {
    double rate = 0;
    for (std::size_t i = 0; i < volumes_.size(); ++i) {
      double own = 0;
      for (const Rim& rim : rims_)
        if (rim.body == body)
          own += at(ranks.on_x[i], rim.seat).norm() * std::sqrt(bodies_->inverse_mass(rim.seat));
      for (std::size_t j = 0; j < volumes_.size(); ++j)
        rate += own * std::abs(ranks.core(static_cast<Index>(i), static_cast<Index>(j))) *
                bodies_->size_of(ranks.on_x[j]);
    }
    most = std::max(most, rate);
  }
  return most > 0 ? 2 / std::sqrt(most) : std::numeric_limits<double>::infinity();
}

std::vector<const model::Rigid*> Gas::closing() const {
  std::vector<const model::Rigid*> all;
  for (const Rim& rim : rims_)
    if (std::find(all.begin(), all.end(), rim.body) == all.end()) all.push_back(rim.body);
  return all;
}

// A rim that has left its body by much leaves a gap through which gas would flow.
Gas::RimGap Gas::farthest_rim(const Trial& trial) const {
  RimGap most;
  place(trial, x_);
  for (const Rim& rim : rims_) {
    const double apart = (at(x_, rim.node) - at(x_, rim.seat)).norm() - rim.apart;
    if (apart > most.apart) most = {apart, rim.node, rim.body, rim.edge};
  }
  return most;
}

void Gas::place(const Trial& trial, std::vector<double>& x) const {
  if (bodies_ != nullptr) return bodies_->place_points(trial, x);
  const auto nodes = trial.configuration.x();
  x.assign(nodes.begin(), nodes.end());
}

double Gas::Volume::volume(std::span<const double> x) const {
  double sum = volume_behind(faces, x, apex) + bulge;
  for (const Ring& ring : lids) {
    const Vec3 centre = centre_of(ring, x) - apex;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum += centre.dot((at(x, ring[i]) - apex).cross(at(x, ring[(i + 1) % ring.size()]) - apex)) / 6;
  }
  return sum;
}

// A lid is a fan of triangles about the mean of its nodes, each of which has its share of the force there.
void Gas::Volume::add_pressure(double pressure, std::span<const double> x, std::span<double> on_x) const {
  mechanics::add_pressure(faces, pressure, x, on_x);
  for (const Ring& ring : lids) {
    const Vec3 centre = centre_of(ring, x);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[(i + 1) % ring.size()];
      const Vec3 force = pressure / 6 * (at(x, a) - centre).cross(at(x, b) - centre);
      at(on_x, a) += force;
      at(on_x, b) += force;
      sum += force;
    }
    for (const Index n : ring) at(on_x, n) += sum / static_cast<double>(ring.size());
  }
}

// With t1 and t2 from the centre to the nodes i and i + 1, the force of a triangle on each of its corners
// changes by p/6 (t1 x dt2 - t2 x dt1). The centre moves by the mean of all; that of the sum of all triangles
// has no effect.
void Gas::Volume::add_lid_tangent(double pressure, std::span<const double> x, TangentSink& sink) const {
  for (const Ring& ring : lids) {
    const std::size_t n = ring.size();
    const Vec3 centre = centre_of(ring, x);
    const double share = 1 / static_cast<double>(n);
    std::vector<Mat3> first(n), second(n);  // by the nodes i and i + 1
    for (std::size_t i = 0; i < n; ++i) {
      first[i] = -pressure / 6 * cross_matrix(at(x, ring[(i + 1) % n]) - centre);
      second[i] = pressure / 6 * cross_matrix(at(x, ring[i]) - centre);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t before = (k + n - 1) % n;
      for (std::size_t j = 0; j < n; ++j) {
        Mat3 change = share * (first[j] + second[(j + n - 1) % n]);
        for (const std::size_t i : {before, k}) {
          change -= share * (first[i] + second[i]);
          if (j == i) change += first[i];
          if (j == (i + 1) % n) change += second[i];
        }
        sink.on_positions(ring[k], ring[j], -change);
      }
    }
  }
}

std::vector<double> Gas::volumes(std::span<const double> x) const {
  std::vector<double> all;
  for (const Volume& volume : volumes_) all.push_back(volume.volume(x));
  return all;
}

GasFlow::GasStep Gas::after(std::vector<double> volumes, double time) const {
  return flow_.advance(states_, open_, std::move(volumes), time_, time - time_);
}

double Gas::gauge(std::size_t i, const GasFlow::GasStep& step) const {
  return step.states[i].pressure - flow_.gas(i).outside;
}

Outcome Gas::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  place(trial, x_);
  auto V = volumes(x_);
  for (std::size_t i = 0; i < V.size(); ++i)
    if (!(V[i] > 0)) return {Answer::cut, -1, "the gas " + flow_.gas(i).name() + " has no volume left"};
  trial_ = after(std::move(V), trial.time);
  aimed_ = trial.time;
  if (trial_.empty >= 0)
    return {Answer::broken, -1,
            "the inflow takes more gas " + flow_.gas(static_cast<std::size_t>(trial_.empty)).name() +
                " away than there is"};
  if (bodies_ == nullptr) {
    for (std::size_t i = 0; i < volumes_.size(); ++i)
      volumes_[i].add_pressure(-gauge(i, trial_), x_, forces.on_x);
    return {};
  }
  push(trial_);
  for (std::size_t k = 0; k < 3 * nodes_; ++k) forces.on_x[k] -= push_[k];
  bodies_->press(push_);
  return {};
}

namespace {

// Passes on what couples nodes of the cloth, and keeps what has to do with bodies.
class BodySink final : public TangentSink {
 public:
  BodySink(TangentSink& cloth, std::size_t nodes, std::vector<GasOnBodies::GasTangent::Part>& parts)
      : cloth_(cloth), nodes_(static_cast<Index>(nodes)), parts_(parts) {}
  void on_positions(Index a, Index b, const Mat3& k) override {
    if (a < nodes_ && b < nodes_)
      cloth_.on_positions(a, b, k);
    else
      parts_.push_back({a, b, k});
  }
  void on_director(Index, const Eigen::Matrix2d&) override {}
  void on_nodes(Index, Index, const Eigen::Matrix<double, 5, 5>&) override {}
  void on_lead(Index, const Vec3&) override {}

 private:
  TangentSink& cloth_;
  const Index nodes_;
  std::vector<GasOnBodies::GasTangent::Part>& parts_;
};

}  // namespace

void Gas::add_tangent(const Trial& trial, TangentSink& sink) const {
  place(trial, x_);
  const auto step = after(volumes(x_), trial.time);
  GasOnBodies::GasTangent of_bodies;
  BodySink split(sink, nodes_, of_bodies.parts);
  for (std::size_t i = 0; i < volumes_.size(); ++i) {
    add_pressure_tangent(volumes_[i].faces, gauge(i, step), x_, split);
    volumes_[i].add_lid_tangent(gauge(i, step), x_, split);
  }
  if (bodies_ == nullptr) return;
  of_bodies.ranks = all_ranks(x_, trial.time);
  bodies_->take(std::move(of_bodies));
}

void Gas::couple(const Trial&, std::vector<NodePair>& pairs) {
  for (const Volume& volume : volumes_) {
    for (const FaceNodes& face : volume.faces)
      if (face[3] < 0)
        for (int a = 0; a < 3; ++a) pairs.emplace_back(face[a], face[(a + 1) % 3]);
    for (const Ring& ring : volume.lids)
      for (const Index a : ring)
        for (const Index b : ring)
          if (a < b && b < static_cast<Index>(nodes_)) pairs.emplace_back(a, b);
  }
}

// The internal forces are -p dV/dx, which change by -dp/dV (dV/dx . dx) dV/dx as the volumes do.
void Gas::add_ranks(const Trial& trial, NodalRanks& out) const {
  place(trial, x_);
  out = all_ranks(x_, trial.time);
  for (auto& column : out.on_x) column.resize(3 * nodes_);
}

NodalRanks Gas::all_ranks(std::span<const double> x, double time) const {
  NodalRanks out;
  for (const Volume& volume : volumes_) {
    out.on_x.emplace_back(x.size(), 0.0);
    volume.add_pressure(1, x, out.on_x.back());
    out.beside.push_back(bodies_ == nullptr ? 0 : bodies_->size_of(out.on_x.back(), nodes_));
  }
  out.core = core(volumes(x), time);
  return out;
}

// N/m5, minus the derivatives of the pressures by the volumes.
Eigen::MatrixXd Gas::core(const std::vector<double>& V, double time) const {
  const auto k = static_cast<Index>(V.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(k, k);
  const auto here = after(V, time);
  for (Index j = 0; j < k; ++j) {
    const auto n = static_cast<std::size_t>(j);
    if (!flow_.flows()) {
      out(j, j) = flow_.gas(n).exponent * here.states[n].pressure / V[n];
      continue;
    }
    const double h = kDifference * V[n];
    auto more = V, less = V;
    more[n] += h;
    less[n] -= h;
    const auto larger = after(std::move(more), time), smaller = after(std::move(less), time);
    for (Index i = 0; i < k; ++i) {
      const auto m = static_cast<std::size_t>(i);
      out(i, j) = (smaller.states[m].pressure - larger.states[m].pressure) / (2 * h);
    }
  }
  return out;
}

void Gas::add_energies(const Trial&, std::vector<Energy>& out) const {
  double stored = 0;
  for (std::size_t i = 0; i < volumes_.size(); ++i)
    stored += available_energy(flow_.gas(i), trial_.states[i]);
  out.push_back({"gas", Account::stored, stored});
  if (flow_.flows()) out.push_back({"vents", Account::dissipated, lost_ + trial_.lost});
}

void Gas::commit() {
  states_ = trial_.states;
  lost_ += trial_.lost;
  time_ = aimed_;
  flow_.open(states_, open_);
  rollback();
}

void Gas::rollback() {
  trial_ = {states_};
  aimed_ = time_;
}

void Gas::keep(Archive& archive) {
  archive(states_, open_, time_, lost_);
  if (archive.reading()) rollback();
}

Gas::GasReading Gas::read(const model::GasGiven& gas) const {
  for (std::size_t i = 0; i < volumes_.size(); ++i)
    if (&flow_.gas(i) == &gas) {
      const GasState& s = trial_.states[i];
      return {gauge(i, trial_), s.volume, s.mass, s.temperature(gas)};
    }
  throw Error("gas: expected a gas volume of the run's model, what m:gas returned");
}

bool Gas::pushes() const {
  for (std::size_t i = 0; i < volumes_.size(); ++i)
    if (gauge(i, trial_) != 0) return true;
  return false;
}

double nozzle_flow(double ratio, double specific, double pressure, double temperature, double behind) {
  const double critical = std::pow(2 / (ratio + 1), ratio / (ratio - 1));
  const double r = std::max(behind / pressure, critical);
  if (!(r < 1)) return 0;
  const double fall = std::pow(r, 2 / ratio) - std::pow(r, (ratio + 1) / ratio);
  return pressure * std::sqrt(2 * ratio / (ratio - 1) * std::max(0.0, fall) / (specific * temperature));
}

double available_energy(const model::GasGiven& gas, const GasState& s) {
  const double n = gas.exponent, pv = s.pressure * s.volume, over = std::log(s.pressure / gas.outside);
  const double grown = s.volume * std::expm1(over / n);  // to the volume at the pressure outside
  const double given = n == 1 ? pv * over : -pv * std::expm1(-(n - 1) / n * over) / (n - 1);
  return std::max(0.0, given - gas.outside * grown);
}

GasFlow::GasFlow(std::vector<VolumeGiven> volumes) : volumes_(std::move(volumes)) {
  for (std::size_t i = 0; i < volumes_.size(); ++i) {
    const auto& gas = *volumes_[i].gas;
    if (gas.inflow || gas.leakage) flows_ = true;
    if (gas.leakage) openings_.push_back({i, -1, volumes_[i].area, 0, true});
    for (std::size_t v = 0; v < gas.vents.size(); ++v) {
      const auto& vent = gas.vents[v];
      const auto to = std::find_if(volumes_.begin(), volumes_.end(),
                                   [&](const VolumeGiven& other) { return vent.to && other.gas == vent.to; });
      openings_.push_back({i, to == volumes_.end() ? -1 : static_cast<int>(to - volumes_.begin()),
                           vent.coefficient * volumes_[i].vents[v], vent.opens, false});
      flows_ = true;
    }
  }
}

std::vector<char> GasFlow::begin() const {
  std::vector<char> open;
  for (const Opening& o : openings_) open.push_back(o.opens > 0 ? 0 : 1);
  return open;
}

void GasFlow::open(const std::vector<GasState>& states, std::vector<char>& open) const {
  for (std::size_t i = 0; i < openings_.size(); ++i) {
    const Opening& o = openings_[i];
    const double behind = o.to < 0 ? gas(o.from).outside : states[static_cast<std::size_t>(o.to)].pressure;
    if (states[o.from].pressure - behind >= o.opens) open[i] = 1;
  }
}

// kg/s from a state to a lower pressure.
double GasFlow::rate(const Opening& o, const GasState& up, const model::GasGiven& gas, double behind) const {
  if (!(up.pressure > behind)) return 0;
  const double temperature = up.temperature(gas);
  if (!o.leaks) return o.area * nozzle_flow(gas.ratio(), gas.specific(), up.pressure, temperature, behind);
  return o.area * std::max(0.0, gas.leakage(up.pressure - behind)) * up.pressure /
         (gas.specific() * temperature);
}

// kg that go in dt from one state to another, or to the outside (null), by the midpoint rule; no more than
// makes the pressures equal. The upper state may be that of the outside, with a mass without end.
double GasFlow::passed(const Opening& o, double dt, const GasState& up, const GasState* down,
                       const model::GasGiven& gas, double outside) const {
  const bool from_outside = std::isinf(up.mass);
  const double temperature = from_outside ? gas.temperature : up.temperature(gas);
  const auto above = [&](double mass) { return from_outside ? up : without(up, mass, gas.exponent); };
  const auto behind = [&](double mass) {
    return down == nullptr ? outside : with(*down, mass, temperature, gas).pressure;
  };
  if (!(up.pressure > behind(0))) return 0;
  // Pa, the pressure behind less that above once this mass has gone.
  const auto lacks = [&](double mass) { return behind(mass) - above(mass).pressure; };
  double most = from_outside ? down->mass : up.mass * (1 - 1e-9);
  while (from_outside && lacks(most) < 0) most *= 2;
  most = root(lacks, 0, most, lacks(0), lacks(most));
  const auto excess = [&](double mass) {
    GasState middle = above(mass / 2);
    if (!from_outside) return mass - dt * rate(o, middle, gas, behind(mass / 2));
    const double to = behind(mass / 2), density = up.pressure / (gas.specific() * temperature);
    const double speed = !(up.pressure > to) ? 0
                         : o.leaks           ? std::max(0.0, gas.leakage(up.pressure - to)) * density
                                   : nozzle_flow(gas.ratio(), gas.specific(), up.pressure, temperature, to);
    return mass - dt * o.area * speed;
  };
  return root(excess, 0, most, excess(0), excess(most));
}

void GasFlow::pass(const Opening& o, double dt, GasStep& step) const {
  GasState& from = step.states[o.from];
  const auto& gas = this->gas(o.from);
  const double before = available(step);
  if (o.to < 0) {
    if (from.pressure > gas.outside) {
      from = without(from, passed(o, dt, from, nullptr, gas, gas.outside), gas.exponent);
    } else if (from.pressure < gas.outside) {
      const GasState outside{0, gas.outside, INFINITY};
      from = with(from, passed(o, dt, outside, &from, gas, gas.outside), gas.temperature, gas);
    }
  } else {
    GasState& to = step.states[static_cast<std::size_t>(o.to)];
    GasState &up = from.pressure >= to.pressure ? from : to, &down = &up == &from ? to : from;
    const auto& other = &up == &from ? gas : this->gas(static_cast<std::size_t>(o.to));
    const double temperature = up.temperature(other);
    const double mass = passed(o, dt, up, &down, other, gas.outside);
    up = without(up, mass, other.exponent);
    down = with(down, mass, temperature, &up == &from ? this->gas(static_cast<std::size_t>(o.to)) : gas);
  }
  step.lost += before - available(step);
}

void GasFlow::supply(std::size_t i, double mass, GasStep& step) const {
  if (mass == 0) return;
  GasState& s = step.states[i];
  const auto& gas = this->gas(i);
  if (s.mass + mass <= 0) {
    step.empty = static_cast<int>(i);
    return;
  }
  const double before = available_energy(gas, s);
  s = mass > 0 ? with(s, mass, gas.temperature, gas) : without(s, -mass, gas.exponent);
  step.supplied += available_energy(gas, s) - before;
}

double GasFlow::available(const GasStep& step) const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += available_energy(gas(i), step.states[i]);
  return sum;
}

void GasFlow::change_volume(std::size_t i, double volume, GasStep& step) const {
  step.states[i] = at_volume(step.states[i], volume, gas(i).exponent);
}

// So many that little flows in each; known from the state at the beginning alone.
int GasFlow::parts(const std::vector<GasState>& from, const std::vector<char>& open, double time,
                   double dt) const {
  double most = 1;
  for (std::size_t i = 0; i < openings_.size(); ++i) {
    const Opening& o = openings_[i];
    if (open[i] == 0) continue;
    const auto& gas = this->gas(o.from);
    const GasState* const other = o.to < 0 ? nullptr : &from[static_cast<std::size_t>(o.to)];
    const double behind = other == nullptr ? gas.outside : other->pressure;
    const GasState& up = from[o.from];
    const double fast = rate(o, up, gas, behind) * dt, difference = std::abs(up.pressure - behind);
    if (difference > 0)
      most = std::max(most, fast / (kPart * up.mass * std::min(1.0, difference / up.pressure)));
  }
  for (std::size_t i = 0; i < size(); ++i)
    if (gas(i).inflow)
      most = std::max(most, std::abs(gas(i).inflow->value(time + dt / 2)) * dt / (kSupplied * from[i].mass));
  return static_cast<int>(std::ceil(std::min<double>(most, kParts)));
}

// kg that flow in by half parts of a step.
std::vector<double> GasFlow::supplies(std::size_t i, int count, double time, double dt) const {
  std::vector<double> all(static_cast<std::size_t>(2 * count), 0.0);
  if (!gas(i).inflow) return all;
  const double h = dt / (2 * count);
  for (std::size_t k = 0; k < all.size(); ++k)
    all[k] = h * gas(i).inflow->value(time + h * (static_cast<double>(k) + 0.5));
  return all;
}

// A volume that is filled grows as its mass does: then the pressure changes evenly, as equilibrium asks.
// Others change evenly in time.
std::vector<double> GasFlow::progress(const std::vector<double>& supplies) {
  const auto [least, most] = std::minmax_element(supplies.begin(), supplies.end());
  const bool fills = *least >= 0 && *most > 0;
  std::vector<double> shares;
  double sum = 0;
  for (const double s : supplies) shares.push_back(sum += fills ? s : 1);
  for (double& s : shares) s /= sum;
  shares.back() = 1;
  return shares;
}

GasFlow::GasStep GasFlow::advance(const std::vector<GasState>& from, const std::vector<char>& open,
                                  std::vector<double> volumes, double time, double dt) const {
  GasStep step{from};
  if (!flows_ || !(dt > 0)) {
    for (std::size_t i = 0; i < size(); ++i) change_volume(i, volumes[i], step);
    return step;
  }
  const int count = parts(from, open, time, dt);
  std::vector<std::vector<double>> masses, shares;
  for (std::size_t i = 0; i < size(); ++i) {
    masses.push_back(supplies(i, count, time, dt));
    shares.push_back(progress(masses.back()));
  }
  const auto change = [&](std::size_t half) {
    for (std::size_t i = 0; i < size(); ++i) {
      const double share = shares[i][half];
      change_volume(i, share == 1 ? volumes[i] : from[i].volume + share * (volumes[i] - from[i].volume),
                    step);
    }
  };
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    change(2 * k);
    for (std::size_t i = 0; i < size(); ++i) supply(i, masses[i][2 * k], step);
    for (std::size_t i = 0; i < openings_.size(); ++i)
      if (open[i] != 0) pass(openings_[i], dt / count, step);
    for (std::size_t i = 0; i < size(); ++i) supply(i, masses[i][2 * k + 1], step);
    change(2 * k + 1);
  }
  return step;
}

}  // namespace fabricsh::mechanics
