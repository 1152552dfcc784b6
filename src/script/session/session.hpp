// A Lua state and the data shared by its bindings. There are no globals, so several sessions may exist at the
// same time. The module fabric is opened by OpenSession (script/open/open_session.hpp).
#pragma once
#include <atomic>
#include <functional>
#include <lua.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/notice.hpp"
#include "script/session/collector.hpp"
#include "script/session/entry.hpp"
#include "script/session/limits.hpp"

namespace fabricsh::run {
struct Checkpoint;
struct Journal;
}  // namespace fabricsh::run

namespace fabricsh::script {

class WarningLog;

// The progress of a run.
struct RunProgress {
  std::int64_t run = 0;           // its number in the session
  double time = 0, duration = 0;  // s, simulated
  std::size_t steps = 0;
  int iterations = 0;                    // of the last step; 0: none
  double elapsed = 0, remaining = -1;    // s, real time; negative: not known
  std::function<double()> ledger_error;  // costs a pass over the elements
};

// The action of fabric.study on its cases.
struct StudyOptions {
  bool list = false;      // lists them
  std::int64_t only = 0;  // computes this one, from 1 on; 0: all
};

struct SessionOptions {
  std::optional<SafeOptions> safe;  // --safe, with its limits
  bool check = false;               // validate everything, but run and write nothing
  bool quiet = false;               // no progress
  bool strict = false;              // serious warnings of runs are errors
  StudyOptions study = {};
  int threads = 0;  // 0: OMP_NUM_THREADS, else all cores
  std::vector<std::string> command_line;
  std::vector<std::string> arguments = {};           // of the deck
  std::string deck;                                  // path of the deck; empty: none
  std::function<void(const std::string&)> notice;    // a warning or notice, one line
  std::function<void(const RunProgress&)> progress;  // after steps, at most every 0.1 s
  std::function<void()> clear_progress;              // called before the deck prints: removes a progress bar
};

class Session {
 public:
  explicit Session(SessionOptions options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  static Session& of(lua_State* L);
  lua_State* lua() const { return main_; }
  // The state (main or coroutine) whose binding is executing; callbacks are called on it.
  lua_State* active() const { return active_; }
  const SessionOptions& options() const { return options_; }
  Notices& notices() { return notices_; }
  // Says a warning that is not of a run, each text once, and logs it. code: see run/warnings.hpp.
  void warn(const char* code, const std::string& text);
  WarningLog& log() { return *log_; }
  Registry& registry() { return registry_; }
  Collector& collector() { return collector_; }
  // Null unless --safe.
  Limits* limits() { return limits_.get(); }
  // From now on the limits of --safe apply to the state.
  void begin_limits();
  // Whether this process is a copy of the one that created the session.
  bool forked() const;
  // Restores the hook of L when no interrupt is pending: none, or the counting one.
  void rest_hook(lua_State* L);

  // Called for Ctrl-C; a running analysis stops at its next committed step. Safe in signal handlers.
  void interrupt() { interrupted_ = true; }
  // Called for SIGTERM or SIGHUP: the program ends and no further run starts. Safe in signal handlers.
  void terminate(int signal) {
    terminated_ = signal;
    interrupt();
  }
  // The number of the signal; 0: none.
  int terminated() const { return terminated_; }
  bool take_interrupt() { return interrupted_.exchange(false); }
  bool interrupted() const { return interrupted_; }
  // While a run is driven, Ctrl-C stops the run after its step, and not its hooks.
  bool drives() const { return drives_ > 0; }
  void count_drive(int by) { drives_ += by; }
  // To be called when Ctrl-C has ended something: until the next input no further run starts, even if a pcall
  // has caught the first error.
  void call_off() { stopped_by_interrupt_ = called_off_ = true; }
  void begin_input() { called_off_ = false; }
  bool is_called_off() const { return called_off_; }
  bool stopped_by_interrupt() const { return stopped_by_interrupt_; }

  // Analyses are numbered from 1; one of them may start from a checkpoint.
  std::int64_t count_analysis() { return ++analyses_; }
  void restart_from(std::shared_ptr<const run::Checkpoint> checkpoint) { restart_ = std::move(checkpoint); }
  const std::shared_ptr<const run::Checkpoint>& restart() const { return restart_; }
  std::int64_t analyses() const { return analyses_; }
  // Shared by the runs of the session.
  const std::shared_ptr<run::Journal>& journal() const { return journal_; }
  void set_journal(std::shared_ptr<run::Journal> journal) { journal_ = std::move(journal); }
  // Makes every call of a binding, whose arguments have been checked.
  using Execute = int (*)(Call&);
  void set_execute(Execute execute) { execute_ = execute; }
  int execute(Call& call) const { return execute_(call); }
  // Whether the object (a mesh, model or run of the core) must not be changed at present. See Still.
  bool is_still(const void* object) const {
    const auto found = still_.find(object);
    return found != still_.end() && found->second > 0;
  }

 private:
  friend class ActiveState;
  friend class ChangeRefused;
  friend class ChangeAllowed;
  const int process_;
  SessionOptions options_;
  Notices notices_;
  std::unique_ptr<WarningLog> log_;
  Registry registry_;
  Collector collector_;
  std::unique_ptr<Limits> limits_;  // outlives the state, because it provides the allocator
  lua_State* main_ = nullptr;
  lua_State* active_ = nullptr;
  std::atomic<bool> interrupted_{false};
  std::atomic<int> terminated_{0};
  bool stopped_by_interrupt_ = false, called_off_ = false;
  int drives_ = 0;
  std::int64_t analyses_ = 0;
  std::shared_ptr<const run::Checkpoint> restart_;
  std::shared_ptr<run::Journal> journal_;
  Execute execute_ = nullptr;
  std::map<const void*, int> still_;
};

// While an object of this class exists, calls that change the given object are refused, because it is being
// traversed while functions of the deck are called.
class ChangeRefused {
 public:
  ChangeRefused(Session& session, const void* object) : session_(session), object_(object) {
    ++session_.still_[object_];
  }
  ~ChangeRefused() {
    if (--session_.still_[object_] == 0) session_.still_.erase(object_);
  }
  ChangeRefused(const ChangeRefused&) = delete;
  ChangeRefused& operator=(const ChangeRefused&) = delete;

