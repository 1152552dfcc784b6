// The one way to the disk for everything that a deck names. The gate of the process is open: what the system
// allows is allowed. Under --safe it is closed before the deck's first line, and stays so: reading only below
// some folders, writing only below one, and no way round by "..", links, or a folder that is swapped while a
// path is walked, since each folder is opened inside the one before it and never by its path again.
#pragma once
#include <string>
#include <vector>

#include "system/descriptor.hpp"

namespace fabricsh::system {

// A name inside an opened folder: what the *at() calls of the system take. Behind the open gate the folder is
// the current one and the name is the whole path.
struct Place {
  Descriptor folder;
  std::string name;
  bool open_gate = true;
  int at() const;  // the folder's number, or AT_FDCWD
  // A path for libraries that take nothing else; it leads through the opened folder.
  std::string path() const;
  std::string path_of(const std::string& sibling) const;
  // `name` with another last component.
  std::string sibling(const std::string& last) const;
};

class Gate {
 public:
  // The gate of this process, open until close_process() has been called, which works once: a limit that a
  // deck must not pass cannot be an argument that someone forgets to hand down, and the system's own limits
  // (see wall.hpp) are the process' as well. This is the one thing in fabricsh that is global and changes.
  static const Gate& of_process();
  static void close_process(Gate gate);

  Gate() = default;
  // Closed but for these folders, which must exist; `writable` may be empty: nothing is written. What is
  // writable is readable. Error: a folder cannot be opened.
  Gate(const std::vector<std::string>& readable, const std::string& writable);

  bool closed() const { return closed_; }
  // The writable folder, absolute.
  const std::string& writable() const { return writable_.name; }

  // Where path lies, for reading or for writing; `make`: missing folders on the way are made. Error: the gate
  // does not let it pass, or a folder cannot be opened or made.
  Place reading(const std::string& path) const;
  Place writing(const std::string& path, bool make = false) const;

  // A regular file; anything else (a folder, a pipe, a device) is refused. Error: cannot read.
  Descriptor open(const std::string& path) const;
  // A file to be written in place, flags O_WRONLY or O_RDWR with O_CREAT, O_TRUNC, O_APPEND as wanted. Behind
  // the closed gate a regular file with one name. Error: cannot write.
  Descriptor open_to_write(const std::string& path, int flags) const;
  bool exists(const std::string& path) const;                       // and may be read
  std::vector<std::string> names(const std::string& folder) const;  // sorted
  void remove(const std::string& path) const;                       // a file or an empty folder
  bool discard(const std::string& path) const noexcept;  // a file; false: it was not there, or stays
  void rename(const std::string& from, const std::string& to) const;

 private:
  struct Root {
    std::string name;   // absolute, as given
    std::string real;   // without links
    Descriptor folder;  // opened once
  };
  static Root root_of(const std::string& folder);
  Place enter(const Root& root, const std::string& path, const std::string& below, bool make,
              const char* what) const;

  bool closed_ = false;
  std::string current_;  // the current folder when the gate was made
  std::vector<Root> readable_;
  Root writable_;
};

}  // namespace fabricsh::system
