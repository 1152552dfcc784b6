// The origin of the numbers of a card. It is part of the card's source text, one line per field
// after the author's own words, so that it stays with the card and every release can read the file:
//
//   tables 7.1 to 7.3
//   warp.loading: fitted to 4 specimens, polynomial of degree 2
//   warp.unloading: assumed: 4 times the steepest tangent of the loading
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace fabricsh::law {

// Pairs of a field and a text that begins with one of the origins, sorted by field.
using Provenance = std::vector<std::pair<std::string, std::string>>;

// The fields whose origin can be stated, and the words with which an origin begins.
const std::vector<std::string>& provenance_fields();
const std::vector<std::string>& provenance_origins();
bool is_origin(const std::string& words);

// The lines of a source that state origins, and the source without them.
Provenance provenance_of(const std::string& source);
std::string without_provenance(const std::string& source);
// The author's words, followed by one line for each field.
std::string with_provenance(const std::string& words, const Provenance& provenance);

}  // namespace fabricsh::law
