// fabric.history, fabric.ramp, and histories given as numbers or functions.
#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"
#include "script/session/at_work.hpp"

namespace fabricsh::script {

using history::History;

Argument history_(std::string name, std::string unit, std::string sentence) {
  Argument row = object_(std::move(name), "history", std::move(sentence), number | function);
  row.unit = std::move(unit);
  return row.optional();
}

namespace {

History callback(const Function& f, const std::string& what) {
  return History::callback([f, what](double t) {
    lua_State* L = f.push();
    lua_pushnumber(L, t);
    call_deck(L, 1, 1);
    if (lua_type(L, -1) != LUA_TNUMBER || !std::isfinite(lua_tonumber(L, -1)))
      throw Error(what + ": expected the history to return a finite number at t = " +
                  fabricsh::number(t, 10) + " s, got " + describe(L, -1));
    const double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
  });
}

}  // namespace

History read_points(const Call& call, const char* name) {
  std::vector<std::pair<double, double>> points;
  call.each(name, [&](lua_Integer i) {
    const Argument pair{std::string(name) + "[" + std::to_string(i) + "]", numbers, "", everything,
                        "time and value"};
    check_value(call.L(), -1, pair, "", true);
    const auto row = read_numbers(call.L(), -1);
    if (row.size() != 2)
      call.refuse(pair.name, "expected {time, value}, got " + std::to_string(row.size()) + " numbers");
    points.emplace_back(row[0], row[1]);
  });
  return History::table(std::move(points));
}

namespace {

int history_table(Call& call) {
  return push_object(call.L(), std::make_shared<History>(read_points(call, "points")));
}

int ramp(Call& call) {
  return push_object(call.L(),
                     std::make_shared<History>(History::ramp(call.number("value"), call.number("duration"))));
}

int value(Call& call) { return push_value(call.L(), call.self<History>()->value(call.number("time"))); }

bool is_function(const History& h) { return !h.is_straight(); }

// At its kinks a history has the values that it was given.
int points(Call& call) {
  lua_State* L = call.L();
  const auto h = call.self<History>();
  if (is_function(*h)) return lua_pushnil(L), 1;
  return push_list(L, h->is_constant() ? std::vector<double>{0} : h->kinks(), [&](double time) {
    push_numbers(L, {time, h->value(time)});
  });
}

// For example "<history of 3 points to 2 s, 0 to 0.018>".
int history_text(lua_State* L) {
  const History& h = *to_object<History>(L, 1);
  std::string words = "<history";
  if (is_function(h)) {
    words += ", a function of time";
  } else if (h.is_constant()) {
    words += ", always " + exact_number(h.value(0));
  } else {
    double low = h.value(h.kinks().front()), high = low;
    for (const double t : h.kinks()) {
      low = std::min(low, h.value(t));
      high = std::max(high, h.value(t));
    }
    words += " of " + std::to_string(h.kinks().size()) + " points to " + exact_number(h.kinks().back()) +
             " s, " + exact_number(low) + " to " + exact_number(high);
  }
  return push_value(L, words + ">");
}

std::vector<Entry> history_entries() {
  return {
      {"fabric.history()",
       {value_("points", table, "{ {t, v}, ... } with increasing times, s")},
       "A history through points; before the first and after the last it holds their values.",
       "local h = require 'fabric'.history{ {0, 0}, {1, 2} }; assert(h:value(0.5) == 1)",
       history_table},
      {"fabric.ramp()",
       {number_("value", "", everything, "end value"),
        number_("duration", "s", positive, "time to reach it")},
       "From 0 to value over the duration, then held.",
       "local h = require 'fabric'.ramp(3, 2); assert(h:value(1) == 1.5 and h:value(9) == 3)",
       ramp},
      {"history:value()",
       {number_("time", "s", everything, "when")},
       "The history's value at a time.",
       "assert(require 'fabric'.ramp(3, 2):value(2) == 3)",
       value},
      without_arguments("history:points",
                        "Its points { {t, v}, ... }; of a constant one; nil of a function of time, as "
                        "model:declared may have it.",
                        "local points = require 'fabric'.ramp(3, 2):points(); assert(points[2][1] == 2 and "
                        "points[2][2] == 3)",
                        points),
  };
}

}  // namespace

History read_history(Session& session, lua_State* L, int index, const std::string& what) {
  if (lua_type(L, index) == LUA_TNUMBER) return History::constant(lua_tonumber(L, index));
  if (lua_isfunction(L, index)) return callback(Function(session, L, index), what);
  const auto history = to_object<History>(L, index);
  if (history == nullptr)
    throw Error(what + ": expected a number, a function or a history, got " + describe(L, index));
  return *history;
}

void bind_history(Session& session) {
  install(session, history_entries());
  set_meta(session, "history", "__tostring", history_text);
}

}  // namespace fabricsh::script
