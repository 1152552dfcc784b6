// FNV-1a, 64 bits: distinguishes cards, decks and models. It is not a cryptographic hash.
#pragma once
#include <cstdint>
#include <string_view>

namespace fabricsh {

// `h`: the hash of the preceding bytes, to continue from.
inline std::uint64_t hash(std::string_view bytes, std::uint64_t h = 14695981039346656037ull) {
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return h;
}

}  // namespace fabricsh
