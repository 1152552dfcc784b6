// FNV-1a, 64 bits: tells two cards, decks or models apart, no more.
#pragma once
#include <cstdint>
#include <string_view>

namespace fabricsh {

// `h`: a hash of what comes before, to go on from.
inline std::uint64_t hash(std::string_view bytes, std::uint64_t h = 14695981039346656037ull) {
  for (const char c : bytes) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return h;
}

}  // namespace fabricsh
