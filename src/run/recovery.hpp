// Fields of elements at nodes, by superconvergent patch recovery [zienkiewicz1992], and the error that they
// show. An element's value is taken at its centre of area in the reference, where the stresses of linear
// elements are most accurate. Around each node a polynomial is fitted to the elements that meet there, and
// read at the node. Only elements of one region, hence of one card, are fitted together, since stresses jump
// where cards change; nor are those on the two sides of an open joint of a tearable zone.
//
//   a node inside its region: a plane through the elements around it. On the region's border, where a value
//   would come from one side alone: a quadratic through elements up to three rows inwards, or a plane where
//   these are too few; of fewer than three elements, or of elements in one line, their mean by area.
//
// Hence fields that are linear in the plane are exact at all nodes. At a node on the border of regions each
// region has a value of its own; their mean, by the area of their elements there, stands for the node.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "run/result_fields.hpp"

namespace fabricsh::run {

class Recovery {
 public:
  // Finds the patches, of the present joints.
  explicit Recovery(const Readings& run);
  ~Recovery();
  // The values of the nodes, `width` numbers each, from those of the elements. region: from 0, of which alone
  // the values are, NaN at other nodes; -1: of all.
  std::vector<double> at_nodes(std::span<const double> of_elements, std::size_t width, int region = -1) const;
  // The value of an element's own region at its corners: value[corner * width + i].
  void at_corners(mesh::Index element, std::span<const double> of_elements, std::size_t width,
                  double* value) const;

 private:
  struct Patches;
  std::unique_ptr<Patches> patches_;
};

// A field of elements, or one of its values, at all nodes. Errors: a field whose values are of nodes, or jump
// from element to element; a region that is not there.
std::vector<double> recovered(const Readings& run, const FieldPart& part, int region = -1);

// Of each element: the energy norm of recovered less computed stress, in the plane and averaged over the
// thickness, over that of the stress of an element with the sheet's mean energy. The root of its squares'
// mean by volume is the relative error of the whole.
std::vector<double> stress_errors(const Readings& run);

}  // namespace fabricsh::run
