// The rigid bodies of a run, and what is nearest to touch: to be read and shown.
#pragma once
#include <string>
#include <vector>

#include "contact/intersect.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

struct BodyShown {
  std::string name;
  std::vector<Vec3> vertices;                // m, where they are now
  std::vector<contact::Triangle> triangles;  // counter-clockwise from outside
};
struct BodyState {
  Vec3 place, velocity, spin;  // of its centre, m, m/s; rad/s
  Vec3 force;                  // N, of the body on the cloth
};
// Error: nothing touches in the model; the body is none of it.
BodyState body_state(const Run& run, const model::Rigid& body);
struct Touching {
  double gap;         // m, above the floor: of the pair that is nearest to it, no more than contact reaches
  std::string words;  // "node 3 and the sphere"; empty: none is so near
};
Touching nearest_pair(const Run& run);  // Error: nothing touches in the model

// Of every body, in the order in which contacts name them; none without contact.
std::vector<BodyShown> shown_bodies(const Run& run);

}  // namespace fabricsh::run
