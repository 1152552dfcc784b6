// Rows or frames written during a run, at most one per step, each complete when it exists.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

class Series {
 public:
  virtual ~Series() = default;
  Series(const Series&) = delete;
  Series& operator=(const Series&) = delete;

  // Writes a frame of the present state, unless its step already has one.
  void frame(const run::Run& run);
  // Writes a frame where a run has ended by an error; it is removed when the run continues.
  void extra_frame(const run::Run& run);
  void go_on();
  virtual std::vector<std::string> lost() const { return {}; }  // files missing when the series was continued
  bool in_trouble() const { return in_trouble_; }               // writing the last frame failed
  void rewind(std::size_t step);                                // removes frames after a step
  virtual void sync() = 0;                                      // forces the files to the disk
  // Archives the state of the series, for a program that continues it.
  void keep(Archive& archive);

 protected:
  Series() = default;
  explicit Series(Archive& from) { from(steps_, extra_); }
  std::size_t frames() const { return steps_.size(); }
  virtual void write(const run::Run& run) = 0;
  virtual void cut(std::size_t frames) = 0;  // keeps only the first ones
  virtual void keep_place(Archive& archive) = 0;

 private:
  std::vector<std::size_t> steps_;  // the steps of the frames
  bool extra_ = false;              // whether the last frame is an extra one
  bool in_trouble_ = false;
};

}  // namespace fabricsh::run
