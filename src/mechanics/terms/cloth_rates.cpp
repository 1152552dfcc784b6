#include "mechanics/terms/cloth_rates.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "geometry/turning.hpp"

namespace fabricsh::mechanics {

namespace {

// The fraction of the stable step that the bound of every element should permit. Runs take 0.7 of the stable
// step, and at most 0.9 of the bound.
constexpr double kKept = 0.78;

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

ClothRates::ClothRates(const model::Model& model, const RestShape& rest, const std::vector<Batch>& batches,
                       const std::vector<BatchLane>& place)
    : model_(model), rest_(rest), batches_(batches), place_(place) {
  find_membrane_steps();
  for (Index e = 0; e < elements(); ++e) {
    const auto& corner = model_.mesh().elements[static_cast<std::size_t>(e)];
    const bool gets = std::any_of(corner.begin(), corner.end(), [this](Index n) {
      return n >= 0 && !mass_times_.empty() && mass_times_[static_cast<std::size_t>(n)] > 1;
    });
    smallest_size_ = std::min(smallest_size_, rest_.size(e));
    if (!gets) smallest_scaled_ = std::min(smallest_scaled_, rest_.size(e));
  }
}

// The stiffness in its plane over the mass of a corner, 1/s^2.
PlaneMatrix ClothRates::plane_matrix_of(Index e, const Stiffest& stiffest) const {
  const RestShape::Outline corners = rest_.outline(e);
  std::array<Eigen::Vector2d, 4> plane;
  for (int a = 0; a < corners.count; ++a) {
    const Vec3 r = corners.at[a] - corners.at[0];
    plane[static_cast<std::size_t>(a)] = {r.dot(corners.axes[0]), r.dot(corners.axes[1])};
  }
  const std::span<const Eigen::Vector2d> used(plane.data(), static_cast<std::size_t>(corners.count));
  return stiffest.axial * plane_matrix(used, stiffest.shear / stiffest.axial);
}

// 1/s^2: the square of the highest frequency of an element in its plane. Its smallest height tells of
// squares and, with their transverse shear, of triangles; where four sides are oblique, or the stiff yarns do
// not run across the height, it is lower.
double ClothRates::plane_rate_of(Index e, const Stiffest& stiffest, double speed) const {
  const double of_height = std::pow(2 * speed / rest_.size(e), 2);
  if (corners(model_.mesh().elements[static_cast<std::size_t>(e)]) == 3) return of_height;
  return std::min(of_height, largest_eigenvalue(plane_matrix_of(e, stiffest)));
}

double ClothRates::least_across_heights() const {
  std::vector<double> speed;  // m/s, per region
  for (const auto& section : model_.sections()) speed.push_back(std::sqrt(speeds(section).membrane));
  double shortest = std::numeric_limits<double>::infinity();
  for (Index e = 0; e < elements(); ++e)
    shortest = std::min(shortest, rest_.size(e) / speed[static_cast<std::size_t>(model_.region_of(e))]);
  return shortest;
}

// The stable steps for waves in the plane of the cloth. No frequency squared is above the largest mean of
// those of the elements around a node, weighted by their shares of its mass: K_e <= r_e M_e, of which the sum
// is diagonal. Where cloth may tear, elements part from those that they share nodes with.
void ClothRates::find_membrane_steps() {
  shares_.resize(static_cast<std::size_t>(elements()));
  for (Index e = 0; e < elements(); ++e) shares_[static_cast<std::size_t>(e)].fill(corner_mass(e));
  const double shortest = least_across_heights();
  membrane_step_.fill(shortest);
  across_heights_ = shortest;
  if (!model_.all<model::Zone>().empty()) return;
  std::vector<double> speed;  // m/s, per region
  std::vector<Stiffest> stiffest;
  for (const auto& section : model_.sections()) {
    speed.push_back(std::sqrt(speeds(section).membrane));
    stiffest.emplace_back(section);
  }
  std::vector<double> rates(static_cast<std::size_t>(elements()));
#pragma omp parallel for schedule(static) if (rates.size() >= 4096)
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const auto e = static_cast<Index>(i);
    const auto region = static_cast<std::size_t>(model_.region_of(e));
    rates[i] = plane_rate_of(e, stiffest[region], speed[region]);
  }
  SharedMasses found = share_masses(model_.mesh(), shares_, rates, [&](Index e) {
    return plane_matrix_of(e, stiffest[static_cast<std::size_t>(model_.region_of(e))]);
  });
  shares_ = std::move(found.shares);
  const auto step_of = [shortest](double rate) {
    constexpr double rounding = 1e-6;
    const double longer = 2 / std::sqrt(rate);
    return longer > shortest * (1 + rounding) ? longer : shortest;
  };
  const auto weight = [this](std::size_t e, std::size_t c) { return shares_[e][c]; };
  std::vector<double> mass(model_.mesh().nodes.size(), 0);
  for (std::size_t e = 0; e < shares_.size(); ++e)
    for (std::size_t c = 0; c < 4; ++c)
      if (const Index n = model_.mesh().elements[e][c]; n >= 0)
        mass[static_cast<std::size_t>(n)] += weight(e, c);
  MovedMass moved = move_mass(model_.mesh(), means_at_nodes(model_.mesh(), found.rates, weight), mass);
  membrane_step_ = {step_of(found.highest), step_of(moved.highest)};
  across_heights_ *= membrane_step_[1] / membrane_step_[0];
  mass_times_ = std::move(moved.times);
}

void ClothRates::keep_mass() {
  mass_times_.clear();
  membrane_step_[1] = membrane_step_[0];
  smallest_scaled_ = smallest_size_;
  bounds_[1] = {};
}

// kg
CornerMasses ClothRates::shares(Index e, bool scaled) const {
  CornerMasses out = shares_[static_cast<std::size_t>(e)];
  if (!scaled || mass_times_.empty()) return out;
  const auto& corner = model_.mesh().elements[static_cast<std::size_t>(e)];
  for (int c = 0; c < corners(corner); ++c)
    out[static_cast<std::size_t>(c)] *= mass_times_[static_cast<std::size_t>(corner[c])];
  return out;
}

std::vector<double> ClothRates::rates_at_nodes(std::span<const double> rates, bool scaled) const {
  const FrequencyBounds& of = bounds(scaled);
  const mesh::Mesh& mesh = model_.mesh();
  std::vector<double> means = means_at_nodes(mesh, rates, [&](std::size_t e, std::size_t c) {
    return shares_[e][c] *
           (scaled && !mass_times_.empty() ? mass_times_[static_cast<std::size_t>(mesh.elements[e][c])] : 1);
  });
  if (of.inertias.empty()) return means;
  const std::vector<double> turning =
      means_at_nodes(mesh, rates, [&](std::size_t e, std::size_t) { return of.inertias[e]; });
  std::transform(means.begin(), means.end(), turning.begin(), means.begin(),
                 [](double a, double b) { return std::max(a, b); });
  return means;
}

// m^2: rotary inertia per mass, that of the thickness. If scaled, it is at least h^2 (c_s / c)^2 / 4, so that
// rotations against the transverse shear, of frequency c_s / sqrt(inertia), permit the membrane's step, 2 /
// frequency. This slows a wave of wave number k by (k h)^2 (c_s / c)^2 / 8, for woven cloth some hundredth of
// the effect of the lumped mass, (k h)^2 / 24; [hughes1978] has A/8 for all moduli, (k h)^2 / 16.
double ClothRates::inertia_per_mass(const section::Section& section, bool scaled) const {
  const double own = gyration(section);
  if (!scaled) return own;
  return std::max(own, speeds(section).shear * membrane_step_[1] * membrane_step_[1] / 4);
}

double ClothRates::corner_mass(Index i) const {
  const auto& e = model_.mesh().elements[i];
  const auto region = static_cast<std::size_t>(model_.region_of(i));
  return model_.sections()[region].areal_mass * rest_.area(i) / corners(e);
}

// An element whose shape makes rotations against the transverse shear faster than the step takes gets more
// inertia: where a triangle is long, its assumed shear couples the rotation against the short direction with
// the long edge. It is at most that of a rod as long as the element. `permitted`: s, what the step takes. An
// element whose displacements are faster, which slower neighbours make up for, needs no more than its own
// step takes.
ClothRates::ElementBound ClothRates::bound_of(const ElementMatrix& stiffness, Index i, bool scaled,
                                              double permitted) const {
  const auto& e = model_.mesh().elements[i];
  const auto region = static_cast<std::size_t>(model_.region_of(i));
  const double equal = corner_mass(i), own = inertia_per_mass(model_.sections()[region], scaled);
  const CornerMasses mass = shares(i, scaled);
  const int n = corners(e);
  const ElementBound bound{highest_rate(stiffness, n, mass, equal * own), own};
  double wanted = 4 / (permitted * permitted);
  if (!scaled || bound.rate <= wanted) return bound;
  if (const double rate = rate_of_displacements(stiffness, n, mass); rate > wanted)
    wanted = rate / (kKept * kKept);
  if (bound.rate <= wanted) return bound;
  double longest = 0;
  for (int a = 0; a < n; ++a)
    longest = std::max(longest, (rest_.X(i, (a + 1) % n) - rest_.X(i, a)).squaredNorm());
  const double most = std::max(own, longest / 12);
  const double more = std::clamp(inertia_for(stiffness, n, mass, wanted) / equal, own, most);
  return {highest_rate(stiffness, n, mass, equal * more), more};
}

std::array<ClothRates::ElementBound, lanes> ClothRates::bounds_of(const Batch& batch,
                                                                  const Stiffest& stiffest, bool scaled,
                                                                  double permitted) const {
  alignas(64) double x[12 * lanes], d[12 * lanes], b[24 * lanes];
  for (int l = 0; l < lanes; ++l)
    for (int a = 0; a < batch.kind->corners; ++a) {
      const Vec3 &X = rest_.X(batch.element[l], a), &D = rest_.D(batch.element[l], a);
      const Vec3 b1 = first_axis(D), b2 = D.cross(b1);
      for (int i = 0; i < 3; ++i) {
        x[(3 * a + i) * lanes + l] = X[i];
        d[(3 * a + i) * lanes + l] = D[i];
        b[(6 * a + i) * lanes + l] = b1[i];
        b[(6 * a + 3 + i) * lanes + l] = b2[i];
      }
    }
  const auto matrices = stiffest_matrices(batch, stiffest, x, d, b);
  std::array<ElementBound, lanes> all{};
  for (int l = 0; l < batch.used; ++l) all[l] = bound_of(matrices[l], batch.element[l], scaled, permitted);
  return all;
}

// Batches that share their geometry share their bounds where they have equal shares of the masses.
const ClothRates::FrequencyBounds& ClothRates::bounds(bool scaled) const {
  FrequencyBounds& of = bounds_[scaled];
  if (of.made) return of;
  const auto even = [this, scaled](const Batch& batch) {
    return std::all_of(batch.element.begin(), batch.element.begin() + batch.used, [&](Index e) {
      const CornerMasses mass = shares(e, scaled);
      return std::equal(mass.begin() + 1, mass.end(), mass.begin());
    });
  };
  bool alike = true;
  std::map<std::tuple<const double*, int, std::size_t>, std::size_t> known;
  std::vector<std::size_t> same(batches_.size()), first;
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    const bool shared = even(batches_[b]);
    alike = alike && shared;
    const auto [place, is_new] =
        known.try_emplace({batches_[b].geometry, batches_[b].used, shared ? 0 : b + 1}, first.size());
    if (is_new) first.push_back(b);
    same[b] = place->second;
  }
  std::vector<std::array<ElementBound, lanes>> found(first.size());
  const double permitted = kKept * stable_step(scaled);
  std::vector<Stiffest> stiffest;
  for (const auto& section : model_.sections()) stiffest.emplace_back(section);
#pragma omp parallel for schedule(static) if (first.size() >= 4)
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Batch& batch = batches_[first[i]];
    const auto region = static_cast<std::size_t>(batch.section - model_.sections().data());
    found[i] = bounds_of(batch, stiffest[region], scaled, permitted);
  }
  of.rates.resize(place_.size());
  of.inertias.resize(place_.size());
  of.rotary.assign(model_.mesh().nodes.size(), 0);
  for (Index i = 0; i < elements(); ++i) {
    const auto& e = model_.mesh().elements[i];
    const ElementBound& bound = found[same[place_[i].batch]][place_[i].lane];
    of.rates[i] = bound.rate;
    of.inertias[i] = corner_mass(i) * bound.inertia_per_mass;
    for (int c = 0; c < corners(e); ++c) of.rotary[e[c]] += of.inertias[i];
    alike = alike && bound.inertia_per_mass == found[same[place_[0].batch]][place_[0].lane].inertia_per_mass;
  }
  if (alike) of.inertias.clear();  // their means are those by mass
  of.made = true;
  return of;
}

double ClothRates::stable_step(bool scaled) const {
  double shortest = membrane_step_[scaled];
  const double size = scaled ? smallest_scaled_ : smallest_size_;
  for (const auto& section : model_.sections()) {
    const double inertia = inertia_per_mass(section, scaled);
    double bending = 0;  // N m per metre of width
    if (section.bends_apart)
      for (const auto& spring : section.bending) bending = std::max(bending, law::stiffest(spring));
    if (bending > 0)
      shortest = std::min(shortest, size * std::sqrt(inertia * section.areal_mass / (2 * bending)));
    // With scaled inertia both steps are equal up to rounding.
    if (!scaled) shortest = std::min(shortest, 2 * std::sqrt(inertia / speeds(section).shear));
  }
  return shortest;
}

}  // namespace fabricsh::mechanics
