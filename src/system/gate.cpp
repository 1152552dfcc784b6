#include "system/gate.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "base/error.hpp"

namespace fabricsh::system {

namespace fs = std::filesystem;

namespace {

constexpr int folder_flags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

std::string reason_text(int reason) { return std::generic_category().message(reason); }

[[noreturn]] void cannot(const char* what, const std::string& path, const std::string& why) {
  throw Error(std::string("cannot ") + what + " '" + path.c_str() + "': " + why);
}

bool is_link(int folder, const std::string& name) {
  struct stat about {};
  return fstatat(folder, name.c_str(), &about, AT_SYMLINK_NOFOLLOW) == 0 && S_ISLNK(about.st_mode);
}

// The part of path below folder (both absolute and normalised); false if it lies elsewhere.
bool below(const std::string& path, const std::string& folder, std::string& rest) {
  if (path.compare(0, folder.size(), folder) != 0) return false;
  const bool whole = path.size() == folder.size(), at_root = folder == "/";
  if (!whole && !at_root && path[folder.size()] != '/') return false;
  rest = whole ? "" : path.substr(folder.size() + (at_root ? 0 : 1));
  return true;
}

// The path from the current folder; empty if the path does not lie below it.
fs::path from_here(const fs::path& path) {
  if (path.is_relative()) return path.lexically_normal();
  std::error_code code;
  std::string rest;
  const std::string whole = path.lexically_normal().string();
  const fs::path here = fs::current_path(code);
  const char* named = std::getenv("PWD");  // as the shell names it, where links lead to it
  for (const std::string& folder : {here.string(), std::string(named == nullptr ? "" : named)})
    if (!folder.empty() && folder != "/" && below(whole, folder, rest) && !rest.empty()) return rest;
  return {};
}

// Opens a folder inside of another by its bare name.
Descriptor step_into(const Descriptor& folder, const std::string& name, bool make, const std::string& path) {
  if (make && mkdirat(folder.number(), name.c_str(), 0777) != 0 && errno != EEXIST)
    cannot("make the folder", path, reason_text(errno));
  Descriptor next(openat(folder.number(), name.c_str(), folder_flags));
  const int reason = errno;
  if (!next.open() && is_link(folder.number(), name))
    cannot("write into", path, "'" + name + "' is a symbolic link, which --safe does not follow");
  if (!next.open()) cannot("open the folder", path, reason_text(reason));
  return next;
}

Gate& process_gate() {
  static Gate gate;
  return gate;
}

}  // namespace

Descriptor plain_folder(const std::string& path, bool make) {
  fs::path rest = from_here(path), start = ".";
  if (rest.empty()) {  // elsewhere: the folders on the way are the user's own, as links in the system's are
    fs::path whole = fs::path(path).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    start = whole.parent_path();
    rest = whole.filename();
    std::error_code code;
    if (make) fs::create_directories(start, code);
    if (code) cannot("make the folder", path, code.message());
  }
  Descriptor folder(::open(start.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!folder.open()) cannot("open the folder", path, reason_text(errno));
  for (const fs::path& part : rest)
    if (const std::string name = part.string(); !name.empty() && name != ".")
      folder = step_into(folder, name, make && name != "..", path);
  return folder;
}

int PathInFolder::at() const { return open_gate ? AT_FDCWD : folder.number(); }

std::string PathInFolder::path() const { return path_of(name); }

std::string PathInFolder::path_of(const std::string& sibling) const {
  return open_gate ? sibling : "/proc/self/fd/" + std::to_string(folder.number()) + "/" + sibling;
}

std::string PathInFolder::sibling(const std::string& last) const {
  const auto slash = name.rfind('/');
  return (slash == std::string::npos ? "" : name.substr(0, slash + 1)) + last;
}

const Gate& Gate::of_process() { return process_gate(); }

void Gate::close_process(Gate gate) {
  if (process_gate().closed_) throw std::logic_error("the gate is closed already");
  process_gate() = std::move(gate);
}

Gate::Root Gate::root_of(const std::string& folder) {
  Root root;
  root.name = fs::absolute(folder).lexically_normal().string();
  while (root.name.size() > 1 && root.name.back() == '/') root.name.pop_back();
  std::error_code code;
  root.real = fs::canonical(root.name, code).string();
  if (!code) root.folder = Descriptor(::open(root.real.c_str(), folder_flags));
  if (!root.folder.open()) cannot("open", folder, code ? code.message() : reason_text(errno));
  return root;
}

Gate::Root Gate::plain_root_of(const std::string& folder) {
  Root root;
  root.name = fs::absolute(folder).lexically_normal().string();
  while (root.name.size() > 1 && root.name.back() == '/') root.name.pop_back();
  root.folder = plain_folder(folder, false);
  std::error_code code;
  root.real = fs::canonical(fs::path(root.name).parent_path(), code)
                  .append(fs::path(root.name).filename().string())
                  .string();
  if (code) cannot("open", folder, code.message());
  return root;
}

Gate::Gate(const std::vector<std::string>& readable, const std::string& writable)
    : closed_(true), current_(fs::current_path().string()) {
  for (const std::string& folder : readable) readable_.push_back(root_of(folder));
  if (!writable.empty()) writable_ = plain_root_of(writable);
}

// Walks from the root folder by folder, opening each by its bare name inside the
// previous one. `rest` contains no ".." any more, and O_NOFOLLOW refuses a link in place
// of a folder, so replacing a folder during the walk cannot lead outside the root.
PathInFolder Gate::enter(const Root& root, const std::string& path, const std::string& rest, bool make,
                         const char* what) const {
  PathInFolder place{Descriptor(fcntl(root.folder.number(), F_DUPFD_CLOEXEC, 0)), "", false};
  std::size_t from = 0;
  for (std::size_t slash; (slash = rest.find('/', from)) != std::string::npos; from = slash + 1) {
    const std::string name = rest.substr(from, slash - from);
    if (name.empty()) continue;
    Descriptor next(openat(place.at(), name.c_str(), folder_flags));
    if (!next.open() && errno == ENOENT && make) {
      if (mkdirat(place.at(), name.c_str(), 0777) != 0 && errno != EEXIST)
        cannot(what, path, reason_text(errno));
      next = Descriptor(openat(place.at(), name.c_str(), folder_flags));
    }
    const int reason = errno;
    if (!next.open() && is_link(place.at(), name)) cannot(what, path, "--safe follows no symbolic link");
    if (!next.open()) cannot(what, path, reason_text(reason));
    place.folder = std::move(next);
  }
  place.name = rest.substr(from);
  if (place.name.empty()) place.name = ".";
  return place;
}

namespace {

// The system reads a name only up to a zero byte, while the checks here would see the whole text.
void check_name(const std::string& path, const char* what) {
  if (path.find('\0') != std::string::npos) cannot(what, path, "its name has a zero byte");
}

}  // namespace

PathInFolder Gate::reading(const std::string& path) const {
  check_name(path, "read");
  if (!closed_) return {Descriptor(), path, true};
  const std::string whole = (fs::path(current_) / path).lexically_normal().string();
  std::string rest;
  const auto inside = [&](const Root& root) {
    return root.folder.open() && (below(whole, root.name, rest) || below(whole, root.real, rest));
  };
  if (inside(writable_)) return enter(writable_, path, rest, false, "read");
  for (const Root& root : readable_)
    if (inside(root)) return enter(root, path, rest, false, "read");
  cannot("read", path,
         "--safe allows reading only in the deck's folder, the output folder and the program's own");
}

PathInFolder Gate::writing(const std::string& path, bool make) const {
  check_name(path, "write");
  if (!closed_) return {Descriptor(), path, true};
  const std::string whole = (fs::path(current_) / path).lexically_normal().string();
  std::string rest;
  if (!writable_.folder.open()) cannot("write", path, "--safe allows no writing here");
  if (!below(whole, writable_.name, rest) && !below(whole, writable_.real, rest))
    cannot("write", path, "--safe allows writing only below '" + writable_.name + "' (option --output)");
  return enter(writable_, path, rest, make, "write");
}

Descriptor Gate::open(const std::string& path) const {
  const PathInFolder place = reading(path);
  const int flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | (closed_ ? O_NOFOLLOW : 0);
  Descriptor file(openat(place.at(), place.name.c_str(), flags));
  if (!file.open() && errno == ELOOP && closed_) cannot("read", path, "--safe follows no symbolic link");
  if (!file.open()) cannot("read", path, errno == ENXIO ? "it is not a regular file" : reason_text(errno));
  struct stat about {};
  fstat(file.number(), &about);
  if (S_ISDIR(about.st_mode)) cannot("read", path, "it is a folder");
  if (!S_ISREG(about.st_mode)) cannot("read", path, "it is not a regular file");
  return file;
}

Descriptor Gate::open_to_write(const std::string& path, int flags) const {
  const PathInFolder place = writing(path);
  if (!closed_) {
    Descriptor file(::open(path.c_str(), flags | O_CLOEXEC, 0666));
    if (!file.open()) cannot("write", path, reason_text(errno));
    return file;
  }
  // The file is truncated only after its kind has been checked.
  const int careful = (flags & ~O_TRUNC) | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  Descriptor file(openat(place.at(), place.name.c_str(), careful, 0666));
  if (!file.open() && errno == ELOOP) cannot("write", path, "--safe follows no symbolic link");
  if (!file.open()) cannot("write", path, errno == ENXIO ? "it is not a regular file" : reason_text(errno));
  struct stat about {};
  fstat(file.number(), &about);
  if (!S_ISREG(about.st_mode)) cannot("write", path, "it is not a regular file");
  if (about.st_nlink > 1) cannot("write", path, "the file has another name elsewhere (a hard link)");
  if ((flags & O_TRUNC) != 0 && ftruncate(file.number(), 0) != 0) cannot("write", path, reason_text(errno));
  return file;
}

bool Gate::exists(const std::string& path) const {
  try {
    const PathInFolder place = reading(path);
    return faccessat(place.at(), place.name.c_str(), F_OK, closed_ ? AT_SYMLINK_NOFOLLOW : 0) == 0;
  } catch (const Error&) {
    return false;
  }
}

std::vector<std::string> Gate::names(const std::string& folder) const {
  const PathInFolder place = reading(folder.ends_with("/") ? folder : folder + "/");
  const int flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC | (closed_ ? O_NOFOLLOW : 0);
  const int number = openat(place.at(), place.name.c_str(), flags);
  const std::unique_ptr<DIR, int (*)(DIR*)> list(number < 0 ? nullptr : fdopendir(number), closedir);
  if (!list) cannot("read the folder", folder, reason_text(errno));
  std::vector<std::string> names;
  while (const dirent* entry = readdir(list.get()))
    if (const std::string name = entry->d_name; name != "." && name != "..") names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

void Gate::remove(const std::string& path) const {
  const PathInFolder place = writing(path);
  if (unlinkat(place.at(), place.name.c_str(), 0) == 0) return;
  const int reason = errno;
  if ((reason != EISDIR && reason != EPERM) || unlinkat(place.at(), place.name.c_str(), AT_REMOVEDIR) != 0)
    cannot("remove", path, reason_text(reason == EISDIR || reason == EPERM ? errno : reason));
}

bool Gate::discard(const std::string& path) const noexcept {
  try {
    const PathInFolder place = writing(path);
    return unlinkat(place.at(), place.name.c_str(), 0) == 0;
  } catch (const std::exception&) {
    return false;
  }
}

void Gate::rename(const std::string& from, const std::string& to) const {
  const PathInFolder old_place = writing(from), new_place = writing(to);
  if (renameat(old_place.at(), old_place.name.c_str(), new_place.at(), new_place.name.c_str()) != 0)
    cannot("rename", from, reason_text(errno));
}

}  // namespace fabricsh::system
