#include "script/session/warning_log.hpp"

#include <algorithm>

#include "base/archive.hpp"

namespace fabricsh::script {

void WarningLog::add(run::Warning warning) {
  if (lists_.size() > last_place_ && lists_.back()->size() == 1 &&
      lists_.back()->front().text == warning.text)
    return;
  lists_.push_back(std::make_shared<const Warnings>(1, std::move(warning)));
}

void WarningLog::add(std::shared_ptr<const Warnings> of_run) {
  lists_.push_back(std::move(of_run));
  ++runs_;
}

WarningLog::Warnings WarningLog::since(LogPosition place) const {
  Warnings all;
  const auto is_there = [&all](const run::Warning& w) {
    return std::any_of(all.begin(), all.end(),
                       [&](const run::Warning& v) { return v.code == w.code && v.text == w.text; });
  };
  for (std::size_t i = place.lists; i < lists_.size(); ++i)
    for (const run::Warning& w : *lists_[i])
      if (!is_there(w)) all.push_back(w);
  return all;
}

std::string WarningLog::packed_since(LogPosition place) const {
  Archive archive;
  Warnings warnings = since(place);
  bool ran = ran_since(place);
  archive(warnings, ran);
  return archive.bytes();
}

void WarningLog::adopt(const std::string& packed) {
  if (packed.empty()) return;
  Archive archive(packed);
  Warnings warnings;
  bool ran = false;
  archive(warnings, ran);
  lists_.push_back(std::make_shared<const Warnings>(std::move(warnings)));
  runs_ += ran ? 1 : 0;
}

}  // namespace fabricsh::script
