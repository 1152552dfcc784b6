// Distinguishes models, so that a checkpoint is not restored into a different one.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

struct FingerprintPart {
  std::string name;  // "mesh"
  std::string text;  // for messages: "441 nodes and 400 elements"; may be empty
  std::uint64_t hash = 0;
  void keep(Archive& archive) { archive(name, text, hash); }
};
using Fingerprint = std::vector<FingerprintPart>;
// To be raised when the parts change, or what they cover: those of another edition cannot be compared.
inline constexpr int fingerprint_edition = 4;

// Covers mesh, regions, warp, thickness, supports, motions, loads, ties, velocities, rigid bodies and
// contacts, but not the cards.
// Histories are sampled at 33 times from 0 to the duration and at their kinks.
Fingerprint fingerprint(const Model& model, double duration);

// " of 'front.pocket'"; empty in a model of one region.
std::string of_region(const Model& model, const Region& region);

// "the mesh (441 nodes and 400 elements there, 121 nodes and 100 elements here) and the supports"; empty if
// the fingerprints are equal.
std::string difference(const Fingerprint& there, const Fingerprint& here);

}  // namespace fabricsh::model
