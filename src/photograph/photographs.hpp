// The four functions of the part (lab/photographs.hpp).
#pragma once
#include "lab/photographs.hpp"

namespace fabricsh::photograph {

class Photographs : public lab::Photographs {
 public:
  lab::TrackedDots track(const lab::PhotographSeries& series, std::size_t rows, std::size_t columns,
                         const lab::DotOptions& options) const override;
  lab::CorrelatedSubsets correlate(const lab::PhotographSeries& series,
                                   lab::CorrelationOptions options) const override;
  std::string picture(const lab::DotGrid& scene) const override;
  std::string picture(const lab::Speckles& speckles) const override;
};

}  // namespace fabricsh::photograph
