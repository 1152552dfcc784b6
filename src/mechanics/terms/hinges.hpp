// Creases that are hinges (model/reference.hpp): along them each side of the sheet has a director of its own.
// At each end of an edge of the crease the energy is
//
//   k L/4 ((theta - theta0)^2 + (t . (d - d'))^2)
//
// with the length L of the edge in the stress-free shape, its direction t, the directors d and d' of both
// sides and the angle theta between these about t. The second part keeps the sides together along the crease,
// as one director would where the hinge is stiff; in a thin sheet, whose directors are normals, it is zero.
#pragma once
#include <vector>

#include "mechanics/term.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class Hinges final : public Term {
 public:
  // Whether a model has such creases.
  static bool possible(const model::Model& model) { return model.mesh().hinged; }
  Hinges(const model::Model& model, const Configuration& configuration);

  const char* name() const override { return "hinges"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void couple(const Trial&, std::vector<NodePair>& pairs) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  // Degrees, of the hinges at a node the largest; 0: there is none.
  double angle_at(Index node) const;
  void commit() override { angle_ = now_; }
  void rollback() override { now_ = angle_; }
  void keep(Archive& archive) override {
    archive(angle_);
    now_ = angle_;
  }

 private:
  // One end of an edge: the nodes of its left side there and at the other end, and that of its right side.
  struct End {
    Index left, far, right;
    bool forward;   // whether the edge, with its left side on the left, runs from here
    double weight;  // N m/rad
    double rest;    // rad
  };
  Vec3 way(const End& end, const Configuration& now) const;  // m, along the edge
  double angle(std::size_t i, const Configuration& now) const;

  std::vector<End> ends_;
  // rad, per end, at the committed and the trial state: it may pass half a turn, and goes on from there.
  std::vector<double> angle_, now_;
  const model::Model& model_;
};

}  // namespace fabricsh::mechanics
