// A run with all its outputs: tables, series for ParaView, checkpoints, and a run.json that records their
// origin. Decks drive their runs through this class, and so can a program in C++:
//
//   run::Job job(std::make_shared<run::Static>(model, options, notices));
//   job.record("out/curve.csv", {{"force", [](const run::Run& r) { return r.reaction("top").y(); }, "N"}});
//   job.vtk("out/pull", 0.1);
//   job.checkpoint("out/run.ckpt", 0.5);
//   job.solve();
#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "format/json.hpp"
#include "run/keeper.hpp"
#include "run/series.hpp"
#include "system/lock.hpp"

namespace fabricsh::run {

class Job;

// Shared by the runs of one program or deck.
struct Journal {
  // Adds information on the program to run.json besides its version, and on the deck to a checkpoint; may be
  // empty.
  std::function<void(format::Json&)> about = {};
  std::function<void(Checkpoint&)> sign = {};
  // For each folder: the entries of its run.json, by the number of the run.
  std::map<std::string, std::map<std::int64_t, format::Json>> folders = {};
  // For finished runs that are to be kept: the file with a checkpoint of the end, to which the checkpoints of
  // the other runs refer.
  struct FinishedRun {
    std::string file;                     // full path
    std::optional<std::uint64_t> hash{};  // of its content; computed when it is first needed
  };
  std::map<std::int64_t, FinishedRun> finished = {};
  // Another run is about to write this file: a finished run whose checkpoint it is gets a file of its own.
  void make_way(const std::string& file, std::int64_t number);
  // The finished runs but for one, for a checkpoint in the folder. One whose file is gone is no longer kept.
  std::vector<Checkpoint::Finished> list_for(const std::string& folder, std::int64_t except);
  // Of the files that are being written.
  system::Locks locks = {};
};

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Job {
 public:
  explicit Job(std::shared_ptr<Run> run, std::shared_ptr<Journal> journal = std::make_shared<Journal>(),
               std::int64_t number = 1);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  Run& run() const { return *run_; }
  Journal& journal() const { return *journal_; }
  std::int64_t number() const { return number_; }
  double seconds() const { return seconds_ + (driving_ ? clock_.seconds() : 0); }  // s, spent in runs
  bool driving() const { return driving_; }

  // --- outputs. Folders are created. Errors: a path to which this run already writes, a folder that cannot
  // be written, an unknown field; when continuing from a checkpoint, an output that it does not have. every:
  // s between two rows or frames, and the run makes steps end at these times; 0: every step.
  void record(const std::string& path, const std::vector<RecordColumn>& columns, double every = 0);
  void vtk(const std::string& stem, double every = 0, const std::vector<std::string>& fields = {}) {
    vtk(stem, every, VtkContents{fields});
  }
  void vtk(const std::string& stem, double every, const VtkContents& contents);
  // every: s, 0: every step; does not shorten steps. By default every ten minutes of real time.
  std::shared_ptr<Keeper> checkpoint(const std::string& path, std::optional<double> every = {},
                                     std::optional<double> minutes = {});
  // Tells a further listener from now on, after those of its turn.
  void listen(const std::shared_ptr<Listener>& listener);
  template <class Event, class... Arguments>
  void notify(Event event, Arguments&&... arguments) {
    for (const auto& listener : listeners_) ((*listener).*event)(arguments...);
  }
  const std::vector<std::shared_ptr<Output>>& outputs() const { return outputs_; }
  const std::vector<std::shared_ptr<Keeper>>& keepers() const { return keepers_; }
  // Whether a new output may replace this one of the same kind and file. Default: if it failed.
  std::function<bool(const Output&)> replaceable = [](const Output& o) { return o.series->failed(); };

  // --- starting from a checkpoint, before outputs are declared. Errors: a checkpoint of another problem,
  // with the differences; outputs already declared.
  void restart(const std::string& path);
  void begin_from(std::shared_ptr<const Checkpoint> from);  // restored at the first step
  const std::shared_ptr<const Checkpoint>& from() const { return claims_.from(); }
  bool taken_up() const { return taken_up_; }
  void take_up();  // restores it now, if that has not been done
  Claims& claims() { return claims_; }

  // --- driving to the duration, or to a time. When the run ends or fails, its last state goes to outputs and
  // checkpoints, and run.json records how far it came. Errors are those of the run.
  void solve() { advance(run_->duration()); }
  void advance(double time);
  // The parts of advance(), for programs that drive the run themselves.
  void begin();
  // Each listener is called through `guarded`, which may catch its exceptions.
  using Guarded = std::function<void(const std::function<void()>&)>;
  void leave(const Ending& ending, const Guarded& guarded);
  Ending ending() const;  // of a call that no error has ended
  void remember_end();    // if the run is to be kept: in the checkpoints of other runs

  // A checkpoint of the present state, including the outputs.
  Checkpoint now();
  // Returns the data that the driving program stores in the checkpoints.
  std::function<std::string()> caller = {};
  // Called before rows and frames that may have to be made again: one that fails, or that of a run which an
  // error or a signal has ended. Returns what takes back their traces in data that checkpoints keep.
  std::function<std::function<void()>()> untraced = {};
  // Makes it, and takes back its traces if it failed or is an extra one.
  void frame(Series& series, bool extra);

 private:
  void add(std::shared_ptr<Output> output, double every,
           const std::function<std::shared_ptr<Series>(Archive* from)>& make);
  std::string free_path(const std::string& path) const;

  std::shared_ptr<Run> run_;
  std::shared_ptr<Journal> journal_;
  std::int64_t number_;
  std::vector<std::shared_ptr<Output>> outputs_;
  std::vector<std::shared_ptr<Keeper>> keepers_;
  std::vector<std::shared_ptr<Listener>> listeners_;  // these and others, by their turns
  std::set<std::string> paths_;                       // full paths of outputs and checkpoints
  std::vector<system::Locks::Lock> locks_;            // of these, until the run has ended
  Claims claims_;
  bool taken_up_ = false, driving_ = false;
  double seconds_ = 0;  // before the present call
  Clock clock_;         // since the present call began
};

}  // namespace fabricsh::run
