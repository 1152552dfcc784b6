// The numbers that a law remembers at its points: a committed and a trial copy that are never copied into
// each other. An evaluation reads all of the committed numbers and writes all of the trial ones, a commit
// swaps the two, and what is read between a commit or rollback and the next evaluation is the committed copy.
#pragma once
#include <span>

#include "base/archive.hpp"
#include "simd/aligned.hpp"

namespace fabricsh::mechanics {

class LawStates {
 public:
  explicit LawStates(std::size_t numbers = 0) : committed_(numbers, 0.0), trial_(numbers, 0.0) {}

  std::span<const double> current() const { return evaluated_ ? trial_ : committed_; }
  std::span<const double> committed() const { return committed_; }
  // The trial copy to be written, all of it.
  std::span<double> evaluate() {
    evaluated_ = true;
    return trial_;
  }
  void commit() {
    if (evaluated_) committed_.swap(trial_);
    evaluated_ = false;
  }
  void rollback() { evaluated_ = false; }
  // The committed copy. Error when reading: of another number of states.
  void keep(Archive& archive) {
    archive.filled(committed_);
    if (archive.reading()) rollback();
  }

 private:
  LineVector committed_, trial_;
  bool evaluated_ = false;  // does the trial copy belong to the trial configuration
};

}  // namespace fabricsh::mechanics
