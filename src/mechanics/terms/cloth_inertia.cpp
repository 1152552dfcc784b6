// Masses of the cloth, and its largest stable step of central differences.
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

namespace {

// m^2: rotary inertia per mass of the thickness itself, int rho z^2 / int rho.
double gyration(const section::Section& section) {
  if (section.points.size() == 1)
    return section.thickness * section.thickness * (1.0 / 12 + section.offset * section.offset / 4);
  double mass = 0, second = 0;
  for (const auto& p : section.points) {
    const double z = section.thickness / 2 * (p.zeta - section.offset);
    mass += p.weight * p.density;
    second += p.weight * p.density * z * z;
  }
  return second / mass;
}

// (m/s)^2: stiffest in-plane modulus and transverse shear modulus over the density, for the whole thickness.
struct Speeds {
  double membrane = 0, shear = 0;
};
Speeds speeds(const section::Section& section) {
  double stiffness = 0, transverse = 0, mass = 0;
  for (const auto& p : section.points) {
    stiffness += p.weight * law::stiffest(*p.law);
    transverse += p.weight * law::transverse_modulus(*p.law);
    mass += p.weight * p.density;
  }
  return {stiffness / mass, transverse / mass};
}

}  // namespace

// s: the stable step for waves in the plane of the cloth.
double Cloth::membrane_step() const {
  std::vector<double> speed;  // m/s, per region
  for (const auto& section : model_.sections()) speed.push_back(std::sqrt(speeds(section).membrane));
  double shortest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < elements(); ++e)
    shortest = std::min(
        shortest, size(model_.mesh().elements[e], X_) / speed[static_cast<std::size_t>(model_.region_of(e))]);
  return shortest;
}

// m^2: rotary inertia per mass, that of the thickness. If scaled, it is at least h^2 (c_s / c)^2 / 4, so that
// rotations against the transverse shear, of frequency c_s / sqrt(inertia), permit the membrane's step, 2 /
// frequency. This slows a wave of wave number k by (k h)^2 (c_s / c)^2 / 8, for woven cloth some hundredth of
// the effect of the lumped mass, (k h)^2 / 24; [hughes1978] has A/8 for all moduli, (k h)^2 / 16.
double Cloth::inertia_per_mass(const section::Section& section, bool scaled) const {
  const double own = gyration(section);
  if (!scaled) return own;
  return std::max(own, speeds(section).shear * step_of_membrane_ * step_of_membrane_ / 4);
}

void Cloth::add_inertia() {
  const auto& all = model_.mesh().elements;
  step_of_membrane_ = membrane_step();
  for (const bool scaled : {false, true}) {
    std::vector<double> inertia;  // per region
    for (const auto& section : model_.sections()) inertia.push_back(inertia_per_mass(section, scaled));
    rotary_[scaled].assign(X_.size(), 0);
    for (Index i = 0; i < elements(); ++i) {
      const auto& e = all[i];
      const auto region = static_cast<std::size_t>(model_.region_of(i));
      const double mass = model_.sections()[region].areal_mass * area(e, X_) / corners(e);
      for (int c = 0; c < corners(e); ++c) rotary_[scaled][e[c]] += mass * inertia[region];
    }
  }
}

double Cloth::stable_step(bool scaled) const {
  double shortest = step_of_membrane_;
  for (const auto& section : model_.sections()) {
    const double inertia = inertia_per_mass(section, scaled);
    double bending = 0;  // N m per metre of width
    if (section.bends_apart)
      for (const auto& spring : section.bending) bending = std::max(bending, law::stiffest(spring));
    if (bending > 0)
      shortest =
          std::min(shortest, smallest_size() * std::sqrt(inertia * section.areal_mass / (2 * bending)));
    // With scaled inertia both steps are equal up to rounding.
    if (!scaled) shortest = std::min(shortest, 2 * std::sqrt(inertia / speeds(section).shear));
  }
  return shortest;
}

double Cloth::smallest_size() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& e : model_.mesh().elements) smallest = std::min(smallest, size(e, X_));
  return smallest;
}

double Cloth::largest_stretch() const {
  const auto x = configuration_.x();
  double largest = 0;  // squared
#pragma omp parallel for schedule(static) reduction(max : largest) if (place_.size() >= 4096)
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const auto& e = model_.mesh().elements[i];
    const int n = corners(e);
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        largest = std::max(largest,
                           (at(x, e[b]) - at(x, e[a])).squaredNorm() / (X_[e[b]] - X_[e[a]]).squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace fabricsh::mechanics
