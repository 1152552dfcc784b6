// The reference geometry of the batches. Batches with the same numbers, as in a regular sheet, share one
// copy: that saves memory, and the copy stays in the cache.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <deque>
#include <span>
#include <unordered_map>

#include "mechanics/batch.hpp"
#include "simd/aligned.hpp"

namespace fabricsh::mechanics {

class GeometryStore {
 public:
  // Stored geometry of a batch. The numbers keep their address as long as the store exists.
  struct StoredBatch {
    const double* numbers;
    element::Sharing sharing;
  };

  // The stored copy of the numbers of a batch of this kind and section, whole lines of lanes. find_sharing()
  // is called for numbers that are new.
  template <class FindSharing>
  StoredBatch keep(const Batch& batch, std::span<const double> numbers, FindSharing find_sharing) {
    const auto [first, last] = known_.equal_range(hash(numbers));
    for (auto i = first; i != last; ++i)
      if (i->second.kind == batch.kind &&
          std::memcmp(i->second.entry.numbers, numbers.data(), numbers.size_bytes()) == 0)
        return i->second.entry;
    const Known added{batch.kind, {store(numbers), find_sharing()}};
    known_.emplace(hash(numbers), added);
    return added.entry;
  }
  // To be called after the last batch: frees what is only needed to find copies.
  void finish() { known_ = {}; }

 private:
  struct Known {
    const BatchKind* kind;  // of a region, and so of a section
    StoredBatch entry;
  };

  static std::uint64_t hash(std::span<const double> numbers) {
    std::array<std::uint64_t, lanes> h{};
    for (std::size_t i = 0; i < numbers.size(); i += lanes)
      for (std::size_t l = 0; l < lanes; ++l)
        h[l] = (std::rotl(h[l], 29) ^ std::bit_cast<std::uint64_t>(numbers[i + l])) * 0x9E3779B97F4A7C15u;
    std::uint64_t all = 0;
    for (const std::uint64_t one : h) all = (std::rotl(all, 29) ^ one) * 0x9E3779B97F4A7C15u;
    return all ^ all >> 32;
  }

  const double* store(std::span<const double> numbers) {
    constexpr std::size_t block = 1u << 20;  // numbers
    if (blocks_.empty() || blocks_.back().size() - used_ < numbers.size()) {
      blocks_.emplace_back(std::max(block, numbers.size()));
      used_ = 0;
    }
    double* const place = blocks_.back().data() + used_;
    std::copy(numbers.begin(), numbers.end(), place);
    used_ += numbers.size();
    return place;
  }

  std::deque<LineVector> blocks_;
  std::size_t used_ = 0;  // numbers of the last block
  std::unordered_multimap<std::uint64_t, Known> known_;
};

}  // namespace fabricsh::mechanics
