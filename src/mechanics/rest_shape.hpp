// The shape in which each element is free of stress: that of the mesh, or another one, which is stored.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "element/shell4.hpp"
#include "mechanics/mesh_tools.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// The strain by which a card has a tension along warp and weft, in the plane without shear.
struct Prestrain {
  std::array<double, 2> strain{};   // E11, E22
  std::array<double, 2> stretch{};  // of warp and weft
};
// tension: N/m, over the width as it is stretched. Error: none below a strain of 100 %.
Prestrain prestrain(const section::Section& section, const std::array<double, 2>& tension);

class RestShape {
 public:
  using Shape = element::Placed<4>;
  // directors: of the nodes of the mesh; kept. Errors: a stress-free shape that is degenerate; those of
  // creases and prestrain().
  RestShape(const model::Model& model, const std::vector<Vec3>& directors);

  // Of a corner of an element: place, m, and director.
  const Vec3& X(Index element, int corner) const {
    return shape_.empty() ? mesh_.nodes[node(element, corner)]
                          : shape_[static_cast<std::size_t>(element)].X[static_cast<std::size_t>(corner)];
  }
  const Vec3& D(Index element, int corner) const {
    return shape_.empty() ? directors_[node(element, corner)]
                          : shape_[static_cast<std::size_t>(element)].D[static_cast<std::size_t>(corner)];
  }
  // Where the element is without moments, if that is not in its stress-free shape.
  const Shape* unbent(Index element) const {
    return unbent_.empty() ? nullptr : &unbent_[static_cast<std::size_t>(element)];
  }
  double area(Index element) const;  // m^2
  double size(Index element) const;  // m, see mechanics::size
  // Of an element: its corners, m, unit vectors along warp and weft, and its area, m^2.
  struct Outline {
    Vec3 at[4], axes[2];
    int count;
    double area;
  };
  Outline outline(Index element) const;
  // The warp of the model at a place of this shape.
  Vec3 warp(Index element, const Vec3& X, const Vec3& n) const;

  // The effect of a prestress, a line for each region that has one.
  const std::vector<std::string>& told() const { return told_; }

 private:
  std::size_t node(Index element, int corner) const {
    return static_cast<std::size_t>(
        mesh_.elements[static_cast<std::size_t>(element)][static_cast<std::size_t>(corner)]);
  }
  std::array<Index, 4> own_corners(Index element) const;
  void take_shape();
  void lay_flat(Index element);
  void take_creases();
  void take_prestress();
  void contract(Index element, const Prestrain& by);

  const model::Model& model_;
  const mesh::Mesh& mesh_;
  const std::vector<Vec3>& directors_;
  std::vector<Shape> shape_, unbent_;  // per element; empty: the mesh
  // The change of an element by a prestress: x = middle + F (X - middle).
  struct Contraction {
    Vec3 middle;
    Mat3 F;
  };
  std::map<Index, Contraction> contracted_;
  std::vector<std::string> told_;
};

// Directors where a mesh is folded flat, whose normals cancel: away from its elements.
std::vector<Vec3> directors_of_folded(const mesh::Mesh& mesh);

}  // namespace fabricsh::mechanics
