#include "script/session/session.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "base/hash.hpp"
#include "script/session/warning_log.hpp"

namespace fabricsh::script {

namespace {

// --- Warnings of processes that run in parallel.

// Hashes of the texts that were shown, in memory shared by a process and its copies: initially zeros, only
// ever filled. Without that memory, or if it is full, a text counts as not shown yet.
class Said {
 public:
  Said() {
    void* pages = mmap(nullptr, sizeof(Slots), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (pages != MAP_FAILED) slots_ = static_cast<Slots*>(pages);
  }
  ~Said() {
    if (slots_ != nullptr) munmap(slots_, sizeof(Slots));
  }
  Said(const Said&) = delete;
  Said& operator=(const Said&) = delete;

  bool holds(const std::string& text) const { return find(text, false); }
  // Adds the text; true if it was present already.
  bool held(const std::string& text) { return find(text, true); }

 private:
  static constexpr std::size_t kSlots = 4096;
  using Slots = std::array<std::atomic<std::uint64_t>, kSlots>;

  bool find(const std::string& text, bool add) const {
    const std::uint64_t wanted = std::max<std::uint64_t>(hash(text), 1);
    for (std::size_t i = 0; slots_ != nullptr && i < kSlots; ++i) {
      auto& slot = (*slots_)[(wanted + i) % kSlots];
      std::uint64_t there = slot.load();
      if (there == 0 && (!add || slot.compare_exchange_strong(there, wanted))) return false;
      if (there == wanted) return true;
    }
    return false;
  }

  Slots* slots_ = nullptr;
};

// A sink that shows a warning only once among all copies of this process and the process
// itself. Needed because the cases of a study, each computed in a copy, all warn of the same
// card.
Notices::Sink said_once_by_copies(Notices::Sink sink) {
  if (!sink) return sink;
  return
      [sink = std::move(sink), said = std::make_shared<Said>(), process = getpid()](const std::string& text) {
        const bool warning = text.starts_with("warning: ");
        const bool known = warning && (getpid() == process ? said->holds(text) : said->held(text));
        if (!known) sink(text);
      };
}

// --- The session.

// The sink as long as the log shows what is said. The log is created after the notices.
Notices::Sink while_shown(Notices::Sink sink, const std::unique_ptr<WarningLog>& log) {
  if (!sink) return sink;
  return [sink = std::move(sink), &log](const std::string& text) {
    if (log->shows()) sink(text);
  };
}

}  // namespace

Session::Session(SessionOptions options)
    : process_(getpid()),
      options_(std::move(options)),
      notices_(while_shown(said_once_by_copies(options_.notice), log_), options_.quiet),
      log_(std::make_unique<WarningLog>()) {
  main_ = luaL_newstate();
  if (main_ == nullptr) throw std::bad_alloc();
  active_ = main_;
  *static_cast<Session**>(lua_getextraspace(main_)) = this;
}

void Session::begin_limits() {
  limits_ = std::make_unique<Limits>(*options_.safe);
  limits_->watch(main_);
}

void Session::warn(const char* code, const std::string& text) {
  log_->add({code, text});
  notices_.once(text, "warning: " + text);
}

bool Session::forked() const { return getpid() != process_; }

void Session::rest_hook(lua_State* L) {
  if (limits_)
    limits_->rest_hook(L);
  else
    lua_sethook(L, nullptr, 0, 0);
}

Session::~Session() { lua_close(main_); }

Session& Session::of(lua_State* L) { return **static_cast<Session**>(lua_getextraspace(L)); }

namespace {

// Keeps a reference to the value on top of the stack and pops it. All holders are objects of the same state,
// so the reference does not outlive it.
std::shared_ptr<const int> reference_to_top(Session& session, lua_State* L) {
  const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
  return {new int(reference), [owner = &session](const int* r) {
            luaL_unref(owner->active(), LUA_REGISTRYINDEX, *r);
            delete r;
          }};
}

struct Work {
  const std::function<void()>& run;
  std::exception_ptr error = nullptr;
};

int run_work(lua_State* L) {
  auto& work = *static_cast<Work*>(lua_touserdata(L, 1));
  try {
    work.run();
  } catch (const std::exception&) {  // not Lua's own exception, which is not a std::exception
    work.error = std::current_exception();
  }
  return 0;
}

}  // namespace

Raised::Raised(Session& session, lua_State* L) : reference_(reference_to_top(session, L)) {}

void Raised::push(lua_State* L) const { lua_rawgeti(L, LUA_REGISTRYINDEX, *reference_); }

void in_protected_call(Session& session, const std::function<void()>& run) {
  lua_State* L = session.active();
  luaL_checkstack(L, 8, "too many nested callbacks");
  Work work{run};
  lua_pushcfunction(L, run_work);
  lua_pushlightuserdata(L, &work);
  if (lua_pcall(L, 1, 0, 0) != LUA_OK) throw Raised(session, L);
  if (work.error) std::rethrow_exception(work.error);
}

Function::Function(Session& session, lua_State* L, int index) : session_(&session) {
  lua_pushvalue(L, index);
  handle_ = reference_to_top(session, L);
}

lua_State* Function::push() const {
  lua_State* L = session_->active();
  luaL_checkstack(L, 8, "too many nested callbacks");
  lua_rawgeti(L, LUA_REGISTRYINDEX, *handle_);
  return L;
}

}  // namespace fabricsh::script
