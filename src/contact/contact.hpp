// Contact between the surfaces of a scene at given positions: forces, energies, stiffness, safe share of a
// step.
//
// Lists of near pairs are kept until surfaces that are near have moved against each other farther than they
// allow for: an outer list, found with the grid, and an inner one with its nearest pairs. The results do not
// depend on the lists: pairs come in a fixed order, and their forces go into separate slots that are summed
// node by node in that order. The bits are therefore the same for any number of threads and any skin.
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "base/archive.hpp"
#include "contact/batch.hpp"
#include "contact/patches.hpp"
#include "contact/search.hpp"

namespace fabricsh::contact {

// Data of a step that friction needs, for all points of the scene.
struct Way {
  std::span<const Vec3> start;      // m, positions at its start; empty: friction is left out
  std::span<const Vec3> turn = {};  // rad, of the body that a rigid vertex is of; empty: none turns
  double dt = 0;                    // s, of a step in time; 0: a static step
  // Explicit steps: the points' inverse masses, 1/kg, 0: held or driven.
  std::span<const double> inverse_mass = {};
  // The planes of symmetry that a node lies in, or that cut the body of a rigid vertex, one bit each. Masses
  // are then those of the whole model. Empty: there are no planes.
  std::span<const unsigned char> planes = {};
};

struct Totals {
  double contact = 0, guard = 0;  // J
  double stick = 0;               // J, elastic energy of friction that sticks
  double work = 0;                // J, of the step's sliding against friction
  double impact = 0;              // J, of its approaches against their damping
  // m: smallest gap above the floor of all pairs within range of contact; if there is none, the least
  // distance from gap to floor of any pair, which is then a lower bound.
  double gap = 0;
  double hard_gap = 0;       // m: the smallest of all pairs with a guard that is not eased; infinite: none
  bool struck = false;       // whether a pair comes into a guard of a body that may be eased as in an impact
  std::size_t touching = 0;  // pairs
};

// Of a stiffness, by point: whether the forces on it are wanted, and what its motion does to them. Empty:
// all.
struct Wanted {
  std::span<const char> on = {}, by = {};
};

struct Skins {
  double outer = 0, inner = 0;  // m; 0: a third and an eighth of the cloth's mean edge
};

class Contact {
 public:
  explicit Contact(const Scene& scene, Skins skins = {});

  const Scene& scene() const { return *scene_; }

  // `x` always means the positions of the scene's points (cloth nodes and rigid vertices), m; they must
  // be finite. Adds the forces on every point to `force`, N; with a way also those of friction. The
  // torques of friction on bodies, N m, are added to `torque` (one entry per point, used for one vertex
  // of each body; empty: not wanted).
  Totals add_forces(std::span<const Vec3> x, std::span<Vec3> force, const Way& way = {},
                    std::span<Vec3> torque = {});

  // Whether guards of bodies that may be eased are, see Interaction::eased; those between cloths always are,
  // but for a pair that comes in as in an impact. step: s, the planned one, of which a part is perhaps taken.
  void ease(bool on, double step) {
    eases_ = on;
    planned_ = step;
  }
  bool eases(const Interaction& it) const { return it.eased && (it.cloths || eases_); }
  // Of the forces that were last added, in the pairs' order: how stiff the guards of bodies that are eased
  // are for each node of the cloth, N/m, and along which normal. The sum is a bound for all that the nodes do
  // at once. The third: the body's corners of the pair and their shares of it, which add up to 1; 0: none.
  struct BodySide {
    std::array<std::int32_t, 4> point{};
    std::array<double, 4> share{};
  };
  void barriers(const std::function<void(std::int32_t, double, const Vec3&, const BodySide&)>& visit) const;
  // The same of guards between cloths, with the points of each pair and their weights: how its sides part.
  using VisitBetween = std::function<void(const std::array<std::int32_t, 4>&, const Force::Barrier&)>;
  void barriers_between(const VisitBetween& visit) const;

  // Of the forces that were last added: marks the points of all pairs that press and have a corner from
  // `first` to `end`, as the vertices of a body, or of all that have none there.
  void mark_pressed(std::int32_t first, std::int32_t end, bool have, std::span<char> marked) const;

