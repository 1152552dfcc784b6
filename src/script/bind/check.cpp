// card:check.
#include "law/check.hpp"

#include <cmath>

#include "script/bind/run.hpp"

namespace fabricsh::script {

namespace {

void push_item(lua_State* L, const law::CheckItem& item) {
  push_record(L, "key", item.key, "severity", name(item.severity), "text", item.text, "numbers", [&] {
    lua_newtable(L);
    for (const auto& [name, value] : item.numbers) put(L, name.c_str(), value);
  });
}

// Pushes where the law of the thesis is not definite, by path and pair of branches; empty for other cards.
void push_criterion(lua_State* L, const card::Card& card, bool usable) {
  const auto* woven = std::get_if<card::Woven>(&card.law);
  if (woven == nullptr || !usable) return lua_newtable(L);
  push_list(L, law::criterion_table(*woven, *law::compile(card)), [L](const auto& row) {
    push_record(L, "path", row.path, "warp", law::name(row.warp), "weft", law::name(row.weft));
    if (!std::isnan(row.first)) put(L, "first", row.first);
    put(L, "last", row.last);
  });
}

double element_size(const Call& call) {
  if (call.is("element_size", LUA_TNUMBER)) return call.number("element_size");
  if (!call.has("element_size")) return 0.1;
  return call.fields("element_size").number("element_size");
}

Argument size_() {
  return number_("element_size", "m", positive, "smallest in the plane, for the explicit step");
}

int check(Call& call) {
  lua_State* L = call.L();
  const auto report = law::check(*call.self<card::Card>(), element_size(call));
  push_record(
      L, "card", report.card, "text", report.text(), "ok", report.ok(), "items",
      [&] { push_list(L, report.items, [&](const auto& one) { push_item(L, one); }); }, "criterion",
      [&] { push_criterion(L, *call.self<card::Card>(), report.ok()); });
  set_text_of(L, "fabricsh.check", report_text);
  return 1;
}

// The argument: a number, or {element_size=}.
Argument size_row() {
  Argument row = size_().optional();
  row.kinds |= fields;
  row.rows = {size_().or_else(0.1)};
  row.sentence += "; default 0.1";
  return row;
}

}  // namespace

void bind_check(Session& session) {
  install(session,
          {{"card:check()",
            {size_row()},
            "Errors of the card and remarks on it: a table {ok, card, text, items, criterion}, which "
            "prints as its text. An item has key, severity (note, warning, error), text, numbers; a row of "
            "criterion has path, warp, weft (branches), first (strain of violation or nil), last.",
            "local report = require 'fabric'.card 'blend':check{ element_size=0.01 }\nassert(report.ok and "
            "#report.items > 0)\n"
            "assert(tostring(report) == report.text)",
            check}});
}

}  // namespace fabricsh::script
