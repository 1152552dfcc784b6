// Strain beyond what the cards were tested to. It is looked for in the law's states right after the kernels
// have written them: a step costs one or two nanoseconds more for each element, and no peak is missed.
#include <algorithm>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"

namespace fabricsh::assembly {

void Assembly::find_tested() {
  const auto& section = model_.section();
  const auto& plies = model_.options().plies;
  const std::size_t per_card = section.points.size() / std::max<std::size_t>(1, plies.size());
  for (std::size_t k = 0; k < section.points.size(); ++k) {
    const auto& point = section.points[k];
    TestedPoint here{point.law.get(), point.state, {}, {}};
    here.tested = fabric::tested_strains(plies.empty() ? model_.card() : plies[k / per_card].card);
    for (std::size_t i = 0; i < 3; ++i) here.inverse[i] = here.tested[i] > 0 ? 1 / here.tested[i] : 0;
    if (here.tested != std::array<double, 3>{}) tested_.push_back(here);
  }
  if (tested_.empty()) return;
  shares_ = fabric::shares_function(best_isa());
  share_.assign(batches_.size(), 0);
}

double Assembly::share_of(const Batch& batch, const double* law) const {
  alignas(64) double share[lanes] = {};
  const long stride = static_cast<long>(model_.section().state_size) * lanes;
  for (const TestedPoint& point : tested_)
    shares_(*point.law, point.inverse.data(), law + batch.law + static_cast<long>(point.state) * lanes,
            stride, batch.kind->in_plane, share);
  return *std::max_element(share, share + lanes);  // lanes that stay empty repeat an element
}

double Assembly::largest_share() const {
  return share_.empty() ? 0 : *std::max_element(share_.begin(), share_.end());
}

Strained Assembly::most_strained() const {
  Strained most;
  if (share_.empty()) return most;
  const Batch& batch = batches_[std::max_element(share_.begin(), share_.end()) - share_.begin()];
  const double* law = std::as_const(*state_).law().data() + batch.law;
  for (int lane = 0; lane < batch.used; ++lane)
    for (int g = 0; g < batch.kind->in_plane; ++g)
      for (const TestedPoint& point : tested_) {
        const long offset = static_cast<long>(g * model_.section().state_size + point.state) * lanes + lane;
        const auto peak = fabric::peak_strains(*point.law, law + offset, lanes);
        for (std::size_t i = 0; i < 3; ++i)
          if (const double share = peak[i] * point.inverse[i]; share > most.share)
            most = {share, peak[i], point.tested[i], static_cast<int>(i), batch.element[lane]};
      }
  return most;
}

}  // namespace fabricsh::assembly
