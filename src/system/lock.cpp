#include "system/lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "base/error.hpp"
#include "base/hash.hpp"

namespace fabricsh::system {

namespace {

constexpr const char* lock_name = ".fabricsh.lock";

// A byte that every process with an output in the folder shares, behind those of the outputs.
constexpr std::uint64_t users = std::uint64_t{1} << 62U;

std::uint64_t byte_of(const std::string& path) {
  return hash(std::filesystem::path(path).filename().string()) >> 2U;
}

// Locks a byte (F_RDLCK: shared, F_WRLCK: alone) or unlocks it. These locks belong to the open file, not to
// the process, so that closing another descriptor of the same file does not end them. Returns 0 or the
// system's reason.
int set_lock(const Descriptor& file, int kind, std::uint64_t byte) {
  struct flock lock {};
  lock.l_type = static_cast<short>(kind);
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(byte);
  lock.l_len = 1;
  return fcntl(file.number(), F_OFD_SETLK, &lock) == 0 ? 0 : errno;
}

bool is_taken(int reason) { return reason == EAGAIN || reason == EACCES; }

// Whether the name still leads to the open file, which another process may have removed meanwhile.
bool in_place(const PathInFolder& place, const Descriptor& file) {
  struct stat own {
  }, there{};
  return fstat(file.number(), &own) == 0 &&
         fstatat(place.at(), place.name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 &&
         own.st_dev == there.st_dev && own.st_ino == there.st_ino;
}

}  // namespace

struct Locks::Byte {
  Byte(std::shared_ptr<File> of, std::uint64_t byte) : file(std::move(of)), at(byte) {}
  Byte(const Byte&) = delete;
  Byte& operator=(const Byte&) = delete;
  ~Byte();
  const std::shared_ptr<File> file;
  const std::uint64_t at;
};

// A lock file of which this process is a user.
struct Locks::File {
  File(PathInFolder at, Descriptor open) : place(std::move(at)), file(std::move(open)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  // Whoever is the only user removes the file.
  ~File() {
    if (set_lock(file, F_WRLCK, users) == 0 && in_place(place, file))
      unlinkat(place.at(), place.name.c_str(), 0);
  }
  const PathInFolder place;
  const Descriptor file;
  std::map<std::uint64_t, std::weak_ptr<const Byte>> bytes;
};

Locks::Byte::~Byte() { set_lock(file->file, F_UNLCK, at); }

std::shared_ptr<Locks::File> Locks::file_beside(const std::string& path) {
  constexpr int tries = 1000;  // of a millisecond, each while another process removes the file
  for (int i = 0; i < tries; ++i) {
    PathInFolder place = Gate::of_process().writing(path);
    place.name = place.sibling(lock_name);
    constexpr int flags = O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC;
    Descriptor file(openat(place.at(), place.name.c_str(), flags, 0666));
    struct stat about {};
    if (!file.open() || fstat(file.number(), &about) != 0) return nullptr;
    std::weak_ptr<File>& known = files_[{about.st_dev, about.st_ino}];
    if (auto there = known.lock()) return there;
    const int reason = set_lock(file, F_RDLCK, users);
    if (reason != 0 && !is_taken(reason)) return nullptr;
    if (reason == 0 && in_place(place, file)) {
      auto opened = std::make_shared<File>(std::move(place), std::move(file));
      known = opened;
      return opened;
    }
    usleep(1000);
  }
  return nullptr;
}

Locks::Lock Locks::take(const std::string& path) {
  const std::shared_ptr<File> file = file_beside(path);
  if (file == nullptr) return nullptr;
  const std::uint64_t at = byte_of(path);
  std::weak_ptr<const Byte>& known = file->bytes[at];
  if (auto there = known.lock()) return there;
  const int reason = set_lock(file->file, F_WRLCK, at);
  if (is_taken(reason))
    throw Error("'" + path +
                "' is being written by another process: wait until that has ended, or write elsewhere");
  if (reason != 0) return nullptr;
  auto byte = std::make_shared<const Byte>(file, at);
  known = byte;
  return byte;
}

}  // namespace fabricsh::system