  // Stiffness of the touching pairs, in the pairs' order: visit(points of the pair, Hessian of its energy,
  // N/m, its friction). With a way the Hessian contains the part of friction: -d force/dx, not symmetric.
  // Otherwise, and if not all is wanted, the friction is null. Blocks that are not wanted may be zero.
  using VisitStiffness =
      std::function<void(const std::array<std::int32_t, 4>&, const Matrix12&, const FrictionTangent*)>;
  void stiffness(std::span<const Vec3> x, const VisitStiffness& visit, const Way& way = {},
                 const Wanted& wanted = {});

  // The elastic slips of friction are those of the last forces that were added with a way; or stay those of
  // the last commit.
  void commit();
  void rollback() { has_tried_ = false; }
  // Friction of the pairs that hold a slip in the committed state.
  struct Rubbing {
    std::size_t pairs = 0, sliding = 0;
    double force = 0, of_sliding = 0;                  // N, sum of the sizes of their forces
    std::array<std::int32_t, 4> most{-1, -1, -1, -1};  // points of the sliding pair with the largest force
  };
  Rubbing held_friction() const;
  void keep(Archive& archive);  // the committed slips

  // Visits the points of each pair that touches or soon may. Returns a number that changes
  // whenever this set of pairs does, so that the sparse pattern of the stiffness can be updated.
  void couples(std::span<const Vec3> x, const std::function<void(const std::array<std::int32_t, 4>&)>& visit);
  std::uint64_t version() const { return version_; }

  // Sets how far overlaps are opened (Interaction::opening), 0 to 1 for each interaction. A pair that starts
  // with the share s of the law's lengths then has s + (1 - s) * share of them.
  void open_to(std::span<const double> share);

  // Sets for each crack face how far it has been apart at least: the distance of the nearest pair of crack
  // faces that it is in; infinite, where none is within reach. Returns whether any is more than before.
  bool widen(std::span<const Vec3> x, std::vector<double>& apart);
  void apart_changed();  // Scene::apart has: the pairs of crack faces have other lengths
  void scene_changed();  // other nodes at the corners of its triangles, see Scene::with_corners

  // The largest share, 0 to 1, of the displacement `by` (m) during which no pair reaches its floor; with
  // `among` no pair all of whose points are marked there.
  double safe_fraction(std::span<const Vec3> x, std::span<const Vec3> by,
                       std::span<const char> among = {}) const;

  // Pairs below their floor, and edges that cut a facet: states that cannot be computed.
  struct Overlap {
    std::array<std::int32_t, 4> point;  // corners, -1: none
    double gap;  // m; if the edge cuts the facet, less how far the nearer of its ends is beyond its plane
  };
  std::vector<Overlap> overlaps(std::span<const Vec3> x) const;
  // The latter alone, whose ends are both at least so far from the facet's plane, in ranges of the law.
  std::vector<Overlap> crossings(std::span<const Vec3> x, double least) const;
  // The pair that is closest to its floor among those within the range of contact; `gap` is measured
  // above the floor. Without such a pair there are no corners, and `gap` is the range of contact.
  Overlap nearest(std::span<const Vec3> x);
  double reach() const { return widest_; }  // m, above the floor: the largest range of all laws

  // Whether the largest way of the points bounds how far anything moves between two states.
  bool vertex_motion_bounds_surface_motion(std::span<const Vec3> from, std::span<const Vec3> to) const {
    return !patches_.walls_turn(from, to);
  }
  // Whether anything may have passed on the straight way `by` (m) from `x`. `gap`: m, the smallest at its
  // end.
  bool may_have_passed(std::span<const Vec3> x, std::span<const Vec3> by, double gap);

  // For each point the smallest gap (m, at most the law's) and the pressure (Pa), those on both faces of a
  // sheet added, as of the forces that were last added at `x`.
  struct AtPoints {
    std::vector<double> gap, pressure;
  };
  AtPoints at_points(std::span<const Vec3> x) const;

  std::size_t searches() const { return searches_; }  // how often the grid was searched
  std::size_t listed() const { return inner_.size(); }

