#include <sys/stat.h>

#include "message_of.hpp"
#include "scratch.hpp"
#include "system/atomic.hpp"

using namespace fabricsh;
using namespace fabricsh::system;
using Names = std::set<std::string>;

TEST_CASE("a whole file appears, with its folders, and nothing beside it", "[files]") {
  const ScratchFolder folder;
  write_file(folder / "a/b/c.txt", "hello\n");
  CHECK(content_of(folder / "a/b/c.txt") == "hello\n");
  CHECK(folder.listing() == Names{"a", "a/b", "a/b/c.txt"});
  write_file(folder / "a/b/c.txt", "", Sync::no);
  CHECK(content_of(folder / "a/b/c.txt").empty());
}

TEST_CASE("a new file has the permissions that any program gives", "[files]") {
  const ScratchFolder folder;
  write_file(folder / "ours", "x");
  std::ofstream(folder / "theirs") << "x";
  struct stat ours {
  }, theirs{};
  REQUIRE(stat((folder / "ours").c_str(), &ours) == 0);
  REQUIRE(stat((folder / "theirs").c_str(), &theirs) == 0);
  CHECK(ours.st_mode == theirs.st_mode);
}

TEST_CASE("without commit the old file stays", "[files]") {
  const ScratchFolder folder;
  write_file(folder / "x", "old");
  {
    const AtomicFile file(folder / "x");
    std::ofstream(file.temporary()) << "half";
    CHECK(folder.listing().size() == 2);
  }
  CHECK(content_of(folder / "x") == "old");
  CHECK(folder.listing() == Names{"x"});
}

TEST_CASE("a link is followed, not replaced", "[files]") {
  const ScratchFolder folder;
  write_file(folder / "real/x", "old");
  std::filesystem::create_symlink("real/x", folder / "link");
  write_file(folder / "link", "new");
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(content_of(folder / "real/x") == "new");
  std::filesystem::create_symlink("real/y", folder / "dangling");
  write_file(folder / "dangling", "made");
  CHECK(content_of(folder / "real/y") == "made");
}

TEST_CASE("a file that cannot be written says the path and the reason", "[files]") {
  const ScratchFolder folder;
  write_file(folder / "plain", "x");
  says(message_of([&] { write_file(folder / "plain/y.txt", ""); }), "plain");
  says(message_of([&] { write_file(folder / "plain/y.txt", ""); }), "Not a directory");
  std::filesystem::create_directory(folder / "sub");
  says(message_of([&] { write_file(folder / "sub", ""); }), "sub': Is a directory");
  says(message_of([&] { write_file(folder / "sub/", ""); }), "expected the name of a file");
  says(message_of([] { write_file("", ""); }), "expected the name of a file");
  says(message_of([] { write_file("/dev/null", ""); }), "'/dev/null': it is not a regular file");
  CHECK(message_of([] { write_file("/proc/nothing/x", ""); }) != "no error");
  CHECK(message_of([] {
          write_file("/proc/nothing.txt", "");
        }).starts_with("cannot write '/proc/nothing.txt': "));
  CHECK(folder.listing() == Names{"plain", "sub"});
}
