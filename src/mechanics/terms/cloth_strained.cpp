// Strain beyond the tested range of the cards. It is read from the law's states right after the kernels have
// written them, which costs one or two nanoseconds per element and step and misses no peak.
#include "mechanics/terms/cloth_strained.hpp"

#include <algorithm>

namespace fabricsh::mechanics {

StrainsReached::StrainsReached(const model::Model& model, const std::vector<Batch>& batches,
                               const std::vector<BatchLane>& place, const LawStates& states)
    : model_(model), batches_(batches), place_(place), states_(states) {
  bool any = false;
  for (std::size_t r = 0; r < model_.regions().size(); ++r) {
    const auto& section = model_.sections()[r];
    const auto& region = model_.regions()[r];
    const auto& plies = region.options.plies;
    tested_.emplace_back();
    for (std::size_t k = 0; k < section.points.size(); ++k) {
      const auto& point = section.points[k];
      TestedPoint here{point.law.get(), point.state, {}, {}};
      here.tested =
          law::tested_strains(plies.empty() ? region.card : plies[static_cast<std::size_t>(point.ply)].card);
      for (std::size_t i = 0; i < 3; ++i) here.inverse[i] = here.tested[i] > 0 ? 1 / here.tested[i] : 0;
      if (here.tested != std::array<double, 3>{}) tested_.back().push_back(here);
    }
    any = any || !tested_.back().empty();
  }
  if (!any) return;
  ratio_at_ = law::strain_ratio_function(best_isa());
  ratio_.assign(batches_.size(), 0);
}

const std::vector<StrainsReached::TestedPoint>& StrainsReached::tested(const Batch& batch) const {
  return tested_[static_cast<std::size_t>(batch.section - model_.sections().data())];
}

void StrainsReached::record(Index b, const double* states) {
  if (ratio_.empty()) return;
  const Batch& batch = batches_[static_cast<std::size_t>(b)];
  const long stride = static_cast<long>(batch.section->state_size) * lanes;
  double most = 0;
  for (const TestedPoint& point : tested(batch))
    most = std::max(
        most, ratio_at_(*point.law, point.inverse.data(), states + static_cast<long>(point.state) * lanes,
                        stride, batch.kind->in_plane));
  ratio_[static_cast<std::size_t>(b)] = most;  // empty lanes repeat an element
}

double StrainsReached::largest_ratio() const {
  return ratio_.empty() ? 0 : *std::max_element(ratio_.begin(), ratio_.end());
}

Strained StrainsReached::most() const {
  if (ratio_.empty()) return {};
  const Batch& batch = batches_[std::max_element(ratio_.begin(), ratio_.end()) - ratio_.begin()];
  return most_of(batch, 0, batch.used);
}

double StrainsReached::ratio(Index element) const {
  if (ratio_.empty()) return 0;
  const BatchLane place = place_[element];
  return most_of(batches_[place.batch], place.lane, place.lane + 1).strain_ratio;
}

// The most strained point of the elements in lanes first_lane to last_lane - 1.
Strained StrainsReached::most_of(const Batch& batch, int first_lane, int last_lane) const {
  Strained most;
  const double* law = states_.current().data() + batch.law;
  for (int lane = first_lane; lane < last_lane; ++lane)
    for (int g = 0; g < batch.kind->in_plane; ++g)
      for (const TestedPoint& point : tested(batch)) {
        const long offset = static_cast<long>(g * batch.section->state_size + point.state) * lanes + lane;
        const auto peak = law::peak_strains(*point.law, law + offset, lanes);
        for (std::size_t i = 0; i < 3; ++i)
          if (const double strain_ratio = peak[i] * point.inverse[i]; strain_ratio > most.strain_ratio)
            most = {strain_ratio, peak[i], point.tested[i], static_cast<int>(i), batch.element[lane]};
      }
  return most;
}

}  // namespace fabricsh::mechanics
