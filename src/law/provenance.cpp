#include "law/provenance.hpp"

#include <algorithm>

#include "rheology/elements.hpp"

namespace fabricsh::law {

const std::vector<std::string>& provenance_fields() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {"bending",      "biaxial",       "density",         "rupture.warp",
                                    "rupture.weft", "shear.loading", "shear.unloading", "thickness",
                                    "warp.loading", "warp.loop",     "warp.poisson",    "warp.unloading",
                                    "weft.loading", "weft.loop",     "weft.poisson",    "weft.unloading"};
    rheology::for_each([&all](auto element, auto, auto) { all.emplace_back(element.name); });
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

const std::vector<std::string>& provenance_origins() {
  static const std::vector<std::string> words = {"fitted", "measured", "copied", "typed", "assumed"};
  return words;
}

bool is_origin(const std::string& words) {
  const auto& origins = provenance_origins();
  return std::any_of(origins.begin(), origins.end(),
                     [&](const std::string& origin) { return words.starts_with(origin); });
}

std::string line_of_origin(const std::string& source) {
  const auto& fields = provenance_fields();
  for (std::size_t from = 0; from <= source.size();) {
    const std::size_t end = std::min(source.find('\n', from), source.size());
    const std::string line = source.substr(from, end - from);
    const auto colon = line.find(": ");
    if (colon != std::string::npos && is_origin(line.substr(colon + 2)) &&
        std::find(fields.begin(), fields.end(), line.substr(0, colon)) != fields.end())
      return line;
    from = end + 1;
  }
  return {};
}

}  // namespace fabricsh::law
