// Where the numbers of a card come from. A card keeps it in its source, a line for each field behind the
// words that its maker wrote, so that it goes wherever the card goes and every release can read the file:
//
//   tables 7.1 to 7.3
//   warp.loading: fitted to 4 specimens, polynomial of degree 2
//   warp.unloading: assumed: 4 times the steepest tangent of the loading
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace fabricsh::law {

// Pairs of a field and words that begin with one of the origins; in the order of the fields' names.
using Provenance = std::vector<std::pair<std::string, std::string>>;

// Fields whose origin a card may tell, and how the words that tell it begin.
const std::vector<std::string>& provenance_fields();
const std::vector<std::string>& provenance_origins();
bool is_origin(const std::string& words);

// The lines of a source that tell of fields, and what is left without them.
Provenance provenance_of(const std::string& source);
std::string without_provenance(const std::string& source);
// The words of the maker with a line for each field.
std::string with_provenance(const std::string& words, const Provenance& provenance);

}  // namespace fabricsh::law
