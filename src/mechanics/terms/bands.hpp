// Bands along edges (model/declarations.hpp): between neighbouring nodes of an edge a spring that pulls and
// never pushes, whose length without force is that of the edge, less the ease.
#pragma once
#include <vector>

#include "mechanics/term.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

class EdgeBands final : public Term {
 public:
  explicit EdgeBands(const model::Model& model);

  const char* name() const override { return "bands"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override;
  void add_tangent(const Trial& trial, TangentSink& sink) const override;
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override;
  StepWork step_work() const override { return work_; }
  void commit() override;
  void keep(Archive& archive) override { archive(time_, pulling_); }

 private:
  struct BandPiece {
    Index a, b;
    double length;  // m, of the edge
    std::size_t band;
  };
  double rest(const BandPiece& piece, double time) const;  // m
  double strain(const BandPiece& piece, const Trial& trial) const;
  double pull_on_rest(const BandPiece& piece, double strain) const;  // N, d(energy) / d(rest length)

  const std::vector<model::EdgeBand> bands_;
  std::vector<BandPiece> pieces_;
  std::vector<double> pulling_, now_;  // N: the last of these at the committed and the trial state
  double time_ = 0, aimed_ = 0;        // s: committed, of the trial state
  StepWork work_;                      // of shortening the bands in the step
};

}  // namespace fabricsh::mechanics
