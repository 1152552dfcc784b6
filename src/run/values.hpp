// The values that can be read from a run.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "geometry/vec.hpp"
#include "law/law.hpp"
#include "solver/stable.hpp"

namespace fabricsh::run {

// Averages over the reference volume of an element; material axes, tensor components. Their names are defined
// in result_fields.cpp.
struct ElementValues {
  double E11 = 0, E22 = 0, E23 = 0, E13 = 0, E12 = 0;
  double S11 = 0, S22 = 0, S23 = 0, S13 = 0, S12 = 0;
  double stored = 0, dissipated = 0;  // J/m^3
  std::array<double, law::dissipations>
      lost{};  // J/m^3, what dissipated consists of, by law::dissipation_names
  double residual1 = 0, residual2 = 0, slack1 = 0, slack2 = 0;
  double folded = 0;
};

struct NodeValues {
  Vec3 x, X, u, v, n;  // current, reference, displacement (m), velocity (m/s; zero in statics), director
};

struct EnergyPart {
  std::string name;
  double value = 0;  // J
};

struct EnergyAccount {  // J
  double kinetic = 0, stored = 0, dissipated = 0, external = 0;
  double damping = 0;  // to viscous forces, and to the integrator if it damps (gamma > 1/2, hht < 0)
  double relaxed = 0;  // taken away by relaxation in static runs: what loads did more than cloth stores
  double scaled = 0;   // part of kinetic: in rotary inertia beyond that of the thickness
  double contact = 0, guard = 0;   // part of stored: contact, and the guard above its floor
  double directors = 0;            // part of stored: the guard of the directors
  double stick = 0;                // part of stored: elastic slip of friction
  double rigid = 0;                // part of kinetic: free rigid bodies
  std::optional<double> gas = {};  // part of stored: what gas gives until its pressure is that outside
  double created = 0;              // by a law that is not dissipative
  // Parts of `dissipated`: of the cloth "warp", "weft", "shear" and those of the elements of its law
  // (law::dissipation_names), and "bending"; "friction" and "impact" of contact, "joints", lost as they
  // closed or opened, "fracture" of broken yarns; and those of terms that a program has added. A name may be
  // there twice.
  std::vector<EnergyPart> lost;
  double lost_in(std::string_view name) const;  // J, the sum of those with this name
  double internal() const { return stored + dissipated; }
  // At the beginning what is there, and what another run from which this one goes on has lost.
  double taken_over() const { return kinetic + internal() + damping; }
  double initial = 0;  // that
  // kinetic + stored + dissipated + damping + relaxed - external - initial; zero if no energy is created.
  double surplus() const { return kinetic + stored + dissipated + damping + relaxed - external - initial; }
  // |surplus| / largest |external| so far (a free flight: / initial). In statics of the part that is more
  // than loads and supports can have given, whatever the way from one state to the next.
  double error = 0;
};

// All energies by the names that decks and run.json give them: those of the cloth that are dissipated as
// "dissipated_warp", those of other terms as "friction". The usual ones are there even where they are 0.
std::vector<EnergyPart> energies(const EnergyAccount& account);

// Where a run exceeded the tested range of its card most.
struct Beyond {
  double strain_ratio = 0;        // strain over tested strain: 1.2 is 20 % beyond; 0: never above 1
  std::string yarn;               // "warp", "weft", "shear"
  std::int64_t element = -1;      // numbered from 0
  double time = 0;                // s, of the ratio above
  double first = 0;               // s, when the ratio first exceeded 1 anywhere
  double strain = 0, tested = 0;  // E11, E22 or |E12| (tensor) there, and the tested strain of the card
  void keep(Archive& archive) { archive(strain_ratio, yarn, element, time, first, strain, tested); }
};

// Report of a committed step.
struct StepReport {
  double time = 0, step = 0;
  int iterations = 0;
  int cuts = 0;                      // halvings of this step
  std::vector<double> residuals;     // relative residual of each iteration; the first is the predictor's
  std::int64_t negative_pivots = 0;  // of the last tangent; 0 on a stable path
  solver::Stability stability = solver::Stability::unchecked;
  double path = std::numeric_limits<double>::quiet_NaN();  // see Static::compare_halves(); NaN: not asked
  void keep(Archive& archive) {
    archive(time, step, iterations, cuts, residuals, negative_pivots, stability, path);
  }
};

}  // namespace fabricsh::run