 private:
  void prepare(std::span<const Vec3> x);
  std::vector<Candidate> find(std::span<const Vec3> x, double skin, std::span<const Vec3> by = {}) const;
  void scale(Candidate& c) const;
  void scale_all();
  double least_apart(const Candidate& c) const;
  bool rigid(std::int32_t point) const {
    return point >= std::int32_t(scene_->nodes()) && !scene_->spots().is(point);
  }
  // The value for the rigid side of a pair; zero if no side is rigid.
  Vec3 of_body(const Candidate& c, std::span<const Vec3> by_point) const;
  static constexpr double rounding = 1e-9;        // share of a skin: rounding never decides what is looked at
  static constexpr double nearly = 1 - rounding;  // of the motion that a list allows for
  class OfSlot;
  void find_slip(std::size_t slot, std::span<const Vec3> x, const Way& way, Slip& slip);
  // Keeps the slip of a pair: turned with it, and with the resistance at its mirror images.
  void keep_slip(std::size_t slot, const Corners& x, const Way& way, Force& force);
  void share_slips();
  bool passes_on(PairKind kind, std::int32_t first, std::int32_t interaction) const;
  bool eases(std::size_t slot) const;
  bool approaches_fast(const Candidate& c, const Force& force, const Corners& now, const Way& way) const;
  std::uint32_t torque_row(const Candidate& c) const;
  unsigned planes_of(const Candidate& c, std::span<const unsigned char> planes) const;
  std::array<double, 4> resists(const Candidate& c, const Force& force, const Way& way) const;
  double margin(const Candidate& c, std::span<const Vec3> x) const;
  void mark_checked(std::span<const Vec3> x, double change);
  void search(std::span<const Vec3> x);
  void refine(std::span<const Vec3> x, double since_search);
  void tally_all(std::span<const Vec3> x);
  void clear_lists();
  void index_slots();
  void index_spots();
  std::vector<std::uint32_t> touching(std::span<const Vec3> x) const;
  static Blocks wanted_of(const Candidate& c, const Wanted& wanted);
  static void visit_in_nodes(const Candidate& c, const Matrix12& k, const FrictionTangent* friction,
                             const VisitStiffness& visit);
  // The way `by` from x, m, on which near surfaces come nearer to each other by `most`; with `among` only
  // pairs all of whose points are marked there stop it.
  struct OnWay {
    std::span<const Vec3> x, by;
    double most;
    std::span<const char> among;
  };
  double share_of(const OnWay& way, const std::vector<Candidate>& pairs, std::span<const double> margin = {},
                  double since = 0) const;
  void press(std::size_t slot, std::span<const Vec3> x, const Way& way);
  void press_all(std::span<const Vec3> x, const Way& way, bool torques);
  // --- batches of pairs (press.cpp): each pair has a lane, those that are taken alone, too
  struct Batch {
    double least = 0, offset = 0;       // m: the smallest of idle_; of its pairs
    std::int32_t law = -1;              // row of its law; -1: its pairs are taken alone
    unsigned char any = 0, active = 0;  // lanes with a pair, and with one that touched last
  };
  class Batches;
  void make_batches();
  void put_pair(std::uint32_t slot, int lane, BatchPairs& batch) const;
  // Shared by the pairs of an interaction; empty: none are taken by the batch in such a step.
  std::vector<BatchLaw> laws_of_batches(const Way& way) const;
  void place_points(std::span<const Vec3> x, const Way& way);
  void gather(std::size_t first_slot, std::size_t end, std::uint32_t from, std::uint32_t to, bool torques);
  void gather_slot(std::size_t slot, std::uint32_t from, std::uint32_t to, bool torques);
  void add_points(std::span<Vec3> force, std::span<Vec3> torque, bool rubs, Totals& totals);
  const ContactLaw& law(const Candidate& c) const {
    return scene_->interactions()[std::size_t(c.interaction)].law;
  }

