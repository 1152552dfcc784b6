// What tells two models apart: a checkpoint of one is none of the other.
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

// Mesh, warp, thickness, supports, motions, loads, ties, velocities; not the cards. Histories are looked at
// at 33 times from 0 to the duration and at their kinks.
Fingerprint fingerprint(const Model& model, double duration);

// "the mesh (441 nodes and 400 elements there, 121 nodes and 100 elements here) and the supports"; empty:
// they are the same.
std::string difference(const Fingerprint& there, const Fingerprint& here);

}  // namespace fabricsh::model
