#include "system/atomic.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <system_error>

namespace fabricsh::system {

namespace fs = std::filesystem;

namespace {

std::string cause_text(int reason) { return std::generic_category().message(reason); }

// The file that path refers to after following links. Only a regular file may be replaced.
fs::path target_of(const std::string& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (fs::is_directory(status)) cannot_write(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Error("cannot write '" + path + "': it is not a regular file");
  if (!fs::is_symlink(path, code)) return path;
  return fs::exists(status) ? fs::canonical(path) : fs::path(path).parent_path() / fs::read_symlink(path);
}

// While the gate is closed a link is refused instead of followed.
void check_plain(const PathInFolder& place, const std::string& path) {
  struct stat about {};
  if (place.open_gate || fstatat(place.at(), place.name.c_str(), &about, AT_SYMLINK_NOFOLLOW) != 0) return;
  if (S_ISDIR(about.st_mode)) cannot_write(path, EISDIR);
  if (S_ISLNK(about.st_mode)) throw Error("cannot write '" + path + "': --safe follows no symbolic link");
  if (!S_ISREG(about.st_mode)) throw Error("cannot write '" + path + "': it is not a regular file");
}

// Creates an empty file beside the target under a new name; returns its name in that place.
std::string make_temporary(const PathInFolder& place, const std::string& path) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  for (int attempt = 0;; ++attempt) {
    const std::string tail = std::to_string(getpid()) + "-" + std::to_string(now + attempt) + ".part";
    const std::string name = place.sibling("." + fs::path(place.name).filename().string() + "." + tail);
    const Descriptor file(openat(place.at(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.open()) return name;
    if (errno != EEXIST || attempt == 100) cannot_write(path, errno);
  }
}

int sync_to_disk(const PathInFolder& place, const std::string& file) {
  const Descriptor opened(openat(place.at(), file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!opened.open() || fsync(opened.number()) != 0) return errno;
  return 0;
}

// Synchronises the directory entries to the disk; some file systems do not support that.
void sync_folder(const PathInFolder& place, const std::string& path) {
  const std::string folder = fs::path(place.name).parent_path().string();
  const int reason = sync_to_disk(place, folder.empty() ? "." : folder);
  if (reason != 0 && reason != EINVAL && place.open_gate) cannot_write(path, reason);
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

// The process number in ".name.PROCESS-NUMBER.part"; 0 for any file that is not one of ours.
pid_t writer_of(const std::string& name) {
  const std::string tail = ".part";
  if (!name.ends_with(tail)) return 0;
  const auto dot = name.rfind('.', name.size() - tail.size() - 1);
  pid_t process = 0;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + dot + 1, end, process);
  return error == std::errc() && stop != end && *stop == '-' ? process : 0;
}

}  // namespace

void cannot_write(const std::string& path, int reason) {
  throw CannotWrite("cannot write '" + path + "': " + cause_text(reason));
}

Descriptor::~Descriptor() {
  if (open()) close(number_);
}

int Descriptor::write(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t done = ::write(number_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return 0;
}

void make_folder_for(const std::string& path) {
  const Gate& gate = Gate::of_process();
  if (gate.closed()) return void(gate.writing(path, true));
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) throw Error("cannot make the folder '" + folder.string() + "': " + code.message());
  if (!fs::is_directory(folder, code)) throw Error("'" + folder.string() + "' is not a folder");
}

void sync_file(const std::string& path) {
  const Descriptor file = Gate::of_process().open(path);
  if (fsync(file.number()) != 0) cannot_write(path, errno);
}

void remove_leftovers(const std::string& path_begin) {
  const Gate& gate = Gate::of_process();
  const std::string folder = folder_of(path_begin);
  if (!gate.exists(folder)) return;
  const std::string begin = "." + fs::path(path_begin).filename().string();
  for (const std::string& name : gate.names(folder)) {
    const pid_t writer = name.starts_with(begin) ? writer_of(name) : 0;
    if (writer > 0 && kill(writer, 0) != 0 && errno == ESRCH) gate.discard(folder + "/" + name);
  }
}

AtomicFile::AtomicFile(const std::string& path, Folder folder) : path_(path) {
  if (path.empty() || path.back() == '/')
    throw Error("cannot write '" + path + "': expected the name of a file");
  const Gate& gate = Gate::of_process();
  const std::string target = gate.closed() ? path : target_of(path).string();
  if (folder == Folder::make) make_folder_for(target);
  place_ = gate.writing(target);
  check_plain(place_, path);
  part_ = make_temporary(place_, path);
  temporary_ = place_.path_of(part_);
}

AtomicFile::~AtomicFile() {
  if (!part_.empty()) unlinkat(place_.at(), part_.c_str(), 0);
}

Descriptor AtomicFile::open() const {
  Descriptor opened(openat(place_.at(), part_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (!opened.open()) cannot_write(path_, errno);
  return opened;
}

void AtomicFile::commit(Sync sync) {
  if (sync == Sync::yes)
    if (const int reason = sync_to_disk(place_, part_)) cannot_write(path_, reason);
  if (renameat(place_.at(), part_.c_str(), place_.at(), place_.name.c_str()) != 0) cannot_write(path_, errno);
  part_.clear();
  if (sync == Sync::yes) sync_folder(place_, path_);
}

void write_file(const std::string& path, std::string_view content, Sync sync, Folder folder) {
  AtomicFile file(path, folder);
  {
    const Descriptor opened = file.open();
    if (const int reason = opened.write(content)) cannot_write(path, reason);
  }
  file.commit(sync);
}

}  // namespace fabricsh::system
