// Scalar functions of time: what drives supports and loads.
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace fabricsh::history {

// value(t): in the unit of what it drives. Kinks are the times that a step must land on.
// Errors: table() throws Error unless times strictly increase and every number is finite; a callback whose
// value is not finite throws Error naming the time.
class History {
 public:
  History() : History(Points{}) {}  // zero at all times
  static History constant(double value);
  static History table(std::vector<std::pair<double, double>> points);  // (t, v); holds its end values
  static History ramp(double value, double duration);                   // 0 to value over duration, then held
  static History callback(std::function<double(double)> f);

  double value(double t) const;
  // d value / dt from the right; callbacks by central difference over step.
  double rate(double t, double step = 1e-6) const;
  bool is_constant() const { return !callback_ && points_->size() <= 1; }
  const std::vector<double>& kinks() const { return *kinks_; }

 private:
  using Points = std::vector<std::pair<double, double>>;
  explicit History(Points points);
  // Shared by all copies: a record of many rows is stored once, however many nodes follow it.
  std::shared_ptr<const Points> points_;
  std::shared_ptr<const std::vector<double>> kinks_;
  std::function<double(double)> callback_;
};

}  // namespace fabricsh::history
