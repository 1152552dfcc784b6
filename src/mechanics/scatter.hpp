// Numbers drawn by a seed and a place, the same whatever was drawn before; strengths that scatter.
#pragma once
#include <cmath>
#include <cstdint>

namespace fabricsh::mechanics {

// A number from 0 to 1, neither included, that depends on nothing but these three: the mixing steps of
// splitmix64 [steele2014].
inline double draw(std::uint64_t seed, std::int64_t place, int family) {
  std::uint64_t z = seed;
  for (const auto part : {static_cast<std::uint64_t>(place), static_cast<std::uint64_t>(family)}) {
    z += 0x9e3779b97f4a7c15u * (part + 1);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
  }
  return (static_cast<double>(z >> 12) + 0.5) * 0x1p-52;
}

// A strength over its mean, after Weibull; chance: a number from 0 to 1. size: a factor for the size.
inline double weibull_strength(double modulus, double chance, double size = 1) {
  return size * std::pow(-std::log(chance), 1 / modulus) / std::tgamma(1 + 1 / modulus);
}

}  // namespace fabricsh::mechanics
