#include "run/series.hpp"

#include "run/job.hpp"

namespace fabricsh::run {

void Series::frame(const run::Run& run) {
  if (!steps_.empty() && run.steps().size() == steps_.back()) return;
  failed_ = true;
  remove_forgotten();
  write(run);
  failed_ = false;
  steps_.push_back(run.steps().size());
}

void Series::extra_frame(const run::Run& run) {
  const std::size_t before = steps_.size();
  frame(run);
  extra_ = extra_ || steps_.size() > before;
}

void Series::go_on() {
  if (!extra_) return;
  steps_.pop_back();
  extra_ = false;
  remove_forgotten();
}

void Series::forget(std::size_t step) {
  while (!steps_.empty() && steps_.back() > step) {
    steps_.pop_back();
    extra_ = false;
  }
}

void Series::keep(Archive& archive) {
  std::vector<std::size_t> counted = steps_;
  if (extra_) counted.pop_back();
  archive(counted);
  keep_place(archive, counted.size());
}

void Output::end(Job& job, const Ending& ending) {
  if (!ending.ended) return;
  job.frame(*series, ending.broken);
}

void Output::forget(Job& job) { series->forget(job.run().steps().size()); }

void Output::save(std::vector<Checkpoint::CheckpointPart>& parts) {
  Archive place;
  series->keep(place);
  parts.push_back({kind, path, place.bytes()});
}

}  // namespace fabricsh::run
