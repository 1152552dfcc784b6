// Rows or frames that a run writes as it goes, one a step at most, each whole when it is there.
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

  // Of the state that the analysis holds now, unless its step has one.
  void frame(const run::Run& run);
  // The same where a run is broken off: it shows where that was, and goes away when the run goes on.
  void extra_frame(const run::Run& run);
  void go_on();
  virtual std::vector<std::string> lost() const { return {}; }  // files that were gone when it went on
  bool in_trouble() const { return in_trouble_; }               // its last frame was an error
  void rewind(std::size_t step);                                // takes off what is later than a step
  virtual void sync() = 0;                                      // to the disk
  // How far it is, for a program that continues it.
  void keep(Archive& archive);

 protected:
  Series() = default;
  explicit Series(Archive& from) { from(steps_, extra_); }
  std::size_t frames() const { return steps_.size(); }
  virtual void write(const run::Run& run) = 0;
  virtual void cut(std::size_t frames) = 0;  // keeps the first ones
  virtual void keep_place(Archive& archive) = 0;

 private:
  std::vector<std::size_t> steps_;  // of the frames
  bool extra_ = false;              // is the last one
  bool in_trouble_ = false;
};

}  // namespace fabricsh::run
