// The surfaces that may touch, sheets of cloth and then rigid bodies, and the law of each two that meet.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/scene.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/terms/bodies.hpp"
#include "mechanics/terms/cloth.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// The largest explicit step with contact as a share of the cloth's stable step, and the stiffness that it
// carries times its square over the areal mass.
inline constexpr double contact_step_of_cloth = 0.6, carried_stiffness = 0.2;

class ContactSurfaces {
 public:
  // Error: sides that share nodes (see model::work_out_surfaces).
  ContactSurfaces(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
                  const Dofs& dofs);
  ContactSurfaces(const ContactSurfaces&) = delete;  // pairs refer to its scene

  // Data of an interaction of the scene beside its law.
  struct Meeting {
    contact::LawData data;
    std::string names;             // "the ball on the cloth"
    double carried = 0;            // Pa/m, by an explicit step
    bool bodies = false;           // two rigid bodies meet
    bool given = false;            // the stiffness
    bool softened = false;         // to what is carried
    bool taken = false;            // the stiffness, from another run
    bool follows = false;          // its gap follows the size of the elements
    std::optional<double> settle;  // s
    std::size_t near = 0;          // points that start too near
    double nearest = 0;            // m: the smallest share of it times the gap
    double spacing = 0;            // m, of contact points inside the elements; 0: there are none
  };
  const std::vector<Meeting>& meetings() const { return meetings_; }  // by interaction
  contact::Scene& scene() { return scene_; }
  const contact::Scene& scene() const { return scene_; }
  const contact::ContactLaw& law(std::size_t meeting) const { return scene_.interactions()[meeting].law; }
  Bodies& bodies() { return bodies_; }
  const Bodies& bodies() const { return bodies_; }
  // Whether anything may touch anything; bodies that close gas alone do not.
  bool any() const { return !scene_.interactions().empty(); }
  bool friction() const { return friction_; }
  bool rubs() const { return rubs_; }  // friction or the damping of approach acts
  bool moves() const { return bodies_.any_free() || bodies_.any_driven(); }
  std::size_t nodes() const { return model_.mesh().nodes.size(); }
  double edge() const { return edge_; }                // m, mean length of an edge
  double least_areal() const { return least_areal_; }  // kg/m2
  double step() const { return step_; }                // s, for which stiffnesses are limited

  int sheets() const { return static_cast<int>(sheets_.size()); }
  // The body that a surface, or a vertex among the points, is of; -1: it is of the cloth.
  int body_of(int surface) const { return std::max(-1, surface - sheets()); }
  int body_at(std::int32_t point) const;
  int find_body(const model::Rigid& body) const;  // -1: not in this model
  Index point_of(Index node) const;               // the point that stands for it
  Index element_of(const contact::TriangleRow& row) const {
    return surfaces_.elements[row.surface][row.element];
  }
  std::string name_of(int surface) const;
  std::string words(const std::array<std::int32_t, 4>& points) const;  // "node 3 and sphere"
  // The parameters used for each contact, in lines of text.
  std::vector<std::string> describe() const;
  // Of each ball and rod whose force on flat cloth depends much on where the nodes lie: how far, and why.
  std::vector<std::string> dependent() const;
  // Whether the stiffness of a contact that cloth takes part in was neither given nor measured.
  bool assumes_stiffness() const;

  // Limits every stiffness that was not given to what an explicit step of the cloth carries. Contact then
  // does not shorten an explicit step, and in implicit motion it does not oscillate faster than the mesh.
  void soften(bool measured);
  // Every stiffness that was not given becomes that of the same contact there.
  void take_stiffness(const ContactSurfaces& other);
  double opened_at() const;  // s: when all overlaps at the start are opened; 0: there are none

 private:
  struct Sheet {                                              // a surface of cloth
    double thickness = 0, floor = 0, areal = 0;               // m, m, kg/m2
    std::vector<std::pair<double, double>> compression = {};  // thickness, m, and pressure, Pa; empty: none
    std::string name = {};  // of the bodies that it consists of; empty: it is a part of one
  };
  Sheet sheet(const std::vector<Index>& elements) const;
  Meeting meeting_of(const model::SurfacePair& meeting) const;
  Meeting meeting_of_bodies(const model::SurfacePair& meeting) const;
  double moving_mass(const model::SurfacePair& m) const;
  std::string stiffness_words(const Meeting& m, const contact::ContactLaw& law) const;
  double side_of_elements(int sheet) const;
  void find_warps(const Configuration& configuration, const Cloth& cloth);
  void follow_elements();
  void spread_points();
  void sew_scene(const Dofs& dofs);
  void open_overlaps();

  const model::Model& model_;
  const Joints& joints_;
  const model::Surfaces surfaces_;
  contact::Scene scene_;
  std::vector<Sheet> sheets_;
  Bodies bodies_;
  std::vector<Meeting> meetings_;
  bool friction_ = false, rubs_ = false;
  double least_areal_ = std::numeric_limits<double>::infinity();
  double step_ = 0, edge_ = 0;
};

// --- contact points inside the elements, for balls and rods that are small against them (contact_points.cpp)

// How much stiffer than what presses whole elements such a contact may be in an explicit step: the area of
// the smallest element over the largest that a body presses of one. 1 without points in all elements.
double eased(const contact::Scene& scene, const contact::Interaction& it);

// m2: the area that would take the same energy if it were pressed flat through the range of contact as the
// patch that such a body presses of one element.
double area_as_flat(const contact::Scene& scene, const contact::Interaction& it);

// How many times the law's force that of a ball or a rod on a node of flat cloth is, roughly, where elements
// have no points inside; 0 where all have, and of other bodies.
double dependence(const contact::Scene& scene, const contact::Interaction& it);

// Words on that where it shows, and on points inside that are too few; or none.
std::string dependence_words(const contact::Scene& scene, const contact::Interaction& it);

}  // namespace fabricsh::mechanics
