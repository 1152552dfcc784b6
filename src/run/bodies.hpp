// Reading the rigid bodies of a run, the pair that is closest to contact, and the gas of volumes.
#pragma once
#include <string>
#include <vector>

#include "contact/intersect.hpp"
#include "mechanics/terms/contact.hpp"
#include "model/gas.hpp"
#include "run/readings.hpp"

namespace fabricsh::run {

struct BodyShown {
  std::string name;
  std::vector<Vec3> vertices;                // m, present positions
  std::vector<contact::Triangle> triangles;  // counter-clockwise from outside
  std::vector<double> pressure;  // Pa, of the cloth on each vertex of a surface; empty: another shape
};
struct BodyState {
  Vec3 place, velocity, spin;  // of its centre, m, m/s; rad/s
  Vec3 force;                  // N, of the body on the cloth
  Vec3 support;                // N, of m:fix on the body
};
// Error: the model has no contact, or the body is not part of it.
BodyState body_state(const Readings& run, const model::Rigid& body);
// The action of the cloth on the facets of a body. Error: as above; its shape is no surface of facets.
mechanics::OnSkin on_skin(const Readings& run, const model::Rigid& body);
struct Touching {
  double gap;         // m, above the floor, for the pair closest to its floor; at most the range of contact
  std::string words;  // "node 3 and the sphere"; empty: no pair within range
};
Touching nearest_pair(const Readings& run);  // Error: the model has no contact

// All bodies, in the order in which the contacts name them; empty without contact.
std::vector<BodyShown> shown_bodies(const Readings& run);

struct GasReading {
  double pressure;     // Pa, above that outside
  double volume;       // m3
  double mass;         // kg
  double temperature;  // K
};
// Error: the volume is not one of the run's model.
GasReading gas_state(const Readings& run, const model::GasGiven& gas);

}  // namespace fabricsh::run
