// A run with all that it writes: tables, series for ParaView, checkpoints and a run.json that says what made
// them. Decks drive their runs by this, and so can a program in C++:
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
#include "run/checkpoint.hpp"
#include "run/series.hpp"
#include "run/table_series.hpp"

namespace fabricsh::run {

class Job;

// What the runs of one program or deck share.
struct Journal {
  // What run.json says of the program besides its version, and what a checkpoint says of the deck; may be
  // empty.
  std::function<void(format::Json&)> about = {};
  std::function<void(Checkpoint&)> sign = {};
  // What the run.json of each folder says of the runs that write there, by their numbers.
  std::map<std::string, std::map<std::int64_t, format::Json>> folders = {};
  // Of runs that are finished and were kept: a checkpoint of their end, as bytes, which goes into those of
  // the other runs.
  std::map<std::int64_t, std::string> finished = {};
};

// A table or series of a run's.
struct Output {
  std::string kind, path;  // "record" or "vtk", as given
  std::string file;        // its full path
  std::shared_ptr<Series> series;
  std::size_t hook = 0;  // that writes it
};

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Writes a checkpoint of a run as often as it is asked for.
class Keeper {
 public:
  // every: s of simulated time, 0: every step; minutes of time on the clock; at least one of them.
  Keeper(Job& job, std::string path, std::optional<double> every, std::optional<double> minutes);
  // What else goes into the checkpoint under this one's path, asked for each time.
  void keep_also(std::function<void(std::vector<Checkpoint::Part>&)> parts) { also_ = std::move(parts); }
  void add_parts(std::vector<Checkpoint::Part>& parts) const {
    if (also_) also_(parts);
  }
  const std::string& path() const { return path_; }
  void look();                      // after a step: writes where that is due
  void write();                     // Error: names the file and why
  void force() { forced_ = true; }  // at the next look
  // The file is another run's by now: only what is kept besides goes into the checkpoints of the others.
  void write_nothing() { silent_ = true; }

 private:
  bool due() const;
  Job& job_;
  std::string path_;
  std::optional<double> every_, minutes_;
  std::function<void(std::vector<Checkpoint::Part>&)> also_;
  double next_ = 0;  // s
  bool forced_ = false, silent_ = false;
  std::size_t written_ = static_cast<std::size_t>(-1);  // at that step
  std::chrono::steady_clock::time_point last_;
};

class Job {
 public:
  explicit Job(std::shared_ptr<Run> run, std::shared_ptr<Journal> journal = std::make_shared<Journal>(),
               std::int64_t number = 1);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  Run& run() const { return *run_; }
  const std::shared_ptr<Run>& run_pointer() const { return run_; }
  Journal& journal() const { return *journal_; }
  std::int64_t number() const { return number_; }
  double seconds() const { return seconds_ + (driving_ ? clock_.seconds() : 0); }  // spent in runs
  bool driving() const { return driving_; }

  // --- what it writes. Folders are made. Errors: a path that this run writes to already, a folder that can't
  // be written, an unknown field; where the run goes on from a checkpoint, an output that it doesn't have.
  // every: s between two rows or frames, on which the run then lands; 0: every step.
  void record(const std::string& path, const std::vector<Column>& columns, double every = 0);
  void vtk(const std::string& stem, double every = 0, const std::vector<std::string>& fields = {});
  // every: s, 0: every step; no step is made shorter for it. Without any: every ten minutes on the clock.
  std::shared_ptr<Keeper> checkpoint(const std::string& path, std::optional<double> every = {},
                                     std::optional<double> minutes = {});
  const std::vector<std::shared_ptr<Output>>& outputs() const { return outputs_; }
  const std::vector<std::shared_ptr<Keeper>>& keepers() const { return keepers_; }
  // An output of that kind and file whose place another may take. Default: one that was an error.
  std::function<bool(const Output&)> replaceable = [](const Output& o) { return o.series->in_trouble(); };

  // --- going on from a checkpoint; before its outputs are told. Errors: of another problem, with what
  // differs; outputs were told already.
  void restart(const std::string& path);
  void begin_from(std::shared_ptr<const Checkpoint> from);  // taken up with the first step
  const std::shared_ptr<const Checkpoint>& from() const { return claims_.from(); }
  bool taken_up() const { return taken_up_; }
  void take_up();  // where it has not been yet
  Claims& claims() { return claims_; }

  // --- driving: to the duration, to a time. Where the run ends or fails, the outputs and checkpoints get its
  // last state; run.json says how far it came. Errors are the run's own.
  void solve() { advance(run_->duration()); }
  void advance(double time);
  // The parts of that: who drives the run in another way calls them around it.
  void begin();
  // status: for run.json; ended: the outputs get the last state; broken: by an error, so that it goes away
  // when the run goes on. Each piece of work goes through `guarded`, which may keep what it throws.
  using Guarded = std::function<void(const std::function<void()>&)>;
  void leave(const std::string& status, bool ended, bool broken, const Guarded& guarded);
  void write_report(const std::string& status, double seconds);
  void remember_end();  // where it is kept: in the checkpoints of the other runs

  // The run as it is with what it writes, as a checkpoint.
  Checkpoint now();
  // What who drives the run keeps in its checkpoints.
  std::function<std::string()> caller = {};

 private:
  template <class Make, class Continue>
  void add(Output output, double every, const std::string& written, const Make& make,
           const Continue& continued);
  std::string free_path(const std::string& path) const;
  format::Json report(const std::string& status, double seconds) const;

  std::shared_ptr<Run> run_;
  std::shared_ptr<Journal> journal_;
  std::int64_t number_;
  std::vector<std::shared_ptr<Output>> outputs_;
  std::vector<std::shared_ptr<Keeper>> keepers_;
  std::vector<std::string> written_;  // paths of the outputs, for run.json
  std::set<std::string> paths_;       // full, of outputs and checkpoints
  Claims claims_;
  bool taken_up_ = false, driving_ = false;
  double seconds_ = 0;  // before the call under way
  Clock clock_;         // of that call
};

// The run in one object of run.json.
std::string hash_text(const std::string& bytes);  // "fnv1a64:...", as run.json tells files apart

}  // namespace fabricsh::run
