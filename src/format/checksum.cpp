#include "format/checksum.hpp"

#include <zlib.h>

namespace fabricsh::format {

std::uint32_t checksum(std::string_view bytes, std::uint32_t so_far) {
  return static_cast<std::uint32_t>(
      crc32_z(so_far, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace fabricsh::format
