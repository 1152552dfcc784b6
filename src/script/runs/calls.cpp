#include "script/runs/calls.hpp"

#include <algorithm>

#include "base/number.hpp"

namespace fabricsh::script {

std::string Drive::words() const {
  switch (made) {
    case CallKind::advance:
      return "advance(" + exact_number(target) + ")";
    case CallKind::step:
      return "step()";
    case CallKind::reach:
      return "reach()";
    case CallKind::restore:
      return "restore()";
    default:
      return "solve()";
  }
}

bool Calls::restored_after(std::int64_t call) const {
  return std::any_of(made.begin() + std::min(call, static_cast<std::int64_t>(made.size())), made.end(),
                     [](const Drive& drive) { return drive.made == CallKind::restore; });
}

bool Notes::put(const std::string& key, std::string value) {
  const std::string* old = find(key);
  const std::size_t rest = bytes_ - (old != nullptr ? key.size() + old->size() : 0);
  const std::size_t wanted = key.size() + value.size();
  full_ = full_ || wanted > most_bytes || rest > most_bytes - wanted;
  if (full_) return false;
  bytes_ = rest + wanted;
  notes_[key] = std::move(value);
  return true;
}

void Notes::keep(Archive& archive) {
  std::vector<std::string> keys, values;
  for (const auto& [key, value] : notes_) {
    keys.push_back(key);
    values.push_back(value);
  }
  archive(keys, values, full_);
  if (!archive.reading()) return;
  if (keys.size() != values.size()) throw Error("what the deck has read is damaged");
  notes_.clear();
  bytes_ = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    bytes_ += keys[i].size() + values[i].size();
    notes_[keys[i]] = std::move(values[i]);
  }
}

}  // namespace fabricsh::script
