// Contact of cloth with rigid bodies, other cloth and itself (share/doc/contact.md), and the rigid bodies.
//
// Friction remembers its elastic slip from step to step (contact/pair.hpp). In static and implicit steps its
// Jacobian is exact, and Newton's steps are cut to the safe share.
#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/advance.hpp"
#include "contact/contact.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/facets.hpp"
#include "mechanics/terms/bodies.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// The largest explicit step with contact as a share of the cloth's stable step, and the stiffness that it
// carries times its square over the areal mass.
inline constexpr double contact_step_of_cloth = 0.6, carried_stiffness = 0.2;
inline constexpr double dense_pressure = 1e6;  // Pa, presses woven cloth down to its fibres

class Contacts final : public Term, public StepLimiter, public OwnUnknowns, public AtStepEnd {
 public:
  // Error: sides that share nodes (see model::work_out_surfaces). What overlaps is told by check_start().
  Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
           const Dofs& dofs);

  const char* name() const override { return "contact"; }
  Outcome add_forces(const law::Step& step, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  bool symmetric() const override { return !friction_; }
  void couple(const Trial& trial, std::vector<NodePair>& pairs) override;
  void add_energies(const Trial&, std::vector<Energy>& out) const override;
  // Of what drives bodies, of gravity on free ones, and of what opens overlaps.
  StepWork step_work() const override;
  void set_time(double time) override;
  void commit() override;
  void rollback() override;
  void renumbered(Forces& forces) override;
  void keep(Archive& archive) override;

  // Error: an overlap at the start, with its pairs; cloth inside a solid. Of a run that goes on from a state
  // both are looked for there, when the bodies have gone where they are at its time.
  void check_start() const;
  void begin_here();
  bool jumps() const {
    return bodies_.jumps();
  }  // whether a body is elsewhere at that time than in the state

  // --- motion of the bodies in a step: Newton's iterations move them by shares of the remaining way
  void begin_iterate() override {
    at_ = share_;
    bodies_.begin_iterate();
  }
  void move(double scale) override {
    share_ = at_ + scale * (1 - at_);
    bodies_.move(scale);
  }
  bool at_target() const override { return share_ >= 1 || !moves_; }

  // --- steps. Explicit ones have a check of their own, below.
  bool limits() const override { return !explicit_ && meets(); }
  void mark(const Trial& trial) override;
  double safe_fraction(const Trial& trial) override;  // without any surface passing another
  // The share during which nothing moves farther than a few elements, relative to the mean motion.
  double near_share(const Trial& trial) override;
  // Until then the straight ways of the bodies stand for their paths: they leave them by no more than the
  // smallest distance that contact allows, so that what a body passes over on its path it would also come
  // that near to on its straight way.
  double latest_end(double to) const override;
  bool turns_too_far() const;  // a body in the trial step

  // --- implicit steps take the forces of contact at their end, while the cloth keeps its own rule: then
  // contact cannot make energy, and what it takes is the energy "impact". The tangent has their weight, too.
  void set_weight(double weight) override;
  bool acts() const override { return touching_now() > 0 || !tied_.empty(); }
  std::span<const Vec3> push() const override { return std::span(force_).first(nodes_); }
  double work_on_cloth() const override;

  // --- implicit steps of free bodies: six unknowns each, the force on it at the step's end
  std::size_t own_unknowns() const override { return bodies_.unknowns(); }
  bool own_push(std::size_t j, std::span<double> on_x) const override;
  Eigen::VectorXd own_answer(std::span<const double> move) const override;
  Eigen::MatrixXd own_response() const override;
  Eigen::VectorXd own_residual() const override;
  void direct(std::span<const double> way) override { bodies_.direct(way); }
  double largest_own_force() const override;  // where bodies meet each other; else 0
  double largest_own_residual() const override { return bodies_.largest_residual(); }
  Eigen::MatrixXd own_stiffness() const override;

  // By the places (m) and turns (rad) of all free bodies, 6 numbers each: derivatives of the internal forces
  // on the nodes, N; of the forces and torques on the bodies with the other sign; and of the volumes of gas,
  // m3, whose changes of pressure both are without.
  struct AtRest {
    std::vector<std::vector<double>> on_nodes, of_volumes;  // by number
    Eigen::MatrixXd stiffness;
  };
  AtRest at_rest() const;

  // The places of free bodies at rest are unknowns from here on.
  void go_static(double rise);  // s, see Bodies

  // --- gas that pushes on bodies. Points are the nodes of the cloth and then the vertices of the bodies.
  std::size_t points() const { return x_.size(); }
  void place_points(const Trial& trial, std::vector<double>& x) const;  // m, 3 per point
  void begin_gas(std::span<const double> on_x);  // N, 3 per point, at the start of the run
  void press(std::span<const double> on_x);      // the same at the end of the step
  double inverse_mass(Index point) const { return inverse_mass_[static_cast<std::size_t>(point)]; }  // 1/kg
  // The sum of the forces on points, from the given one on, each over the root of its mass.
  double size_of(std::span<const double> on_x, std::size_t from = 0) const;
  // Derivatives of the internal forces of gas by places, of which one is at least a body's; with those of the
  // volumes.
  struct GasTangent {
    struct Part {
      Index a, b;
      Mat3 k;  // d(internal force on a) / d(place of b), N/m
    };
    std::vector<Part> parts;
    NodalRanks ranks;  // by points
  };
  void take(GasTangent tangent) { gas_ = std::move(tangent); }

  // --- explicit steps
  void go_explicit();
  // Whether the last state is impossible, or its motion may have passed through a surface. If the largest
  // motion does not exclude that, each near pair is checked.
  bool may_have_passed();
  bool guarded() const { return trial_.guard > 0; }
  // Whether a guard acts that needs shorter steps: others are met by inertia, see hold_back().
  bool needs_short_steps() const { return std::isfinite(trial_.hard_gap); }
  // Whether something has come into one of these as in an impact, whose energy inertia would err with; and
  // whether they are met by it in the next steps.
  bool struck() const { return trial_.struck; }
  void ease(bool on, double planned) { contact_->ease(on, planned); }
  // To be called with the residual of each evaluation of forces: takes from it what the inertia that meets
  // the guards holds back, N by unknowns.
  void hold_back(std::span<double> residual);
  double share_of_cloth() const;  // the largest step with contact, as a share of the cloth's stable step
  // s: the largest step: 0.6 of the cloth's own stable step, limited by the stiffest contact.
  double largest_step(bool scaled) const;
  // s: the largest step for the stiffness at the smallest gap, including that of the guard.
  double largest_contact_step() const;
  // m/s: the least speed, over all contacts, that uses up the range of contact above the guard when cloth of
  // the least areal mass meets it. What comes faster is pressed into the guard. `flat`: where all of it is
  // pressed at once; `anywhere`: where an element meets no more than one corner or edge of a body.
  struct Stopped {
    double flat, anywhere;
    bool given;  // the stiffness of that contact, which is then not that of smaller elements
  };
  Stopped speed_stopped() const;
  // Whether the stiffness of a contact that cloth takes part in was neither given nor measured.
  bool assumes_stiffness() const;
  // Of each seam that is to be drawn together: the farthest of its stitches whose straight way passes through
  // a body of facets that the cloth touches.
  struct DrawnThrough {
    std::size_t stitch;
    std::string body;
    double stopped;  // m/s: as `anywhere` of what the cloth meets there
  };
  std::vector<DrawnThrough> drawn_through() const;
  double fastest_body() const { return bodies_.fastest_free(); }  // m/s, of the free ones
  bool blocked() const { return blocked_; }  // the state of the last forces is impossible

  // --- reading of the present state of the configuration
  const Bodies& bodies() const { return bodies_; }
  int find_body(const model::Rigid& body) const;  // -1: not in this model
  struct NearestPair {
    double gap;                         // m, above the floor
    std::array<std::int32_t, 4> point;  // corners, -1: none
  };
  NearestPair nearest() const;
  // What presses a pair of cloth and a body, and what its law carries before the guard begins.
  struct Pressed {
    double pressure, carried;  // Pa
    double stiffness,
        step;  // Pa/m, that would carry this pressure with a margin; s, the largest step with it
  };
  std::optional<Pressed> pressed(const NearestPair& pair) const;  // empty: no more than is carried
  double gap(Index node) const;       // m, above the floor; at most the range of contact
  double pressure(Index node) const;  // Pa, without friction, of both faces added
  // What the cloth does to a body whose shape is a surface.
  struct OnSkin {
    std::vector<Vec3> at;          // m, where its vertices are
    std::vector<double> pressure;  // Pa, on each vertex, without friction; inwards is positive
    std::vector<double> area;      // m2, a third of the facets around each vertex, as they are
    std::vector<Index> node;       // of the cloth, that touches it; ascending
    std::vector<Vec3> place;       // m, where on the body's surface at time 0 this is
  };
  OnSkin on_skin(std::size_t body) const;
  std::size_t touching() const { return read().totals.touching; }
  contact::Contact::Rubbing held_friction() const {
    return contact_->held_friction();
  }  // in the committed state
  std::size_t touching_now() const { return (evaluated_ ? trial_ : committed_).touching; }
  std::string words(const std::array<std::int32_t, 4>& points) const;  // "node 3 and sphere"
  // The parameters used for each contact, in lines of text.
  std::vector<std::string> describe() const;
  // Two held or driven bodies that face each other across cloth, nearer than it needs in contact, where that
  // is worst. They cannot give way.
  struct Nip {
    std::string first, second;
    std::size_t plies;
    double gap, thickness, floor;  // m: between their surfaces; of contact; the least that it allows
    double pressure, carried;      // Pa: by the law, infinite if the floors do not fit; before its guard
    Index node;
  };
  std::vector<Nip> nips() const;
  // Of each ball and rod whose force on flat cloth depends much on where the nodes lie: how far, and why.
  std::vector<std::string> dependent() const;

 private:
  // Whether anything may touch anything; bodies that close gas alone do not.
  bool meets() const { return !scene_.interactions().empty(); }
  contact::Totals touch(contact::Way way);
  struct Sheet {                                              // a surface of cloth
    double thickness = 0, floor = 0, areal = 0;               // m, m, kg/m2
    std::vector<std::pair<double, double>> compression = {};  // thickness, m, and pressure, Pa; empty: none
    std::string name = {};  // of the bodies that it consists of; empty: it is a part of one
  };
  // What is known of an interaction beside its law.
  struct Meeting {
    contact::LawData data;
    std::string names;             // "the ball on the cloth"
    double carried = 0;            // Pa/m, by an explicit step
    bool bodies = false;           // two rigid bodies meet
    bool given = false;            // the stiffness
    bool softened = false;         // to what is carried
    bool follows = false;          // its gap follows the size of the elements
    std::optional<double> settle;  // s
    std::size_t near = 0;          // points that start too near
    double nearest = 0;            // m: the smallest share of it times the gap
    double spacing = 0;            // m, of contact points inside the elements; 0: there are none
  };
  // What the inertia that meets guards holds back of the forces on a node, see contact_eased.cpp.
  struct HeldBack {
    Index node = 0;
    Vec3 force = Vec3::Zero();  // N
    void keep(Archive& archive);
  };
  struct Block {
    std::array<std::int32_t, 4> point;
    contact::Matrix12 k;
  };
  // How a pair's forces and torque change with the place and the turn of a free body. Two bodies that meet
  // have one each of the same pair.
  struct OnBody {
    std::size_t block;
    int body;                             // of the free ones
    Eigen::Matrix<double, 12, 6> by;      // its corners, by the body's place and turn
    Eigen::Matrix<double, 12, 6> force;   // on its corners, by the body's place and turn, with the other sign
    Eigen::Matrix<double, 6, 12> answer;  // on the body, by its corners
    Eigen::Matrix<double, 6, 6> rubbed;   // on the body, by its own place and turn, through friction alone
  };
  struct Reading {
    std::uint64_t version = 0;
    contact::Totals totals;
    std::vector<Vec3> x, force;  // m; N, without friction
    contact::Contact::AtPoints at_points;
  };
  Contacts(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
           const Dofs& dofs, model::Surfaces surfaces);
  Sheet sheet(const std::vector<Index>& elements) const;
  void find_masses();
  contact::Triangle corners_of(const contact::TriangleRow& row) const;
  std::vector<double> crack_faces() const;
  void find_warps();
  void refuse_films() const;
  void sew_scene();
  std::vector<double> parted_faces() const;
  void set_apart(std::vector<double> apart);
  void follow_faces();
  Meeting meeting_of(const model::SurfacePair& meeting) const;
  Meeting meeting_of_bodies(const model::SurfacePair& meeting) const;
  double moving_mass(const model::SurfacePair& m) const;
  std::string name_of(int side) const;
  std::string stiffness_words(const Meeting& m, const contact::ContactLaw& law) const;
  double weakest_share(const contact::Interaction& it) const;
  Stopped stopped_by(std::size_t meeting) const;
  double side_of_elements(int sheet) const;
  void follow_elements();
  void spread_points();
  double carried_by_bodies(double share, bool guarded) const;
  void soften(bool measured);
  void ease_guards();
  double held_work() const;
  void open_overlaps();
  void open_to(double time) const;
  double opening_energy(std::span<const Vec3> x, double time);
  double opening_pace(std::span<const Vec3> x, double time, double dt);
  bool work_of_opening();
  void find_overlaps(double time);
  std::string overlaps_at(double time);
  std::string inside() const;
  void find_tied();
  double push_tied();
  void add_tied_blocks();
  void find_driven();
  bool driven_meet();
  void begin_pressed();
  void positions(std::span<const double> x, double share, std::vector<Vec3>& out) const;
  void find_motion();
  contact::Way way(double dt);
  // J, lost by friction in the trial step: its work less what the springs of what sticks take up.
  double taken() const;
  double lost() const { return evaluated_ ? trial_.work - (trial_.stick - committed_.stick) : 0; }
  void add_on_body(const contact::FrictionTangent* friction);
  Eigen::MatrixXd responses() const;  // of free bodies to the changes of their unknowns
  std::vector<Vec3> way_of(int body, const Bodies::Vector6& moved) const;
  std::vector<Vec3> way_left() const;
  std::vector<double> gas_change(std::span<const double> nodes, std::span<const Vec3> vertices,
                                 bool with_volumes) const;
  Eigen::VectorXd gas_on_bodies(std::span<const double> change) const;
  void add_gas_answers(bool with_volumes, Eigen::MatrixXd& answers) const;
  Eigen::MatrixXd answers(bool with_volumes) const;
  void prepare_tangent(const Trial& trial);
  const Reading& read() const;
  int surface_of(std::int32_t point) const;
  double touches_within(Index node, std::size_t body) const;

  const model::Model& model_;
  const Configuration& configuration_;
  const Cloth& cloth_;
  const Dofs& dofs_;
  const Joints& joints_;
  const Freedoms& freedoms_;
  const model::Surfaces surfaces_;
  contact::Scene scene_;
  std::vector<Sheet> sheets_;
  Bodies bodies_;
  mutable std::unique_ptr<contact::Contact> contact_;
  std::vector<Meeting> meetings_;         // by interaction
  double trial_time_ = 0;                 // s
  double opened_at_ = 0;                  // s: when all overlaps are opened
  StepWork opening_work_;                 // in the step
  mutable std::vector<double> share_of_;  // see open_to()
  bool friction_ = false, explicit_ = false, moves_ = false, blocked_ = false;
  double least_areal_ = 0, step_ = 0;  // kg/m2; s, step for which stiffnesses are limited
  double edge_ = 0;                    // m, mean length of an edge

  std::size_t nodes_ = 0;
  std::vector<Vec3> x_, start_, marked_, force_, torque_, turning_, by_;
  std::vector<double> inverse_mass_;
  std::vector<Index> led_by_;  // per node, the leader of its joint; empty: there are no zones
  // With planes of symmetry: those that each node lies in, or that cut the body of a rigid vertex, a bit
  // each. Inverse masses are then those of the whole model.
  std::vector<unsigned char> planes_;
  double share_ = 0, at_ = 0;  // share of the bodies' way: trial, iterate
  double moved_ = 0;           // m, largest motion in the step
  contact::Totals trial_, committed_;
  double lost_ = 0;                           // J, lost by friction up to the committed state
  double impact_ = 0, trial_impact_ = 0;      // J, taken by implicit steps; in the trial step
  std::vector<HeldBack> held_, held_before_;  // in the trial and in the committed state
  double held_energy_ = 0;                    // J, up to the committed state
  double weight_ = 1;                         // of the forces at the end of an implicit step
  bool static_ = false;
  bool implicit_ = false, rubs_ = false;  // rubs: friction or the damping of approach acts
  bool evaluated_ = false;
  // Nodes that go along with a body, held to their places on it by springs that are stiff beside the cloth.
  struct TiedTo {
    std::size_t node, point;
    double carried;  // N/m, by an explicit step
  };
  std::vector<TiedTo> tied_;
  double tied_energy_ = 0, trial_tied_ = 0;  // J, of these springs
  double stiff_tie() const { return explicit_ ? kMovingTie : kStiffTie; }
  // Of what an explicit step would carry beside the cloth; explicit steps are half as long then.
  static constexpr double kMovingTie = 10, kStiffTie = 1000;
  std::string overlaps_;  // at the start, as a message; empty: there are none
  std::vector<Block> blocks_;
  std::vector<OnBody> on_bodies_;
  GasTangent gas_;  // without columns: gas pushes on no body
  // Pairs of nodes coupled at any time: a * nodes + b, a < b, ascending. They only become more, and a
  // rollback takes back those since the last commit.
  std::vector<std::int64_t> pairs_, committed_pairs_;
  // Whether the motion of a point is given: nodes that are held or driven, vertices of bodies that are not
  // free. Empty: nothing of that kind moves towards cloth of that kind.
  std::vector<char> driven_;
  std::optional<bool> met_;  // whether such points meet in the step; empty: not yet known
  mutable Reading reading_;
};

}  // namespace fabricsh::mechanics
