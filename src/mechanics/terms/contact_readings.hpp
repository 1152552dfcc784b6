// Readings of contact in the present state of the configuration.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mechanics/terms/contact_state.hpp"

namespace fabricsh::mechanics {

// The action of the cloth on a body whose shape is a surface.
struct OnSkin {
  std::vector<Vec3> at;          // m, where its vertices are
  std::vector<double> pressure;  // Pa, on each vertex, without friction; inwards is positive
  std::vector<double> area;      // m2, a third of the facets around each vertex, as they are
  std::vector<Index> node;       // of the cloth, that touches it; ascending
  std::vector<Vec3> place;       // m, where on the body's surface at time 0 this is
};

// Two held or driven bodies that face each other across cloth, nearer than it needs in contact, where that is
// worst. They cannot give way.
struct Nip {
  std::string first, second;
  std::size_t plies;
  double gap, thickness, floor;  // m: between their surfaces; of contact; the least that it allows
  double pressure, carried;      // Pa: by the law, infinite if the floors do not fit; before its barrier
  Index node;
};

class ContactReadings {
 public:
  ContactReadings(const ContactState& state, SettlingOverlaps& settling)
      : state_(state), settling_(settling) {}
  struct NearestPair {
    double gap;                         // m, above the floor
    std::array<std::int32_t, 4> point;  // corners, -1: none
  };
  NearestPair nearest() const;
  // Edges through facets, by more than rounding can put sides of a slit or a tear through each other.
  std::vector<contact::Contact::Overlap> crossings() const;
  double gap(Index node) const;       // m, above the floor; at most the range of contact
  double pressure(Index node) const;  // Pa, without friction, of both faces added
  OnSkin on_skin(std::size_t body) const;
  std::size_t touching() const { return read().totals.touching; }
  bool any_touched() const { return state_.totals().touching > 0; }  // by the last forces
  contact::Contact::Rubbing held_friction() const { return state_.pairs.held_friction(); }  // as committed
  std::vector<Nip> nips() const;
  void forget() { reading_.version = 0; }

 private:
  struct Reading {
    std::uint64_t version = 0;
    contact::Totals totals;
    std::vector<Vec3> x, force;  // m; N, without friction
    contact::Contact::AtPoints at_points;
  };
  const Reading& read() const;
  double touches_within(Index node, int surface) const;

  const ContactState& state_;
  SettlingOverlaps& settling_;
  mutable Reading reading_;
};

}  // namespace fabricsh::mechanics
