// Hooks, events and landings of a run.
#include "run/schedule.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

constexpr int kDue = 10;  // added to the side of an event, which is -1, 0 or 1, whose hook is still to run

Window::Value value_of(const Window::Reaction& of) {
  return [of](const Run& run) -> Sampled {
    const Vec3 force =
        of.body < 0 ? run.reaction(of.set) : run.force_of_body(static_cast<std::size_t>(of.body));
    return {force[0], force[1], force[2]};
  };
}

}  // namespace

void Schedule::check_interval(double interval) const {
  const double duration = run_.duration();
  if (!(duration / interval <= most_steps))
    throw Error("every: expected at least " + number(duration / most_steps) + " s (" + number(most_steps) +
                " calls in the duration of " + number(duration) + " s), got " + number(interval) + " s");
}

std::size_t Schedule::add(Timed timed) {
  timed_.push_back(std::move(timed));
  take_up(timed_.back());
  return timed_.size() - 1;
}

std::size_t Schedule::every_step(Hook hook, AfterError after) { return add({0, std::move(hook), after}); }

std::size_t Schedule::every(double interval, Hook hook, AfterError after) {
  if (!(interval > 0) || !std::isfinite(interval))
    throw Error("every: expected a positive time in s or \"step\", got " + number(interval));
  check_interval(interval);
  return add({interval, std::move(hook), after});
}

void Schedule::reschedule(std::size_t hook, double interval) {
  Timed& timed = timed_.at(hook);
  if (timed.interval == interval) return;
  if (interval > 0) check_interval(interval);
  timed.interval = interval;
  timed.count = 1;
  if (interval > 0) timed.count += static_cast<std::int64_t>(std::floor(run_.time() / interval + 1e-9));
}

void Schedule::event(std::function<double(Run&)> value, double tolerance, Hook hook) {
  if (!(tolerance > 0))
    throw Error("event: field 'tolerance': expected a positive number, got " + number(tolerance));
  Event event{std::move(value), tolerance, std::move(hook)};
  take_up(event, events_.size());
  events_.push_back(std::move(event));
}

Window& Schedule::window(const std::string& name, Window made) {
  Window& window = windows_.add(name, std::move(made));
  if (run_.started() && !window.begun()) window.sample(run_, {});
  windows_.remember_bodies(run_);
  return window;
}

void Schedule::begin_schedule() {
  for (auto& event : events_) {
    measure(event);
    event.settle();
  }
  for (auto& timed : timed_) timed.pending = true;
}

// --- events

void Schedule::Event::settle() {
  largest = std::max(largest, std::abs(now));
  last = now;
  if (side != 0 && (near() || crossed())) {
    pending = true;
    side = 0;
  }
  if (!near()) side = now > 0 ? 1 : -1;
}

bool Schedule::Event::crossed() const { return side != 0 && !near() && (now > 0) != (side > 0); }

void Schedule::measure(Event& event) {
  event.now = event.value(run_);
  if (!std::isfinite(event.now))
    throw Error("event: field 'value': expected a finite number, got " + number(event.now));
}

// --- hooks

void Schedule::settle() {
  for (auto& event : events_) event.settle();
  windows_.sample(run_);
  hooked_ = hooked_ || !events_.empty() || !windows_.empty();
  for (auto& timed : timed_) {
    const double due = static_cast<double>(timed.count) * timed.interval;
    if (timed.interval > 0 && run_.time() < due - same_time * run_.duration()) continue;
    ++timed.count;
    timed.pending = true;
  }
}

void Schedule::run_pending() {
  for (std::size_t i = 0; i < timed_.size(); ++i) {
    if (!timed_[i].pending) continue;
    const bool repeat = timed_[i].after == AfterError::repeat;
    timed_[i].pending = repeat;
    hooked_ = true;
    const Hook hook = timed_[i].hook;  // a copy, because a hook may add hooks
    hook(run_);
    timed_[i].pending = false;
  }
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (!events_[i].pending) continue;
    events_[i].pending = false;
    const Hook hook = events_[i].hook;
    if (hook) hook(run_);
  }
}

// --- landings

