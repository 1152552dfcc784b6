// The state variables of the laws at all points. Between a commit or rollback and the next evaluation the
// committed state is read. The states are stored in one of two ways.
//
// As two copies: an evaluation reads all committed numbers and writes all trial ones, and a commit swaps the
// two, so that nothing is ever copied. This suits steps with several evaluations.
//
// In place: an evaluation overwrites the numbers that it changes and saves their old values, which a rollback
// restores. This suits steps with one evaluation: unchanged numbers are not written, which saves more than
// half of the memory traffic.
#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "simd/aligned.hpp"
#include "simd/isa.hpp"

namespace fabricsh::mechanics {

class LawStates {
 public:
  explicit LawStates(std::size_t numbers = 0) : now_(numbers, 0.0), other_(numbers) {}

  // Switches to updates in place. Not allowed between an evaluation and the commit or rollback after it.
  void update_in_place() { changed_.assign(now_.size() / lanes, 0); }
  bool in_place() const { return !changed_.empty(); }

  std::span<const double> current() const { return evaluated_ && !in_place() ? other_ : now_; }
  // In place: not to be called between an evaluation and the commit or rollback after it.
  std::span<const double> committed() const { return now_; }
  // Begins an evaluation from the committed state. Returns the trial copy, all of which must be written; in
  // place the array for the old values of the numbers that change.
  std::span<double> evaluate() {
    rollback();
    evaluated_ = true;
    return other_;
  }
  // In place: the states, and one byte for each line of eight lanes, which the evaluation must write: bit l
  // is set if the number of lane l has changed.
  double* now() { return now_.data(); }
  unsigned char* changed() { return changed_.data(); }

  void commit() {
    if (evaluated_ && !in_place()) now_.swap(other_);
    evaluated_ = false;
  }
  void rollback() {
    if (evaluated_ && in_place()) put_back(now_);
    evaluated_ = false;
  }
  // The committed state. Error when reading: a different number of states.
  void keep(Archive& archive) {
    if (evaluated_ && in_place() && !archive.reading()) {
      LineVector committed = now_;
      put_back(committed);
      return archive.filled(committed);
    }
    archive.filled(now_);
    if (archive.reading()) evaluated_ = false;
  }

 private:
  void put_back(LineVector& numbers) const {
    for (std::size_t i = 0; i < changed_.size(); ++i)
      for (std::size_t l = 0; changed_[i] != 0 && l < lanes; ++l)
        if ((changed_[i] >> l & 1) != 0) numbers[i * lanes + l] = other_[i * lanes + l];
  }

  LineVector now_, other_;
  std::vector<unsigned char> changed_;  // empty: two copies
  bool evaluated_ = false;              // since the last commit or rollback
};

}  // namespace fabricsh::mechanics
