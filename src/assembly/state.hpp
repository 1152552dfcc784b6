// The state of a run: kinematics of the nodes and states of the law, a committed and a trial copy of each.
// Only an analysis commits or rolls back.
//
// The law's states are never copied: forces() reads the committed ones and writes all of the trial ones, a
// commit swaps the two, and what is read between a commit or rollback and the next forces() is the committed
// copy. So an explicit step is: move x(), d(), b1(); touch(); assembly.forces(); commit(time).
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/aligned.hpp"
#include "base/archive.hpp"

namespace fabricsh::assembly {

class StateStore {
 public:
  // nodes: 9 numbers each (position x 3, director 3, first director axis b1 3); law: numbers of all law
  // states.
  StateStore(std::size_t nodes, std::size_t law)
      : nodes_(nodes),
        committed_(9 * nodes, 0.0),
        trial_(committed_),
        committed_law_(law, 0.0),
        trial_law_(law, 0.0) {}

  std::size_t nodes() const { return nodes_; }
  // Trial copy.
  std::span<double> x() { return part(0); }
  std::span<double> d() { return part(1); }
  std::span<double> b1() { return part(2); }
  std::span<double> kinematics() { return trial_; }
  std::span<const double> x() const { return std::span(trial_).subspan(0, 3 * nodes_); }
  std::span<const double> d() const { return std::span(trial_).subspan(3 * nodes_, 3 * nodes_); }
  std::span<const double> b1() const { return std::span(trial_).subspan(6 * nodes_, 3 * nodes_); }
  std::span<const double> law() const { return evaluated_ ? trial_law_ : committed_law_; }
  // The law's trial copy to be written, all of it.
  std::span<double> evaluate_law() {
    evaluated_ = true;
    return trial_law_;
  }
  // Committed copy.
  std::span<const double> committed_kinematics() const { return committed_; }
  std::span<const double> committed_law() const { return committed_law_; }

  double time() const { return time_; }  // of the committed state, s
  std::uint64_t version() const { return version_; }
  void touch() { ++version_; }  // the trial copy has changed
  void commit(double time) {
    committed_ = trial_;
    if (evaluated_) committed_law_.swap(trial_law_);
    evaluated_ = false;
    time_ = time;
    ++version_;
  }
  void rollback() {
    trial_ = committed_;
    evaluated_ = false;
    ++version_;
  }
  // The committed copy, for snapshots and checkpoints. Error when reading: of another model.
  void keep(Archive& archive) {
    archive(time_);
    archive.filled(committed_);
    archive.filled(committed_law_);
    if (archive.reading()) rollback();
  }

 private:
  std::span<double> part(int k) { return std::span(trial_).subspan(3 * nodes_ * k, 3 * nodes_); }
  std::size_t nodes_;
  std::vector<double> committed_, trial_;  // kinematics
  LineVector committed_law_, trial_law_;
  bool evaluated_ = false;  // does the law's trial copy belong to the trial configuration
  double time_ = 0;
  std::uint64_t version_ = 1;
};

}  // namespace fabricsh::assembly
