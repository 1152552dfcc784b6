#include "script/warning_log.hpp"

#include <algorithm>

#include "script/bind/rooms.hpp"

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

WarningLog::Warnings WarningLog::since(Place place) const {
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

std::string WarningLog::packed_since(Place place) const {
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

void push_warnings(lua_State* L, const WarningLog::Warnings& warnings) {
  lua_createtable(L, static_cast<int>(warnings.size()), 0);
  lua_Integer place = 0;
  for (const run::Warning& w : warnings) {
    lua_createtable(L, 0, 5);
    set_text(L, "code", w.code);
    set_text(L, "text", w.text);
    set_number(L, "time", w.time);
    if (w.element >= 0) {
      lua_pushinteger(L, w.element + 1);
      lua_setfield(L, -2, "element");
    }
    lua_pushboolean(L, w.serious ? 1 : 0);
    lua_setfield(L, -2, "serious");
    lua_rawseti(L, -2, ++place);
  }
}

}  // namespace fabricsh::script
