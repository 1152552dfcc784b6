// The envelope of a checkpoint: what is in it is the business of who writes it.
//
//   "fabricsh checkpoint 2\n"  18 + 3 + 1 bytes: what the file is, and the version of its format
//   size                       8 bytes, of the content; numbers as the machine has them
//   checksum                   4 bytes, CRC-32 of the size and the content
//   content
#pragma once
#include <string>

namespace fabricsh::format {

// Replaces the file, synced to the disk before and after it gets its name: at any instant the old one or the
// new one is there, whole. Its folder must exist.
void write_checkpoint(const std::string& path, const std::string& content);

// Error, with path and reason: see read_file; no checkpoint, of another version, cut short, damaged.
std::string read_checkpoint(const std::string& path);

}  // namespace fabricsh::format
