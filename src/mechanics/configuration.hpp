// Positions and directors of the nodes, as a committed and a trial copy. Only a run commits or rolls back.
// A step changes the trial copy and calls touch(); the terms read it; commit() makes it the committed
// copy.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"

namespace fabricsh::mechanics {

class Configuration {
 public:
  // nodes: each has 9 numbers, global: position x (m), director d (unit), first axis b1 of the director's
  // frame (unit).
  explicit Configuration(std::size_t nodes) : nodes_(nodes), committed_(9 * nodes, 0.0), trial_(committed_) {}

  std::size_t nodes() const { return nodes_; }
  // Trial copy, 3 per node each.
  std::span<double> x() { return part(writable(), 0); }
  std::span<double> d() { return part(writable(), 1); }
  std::span<double> b1() { return part(writable(), 2); }
  std::span<double> kinematics() { return writable(); }
  std::span<const double> x() const { return part(current(), 0); }
  std::span<const double> d() const { return part(current(), 1); }
  std::span<const double> b1() const { return part(current(), 2); }
  std::span<const double> kinematics() const { return current(); }
  // Committed copy: x of all nodes, then d, then b1.
  std::span<const double> committed_kinematics() const { return committed_; }

  double time() const { return time_; }  // of the committed copy, s
  std::uint64_t version() const { return version_; }
  void touch() { ++version_; }           // to be called after a change of the trial copy
  bool moved() const { return moved_; }  // whether the trial copy may differ from the committed one
  // To be called before the whole trial copy is written: the committed one then need not be copied first.
  void overwrite() { moved_ = true; }
  void commit(double time) {
    if (moved_) committed_.swap(trial_);
    moved_ = false;
    time_ = time;
    ++version_;
  }
  void rollback() {
    moved_ = false;
    ++version_;
  }
  // The committed copy, for snapshots and checkpoints. Error when reading: a different number of nodes.
  void keep(Archive& archive) {
    archive(time_);
    archive.filled(committed_);
    if (archive.reading()) rollback();
  }

 private:
  // Until the trial copy is moved, its numbers are not valid and the committed copy is used instead.
  const std::vector<double>& current() const { return moved_ ? trial_ : committed_; }
  std::span<double> writable() {
    if (!moved_) trial_ = committed_;
    moved_ = true;
    return trial_;
  }
  template <class T>
  std::span<T> part(std::span<T> all, int k) const {
    return all.subspan(3 * nodes_ * static_cast<std::size_t>(k), 3 * nodes_);
  }
  std::span<const double> part(const std::vector<double>& all, int k) const {
    return part(std::span<const double>(all), k);
  }
  std::size_t nodes_;
  std::vector<double> committed_, trial_;
  bool moved_ = false;
  double time_ = 0;
  std::uint64_t version_ = 1;
};

}  // namespace fabricsh::mechanics