 private:
  Session& session_;
  const void* object_;
};

// While an object of this class exists, the given object may be changed again: by a hook of its runs.
class ChangeAllowed {
 public:
  ChangeAllowed(Session& session, const void* object) : session_(session), object_(object) {
    std::swap(before_, session_.still_[object_]);
  }
  ~ChangeAllowed() { session_.still_[object_] = before_; }
  ChangeAllowed(const ChangeAllowed&) = delete;
  ChangeAllowed& operator=(const ChangeAllowed&) = delete;

 private:
  Session& session_;
  const void* object_;
  int before_ = 0;
};

// Marks L as the state whose binding is executing, for as long as it exists.
class ActiveState {
 public:
  ActiveState(Session& session, lua_State* L) : session_(session), before_(session.active_) {
    session_.active_ = L;
  }
  ~ActiveState() { session_.active_ = before_; }
  ActiveState(const ActiveState&) = delete;
  ActiveState& operator=(const ActiveState&) = delete;

 private:
  Session& session_;
  lua_State* before_;
};

// Does the work in a protected call of the active state. A Lua error becomes a Raised, which enter() raises
// again; caught without a protected call it would leave Lua's stack as it was at the error.
void in_protected_call(Session& session, const std::function<void()>& work);

// A Lua error on its way through C++.
class Raised : public std::exception {
 public:
  // Made from the value on top of the stack, which is popped.
  Raised(Session& session, lua_State* L);
  void push(lua_State* L) const;
  const char* what() const noexcept override { return "an error in a hook"; }

 private:
  std::shared_ptr<const int> reference_;
};

// A reference to a Lua function, shared by copies. The function is called on the state active then.
class Function {
 public:
  Function() = default;
  Function(Session& session, lua_State* L, int index);
  explicit operator bool() const { return handle_ != nullptr; }
  // Pushes the function on the active state and returns that state.
  lua_State* push() const;

 private:
  std::shared_ptr<const int> handle_;
  Session* session_ = nullptr;
};

}  // namespace fabricsh::script
