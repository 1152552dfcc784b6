// The state of a run: one contiguous, versioned block. Committed and trial copies; only an analysis commits
// or rolls back.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace fabricsh::assembly {

class StateStore {
 public:
  // nodes: 9 numbers each (position x 3, director 3, first director axis b1 3); law: numbers of all law
  // states.
  StateStore(std::size_t nodes, std::size_t law)
      : nodes_(nodes), committed_(9 * nodes + law, 0.0), trial_(committed_) {}

  std::size_t nodes() const { return nodes_; }
  // Trial copy.
  std::span<double> x() { return part(0); }
  std::span<double> d() { return part(1); }
  std::span<double> b1() { return part(2); }
  std::span<double> kinematics() { return std::span(trial_).first(9 * nodes_); }
  std::span<double> law() { return std::span(trial_).subspan(9 * nodes_); }
  std::span<const double> x() const { return std::span(trial_).subspan(0, 3 * nodes_); }
  std::span<const double> d() const { return std::span(trial_).subspan(3 * nodes_, 3 * nodes_); }
  std::span<const double> law() const { return std::span(trial_).subspan(9 * nodes_); }
  // Committed copy.
  std::span<const double> committed_kinematics() const { return std::span(committed_).first(9 * nodes_); }
  std::span<const double> committed_law() const { return std::span(committed_).subspan(9 * nodes_); }

  double time() const { return time_; }  // of the committed state, s
  std::uint64_t version() const { return version_; }
  void touch() { ++version_; }  // the trial copy has changed
  void commit(double time) {
    committed_ = trial_;
    time_ = time;
    ++version_;
  }
  void rollback() {
    trial_ = committed_;
    ++version_;
  }
  const std::vector<double>& data() const { return committed_; }
  void restore(const std::vector<double>& data, double time) {
    committed_ = data;
    trial_ = data;
    time_ = time;
    ++version_;
  }

 private:
  std::span<double> part(int k) { return std::span(trial_).subspan(3 * nodes_ * k, 3 * nodes_); }
  std::size_t nodes_;
  std::vector<double> committed_, trial_;
  double time_ = 0;
  std::uint64_t version_ = 1;
};

}  // namespace fabricsh::assembly
