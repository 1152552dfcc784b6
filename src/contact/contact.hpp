// Contact between the surfaces of a scene at given positions: forces, energies, stiffness, how far a step may
// go.
//
// Lists of near pairs are kept while nothing has moved, against the mean motion, by more than they allow for:
// an outer one, found by the grid, and an inner one, those of the outer that are nearest. What comes out
// doesn't depend on the lists: pairs come in a fixed order, their forces go into slots of their own and are
// added up node by node in that order, so the bits are the same for any number of threads and any skin.
#pragma once
#include <functional>
#include <vector>

#include "contact/search.hpp"

namespace fabricsh::contact {

// What explicit friction needs to know of the motion, for all points of the scene.
struct Motion {
  std::span<const Vec3> velocity;        // m/s
  std::span<const double> inverse_mass;  // 1/kg; 0: held or driven
  double step = 0;                       // s
};

struct Totals {
  double contact = 0, guard = 0;  // J
  double lost = 0;                // W with a Motion, J with a start: what friction takes
  double gap =
      0;  // m: the smallest gap above the floor, of all pairs within reach of contact; the smallest
          // way between a gap and its floor that a pair can have where there is none: so none has less
  std::size_t touching = 0;  // pairs
};

struct Skins {
  double outer = 0, inner = 0;  // m; 0: a third and an eighth of the cloth's mean edge
};

class Contact {
 public:
  explicit Contact(const Scene& scene, Skins skins = {});

  const Scene& scene() const { return *scene_; }

  // All `x`: positions of the scene's points, cloth and rigid vertices, m. They must be finite.
  // Adds the forces on every point to `force`, N; with `motion` those of friction as well.
  Totals add_forces(std::span<const Vec3> x, std::span<Vec3> force, const Motion* motion = nullptr);

  // Stiffness of the pairs that touch: visit(their points, energy's Hessian, N/m), in the pairs' order. With
  // a `start` (positions at the step's start, m) and `creep` (m) friction's part is added: -d force/dx,
  // unsymmetric.
  using VisitStiffness = std::function<void(const std::array<std::int32_t, 4>&, const Matrix12&)>;
  void stiffness(std::span<const Vec3> x, const VisitStiffness& visit, std::span<const Vec3> start = {},
                 double creep = 0);
  // Adds friction's forces of an implicit or static step from `start`; returns what it takes over the step,
  // J.
  double add_friction(std::span<const Vec3> x, std::span<const Vec3> start, double creep,
                      std::span<Vec3> force);
  // Points of the pairs that touch or soon may, and a number that changes whenever these pairs do: what the
  // sparse pattern of the stiffness must hold.
  void couples(std::span<const Vec3> x, const std::function<void(const std::array<std::int32_t, 4>&)>& visit);
  std::uint64_t version() const { return version_; }

  // Share, 0 to 1, of the displacement `by` (m) that no pair passes on the way to its floor.
  double safe_share(std::span<const Vec3> x, std::span<const Vec3> by) const;

  // Pairs nearer than their floor, and edges that cut a facet: a state that can't be.
  struct Overlap {
    std::array<std::int32_t, 4> point;  // corners, -1: none
    double gap;                         // m; 0 where they cut
  };
  std::vector<Overlap> overlaps(std::span<const Vec3> x) const;
  // The pair within reach of contact that is nearest to its floor, its gap above that; none: no corners, and
  // the gap that contact reaches.
  Overlap nearest(std::span<const Vec3> x);
  double reach() const { return widest_; }  // m, above the floor: the largest of all laws

  // Per point: the smallest gap (m, no more than the law's) and the pressure on it (Pa) of the last forces.
  std::span<const double> gaps() const { return gap_; }
  std::span<const double> pressures() const { return pressure_; }

  std::size_t searches() const { return searches_; }  // how often the grid was asked
  std::size_t listed() const { return inner_.size(); }

 private:
  void prepare(std::span<const Vec3> x);
  double moved(std::span<const Vec3> x, const std::vector<Vec3>& since) const;
  void search(std::span<const Vec3> x);
  void refine(std::span<const Vec3> x);
  void index_slots();
  void gather(std::span<Vec3> force, Totals& totals);
  const Law& law(const Candidate& c) const { return scene_->interactions()[std::size_t(c.interaction)].law; }

  const Scene* scene_;
  Skins skins_;
  double widest_ = 0, narrowest_ = 0;  // m: the largest and smallest way between a pair's gap and its floor
  std::vector<Candidate> outer_, inner_;
  std::vector<Vec3> at_search_, at_refine_;
  std::vector<Force> slots_;
  std::vector<std::int32_t> touched_;            // points with slots, ascending
  std::vector<std::uint32_t> first_, of_point_;  // rows: slot * 4 + corner, ascending for each touched point
  std::vector<double> gap_, pressure_;
  std::vector<double> energy_, guard_, lost_;  // by touched point
  std::size_t searches_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace fabricsh::contact
