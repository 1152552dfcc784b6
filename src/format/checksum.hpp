// CRC-32 as in zip, PNG and gzip, computed by zlib. It finds every error of up to 32
// consecutive bits and all but one in 4e9 of the others: against accidents, not against intent.
#pragma once
#include <cstdint>
#include <string_view>

namespace fabricsh::format {

std::uint32_t checksum(std::string_view bytes, std::uint32_t so_far = 0);

}  // namespace fabricsh::format