double Schedule::landing_after(double now, double limit) const {
  const double after = now + same_time * run_.duration();
  double landing = limit;
  const auto kink = std::upper_bound(kinks_.begin(), kinks_.end(), after);
  if (kink != kinks_.end()) landing = std::min(landing, *kink);
  for (const auto& timed : timed_)
    if (timed.interval > 0) {
      const double t = static_cast<double>(timed.count) * timed.interval;
      if (t > after) landing = std::min(landing, t);
    }
  return landing;
}

bool Schedule::is_kink(double time) const {
  return std::any_of(kinks_.begin(), kinks_.end(),
                     [&](double t) { return std::abs(t - time) <= same_time * run_.duration(); });
}

// --- checkpoints

void Schedule::keep_schedule(Archive& archive, bool waits) {
  if (!archive.reading()) {
    kept_timed_.clear();
    kept_events_.clear();
    for (const auto& timed : timed_)
      kept_timed_.push_back({timed.interval, timed.after == AfterError::repeat,
                             timed.repeats() || (timed.pending && waits), timed.count});
    for (const auto& event : events_)
      kept_events_.push_back({event.last, event.largest, event.side + (event.pending && waits ? kDue : 0)});
  }
  archive(kept_timed_, kept_events_);
  if (archive.reading()) {
    for (Timed& timed : timed_) take_up(timed);
    for (std::size_t i = 0; i < events_.size(); ++i) take_up(events_[i], i);
  }
  windows_.keep(archive);
}

// A hook added after the state was stored counts from now.
void Schedule::take_up(Timed& timed) {
  timed.pending = false;
  timed.count = 1;
  const auto kept = std::find_if(kept_timed_.begin(), kept_timed_.end(), [&](const TimedState& k) {
    return !k.taken && k.interval == timed.interval && k.is_output == (timed.after == AfterError::repeat);
  });
  if (kept != kept_timed_.end()) {
    kept->taken = true;
    timed.count = kept->count;
    timed.pending = kept->repeats;
  } else if (timed.interval > 0) {
    timed.count += static_cast<std::int64_t>(std::floor(run_.time() / timed.interval + 1e-9));
  }
}

void Schedule::take_up(Event& event, std::size_t i) {
  event.pending = false;
  if (i < kept_events_.size()) {
    event.last = kept_events_[i].last;
    event.largest = kept_events_[i].largest;
    event.pending = kept_events_[i].side > kDue - 2;
    event.side = kept_events_[i].side - (event.pending ? kDue : 0);
  } else if (run_.started()) {
    event.side = 0;
    measure(event);
    event.settle();
  }
}

Window::Window(double width, const Reaction& of) : Window(width, value_of(of)) { of_ = {of}; }

// A force of a body in the middle of each step is the same at its beginning as at its end, one at a place
// between these two goes from the one to the other by a part of its change. What else the value may consist
// of does so by all of it: this is the part that it has without the forces of the bodies.
void Window::sample(const Run& run, const std::vector<double>& before) {
  const double now = run.time();
  while (!points_.empty() && points_.back().time >= now) points_.pop_back();  // along an arc, or again
  Point here{now};
  bool of_bodies = false;
  const auto sampled = [&](const std::vector<double>* forces) {
    const Readings::ForcesOfBodies shown(run, forces);
    const Sampled value = value_(run);
    of_bodies = shown.read();
    return value;
  };
  here.begin = here.value = sampled(nullptr);
  if (!points_.empty()) here.begin = points_.back().value;
  if (const double place = run.place_of_contact(); of_bodies && place != 1 && !before.empty()) {
    const Sampled of_before = sampled(&before);
    for (std::size_t c = 0; c < of_before.size(); ++c)
      here.begin[c] += 2 * (1 - place) * (here.value[c] - of_before[c]);
  }
  points_.push_back(here);
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
      const double at_from = b.begin[c] + part * (b.value[c] - b.begin[c]);
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
  for (auto& [name, window] : all_) window.sample(run, before_);
  remember_bodies(run);
}

void Windows::remember_bodies(const Run& run) {
  const auto* const contact = run.assembly().terms().find<mechanics::Contacts>();
  if (empty() || contact == nullptr) return;
  before_.resize(3 * contact->bodies().count());
  for (std::size_t i = 0; 3 * i < before_.size(); ++i)
    at(before_, static_cast<std::ptrdiff_t>(i)) = -contact->bodies().readings().force(i);
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
  archive(names, widths, of, points, before_);
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
