#include "rheology/damage/damage.hpp"

#include <cmath>

#include "base/error.hpp"
#include "base/number.hpp"

namespace fabricsh::rheology::damage {

namespace {

// The strain at which the force per reference width, t S sqrt(1 + 2 E), is the strength; by bisection, since
// the force rises with the strain.
double breaking_strain(const YarnSpring& yarn, double thickness, double strength) {
  const auto force = [&](double E) { return thickness * yarn.stress(E) * std::sqrt(1 + 2 * E); };
  double high = 1e-6, low = 0;
  while (force(high) < strength) high *= 2;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    (force(middle) < strength ? low : high) = middle;
  }
  return high;
}

void set_yarn(const YarnSpring& yarn, const char* name, double size, double thickness, double strength,
              double energy, double* s) {
  const double begin = breaking_strain(yarn, thickness, strength), stress = yarn.stress(begin);
  const double stored = stress * stress / (2 * yarn.unloading),
               softening = energy / (thickness * size) - stored;
  // The descent may not be steeper than unloading, or the element would snap back by itself.
  if (!(softening >= stored))
    throw Error(std::string("field 'damage.") + name + "': expected at most " +
                number(energy / (2 * stored * thickness)) + " m of cloth along the " + name +
                ", where its yarns break at " + number(strength) + " N/m and take " + number(energy) +
                " J/m, got " + number(size) + " m: use a finer mesh, or a lower strength");
  s[state::begin] = begin;
  s[state::residual] = begin - stress / yarn.unloading;
  s[state::stretch] = std::sqrt(1 + 2 * begin);
  s[state::end] = s[state::stretch] + 2 * softening / (stress * s[state::stretch]);
  s[state::stress] = stress;
}

}  // namespace

std::vector<ParameterRow<Parameters>> Element::rows() {
  std::vector<ParameterRow<Parameters>> rows;
  const auto yarn = [&rows](const std::string& side, double Parameters::*strength,
                            double Parameters::*energy) {
    rows.push_back(ParameterRow<Parameters>(side, "breaking of the " + side + " yarns; without it they hold")
                       .not_needed());
    rows.push_back(
        ParameterRow<Parameters>(side + ".strength", strength, "N/m", positive,
                                 "force of the yarns per width at which they break, without the contraction "
                                 "of the cloth across")
            .ask(100, 1e6, "is the strength in N/m of width?")
            .printed(side + " # kN/m", 1e-3));
    rows.push_back(ParameterRow<Parameters>(side + ".energy", energy, "J/m", positive,
                                            "energy that breaking these yarns takes, per metre of the tear")
                       .ask(0.1, 1e5, "is the energy in J per metre of tear?")
                       .printed("energy # J/m"));
  };
  yarn("warp", &Parameters::warp_strength, &Parameters::warp_energy);
  yarn("weft", &Parameters::weft_strength, &Parameters::weft_energy);
  return rows;
}

void Element::set_initial(const std::array<YarnSpring, 2>& yarns, const PointSite& site, const Data& data,
                          double* s) {
  constexpr std::array names = {"warp", "weft"};
  for (std::size_t i = 0; i < 2; ++i)
    if (data.strength[i] > 0 && site.size[i] > 0)
      set_yarn(yarns[i], names[i], site.size[i], site.thickness, site.strength[i] * data.strength[i],
               data.energy[i], s + i * state::count);
}

}  // namespace fabricsh::rheology::damage
