// The second wall by itself, without the gate before it: what the kernel refuses a process behind it.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "app/wall.hpp"
#include "catch.hpp"
#include "scratch.hpp"

namespace {

struct WalledFolder : fabricsh::ScratchFolder {
  WalledFolder() {
    for (const char* part : {"/deck", "/out", "/secret"}) std::filesystem::create_directory(path + part);
    for (const char* file : {"/deck/a", "/out/a", "/secret/a"}) std::ofstream(path + file) << "x";
  }
};

bool opens(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags, 0666);
  if (file >= 0) close(file);
  return file >= 0;
}

// The number of the first claim that does not hold, or 0. Runs in a process of its own behind the wall.
int behind(const std::string& at) {
  fabricsh::app::raise_wall({at + "/deck"}, at + "/out");
  const bool claims[] = {
      prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 1,
      opens(at + "/deck/a", O_RDONLY),
      !opens(at + "/deck/a", O_WRONLY),
      !opens(at + "/deck/new", O_WRONLY | O_CREAT),
      opens(at + "/out/a", O_RDWR | O_TRUNC),
      opens(at + "/out/new", O_WRONLY | O_CREAT),
      unlink((at + "/out/new").c_str()) == 0,
      !opens(at + "/secret/a", O_RDONLY),
      !opens(at + "/out/../secret/a", O_RDONLY),
      unlink((at + "/secret/a").c_str()) != 0,
      rename((at + "/out/a").c_str(), (at + "/secret/b").c_str()) != 0,
      symlink("/etc", (at + "/out/link").c_str()) != 0,
      mkfifo((at + "/out/pipe").c_str(), 0600) != 0,
      !opens("/etc/passwd", O_RDONLY),
      std::system("true") != 0,
  };
  for (int i = 0; i < static_cast<int>(std::size(claims)); ++i)
    if (!claims[i]) return i + 1;
  return 0;
}

}  // namespace

TEST_CASE("behind the wall there are the readable and the writable folder, no others, and no programs") {
  if (syscall(444, nullptr, 0, 1) < 1) {
    WARN("this kernel has no Landlock: the second wall is only no_new_privs here");
    return;
  }
  const WalledFolder folder;
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(behind(folder.path));
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
