#include "law/provenance.hpp"

#include <algorithm>
#include <optional>

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

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::optional<std::pair<std::string, std::string>> origin_of_line(const std::string& line) {
  const auto colon = line.find(": ");
  if (colon == std::string::npos) return {};
  const auto& fields = provenance_fields();
  const std::string field = line.substr(0, colon), words = line.substr(colon + 2);
  if (std::find(fields.begin(), fields.end(), field) == fields.end() || !is_origin(words)) return {};
  return std::pair(field, words);
}

}  // namespace

Provenance provenance_of(const std::string& source) {
  Provenance out;
  for (const std::string& line : lines_of(source))
    if (auto pair = origin_of_line(line)) out.push_back(std::move(*pair));
  std::sort(out.begin(), out.end());
  return out;
}

std::string without_provenance(const std::string& source) {
  std::string out;
  bool first = true;
  for (const std::string& line : lines_of(source)) {
    if (origin_of_line(line)) continue;
    out += (first ? "" : "\n") + line;
    first = false;
  }
  return out;
}

std::string with_provenance(const std::string& words, const Provenance& provenance) {
  std::string out = without_provenance(words);
  for (const auto& [field, origin] : provenance) {
    std::string line = origin;
    std::replace(line.begin(), line.end(), '\n', ' ');
    out += "\n" + field + ": " + line;
  }
  return out;
}

}  // namespace fabricsh::law
