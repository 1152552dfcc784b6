#include "run/windows.hpp"

#include <algorithm>

#include "mechanics/terms/contact.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

Window::Value value_of(const Window::Reaction& of) {
  return [of](const Run& run) -> Sampled {
    const Vec3 force = of.body < 0 ? run.reaction(of.set)
                                   : Vec3(-run.contact().bodies().force(static_cast<std::size_t>(of.body)));
    return {force[0], force[1], force[2]};
  };
}

}  // namespace

Window::Window(double width, const Reaction& of) : Window(width, value_of(of)) { of_ = {of}; }

void Window::sample(const Run& run) {
  const double now = run.time();
  while (!points_.empty() && points_.back().time >= now) points_.pop_back();  // along an arc, or again
  points_.push_back({now, value_(run)});
  const auto inside =
      std::find_if(points_.begin(), points_.end(), [&](const Point& p) { return p.time > now - width_; });
  if (inside - points_.begin() > 1) points_.erase(points_.begin(), inside - 1);
}

Sampled Window::mean() const {
  if (points_.empty()) return {};
  const double end = points_.back().time, begin = std::max(points_.front().time, end - width_);
  if (!(end > begin)) return points_.back().value;
  Sampled sum = {};
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Point &a = points_[i - 1], &b = points_[i];
    const double from = std::max(a.time, begin), part = (from - a.time) / (b.time - a.time);
    for (std::size_t c = 0; c < sum.size(); ++c) {
      const double at_from = a.value[c] + part * (b.value[c] - a.value[c]);
      sum[c] += (b.time - from) * (at_from + b.value[c]) / 2;
    }
  }
  for (double& s : sum) s /= end - begin;
  return sum;
}

Window& Windows::add(const std::string& name, Window window) {
  if (Window* const old = find(name)) window.points_ = std::move(old->points_);
  if (const auto kept = kept_.find(name); kept != kept_.end()) {
    window.points_ = std::move(kept->second);
    kept_.erase(kept);
  }
  return all_.insert_or_assign(name, std::move(window)).first->second;
}

Window* Windows::find(const std::string& name) {
  const auto found = all_.find(name);
  return found == all_.end() ? nullptr : &found->second;
}

void Windows::sample(const Run& run) {
  for (auto& [name, window] : all_) window.sample(run);
}

void Windows::keep(Archive& archive) {
  std::vector<std::string> names;
  std::vector<double> widths;
  std::vector<std::vector<Window::Reaction>> of;
  std::vector<std::vector<Window::Point>> points;
  if (!archive.reading())
    for (const auto& [name, window] : all_) {
      names.push_back(name);
      widths.push_back(window.width_);
      of.push_back(window.of_);
      points.push_back(window.points_);
    }
  archive(names, widths, of, points);
  if (!archive.reading()) return;
  kept_.clear();
  for (auto& [name, window] : all_) window.points_.clear();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (find(names[i]) == nullptr && !of[i].empty()) add(names[i], Window(widths[i], of[i].front()));
    if (Window* const window = find(names[i]))
      window->points_ = std::move(points[i]);
    else
      kept_[names[i]] = std::move(points[i]);
  }
}

}  // namespace fabricsh::run
