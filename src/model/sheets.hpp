// The cloth of a model: its bodies on one mesh, and for each element the card, the section, the warp
// direction and the stress-free shape.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "card/card.hpp"
#include "mesh/mesh.hpp"
#include "model/reference.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

using mesh::Index;

// Warp direction at a point of the reference surface: an angle (degrees, counter-clockwise about the shell
// normal, from global +x projected on the surface), or a vector to be projected on the surface.
using Direction = std::variant<double, Vec3>;
using WarpField = std::function<Direction(const Vec3& X)>;

struct Options {
  std::optional<double> thickness;        // m; takes precedence over the card's
  std::optional<WarpField> warp;          // required unless the mesh is flat
  std::string warp_text;                  // for the printed model
  int points = 3;                         // through the thickness, 1 to 9
  std::vector<section::Ply> plies;        // if given, they replace the card and its thickness
  double offset = 0;                      // reference surface at zeta_bar in [-1, 1]; 0: middle surface
  std::optional<card::Folds> folds = {};  // takes precedence over the card's
  bool membrane = false;                  // without bending and transverse shear; all directors are held
  bool full_yarns = false;                // the strain of oblique yarns as interpolated (element/shell4.hpp)
};

// A set of elements with its own card, thickness, plies or warp.
struct RegionGiven {
  std::string set;  // of the mesh of the body
  card::Card card;
  Options options;
};
struct BodyGiven {
  std::string name;  // empty: the only body of its model; its sets keep their names
  std::shared_ptr<mesh::Mesh> mesh;
  card::Card card;
  Options options;
  std::vector<RegionGiven> regions;
  ReferenceGiven reference = {};
};

// The shape in which the cloth of a body is free of stress.
inline const mesh::Mesh& rest_shape(const BodyGiven& body) {
  return body.reference.mesh ? *body.reference.mesh : *body.mesh;
}

// Material data of a part of the elements, compiled: one region of a body, or the rest of it.
struct Region {
  std::string name;  // "", "front", "pocket", "front.pocket"
  card::Card card;
  Options options;
  Index body = 0;
};

class Sheets {
 public:
  // Errors: points outside 1..9; a thickness that is not positive; no warp on a mesh that is not flat; a card
  // that its law refuses (with the reason). No body; several without different names; a region without a
  // whole element; an element in two regions (named).
  explicit Sheets(std::vector<BodyGiven> bodies);

  const mesh::Mesh& mesh() const { return *mesh_; }
  std::shared_ptr<const mesh::Mesh> mesh_pointer() const { return mesh_; }
  const std::vector<BodyGiven>& bodies() const { return bodies_; }
  // For each body: the body's own region first, then its other regions.
  const std::vector<Region>& regions() const { return regions_; }
  const card::Card& card() const { return regions_.front().card; }  // of the first region
  // One section per region; each element belongs to exactly one.
  const std::vector<section::Section>& sections() const { return sections_; }
  bool membrane() const { return regions_.front().options.membrane; }  // as a whole
  int region_of(mesh::Index element) const { return region_of_.empty() ? 0 : region_of_[element]; }
  std::string element_name(mesh::Index element) const;  // "12", or "12 of body front" if there are several
  const section::Section& section() const { return sections_.front(); }
  const Options& options() const { return regions_.front().options; }  // of the first region
  double thickness() const { return section().thickness; }
  // The card of the element's region; of the first region for element -1 (none).
  const card::Card& card_of(mesh::Index element) const {
    return regions_[element < 0 ? 0 : region_of(element)].card;
  }
  // The number of a ply in the element's section, from 0, by its name or as ply1, ply2, ... from below; -1:
  // the section has no such ply. A sheet without plies is one.
  int ply_of(mesh::Index element, const std::string& ply) const;
  std::vector<std::string> plies() const;  // the names that ply_of() accepts in any section
  card::Folds folds_of(mesh::Index element) const {
    const Region& region = regions_[element < 0 ? 0 : region_of(element)];
    return region.options.folds.value_or(region.card.folds);
  }
  double thickness_of(mesh::Index element) const { return sections_[region_of(element)].thickness; }
  const ReferenceGiven& reference_of(mesh::Index element) const {
    return bodies_[static_cast<std::size_t>(regions_[region_of(element)].body)].reference;
  }
  // m, a node of the mesh without its zones in the stress-free shape, but for a prestress.
  const Vec3& rest_node(mesh::Index place) const {
    const auto& nodes = rest_nodes_.empty() ? mesh_->uncut().nodes : rest_nodes_;
    return nodes[static_cast<std::size_t>(place)];
  }
  // The same of a corner of an element.
  const Vec3& rest_corner(mesh::Index element, int corner) const {
    const auto& nodes = mesh_->elements[static_cast<std::size_t>(element)];
    return rest_node(mesh_->place_of(nodes[static_cast<std::size_t>(corner)]));
  }
  // Warp direction as a vector, not yet projected, at X on the stress-free shape with the unit normal n.
  // Error: not finite, or zero after projection.
  Vec3 warp_at(mesh::Index element, const Vec3& X, const Vec3& n) const;
  // The same at x on the mesh: carried there by the sides of the element where that is another shape.
  Vec3 warp_as_placed(mesh::Index element, const Vec3& x, const Vec3& n) const;

 protected:
  void seal_meshes();                 // later changes of the meshes are Errors
  std::shared_ptr<mesh::Mesh> mesh_;  // that of the only body, or all bodies joined

 private:
  void add_body(Index body);
  void take_reference(const BodyGiven& body, const std::string& of);
  void assign(Index region, Index body, const std::string& set);
  std::vector<BodyGiven> bodies_;
  std::vector<Region> regions_;
  std::vector<section::Section> sections_;  // one per region
  std::vector<int> region_of_;              // per element; empty: all elements are in the first
  std::vector<Vec3> rest_nodes_;            // of the mesh without its zones; empty: those of the mesh
  std::vector<Vec3> rest_warp_;  // per element, as Mesh::warp, of the stress-free shapes; empty: of the mesh
};

}  // namespace fabricsh::model
