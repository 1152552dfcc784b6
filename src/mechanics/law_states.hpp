// The state variables of the laws at all points. Between a commit or rollback and the next evaluation the
// committed state is read. The states are stored in one of two ways.
//
// As two copies: an evaluation reads all committed numbers and writes all trial ones, and a commit swaps the
// two, so that nothing is ever copied. This suits steps with several evaluations.
//
// In place: an evaluation overwrites the numbers that it changes and appends their old values to a log, from
// which a rollback restores them. This suits steps with one evaluation: unchanged numbers are not written,
// which saves half of the memory and more than half of the memory traffic.
#pragma once
#include <omp.h>

#include <algorithm>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "simd/aligned.hpp"
#include "simd/isa.hpp"

namespace fabricsh::mechanics {

class LawStates {
 public:
  explicit LawStates(std::size_t numbers = 0) : now_(numbers, 0.0) {}

  // Switches to updates in place. Not allowed between an evaluation and the commit or rollback after it.
  // starts: of the groups of numbers whose old values a kernel appends in one call, ascending, whole lines of
  // lanes, and the end of the last group. width: the number of lanes that the kernel works on at once.
  void update_in_place(std::vector<std::size_t> starts, int width) {
    changed_.assign(now_.size() / lanes, 0);
    starts_ = std::move(starts);
    saved_.assign(starts_.size(), nullptr);
    width_ = static_cast<std::size_t>(width);
    other_ = {};
  }
  bool in_place() const { return !changed_.empty(); }

  // Sets committed numbers of one lane, from the index of the first on, before the first evaluation.
  void set(std::size_t first, std::span<const double> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) now_[first + i * lanes] = numbers[i];
  }

  std::span<const double> current() const { return evaluated_ && !in_place() ? other_ : now_; }
  // In place: not to be called between an evaluation and the commit or rollback after it.
  std::span<const double> committed() const { return now_; }
  // Begins an evaluation from the committed state. Returns the trial copy, all of which must be written; in
  // place nothing.
  std::span<double> evaluate() {
    rollback();
    evaluated_ = true;
    if (!in_place()) {
      other_.resize(now_.size());
      return other_;
    }
    logs_.resize(static_cast<std::size_t>(omp_get_max_threads()));
    for (Log& log : logs_) log.rewind();
    return {};
  }
  // In place: the states, and one byte for each line of eight lanes, which the evaluation must write: bit l
  // is set if the number of lane l has changed.
  double* now() { return now_.data(); }
  unsigned char* changed() { return changed_.data(); }
  // In place: where the old numbers of a group are to be appended, by the calling thread, in the order of the
  // parts of `width` lanes and then of the lines; `width` numbers for each part of a line in which one has
  // changed. end_group() receives the end of what was appended.
  double* begin_group(std::size_t group) {
    double* const place = own_log().place(starts_[group + 1] - starts_[group], now_.size());
    saved_[group] = place;
    return place;
  }
  void end_group(const double* end) { own_log().take(end); }

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
  // The old numbers that one thread has saved since the last rewind, in blocks that keep their place.
  class Log {
   public:
    void rewind() {
      block_ = 0;
      used_ = 0;
    }
    // A place with room for so many numbers. all: the most that can ever be saved.
    double* place(std::size_t numbers, std::size_t all) {
      constexpr std::size_t usual = 1u << 20;
      if (block_ < blocks_.size() && blocks_[block_].size() - used_ < numbers) {
        ++block_;
        used_ = 0;
      }
      if (block_ == blocks_.size()) blocks_.emplace_back(std::max(numbers, std::min(usual, all)));
      return blocks_[block_].data() + used_;
    }
    void take(const double* end) { used_ = static_cast<std::size_t>(end - blocks_[block_].data()); }

   private:
    std::deque<LineVector> blocks_;
    std::size_t block_ = 0, used_ = 0;
  };

  Log& own_log() { return logs_[static_cast<std::size_t>(omp_get_thread_num())]; }

  void put_back(LineVector& numbers) const {
    for (std::size_t g = 0; g + 1 < starts_.size(); ++g) {
      const double* old = saved_[g];
      for (std::size_t first = 0; first < lanes; first += width_)
        for (std::size_t i = starts_[g] / lanes; i < starts_[g + 1] / lanes; ++i) {
          const unsigned bits = changed_[i] >> first & ((1u << width_) - 1);
          for (std::size_t l = 0; l < width_ && bits != 0; ++l)
            if ((bits >> l & 1) != 0) numbers[i * lanes + first + l] = old[l];
          if (bits != 0) old += width_;
        }
    }
  }

  LineVector now_, other_;              // other_: empty in place
  std::vector<unsigned char> changed_;  // empty: two copies
  std::vector<std::size_t> starts_;
  std::vector<const double*> saved_;  // per group: its old numbers of the last evaluation
  std::size_t width_ = lanes;
  std::vector<Log> logs_;   // per thread
  bool evaluated_ = false;  // since the last commit or rollback
};

}  // namespace fabricsh::mechanics
