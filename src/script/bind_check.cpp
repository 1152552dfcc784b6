// card:check.
#include "fabric/check.hpp"
#include "script/bind_run.hpp"

namespace fabricsh::script {

namespace {

int report_text(lua_State* L) {
  lua_getfield(L, 1, "text");
  return 1;
}

void push_item(lua_State* L, const fabric::CheckItem& item) {
  lua_newtable(L);
  set_text(L, "key", item.key);
  set_text(L, "severity", fabric::name(item.severity));
  set_text(L, "text", item.text);
  lua_newtable(L);
  for (const auto& [name, value] : item.numbers) set_number(L, name.c_str(), value);
  lua_setfield(L, -2, "numbers");
}

int check(Call& call) {
  lua_State* L = call.L();
  const auto report = fabric::check(*call.self<card::Card>(), call.number("element_size"));
  lua_newtable(L);
  set_text(L, "card", report.card);
  set_text(L, "text", report.text());
  lua_pushboolean(L, report.ok());
  lua_setfield(L, -2, "ok");
  lua_newtable(L);
  for (std::size_t i = 0; i < report.items.size(); ++i) {
    push_item(L, report.items[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  lua_setfield(L, -2, "items");
  if (luaL_newmetatable(L, "fabricsh.check") != 0) {
    lua_pushcfunction(L, report_text);
    lua_setfield(L, -2, "__tostring");
  }
  lua_setmetatable(L, -2);
  return 1;
}

}  // namespace

void bind_check(Session& session) {
  install(
      session,
      {{"card:check",
        Style::positional,
        {number_("element_size", "m", positive, "smallest in the plane, for the explicit step").or_else(0.1)},
        "What is wrong with the card or worth knowing: a table {ok, card, text, items}, which prints as its "
        "text; an "
        "item has key, severity (note, warning, error), text, numbers.",
        "local report = require 'fabric'.card 'blend':check()\nassert(report.ok and #report.items > 0)\n"
        "assert(tostring(report) == report.text)",
        check}});
}

}  // namespace fabricsh::script
