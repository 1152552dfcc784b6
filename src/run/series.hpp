// Rows or frames written during a run, at most one per step, each complete when it exists.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "run/listener.hpp"
#include "run/run.hpp"
#include "run/vtk_frame.hpp"

namespace fabricsh::run {

class Series {
 public:
  virtual ~Series() = default;
  Series(const Series&) = delete;
  Series& operator=(const Series&) = delete;

  // Writes a frame of the present state, unless its step already has one.
  void frame(const run::Run& run);
  // Writes a frame where a run has ended by an error. It is removed when the run continues; checkpoints do
  // not count it, so that they stay usable after that.
  void extra_frame(const run::Run& run);
  void go_on();
  virtual std::vector<std::string> lost() const { return {}; }  // files missing when the series was continued
  bool failed() const { return failed_; }                       // writing the last frame failed
  void forget(std::size_t step);  // no longer counts the frames after a step; their files stay
  void remove_forgotten() { cut(steps_.size()); }
  virtual void sync() = 0;  // forces the files to the disk
  // Archives the state of the series, for a program that continues it.
  void keep(Archive& archive);

 protected:
  // from: the state of the series in the checkpoint of an earlier program; null: it is new.
  explicit Series(Archive* from) {
    if (from != nullptr) (*from)(steps_);
  }
  std::size_t frames() const { return steps_.size(); }
  virtual void write(const run::Run& run) = 0;
  virtual void cut(std::size_t frames) = 0;                           // keeps only the first ones
  virtual void keep_place(Archive& archive, std::size_t frames) = 0;  // of the first ones

 private:
  std::vector<std::size_t> steps_;  // the steps of the frames
  bool extra_ = false;              // whether the last frame is an extra one
  bool failed_ = false;
};

struct RecordColumn {
  std::string name;
  std::function<double(const Run&)> value;
  std::string unit = {};  // in the heading, after the name; empty: none
  double window = 0;      // s: a mean over the last steps; 0: the value at the row
};

// A table in CSV, a row per frame: the time and the values of the columns. Errors: a folder that cannot be
// written; two columns of one name; a table to be continued that has been changed.
std::shared_ptr<Series> make_table(const std::string& path, std::vector<RecordColumn> columns, Archive* from);
// A series for ParaView: a .vtu per frame, and the .pvd that lists them. Errors: as above.
std::shared_ptr<Series> make_vtk(const std::string& stem, VtkContents contents, Archive* from);

// A table or series of a run. Its frames are written by a hook of the run: at time 0, then each `every`
// seconds or step, among the deck's hooks in the order of declaration; and where a call ends.
struct Output final : Listener {
  Output(std::string kind_, std::string path_, std::string written_)
      : kind(std::move(kind_)), path(std::move(path_)), written(std::move(written_)) {}
  std::string kind, path, written;  // "record" or "vtk", as given, the file for run.json
  std::string file = {};            // its full path
  std::shared_ptr<Series> series = nullptr;
  std::size_t hook = 0;

  ListenerOrder turn() const override { return ListenerOrder::output; }
  void begin(Job&) override { series->go_on(); }
  void end(Job& job, const Ending& ending) override;
  void forget(Job& job) override;
  void restored(Job&) override { series->remove_forgotten(); }
  void sync() override { series->sync(); }
  void save(std::vector<Checkpoint::CheckpointPart>& parts) override;
};

}  // namespace fabricsh::run
