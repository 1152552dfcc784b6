// One Lua state with the fabric module, and what its bindings share. No globals: several may live side by
// side.
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
#include "script/call/entry.hpp"
#include "script/sandbox/limits.hpp"

namespace fabricsh::run {
struct Checkpoint;
struct Journal;
}  // namespace fabricsh::run

namespace fabricsh::script {

// How far a run is.
struct Progress {
  std::int64_t run = 0;           // its number in the session
  double time = 0, duration = 0;  // s, simulated
  std::size_t steps = 0;
  int iterations = 0;                    // of the last step; 0: it had none
  double elapsed = 0, remaining = -1;    // s, on the clock; negative: not known
  std::function<double()> ledger_error;  // takes a pass over the elements
};

struct Options {
  std::optional<SafeOptions> safe;  // --safe, with its limits
  bool check = false;               // validate everything, run nothing, write nothing
  bool quiet = false;               // no progress
  int threads = 0;                  // 0: OMP_NUM_THREADS, else all cores
  std::vector<std::string> command_line;
  std::vector<std::string> arguments = {};         // of the deck
  std::string deck;                                // path of the deck; empty: none
  std::function<void(const std::string&)> notice;  // a warning or notice, one line
  std::function<void(const Progress&)> progress;   // after steps, at most every 0.1 s
  std::function<void()> clear_progress;            // the deck may print now: a bar goes away
};

class Session {
 public:
  explicit Session(Options options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  static Session& of(lua_State* L);
  lua_State* lua() const { return main_; }
  // The state (main or coroutine) whose binding runs now: where callbacks are called.
  lua_State* active() const { return active_; }
  const Options& options() const { return options_; }
  Notices& notices() { return notices_; }
  Registry& registry() { return registry_; }
  // Null unless --safe.
  Limits* limits() { return limits_.get(); }
  // Is this a copy of the process that made the session?
  bool forked() const;
  // The hook of L as it stands while no interrupt asks for another: none, or the one that counts.
  void rest_hook(lua_State* L);

  // Asked for by Ctrl-C; a running analysis stops at its next committed step. Safe in a signal handler.
  void interrupt() { interrupted_ = true; }
  // SIGTERM or SIGHUP: the program is to end; no run goes on after it. Safe in a signal handler too.
  void terminate(int signal) {
    terminated_ = signal;
    interrupt();
  }
  // The signal's number; 0: none came.
  int terminated() const { return terminated_; }
  bool take_interrupt() { return interrupted_.exchange(false); }
  bool interrupted() const { return interrupted_; }
  // While a run is driven, Ctrl-C is for the run, which answers after its step; not for its hooks.
  bool drives() const { return drives_ > 0; }
  void count_drive(int by) { drives_ += by; }
  // Has Ctrl-C ended something in this session?
  void set_stopped_by_interrupt() { stopped_by_interrupt_ = true; }
  bool stopped_by_interrupt() const { return stopped_by_interrupt_; }

  // Analyses are numbered from 1; one of them may begin from a checkpoint.
  std::int64_t count_analysis() { return ++analyses_; }
  void restart_from(std::shared_ptr<const run::Checkpoint> checkpoint) { restart_ = std::move(checkpoint); }
  const std::shared_ptr<const run::Checkpoint>& restart() const { return restart_; }
  std::int64_t analyses() const { return analyses_; }
  // What its runs share.
  const std::shared_ptr<run::Journal>& journal() const { return journal_; }
  // May the object (a mesh, model or run of the core) not change now? See Still.
  bool is_still(const void* object) const {
    const auto found = still_.find(object);
    return found != still_.end() && found->second > 0;
  }

 private:
  friend class ActiveState;
  friend class Still;
  friend class Free;
  void open_libraries();
  const int process_;
  Options options_;
  Notices notices_;
  Registry registry_;
  std::unique_ptr<Limits> limits_;  // outlives the state, whose allocator it is
  lua_State* main_ = nullptr;
  lua_State* active_ = nullptr;
  std::atomic<bool> interrupted_{false};
  std::atomic<int> terminated_{0};
  bool stopped_by_interrupt_ = false;
  int drives_ = 0;
  std::int64_t analyses_ = 0;
  std::shared_ptr<const run::Checkpoint> restart_;
  std::shared_ptr<run::Journal> journal_;
  std::map<const void*, int> still_;
};

// As long as it lives, calls that change the object are refused: it is being walked through, and functions of
// the deck's are asked for values meanwhile.
class Still {
 public:
  Still(Session& session, const void* object) : session_(session), object_(object) {
    ++session_.still_[object_];
  }
  ~Still() {
    if (--session_.still_[object_] == 0) session_.still_.erase(object_);
  }
  Still(const Still&) = delete;
  Still& operator=(const Still&) = delete;

 private:
  Session& session_;
  const void* object_;
};

// As long as it lives, the object may change again: a hook of its runs, at a moment that is fit for it.
class Free {
 public:
  Free(Session& session, const void* object) : session_(session), object_(object) {
    std::swap(before_, session_.still_[object_]);
  }
  ~Free() { session_.still_[object_] = before_; }
  Free(const Free&) = delete;
  Free& operator=(const Free&) = delete;

 private:
  Session& session_;
  const void* object_;
  int before_ = 0;
};

// Marks L as the state whose binding runs, as long as it lives.
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

// "deck.lua:12: " of the innermost Lua line that the user wrote (not one of lua/fabric), or empty.
std::string position(lua_State* L);

// Registry key of the report of the last numerical failure.
inline constexpr const char* why_key = "fabricsh.why";

// Pushes the function of a row that the registry keeps.
void push_function(lua_State* L, const Entry& entry);
// The row of the function at index; null when it is none of the registry's.
const Entry* entry_of(lua_State* L, int index);
// Does the work in a protected call of the active state. An error of Lua's becomes a Raised, which enter()
// raises again; caught without that, it would leave Lua's stack where it was raised.
void in_protected_call(Session& session, const std::function<void()>& work);

// An error of Lua's on its way through C++.
class Raised : public std::exception {
 public:
  // Of the value on top of the stack, which is popped.
  Raised(Session& session, lua_State* L);
  void push(lua_State* L) const;
  const char* what() const noexcept override { return "an error in a hook"; }

 private:
  std::shared_ptr<const int> reference_;
};

// Puts the function of such a row where its name says.
void place(lua_State* L, const Entry& entry);

// Makes an unknown field of the table on top of the stack an error that names the nearest known one.
void watch_module(lua_State* L, const std::string& name);

// Puts every row where its name says: functions into the table `fabric` (below the registry key "fabric"),
// methods and properties into their class.
void install(Session& session, std::vector<Entry> entries);

// A reference to a Lua function that C++ keeps; copies share it. Called on the state that is active then.
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
