// Outputs that only one process writes at a time.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "system/gate.hpp"

namespace fabricsh::system {

// Locks of the operating system on one byte for each output in a file `.fabricsh.lock` beside them. They end
// with the process, however it ends, so that a file left behind by a killed one does no harm. Copies of a
// process (fork) share its locks.
class Locks {
 public:
  Locks() = default;
  Locks(Locks&&) = default;
  Locks& operator=(Locks&&) = default;

  // Held by this process, however often it takes it, until the last of the results is gone; then the lock
  // file is removed if nobody uses it. Null where the folder does not exist, cannot be written or knows no
  // locks. Error: another process has it.
  using Lock = std::shared_ptr<const void>;
  Lock take(const std::string& path);

 private:
  struct File;                                          // a lock file
  struct Byte;                                          // that of an output
  using Key = std::pair<std::uint64_t, std::uint64_t>;  // device and number of the lock file
  std::shared_ptr<File> file_beside(const std::string& path);

  std::map<Key, std::weak_ptr<File>> files_;
};

}  // namespace fabricsh::system
