#include "run/series.hpp"

namespace fabricsh::run {

void Series::frame(const run::Run& run) {
  if (!steps_.empty() && run.steps().size() == steps_.back()) return;
  in_trouble_ = true;
  write(run);
  in_trouble_ = false;
  steps_.push_back(run.steps().size());
}

void Series::extra_frame(const run::Run& run) {
  const std::size_t before = steps_.size();
  frame(run);
  extra_ = extra_ || steps_.size() > before;
}

void Series::go_on() {
  if (!extra_) return;
  cut(steps_.size() - 1);
  steps_.pop_back();
  extra_ = false;
}

void Series::rewind(std::size_t step) {
  while (!steps_.empty() && steps_.back() > step) {
    steps_.pop_back();
    extra_ = false;
  }
  cut(steps_.size());
}

void Series::keep(Archive& archive) {
  archive(steps_, extra_);
  keep_place(archive);
}

}  // namespace fabricsh::run