  const Scene* scene_;
  Skins skins_;
  std::vector<double> opened_;         // by interaction
  double widest_ = 0, narrowest_ = 0;  // m: largest and smallest distance from gap to floor of any pair
  double narrowest_at_first_ = 0;      // of all pairs but crack faces
  bool lists_all_ =
      true;  // whether lists have all that may pass: contact points stand for no nodes and edges
  std::vector<Candidate> outer_, inner_;
  std::vector<Vec3> at_search_, at_refine_, at_check_;
  mutable Patches patches_;  // its boxes are worked out anew each time
  double checked_ = 0,
         change_ = 0;  // m: how much near gaps may have changed since refine(), at_check_ and now
  std::vector<double> outer_margin_;  // of each pair of the outer list: the same in search()
  std::vector<double> margin_;  // of each pair of the inner list: how far out of reach it was in refine()
  // The same, or more: until near gaps have changed by so much it presses nothing, see tally.hpp.
  std::vector<double> idle_;
  // Where the points were when it was last said which facet counts a side or a corner: those of a committed
  // state, which the lists have no part in; and of the last forces, if commit() is to look at them.
  std::vector<Vec3> at_tally_, at_try_;
  double tally_way_ = 0;  // m: after which it is said anew
  std::uint32_t commits_ = 0;
  bool tallies_ = false;  // it has to be said anew for the lists
  std::vector<Batch> batches_;
  std::vector<BatchPairs> pairs_;           // by batch
  std::vector<std::uint32_t> first_batch_;  // of the slots that are taken together
  std::vector<BatchPoint> points_;          // by row
  std::vector<std::uint32_t> place_;        // by slot: batch * lanes + lane
  std::vector<PairForce> forces_;           // by slot
  struct Guard {
    double energy = 0;  // J
    Force::Barrier barrier;
  };
  std::vector<Guard> guards_;           // by slot
  std::vector<std::uint32_t> guarded_;  // slots with one, ascending
  // By slot: the rows of its corners, of a spot that of the contact point, and of what its torque acts on;
  // where there is none: no_row.
  std::vector<std::array<std::uint32_t, 5>> rows_of_;
  static constexpr std::uint32_t no_row = ~std::uint32_t(0);
  // By slot: the pair touches; and it has a slip, as a facet; a guard.
  static constexpr char pressing = 1, rubbing = 2, facet_rubs = 4, in_guard = 8;
  std::vector<char> active_;
  std::vector<std::int32_t> touched_;            // points with slots, ascending
  std::vector<std::uint32_t> first_, of_point_;  // rows: slot * 4 + corner, ascending for each touched point
  std::vector<std::uint32_t> row_of_;            // by point: its place among those touched
  std::uint32_t node_rows_ = 0;  // behind them those of contact points inside facets, ascending
  // Forces and energies at a touched point. The energies of a pair are counted at its first corner.
  struct AtPoint {
    double force[4] = {};   // N; and Force::resists
    double energy[4] = {};  // J: contact, stick, work, impact
    double guard = 0;
    // m, the smallest of its pairs; of those with a guard that is not eased.
    double gap = std::numeric_limits<double>::infinity(), hard_gap = gap;
    Vec3 torque = Vec3::Zero();
    std::uint32_t pairs = 0, slips = 0;  // slips: of facets
    bool struck = false;
  };
  std::vector<AtPoint> at_point_;
  // The elastic slips of the pairs that touch. The first corner of a pair is what slides over the rest of it;
  // the slips are in the order of the first corners, for each in the order of the pairs.
  struct Kept {
    Vec3 slip = Vec3::Zero(), pull = Vec3::Zero();
    double gap = 0, damped = 0;  // m, N
    double slides = 0;
  };
  struct Held : Kept {
    std::array<std::int32_t, 4> point{};
    std::int32_t interaction = 0;
    PairKind kind = PairKind::facet;
    bool is(const Candidate& c) const {
      return point == c.point && interaction == c.interaction && kind == c.pair.kind;
    }
    void keep(Archive& archive);
  };
  // While the lists stay, a pair has its lane; else those in use are in a list.
  struct Memory {
    std::vector<BatchMemory> lane;
    std::vector<unsigned char> lanes_used;
    std::vector<Held> list;
    bool by_lane = false;
    bool used(std::uint32_t place) const;
    Kept at(std::uint32_t place) const;
    void begin(std::size_t batches);  // no lane is in use
  };
  std::vector<std::uint32_t> by_first_;     // slots in the order of the slips
  std::vector<std::uint32_t> first_place_;  // by row: those of pairs with this first corner
  void index_places();
  static void put(BatchMemory& to, std::uint32_t lane, const Kept& kept);
  std::optional<Kept> held_by(std::size_t slot);
  void find_held(const BatchPairs& batch, unsigned of_lanes, BatchMemory& to);
  void to_list(Memory& memory) const;
  template <class Visit>
  void each(const Memory& memory, Visit visit) const;
  void join(std::span<const std::uint32_t> slots);
  // The resistances of all slips at each point, mirror images included, over 0.2 m / dt: of those committed
  // and those of the last forces.
  std::vector<double> rubbing_at_, tried_rubbing_;
  double crowd_at(std::size_t point) const;  // see Slip::crowd
  Memory held_, tried_;
  bool has_tried_ = false;
  // By slot, where slips are in a list: which of held_ is that of the pair, or one of the following.
  std::vector<std::int32_t> known_;
  static constexpr std::int32_t unknown = -2, none = -1;
  bool eases_ = true;
  double planned_ = 0;  // s
  std::size_t searches_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace fabricsh::contact
