#include "law/provenance.hpp"

#include <algorithm>

#include "base/number.hpp"
#include "rheology/elements.hpp"

namespace fabricsh::law {

const std::vector<std::string>& provenance_fields() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {
        "bending",        "bending.twist",   "biaxial",   "density",      "rupture.warp",  "rupture.weft",
        "shear.loading",  "shear.unloading", "thickness", "warp.loading", "warp.loop",     "warp.poisson",
        "warp.unloading", "weft.loading",    "weft.loop", "weft.poisson", "weft.unloading"};
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

bool is_assumed(const card::Card& card, const std::string& field) {
  const auto& all = card.provenance;
  return std::any_of(all.begin(), all.end(), [&](const auto& origin) {
    return origin.first == field && origin.second.starts_with("assumed");
  });
}

void drop_ranges(card::Card& card) {
  std::erase_if(card.ranges, [&](const auto& range) { return !is_assumed(card, range.first); });
}

std::string range_text(const card::Card& card, const std::string& field) {
  for (const auto& [name, range] : card.ranges)
    if (name == field)
      return "; " + number(range[0]) + " to " + number(range[1]) +
             (field.ends_with(".poisson") ? "" : " times");
  return {};
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
