// Whole files, written so that a reader sees the old one or the new one and never a part: into a temporary
// file beside it, then renamed. Every error names the path and the system's reason.
#pragma once
#include <string>
#include <string_view>

#include "system/gate.hpp"

namespace fabricsh::system {

// Whether the bytes are forced to the disk before the rename: a checkpoint survives a power cut, a frame of a
// series need only survive the program.
enum class Sync { no, yes };

// Whether a folder that is missing is made. A run makes those of its outputs once; gone later, they are
// missed.
enum class Folder { make, expect };

// Makes the folder that path lies in, and those above it, where they are missing.
void make_folder_for(const std::string& path);

// Replaces the file at path, or leaves it as it was. A link is followed. Error: path is a folder or a device.
void write_file(const std::string& path, std::string_view content, Sync sync = Sync::yes,
                Folder folder = Folder::make);

// The same in steps: open() or, for a writer that wants a file name, temporary(); then commit() puts that in
// place. Without commit() the temporary file goes away and the old file stays.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path, Folder folder = Folder::make);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  const std::string& temporary() const { return temporary_; }
  Descriptor open() const;  // the temporary file, empty
  // Synced: the file is on the disk before it gets its name, and its name when this returns.
  void commit(Sync sync = Sync::yes);

 private:
  std::string path_;              // as given
  Place place_;                   // of the target: what a link at path points to
  std::string part_, temporary_;  // the file beside the target: its name in that place, and its path
};

// Forces a file that has been written to the disk.
void sync_file(const std::string& path);

// Takes away the temporary files that programs which were killed have left of the files whose path begins so.
void remove_leftovers(const std::string& path_begin);

// Error: "cannot write 'out/x.csv': No space left on device".
[[noreturn]] void cannot_write(const std::string& path, int reason);

}  // namespace fabricsh::system
