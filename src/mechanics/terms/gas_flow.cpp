#include "mechanics/terms/gas_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fabricsh::mechanics {

namespace {

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
  // What would have to go before the pressures are equal.
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
