// The state variables of the laws at all points, as a committed and a trial copy. An evaluation reads all
// committed numbers and writes all trial ones, and a commit swaps the two, so that nothing is ever copied.
// Between a commit or rollback and the next evaluation the committed copy is read.
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
  // The trial copy, all of which must be written.
  std::span<double> evaluate() {
    evaluated_ = true;
    return trial_;
  }
  void commit() {
    if (evaluated_) committed_.swap(trial_);
    evaluated_ = false;
  }
  void rollback() { evaluated_ = false; }
  // The committed copy. Error when reading: a different number of states.
  void keep(Archive& archive) {
    archive.filled(committed_);
    if (archive.reading()) rollback();
  }

 private:
  LineVector committed_, trial_;
  bool evaluated_ = false;  // whether the trial copy belongs to the trial configuration
};

}  // namespace fabricsh::mechanics
