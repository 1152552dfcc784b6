// Threads of seams. Where a seam is not closed as a joint (mechanics/sewing.hpp) they make force: they draw
// the edges together over the time given, they are the compliance that a seam has of its own, and where it
// has burst they carry what is left of its strength, less and less as the edges part.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/dofs.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/term.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/tears.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// A spring between a node and the place that it is sewn to, for gaps g from the place to the node, m. While
// it draws, its length goes from the gap at the start to none; it then carries k (g - target), and damping
// beside it. A seam with a stiffness of its own carries k g up to its strength, and from there less down to
// none at 2 G / f, back to the origin on unloading.
struct Thread {
  double k = 0, c = 0;              // N/m; N s/m, of motion alone
  double pace = 0;                  // 1/s: the most by which a target leads, in motion
  double strength = 0, energy = 0;  // N and J; 0: it does not break
  double speed = 0, most = 0;       // m/s and N, see Seams::lead_around(); 0: without limit
  Vec3 start = Vec3::Zero();        // m, gap at the start
  Vec3 gap = Vec3::Zero(), gap_before = Vec3::Zero();          // m: trial, committed
  Vec3 target = Vec3::Zero(), target_before = Vec3::Zero();    // m
  Vec3 shift = Vec3::Zero(), shift_before = Vec3::Zero();      // m, by which the target leads
  Vec3 damping = Vec3::Zero(), damping_before = Vec3::Zero();  // N
  double lost = 0, lost_before = 0;                            // J, to damping
  double widest = 0, widest_before = 0;                        // m, of a seam with a strength

  bool is_softening() const { return strength > 0 && k * widest >= strength; }
  double vanishes() const { return 2 * energy / strength; }
  double stiffness() const;  // N/m, of the way back from the widest opening
  // N/m^2, how the stiffness changes as the widest opening grows in the present step.
  double stiffness_rate() const;
  double fracture() const;  // J, never falls as `widest` grows
  Vec3 elastic() const { return stiffness() * (gap - target); }
  Vec3 force() const { return elastic() + damping; }
  void commit();
  void rollback();
  void keep(Archive& archive);
  // Of a thread that is led: the two ends, first the node. Where they are, what presses on them, N, averaged
  // over time, and what the thread does to them beside its force along the straight way, N.
  struct End {
    Vec3 x = Vec3::Zero(), x_before = Vec3::Zero();  // m
    Vec3 pressed = Vec3::Zero();                     // of the committed state
    Vec3 aside = Vec3::Zero(), aside_before = Vec3::Zero();
  };
  std::array<End, 2> ends;
  bool is_led() const { return most > 0; }
  // m, where the target may go in a step from where it is, on its way to `wanted`.
  Vec3 led(const Vec3& wanted, double dt, double most_now) const;
};

class Seams final : public Term {
 public:
  Seams(const model::Model& model, const Configuration& configuration, const Cloth& cloth, const Dofs& dofs);

