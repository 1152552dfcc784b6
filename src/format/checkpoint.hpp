// The envelope of a checkpoint; its content is defined by the caller.
//
//   "fabricsh checkpoint 2\n"  18 + 3 + 1 bytes: what the file is, and the version of its format
//   size                       8 bytes, of the content; numbers as the machine has them
//   checksum                   4 bytes, CRC-32 of the size and the content
//   content
#pragma once
#include <string>

namespace fabricsh::format {

// Replaces the file and forces it to the disk before and after the rename, so that at
// any instant either the old or the new one exists, complete. Its folder must exist.
void write_checkpoint(const std::string& path, const std::string& content);

// Error, with path and reason: as read_file; not a checkpoint; another version; truncated; damaged.
std::string read_checkpoint(const std::string& path);

}  // namespace fabricsh::format
