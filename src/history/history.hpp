// Scalar functions of time: what drives supports and loads.
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace fabricsh::history {

// value(t) has the unit of the quantity that it drives. A kink is a time at which a step must
// end. Errors: table() throws Error unless the times increase strictly and every number is
// finite; a callback that returns a value that is not finite throws Error naming the time.
class History {
 public:
  History() : History(Points{}) {}  // zero at all times
  static History constant(double value);
  static History table(std::vector<std::pair<double, double>> points);  // points (t, v)
  static History ramp(double value, double duration);                   // 0 to value, then held
  static History callback(std::function<double(double)> f);

  double value(double t) const;
  bool is_constant() const { return !callback_ && points_->size() <= 1; }
  bool is_straight() const { return !callback_; }  // between kinks; a function of time may do anything
  const std::vector<double>& kinks() const { return *kinks_; }

 private:
  using Points = std::vector<std::pair<double, double>>;
  explicit History(Points points);
  // Shared by all copies: a long table is stored once, however many nodes follow it.
  std::shared_ptr<const Points> points_;
  std::shared_ptr<const std::vector<double>> kinks_;
  std::function<double(double)> callback_;
};

}  // namespace fabricsh::history
