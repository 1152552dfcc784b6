// Yarns that break in tearable zones. Cloth tears along its yarns: at a place either family can break, and
// the joint there then opens along a line of the other family. The force along the yarn between elements on
// both sides of such a line is compared with the yarn's strength; when it is reached, springs
// between the crack faces carry the force on, and less as they part, until the energy of the yarns is spent.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mechanics/dofs.hpp"
#include "mechanics/motion.hpp"
#include "mechanics/term.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// A spring between two corners that were one: it carries the force f0 where it opens, and linearly less with
// the opening, down to none at 2 G / f0; back it goes to the origin. The origin lies `offset` before the
// closed crack faces, along the force there, so that the way back is no stiffer than an explicit step or
// Newton's method can bear.
struct CohesiveSpring {
  Index a = 0, b = 0;                // nodes
  int family = 0;                    // that broke
  Vec3 force = Vec3::Zero();         // N, on a from b when it opened
  double offset = 0, energy = 0;     // m; J, G
  double widest = 0, committed = 0;  // m, the largest opening so far: trial, committed
  bool outwards = true;  // whether it carried something and opened in the last committed step, or is new

  Vec3 way(std::span<const double> x) const;  // m, from the origin
  double vanishes() const;                    // m, the opening at which it carries nothing more
  double strength() const;                    // N, carried at the largest opening
  Vec3 pull(const Vec3& way);                 // N, on a from b; moves `widest`
  // N/m, d pull / d way, after pull(). onwards: at the committed opening that of going on as in the last
  // step.
  Mat3 stiffness(const Vec3& way, bool onwards) const;
  double stored(const Vec3& way) const;  // J, against closed crack faces
  double lost() const;                   // J, never falls as `widest` grows
  void keep(Archive& archive) {
    archive(a, b, family, force.x(), force.y(), force.z(), offset, energy, committed, outwards);
  }
};

class Tears final : public Term {
 public:
  // Whether a model has zones and a card with strengths.
  static bool possible(const model::Model& model);
  // Errors: an element at the joints of a zone is a triangle, or an edge is more than a degree off the yarns
  // (named); an energy that spreads over too coarse a mesh, where the zone refuses that.
  Tears(const model::Model& model, const Configuration& configuration, const Cloth& cloth, const Dofs& dofs);

  const char* name() const override { return "tears"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void couple(const Trial&, std::vector<NodePair>& pairs) override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  void renumbered(Forces& forces) override;
  void commit() override;
  void rollback() override;
  void keep(Archive& archive) override;

  // For steps along a path, whose direction is sought: tangents at the committed state are those of going on.
  void follow_path() { onwards_ = true; }
  bool opens() const;                             // whether springs opened in the last step, or are new
  double opening(const NodalRates& moved) const;  // m: by how much these open further with a motion
  // In explicit steps only lines near their strength are measured at each; the others when they are read.
  void go_explicit();
  // The joint whose yarns are nearest to their strength in the state of the last forces. In explicit steps no
  // joint, with a share of 0, as long as none is near.
  struct WorstPlace {
    double share = 0, strength = 0;  // N/m
    const char* yarn = "";
    Vec3 at = Vec3::Zero();  // m, reference
  };
  WorstPlace worst() const;
  // The same where supports hold the yarns themselves: there nothing breaks, however hard the cloth pulls.
  WorstPlace at_support() const;
  // Whether it is time to look there: in explicit steps now and then, in others always.
  bool supports_due() { return !grips_.empty() && (!sparing_ || ++commits_ % 64 == 0); }
  double committed_share() const { return committed_share_; }  // its share
  // Prepares springs for all that have reached it, stable with an explicit step in s (0: the steps are not
  // explicit); returns the ends of edges to be opened next.
  std::vector<Joints::Edge> let_go(double step);
  // Force over strength at the joints of an element, the largest; 1 where a yarn has broken. family: 0 warp,
  // 1 weft.
  double share(Index element, int family) const;
  std::vector<std::string> describe() const { return said_; }

 private:
  struct Corner {
    Index node, element;
    std::array<Index, 2> far, other;  // along warp, weft: the node at the edge's other end, and its place
  };
  struct Site {
    Index place;
    std::vector<Corner> corners;
    std::array<double, 2> strength, energy;  // N/m, J/m, of each family; infinite: it does not break
  };
  // A line along which a joint can open, and what is handed across it.
  struct Line {
    std::size_t site;
    int family;                                    // that breaks
    std::array<std::vector<Index>, 2> nodes, far;  // of the sides: at the place, along the yarn
    std::array<std::vector<Index>, 2> ends;        // of the line, both ways; the second may be empty
    std::array<double, 2> mass{};                  // kg
    struct Spoke {
      Index place, a, b;  // the other end; the corners on both sides
      double length;      // m, half of the edge
    };
    std::vector<Spoke> spokes;
    double length = 0;                  // m
    mutable Vec3 force = Vec3::Zero();  // N, on the first side from the second
    mutable double share = 0;           // of the strength
  };
  void find_sites();
  Corner corner_at(Index element, int a) const;
  void set_strengths();
  double coarse(const model::Zone& zone, std::size_t region, int family, double strength, double energy,
                double h);
  double across(std::size_t region, int family, double strength) const;  // 1/E', m/N
  double spacing(const Site& site, int along) const;                     // m
  void find_lines();
  void add_line(std::size_t site, int family, const std::vector<const Corner*>& joint);
  // Where a support holds yarns against what one side of it pulls with.
  struct Grip {
    std::size_t site;
    int family;
    std::vector<Index> nodes, far;
    double length;  // m
  };
  void find_grips();
  bool holds(Index node, const Vec3& yarn) const;
  Vec3 along(Index from, Index to) const;  // unit, in the reference
  bool held(const Line& line) const;
  void set_limits();
  void measure(std::span<const double> x, std::span<const double> on_x);
  void measure(const Line& line, std::span<const double> x, std::span<const double> on_x) const;
  void measure_near(std::span<const double> x, std::span<const double> on_x);
  std::vector<double> last_forces() const;  // N, of the cloth and the springs, 3 per node
  void know_all() const;
  void all_are_near();

  const model::Model& model_;
  const Configuration& configuration_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  std::vector<Site> sites_;
  std::vector<Line> lines_;
  std::vector<Grip> grips_;
  std::vector<CohesiveSpring> springs_, ready_;  // ready: of the joints that are about to open
  double committed_share_ = 0;
  // Lines that were measured with the last forces, and whether these are all.
  std::vector<std::size_t> near_;
  bool sparing_ = false, onwards_ = false;
  std::uint64_t commits_ = 0;
  mutable bool all_known_ = true;
  // N, for each component of the force on each node: as long as none is larger, no line at the node is near
  // its strength. The lines at a node are lines_at_[first_line_[n]] and on.
  std::vector<double> limits_;
  std::vector<std::size_t> first_line_;
  std::vector<std::uint32_t> lines_at_;
  std::vector<char> listed_;  // of each line: in near_
  std::vector<std::string> said_;
};

}  // namespace fabricsh::mechanics
