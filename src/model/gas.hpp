// Gas in volumes that cloth encloses: its declaration, and the closed surface that is worked out once from
// the mesh.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/rigid.hpp"

namespace fabricsh::model {

// --- Rigid bodies that close holes of volumes of gas.

// A hole whose rim lies at a rigid body: the part of the body's surface within the rim bounds the gas. A
// uniform pressure pushes on any surface within the same rim with the same force and moment, so that beside
// its volume nothing of the part's shape matters.
struct BodyLid {
  std::vector<mesh::Index> rim;  // nodes around the hole, in the order of a face that is seen from outside
  RigidPointer body;
  std::vector<Vec3> seats;  // m, at time 0: the place on the body's surface that is nearest to each of them
  double bulge = 0;         // m3, between the fan of the seats about their mean and the body's surface
};

// m, the place on the body's surface that is nearest to a point, as it is at time 0.
Vec3 seat_on(const Rigid& body, const Vec3& point);
// Error: the rim does not enclose a part of the surface that is seen whole from the gas; `name` of the body.
BodyLid body_lid(std::vector<mesh::Index> rim, const mesh::Mesh& mesh, RigidPointer body,
                 const std::string& name);

struct GasGiven;
using GasPointer = std::shared_ptr<const GasGiven>;

// A hole through which gas flows out, to the outside or to another volume.
struct GasVent {
  std::string set;           // elements, whose area at the start is that of the hole; empty: `area` is given
  double area = 0;           // m2
  double coefficient = 0.6;  // of discharge: the area of the jet over that of the hole
  GasPointer to = nullptr;   // null: the outside
  double opens = 0;          // Pa, pressure difference at which it opens, and then stays open; 0: it is open
};

// Gas in a closed volume. Its errors beside those of check(): later, those of enclosure_of.
struct GasGiven {
  static constexpr const char* call() { return "gas"; }
  std::vector<std::string> sets = {"all"};      // elements that close together
  std::vector<std::string> lids = {};           // nodes of holes that something without weight closes
  std::vector<RigidPointer> bodies = {};        // that close holes
  double initial = 0;                           // Pa, above the outside, at time 0
  std::optional<double> mass = {};              // kg, at time 0; then it determines the pressure
  double temperature = 293.15;                  // K, at time 0, and of what flows in
  double molar = 0.028965;                      // kg/mol
  double cp = 1005;                             // J/(kg K)
  double exponent = 1;                          // of p V^n: 1 isothermal, cp/cv adiabatic
  double outside = 101325;                      // Pa, absolute
  std::optional<history::History> inflow = {};  // kg/s
  std::vector<GasVent> vents = {};
  // m/s, volume that flows through a unit of area at a pressure difference in Pa; empty: nothing does.
  std::function<double(double)> leakage = {};
  std::string leakage_words = {};
  static constexpr double constant = 8.314462618;          // J/(mol K) [tiesinga2021]
  double specific() const { return constant / molar; }     // J/(kg K)
  double ratio() const { return cp / (cp - specific()); }  // of specific heats
  std::string name() const;                                // "of set 'all'"
  static void tell(auto& d, auto& v) {
    v.sets(d.sets);
    v.number("mass", d.mass, "# kg");
    v.number("initial", d.initial, d.mass ? "" : "# Pa at the start");
    v.number("temperature", d.temperature, "");
    v.number("exponent", d.exponent, "exponent #");
    v.number("outside", d.outside, "");
    v.history("inflow", d.inflow, "kg/s", "inflow #");
    v.number("vents", static_cast<double>(d.vents.size()),
             d.vents.empty()       ? ""
             : d.vents.size() == 1 ? "# vent"
                                   : "# vents");
    v.flag("leaks", static_cast<bool>(d.leakage), "leakage " + d.leakage_words);
  }
};

// A closed surface whose faces are oriented outwards.
struct Enclosure {
  std::vector<std::array<mesh::Index, 4>> cloth;   // elements; a triangle has -1 in the last place
  std::vector<std::array<mesh::Index, 4>> strips;  // between the edges of seams
  std::vector<std::vector<mesh::Index>> lids;      // rings of nodes around holes
  std::vector<BodyLid> bodies;                     // rims at rigid bodies
};

class Model;
// Errors: the surface has a hole (which one, and where), an edge at which more than two faces meet, only one
// side, or several separate parts; it encloses nothing; a body that is to close a hole is away from its rim,
// or closes none.
Enclosure enclosure_of(const Model& model, const GasGiven& gas);

}  // namespace fabricsh::model
