// Means over a window of time, for what chatters from step to step: friction, contact, reactions.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::run {

class Run;

using Sampled = std::array<double, 3>;  // a vector, or a number and two zeros

// The values of the last `width` seconds at the ends of the run's own steps, straight between them.
class Window {
 public:
  using Value = std::function<Sampled(const Run&)>;
  Window(double width, Value value) : width_(width), value_(std::move(value)) {}
  // N, of supports or of a body on the cloth: what a state keeps of it is enough to go on.
  struct Reaction {
    std::string set;
    std::int64_t body = -1;  // number; -1: of the set
    void keep(Archive& archive) { archive(set, body); }
  };
  Window(double width, const Reaction& of);
  void sample(const Run& run);
  bool begun() const { return !points_.empty(); }
  Sampled mean() const;  // over the window, or as much of it as there is

 private:
  friend class Windows;
  struct Point {
    double time = 0;
    Sampled value = {};
    void keep(Archive& archive) { archive(time, value[0], value[1], value[2]); }
  };
  double width_;
  Value value_;
  std::vector<Reaction> of_ = {};  // one, or none
  std::vector<Point> points_;      // ascending in time; one at most before the window
};

class Windows {
 public:
  // Of a run that has begun, a window counts from now. One of that name goes on with what it has.
  Window& add(const std::string& name, Window window);
  Window* find(const std::string& name);
  bool empty() const { return all_.empty(); }
  void sample(const Run& run);  // after a step
  void keep(Archive& archive);

 private:
  std::map<std::string, Window> all_;
  std::map<std::string, std::vector<Window::Point>> kept_;
};

}  // namespace fabricsh::run
