#include <fcntl.h>
#include <sys/stat.h>

#include <filesystem>

#include "message_of.hpp"
#include "scratch.hpp"
#include "system/gate.hpp"

using namespace fabricsh;
using namespace fabricsh::system;
namespace fs = std::filesystem;

namespace {

struct Tree : ScratchFolder {
  Tree() {
    for (const char* name : {"deck/sub", "out", "secret"}) fs::create_directories(*this / name);
    for (const char* name : {"deck/a", "deck/sub/b", "out/c", "secret/s"})
      std::ofstream(*this / name) << name;
    fs::create_directory_symlink(*this / "secret", *this / "deck/way");
    fs::create_symlink(*this / "secret/s", *this / "deck/link");
    fs::create_directory_symlink(*this / "secret", *this / "out/way");
    fs::create_hard_link(*this / "secret/s", *this / "out/hard");
    mkfifo((*this / "deck/pipe").c_str(), 0600);
  }
  Gate gate() const { return Gate({*this / "deck"}, *this / "out"); }
};

}  // namespace

TEST_CASE("a closed gate reads below its folders only", "[files]") {
  const Tree tree;
  const Gate gate = tree.gate();
  for (const char* name :
       {"deck/a", "deck/sub/b", "deck/sub/../a", "deck/./sub//b", "out/c", "secret/../deck/a"})
    CHECK(gate.open(tree / name).open());
  for (const char* name : {"secret/s", "deck/../secret/s", "deck/way/../../secret/s", "deckx"})
    says(message_of([&] { gate.open(tree / name); }), "--safe allows reading only");
  for (const char* name : {"deck/way/s", "deck/link", "out/way/s"})
    says(message_of([&] { gate.open(tree / name); }), "follows no symbolic link");
  says(message_of([&] { gate.open(tree / "deck/pipe"); }), "not a regular file");
  says(message_of([&] { gate.open(tree / "deck/sub"); }), "it is a folder");
  says(message_of([&] { gate.open((tree / "deck/..") + std::string("\0/secret/s", 10)); }), "zero byte");
  CHECK(gate.names(tree / "deck/sub") == std::vector<std::string>{"b"});
  CHECK_FALSE(gate.exists(tree / "secret/s"));
}

TEST_CASE("a closed gate writes below one folder only", "[files]") {
  const Tree tree;
  const Gate gate = tree.gate();
  const int anew = O_WRONLY | O_CREAT | O_TRUNC;
  CHECK(gate.open_to_write(tree / "out/new", anew).open());
  CHECK(gate.writing(tree / "out/x/y/z", true).name == "z");
  CHECK(fs::is_directory(tree / "out/x/y"));
  for (const char* name : {"secret/s", "deck/a", "out/../secret/s"}) {
    says(message_of([&] { gate.open_to_write(tree / name, anew); }), "--safe allows writing only below");
    says(message_of([&] { gate.remove(tree / name); }), "--safe allows writing only below");
    says(message_of([&] { gate.rename(tree / "out/c", tree / name); }), "--safe allows writing only below");
  }
  says(message_of([&] { gate.open_to_write(tree / "out/way/s", anew); }), "follows no symbolic link");
  says(message_of([&] { gate.writing(tree / "out/way/new/x", true); }), "follows no symbolic link");
  says(message_of([&] { gate.open_to_write(tree / "out/hard", anew); }), "hard link");
  CHECK(content_of(tree / "secret/s") == "secret/s");
  gate.rename(tree / "out/c", tree / "out/d");
  gate.remove(tree / "out/d");
  CHECK_FALSE(gate.discard(tree / "out/d"));
  says(message_of([&] { Gate({tree / "deck"}, "").writing(tree / "deck/a"); }), "allows no writing");
  says(message_of([&] { Gate({tree / "none"}, ""); }), "cannot open");
}
