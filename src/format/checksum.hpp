// CRC-32 as zip, PNG and gzip have it, by zlib, which the grids' compression brings along: it finds every
// error of up to 32 bits in a row and all but one in 4e9 of the others. Against bad luck, not bad intent.
#pragma once
#include <cstdint>
#include <string_view>

namespace fabricsh::format {

std::uint32_t checksum(std::string_view bytes, std::uint32_t so_far = 0);

}  // namespace fabricsh::format
