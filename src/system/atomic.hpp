// Files that are written whole: a reader sees the old file or the new one, never a part. The bytes go
// to a temporary file in the same folder, which is then renamed. Every error names path and reason.
#pragma once
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "system/gate.hpp"

namespace fabricsh::system {

// Whether the bytes are forced to the disk before the rename. A checkpoint must
// survive a power cut; a frame of a series need only survive the end of the program.
enum class Sync { no, yes };

// Whether a missing folder is created. A run creates the folders of its
// outputs once; if one disappears later, that is reported as an error.
enum class Folder { make, expect };

// Creates the folder of path and all its missing parents.
void make_folder_for(const std::string& path);

// Replaces the file at path, or leaves it intact. Follows links. Error: path is a folder or a device.
void write_file(const std::string& path, std::string_view content, Sync sync = Sync::yes,
                Folder folder = Folder::make);

// The same in steps: write to open(), or to temporary() if the writer wants a file name; then commit()
// renames the temporary file. Without commit() the temporary file is removed and the old file stays.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path, Folder folder = Folder::make);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  const std::string& temporary() const { return temporary_; }
  Descriptor open() const;  // the temporary file, empty
  // With Sync::yes the content is on the disk before the rename, and the new name is when this returns.
  void commit(Sync sync = Sync::yes);

 private:
  std::string path_;              // as given
  PathInFolder place_;            // of the target: what a link at path points to
  std::string part_, temporary_;  // the temporary file: its name in that place, and its path
};

// Forces a file that has been written to the disk.
void sync_file(const std::string& path);

// Removes temporary files left by killed programs, of files whose path begins with path_begin.
void remove_leftovers(const std::string& path_begin);

// A file that the system did not let be written, whatever the deck says: a full disk, a missing right.
class CannotWrite : public Error {
 public:
  using Error::Error;
};
// CannotWrite: "cannot write 'out/x.csv': No space left on device".
[[noreturn]] void cannot_write(const std::string& path, int reason);

}  // namespace fabricsh::system
