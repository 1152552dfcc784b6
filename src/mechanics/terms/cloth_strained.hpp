// Strain beyond the tested range of the cards, at the last forces or tangent. For yarns it is the largest
// strain so far.
#pragma once
#include <array>
#include <vector>

#include "law/peaks.hpp"
#include "mechanics/batch.hpp"
#include "mechanics/law_states.hpp"
#include "model/model.hpp"

namespace fabricsh::mechanics {

// The point with the largest strain relative to the range in which its card was tested.
struct Strained {
  double strain_ratio = 0;  // strain over tested strain: 1.2 is 20 % beyond
  double strain = 0;        // E11, E22 or |E12| (tensor)
  double tested = 0;        // the strain up to which the card was tested
  int yarn = 0;             // 0 warp, 1 weft, 2 shear
  Index element = -1;
};

class StrainsReached {
 public:
  StrainsReached(const model::Model& model, const std::vector<Batch>& batches,
                 const std::vector<BatchLane>& place, const LawStates& states);
  void record(Index batch, const double* states);  // as the kernels have just written them
  double largest_ratio() const;                    // 0: no card states its tested range
  Strained most() const;
  double ratio(Index element) const;  // of one element; 0: its card does not state a tested range

 private:
  // A point through the thickness whose card states a tested range.
  struct TestedPoint {
    const law::Law* law;
    int state;
    std::array<double, 3> tested, inverse;  // E11, E22, E12; 1 over them, 0 if not known
  };
  const std::vector<TestedPoint>& tested(const Batch& batch) const;
  Strained most_of(const Batch& batch, int first_lane, int last_lane) const;

  const model::Model& model_;
  const std::vector<Batch>& batches_;
  const std::vector<BatchLane>& place_;
  const LawStates& states_;
  std::vector<std::vector<TestedPoint>> tested_;  // per region
  law::StrainRatioFunction ratio_at_ = nullptr;
  std::vector<double> ratio_;  // per batch the largest; empty: no card states a tested range
};

}  // namespace fabricsh::mechanics
