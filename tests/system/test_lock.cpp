// Outputs of one process at a time: against another process, after it was killed, and what is left behind.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "message_of.hpp"
#include "scratch.hpp"
#include "system/lock.hpp"

using namespace fabricsh;
using namespace fabricsh::system;
using Names = std::set<std::string>;

namespace {

// Another process that takes the paths, says so, and keeps them until it is told to end or killed.
class Other {
 public:
  explicit Other(const std::vector<std::string>& paths) {
    REQUIRE(pipe(said_) == 0);
    REQUIRE(pipe(told_) == 0);
    process_ = fork();
    if (process_ != 0) {
      char done = 0;
      REQUIRE(read(said_[0], &done, 1) == 1);
      took_all_ = done == 'y';
      return;
    }
    close(told_[1]);
    {
      Locks locks;
      std::vector<Locks::Lock> held;
      char done = 'y';
      for (const std::string& path : paths)
        if (message_of([&] { held.push_back(locks.take(path)); }) != "no error") done = 'n';
      if (write(said_[1], &done, 1) != 1) _exit(1);
      while (read(told_[0], &done, 1) > 0) continue;
    }
    _exit(0);
  }
  ~Other() { end(); }
  Other(const Other&) = delete;
  Other& operator=(const Other&) = delete;
  bool took_all() const { return took_all_; }
  void end(int signal = 0) {
    if (process_ < 0) return;
    if (signal != 0) ::kill(process_, signal);
    close(told_[1]);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }

 private:
  int said_[2] = {}, told_[2] = {};
  pid_t process_ = -1;
  bool took_all_ = false;
};

}  // namespace

TEST_CASE("an output that another process writes is refused until that has ended, the others are not",
          "[files]") {
  const ScratchFolder folder;
  Locks locks;
  Other other({folder / "a.csv", folder / "b.pvd"});
  REQUIRE(other.took_all());
  const std::string refusal = message_of([&] { locks.take(folder / "a.csv"); });
  says(refusal, "'" + (folder / "a.csv") + "' is being written by another process");
  CHECK(message_of([&] { locks.take(folder / "b.pvd"); }) != "no error");
  const auto mine = locks.take(folder / "c.csv");
  CHECK(mine != nullptr);
  CHECK_FALSE(Other({folder / "c.csv"}).took_all());
  other.end();
  CHECK(locks.take(folder / "a.csv") != nullptr);
}

TEST_CASE("a process that was killed leaves no lock", "[files]") {
  const ScratchFolder folder;
  Other other({folder / "a.csv"});
  REQUIRE(other.took_all());
  other.end(SIGKILL);
  CHECK(folder.listing() == Names{".fabricsh.lock"});
  {
    Locks locks;
    const auto mine = locks.take(folder / "a.csv");
    CHECK(mine != nullptr);
    CHECK_FALSE(Other({folder / "a.csv"}).took_all());
  }
  CHECK(folder.listing().empty());
}

TEST_CASE("a process takes what it has again, and keeps it as long as one of its users does", "[files]") {
  const ScratchFolder folder;
  Locks locks;
  auto first = locks.take(folder / "a.csv"), second = locks.take(folder / "a.csv");
  const auto third = locks.take(folder / "b.csv");
  first.reset();
  CHECK_FALSE(Other({folder / "a.csv"}).took_all());
  second.reset();
  CHECK(Other({folder / "a.csv"}).took_all());
  CHECK_FALSE(Other({folder / "b.csv"}).took_all());
  CHECK(folder.listing() == Names{".fabricsh.lock"});
}

TEST_CASE("where nothing can be locked nothing is", "[files]") {
  const ScratchFolder folder;
  Locks locks;
  CHECK(locks.take(folder / "no/such.csv") == nullptr);
  CHECK(locks.take("/proc/fabricsh.csv") == nullptr);
  CHECK(folder.listing().empty());
}

TEST_CASE("processes that take and leave by turns never have it together", "[files]") {
  const ScratchFolder folder;
  constexpr int processes = 4, turns = 200;
  for (int p = 0; p < processes; ++p) {
    if (fork() != 0) continue;
    Locks locks;
    for (int done = 0; done < turns;) {
      Locks::Lock lock;
      if (message_of([&] { lock = locks.take(folder / "a.csv"); }) != "no error") continue;
      const std::string path = folder / "inside";
      if (std::filesystem::exists(path)) _exit(1);
      std::ofstream(path) << p;
      std::filesystem::remove(path);
      ++done;
    }
    _exit(0);
  }
  int status = 0;
  for (int p = 0; p < processes; ++p) {
    REQUIRE(wait(&status) > 0);
    CHECK(status == 0);
  }
  CHECK(folder.listing().empty());
}
