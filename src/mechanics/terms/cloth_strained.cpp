// Strain beyond the tested range of the cards. It is read from the law's states right after the kernels have
// written them, which costs one or two nanoseconds per element and step and misses no peak.
#include <algorithm>

#include "mechanics/terms/cloth.hpp"

namespace fabricsh::mechanics {

void Cloth::find_tested() {
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
  strain_ratio_at_ = law::strain_ratio_function(best_isa());
  strain_ratio_.assign(batches_.size(), 0);
}

const std::vector<Cloth::TestedPoint>& Cloth::tested(const Batch& batch) const {
  return tested_[static_cast<std::size_t>(batch.section - model_.sections().data())];
}

double Cloth::strain_ratio_of(const Batch& batch, const double* states) const {
  const long stride = static_cast<long>(batch.section->state_size) * lanes;
  double most = 0;
  for (const TestedPoint& point : tested(batch))
    most = std::max(most, strain_ratio_at_(*point.law, point.inverse.data(),
                                           states + static_cast<long>(point.state) * lanes, stride,
                                           batch.kind->in_plane));
  return most;  // empty lanes repeat an element
}

double Cloth::largest_strain_ratio() const {
  return strain_ratio_.empty() ? 0 : *std::max_element(strain_ratio_.begin(), strain_ratio_.end());
}

Strained Cloth::most_strained() const {
  if (strain_ratio_.empty()) return {};
  const Batch& batch =
      batches_[std::max_element(strain_ratio_.begin(), strain_ratio_.end()) - strain_ratio_.begin()];
  return most_strained_of(batch, 0, batch.used);
}

double Cloth::strain_ratio(Index element) const {
  if (strain_ratio_.empty()) return 0;
  const BatchLane place = place_[element];
  return most_strained_of(batches_[place.batch], place.lane, place.lane + 1).strain_ratio;
}

// The most strained point of the elements in lanes first_lane to last_lane - 1.
Strained Cloth::most_strained_of(const Batch& batch, int first_lane, int last_lane) const {
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
