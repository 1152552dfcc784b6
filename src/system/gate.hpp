// All file access that a deck can cause goes through this gate. By default it is open: whatever the operating
// system permits is permitted. Under --safe it is closed before the first line of the deck runs, and stays
// closed: reading only below some folders, writing only below one. It cannot be circumvented by "..", by
// links or by replacing a folder meanwhile, because each folder is opened inside its parent, not by its path.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fabricsh::system {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  // Writes all bytes. Returns 0 or the system's reason.
  int write(std::string_view bytes) const;

 private:
  int number_;
};

// A name inside an open folder, as the system's *at() calls take it. With the
// open gate the folder is the current one and the name is the whole path.
struct PathInFolder {
  Descriptor folder;
  std::string name;
  bool open_gate = true;
  int at() const;  // the folder's descriptor, or AT_FDCWD
  // A path for libraries that accept only paths; it leads through the open folder.
  std::string path() const;
  std::string path_of(const std::string& sibling) const;
  // The same place with `last` as the last component of its name.
  std::string sibling(const std::string& last) const;
};

// Opens a folder for writing, step by step: neither it nor, where the path begins in the current folder, a
// folder on the way may be a symbolic link, which whoever packed the current folder could have laid. make:
// missing folders are created. Error: a link, or the system's reason.
Descriptor plain_folder(const std::string& path, bool make);

class Gate {
 public:
  // The gate of this process: open until close_process() is called, which works once. It is global because a
  // limit on a deck must not depend on an argument that someone may forget to pass on; the limits of the
  // operating system (see wall.hpp) also belong to the process. This is the only mutable global in fabricsh.
  static const Gate& of_process();
  static void close_process(Gate gate);

  Gate() = default;
  // A closed gate, except for these folders, which must exist. `writable` may be empty: nothing
  // can be written. The writable folder is also readable. Error: a folder cannot be opened, or the writable
  // one is a link.
  Gate(const std::vector<std::string>& readable, const std::string& writable);

  bool closed() const { return closed_; }
  // The writable folder, absolute.
  const std::string& writable() const { return writable_.name; }

  // The place of a path for reading or for writing. `make`: missing folders on the way are
  // created. Error: the gate refuses the path, or a folder cannot be opened or created.
  PathInFolder reading(const std::string& path) const;
  PathInFolder writing(const std::string& path, bool make = false) const;

  // A regular file; anything else (a folder, a pipe, a device) is refused. Error: cannot read.
  Descriptor open(const std::string& path) const;
  // A file to be written in place; flags: O_WRONLY or O_RDWR, with O_CREAT, O_TRUNC and O_APPEND as needed.
  // A closed gate accepts only a regular file with a single name (no hard links). Error: cannot write.
  Descriptor open_to_write(const std::string& path, int flags) const;
  bool exists(const std::string& path) const;                       // and may be read
  std::vector<std::string> names(const std::string& folder) const;  // sorted
  void remove(const std::string& path) const;                       // a file or an empty folder
  bool discard(const std::string& path) const noexcept;  // a file; false: there was none, or it stays
  void rename(const std::string& from, const std::string& to) const;

 private:
  struct Root {
    std::string name;   // absolute, as given
    std::string real;   // without links
    Descriptor folder;  // opened once
  };
  static Root root_of(const std::string& folder);
  static Root plain_root_of(const std::string& folder);
  PathInFolder enter(const Root& root, const std::string& path, const std::string& below, bool make,
                     const char* what) const;

  bool closed_ = false;
  std::string current_;  // the current folder when the gate was made
  std::vector<Root> readable_;
  Root writable_;
};

}  // namespace fabricsh::system