  const char* name() const override { return "seams"; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void couple(const Trial&, std::vector<NodePair>& pairs) override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  StepWork step_work() const override;
  void renumbered(Forces& forces) override;
  void commit() override;
  void rollback() override;
  void keep(Archive& archive) override;

  // The stitches that are closed if the seams whose time is over close.
  Sewn due(double time) const;
  // Decides for the seams that begin to close whether the directors of both edges become one. Error: see
  // SewnEdges.
  void decide_turning(Sewn& next) const;
  // The stitch that is nearest to its strength in the committed state.
  struct WorstStitch {
    double share = 0, strength = 0;  // N/m
    std::string seam;
    Vec3 at = Vec3::Zero();  // m, reference
  };
  WorstStitch worst() const;
  double committed_share() const { return committed_share_; }  // its share
  // Prepares springs for all closed stitches that have reached it, stable with a step in s; 0: in steps that
  // iterate.
  Sewn let_go(double step);
  bool has_burst(std::size_t stitch) const;
  // m/s, at which the gap of a stitch closes where its thread draws fastest; 0: it is not drawn.
  double closing_speed(std::size_t stitch) const;
  // From now on the threads of the seam of this stitch shorten by no more than `speed`, m/s, and pull with no
  // more than a hand does and along what presses on the nodes, so that it leads them around what lies between
  // them. The seam closes when they meet, at the end of its time or later.
  void lead_around(std::size_t stitch, double speed);
  bool is_led(std::size_t stitch) const { return threads_[stitch].is_led(); }
  // What presses on the nodes; to be given before steps are made.
  void feel(const Contacts& contact) { contact_ = &contact; }
  bool draws() const;  // threads draw edges together
  // Of the stitches that are drawn, of all seams or of one: that whose gap is most above what is wanted by
  // now.
  struct Lagging {
    std::size_t stitch;
    double gap, wanted;      // m
    Vec3 at = Vec3::Zero();  // m, where its node is
  };
  std::optional<Lagging> lagging(std::optional<std::size_t> of_seam = {}) const;
  // The same of a seam that is late, once: if it has not got any closer for a quarter of its time. To be
  // asked after each step.
  std::optional<Lagging> stuck();
  // One line for each seam.
  std::vector<std::string> describe() const;

 private:
  enum class State { closed, drawn, own, burst, open };
  State state(std::size_t stitch) const;
  const model::Seam& seam(std::size_t stitch) const { return dofs_.seams()[dofs_.stitches()[stitch].seam]; }
  bool has_strength(std::size_t stitch) const { return seam(stitch).strength.has_value(); }
  Vec3 nominal(std::size_t stitch, double time) const;  // m, the gap wanted at a time
  double widest(std::size_t seam) const;                // m, gap of its stitches
  bool is_pressed(std::size_t seam) const;              // by a body, at one of its edges
  bool is_over(std::size_t stitch, double time) const;  // the time in which it is drawn
  Vec3 on_place(std::size_t stitch, std::span<const Vec3> at_nodes) const;
  void deflect(std::size_t stitch, std::span<const double> x);
  void average_pressing();
  Vec3 way(std::size_t stitch, std::span<const double> x) const;      // m, of its spring from the origin
  Vec3 parting(std::size_t stitch, std::span<const double> x) const;  // m, of the gap, without what presses
  Mat3 tangent(const Trial& trial, std::size_t stitch) const;
  void pull(const law::Step& step, const Trial& trial, std::size_t stitch);
  void put(std::size_t stitch, const Vec3& force, std::span<double> on_x) const;
  void put_aside(std::size_t stitch, std::span<double> on_x) const;
  void list_joined();
  Vec3 outward(std::size_t stitch, std::span<const double> x) const;
  void spread();
  double share_of(std::size_t stitch, std::span<const double> x) const;
  void measure(std::span<const double> x, std::span<const double> on_x);

  const model::Model& model_;
  const Configuration& configuration_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  std::vector<Thread> threads_;
  std::vector<std::uint8_t> burst_;  // per stitch: a spring is there
  struct Late {
    double since = -1, gap = 0;  // s, -1: it does not wait; m, its widest gap then
    bool told = false;
    void keep(Archive& archive) { archive(since, gap, told); }
  };
  const Contacts* contact_ = nullptr;
  std::vector<Late> late_;                       // per seam
  std::vector<CohesiveSpring> springs_, ready_;  // per stitch; ready: of stitches that are about to open
  std::vector<std::size_t> ready_at_;
  std::vector<std::vector<Index>> around_;  // per stitch: nodes of the elements at its node
  std::vector<double> share_;               // per stitch, of its strength
  std::vector<Vec3> carried_;               // N, per stitch: on its node by the closed seam
  std::vector<Vec3> traction_;              // N/m, per stitch: the mean of that over the elements beside it
  std::vector<model::Follower> joined_;     // those of closed stitches
  bool breaks_ = false;
  double time_before_ = 0, committed_share_ = 0;
};

}  // namespace fabricsh::mechanics
