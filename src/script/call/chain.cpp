#include "script/call/chain.hpp"

#include <algorithm>
#include <cstring>

#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

constexpr int first_levels = 24, last_levels = 8;  // in a deep stack only so many at either end are listed

// Number of active calls, by bisection, because a call of lua_getstack takes time proportional to the level.
int depth(lua_State* L) {
  lua_Debug frame;
  int low = 1, high = 1;
  while (lua_getstack(L, high, &frame) != 0) {
    low = high;
    high *= 2;
  }
  while (low < high) {
    const int middle = (low + high) / 2;
    if (lua_getstack(L, middle, &frame) != 0)
      low = middle + 1;
    else
      high = middle;
  }
  return high;
}

// Whether the code was typed at the prompt or given by -e, so that its author has it in view.
bool typed(const lua_Debug& frame) {
  return std::strcmp(frame.what, "main") == 0 &&
         (std::strcmp(frame.source, "=prompt") == 0 || std::strcmp(frame.source, "=(command line)") == 0);
}

void add(lua_State* L, int level, std::vector<Caller>& all) {
  lua_Debug frame;
  if (lua_getstack(L, level, &frame) == 0) return;
  lua_getinfo(L, "Sln", &frame);
  if (frame.currentline <= 0 || own_module(frame.source) || typed(frame)) return;
  const char* file = frame.source[0] == '@' ? frame.source + 1 : frame.short_src;
  const bool named = std::strcmp(frame.what, "main") != 0 && frame.name != nullptr;
  all.push_back(
      {std::string(file) + ":" + std::to_string(frame.currentline) + ": ", named ? frame.name : ""});
}

}  // namespace

std::vector<Caller> callers(lua_State* L) {
  std::vector<Caller> all;
  const int levels = depth(L);
  const bool deep = levels > first_levels + last_levels;
  for (int level = 0; level < (deep ? first_levels : levels); ++level) add(L, level, all);
  if (!deep) return all;
  all.push_back({"", std::to_string(levels - first_levels - last_levels)});
  for (int level = levels - last_levels; level < levels; ++level) add(L, level, all);
  return all;
}

std::string chain_text(const std::string& message, const std::vector<Caller>& callers) {
  const auto said = std::find_if(callers.begin(), callers.end(), [&](const Caller& caller) {
    return !caller.place.empty() && message.starts_with(caller.place);
  });
  const bool known = said != callers.end();
  std::string text;
  for (auto caller = known ? said + 1 : callers.begin(); caller != callers.end(); ++caller) {
    if (caller->place.empty()) {
      text += "\n  ... " + caller->function + " calls more ...";
      continue;
    }
    text += !known && caller == callers.begin() ? "\n  at " : "\n  called from ";
    text += caller->place.substr(0, caller->place.size() - 2);
    if (!caller->function.empty()) text += ", in '" + caller->function + "'";
  }
  return text;
}

}  // namespace fabricsh::script
