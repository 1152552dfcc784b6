// fabric.lab: least squares and parallel work for identification by simulation.
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "lab/least_squares.hpp"
#include "lab/parallel.hpp"
#include "script/bind/run.hpp"
#include "script/call/words.hpp"
#include "script/session/warning_log.hpp"

namespace fabricsh::script {

namespace {

// Reads the numbers of the table on top of the stack and pops it.
std::vector<double> pop_numbers(lua_State* L, const std::string& what) {
  const Argument row{"", numbers, "", everything, ""};
  if (!lua_istable(L, -1)) throw Error(what + ": expected a list of numbers, got " + describe(L, -1));
  check_value(L, -1, row, what, false);
  auto values = read_numbers(L, -1);
  lua_pop(L, 1);
  return values;
}

// Calls the function with one value above it on the stack; a Lua error becomes an Error with its message.
void call_one(lua_State* L) {
  if (lua_pcall(L, 1, 1, 0) == LUA_OK) return;
  const int kind = lua_type(L, -1);
  const bool words = kind != LUA_TTABLE || luaL_getmetafield(L, -1, "__tostring") != LUA_TNIL;
  if (kind == LUA_TTABLE && words) lua_pop(L, 1);
  const std::string message = words ? luaL_tolstring(L, -1, nullptr) : "an error that is a table";
  lua_pop(L, words ? 2 : 1);
  throw Error(message);
}

std::vector<double> work_on(const Function& work, std::size_t i) {
  lua_State* L = work.push();
  lua_pushinteger(L, static_cast<lua_Integer>(i + 1));
  call_one(L);
  return pop_numbers(L, "work");
}

// Numbers of finished items, of failed ones, and of those whose process ended without an answer.
struct ItemCounts {
  std::size_t all = 0, failed = 0, lost = 0;
};

// For example "study: 3 of 12 done, 1 failed, 1 without an answer, 40 s, about 120 s more".
std::string progress_words(const std::string& title, std::size_t count, const ItemCounts& finished,
                           double seconds) {
  char times[80];
  const double more = seconds / static_cast<double>(finished.all) * static_cast<double>(count - finished.all);
  std::snprintf(times, sizeof times, ", %.0f s, about %.0f s more", seconds, more);
  return title + ": " + std::to_string(finished.all - finished.lost) + " of " + std::to_string(count) +
         " done" + (finished.failed > 0 ? ", " + std::to_string(finished.failed) + " failed" : "") +
         (finished.lost > 0 ? ", " + std::to_string(finished.lost) + " without an answer" : "") + times;
}

// Reports the progress, at most every two seconds and at the end.
class ItemProgress {
 public:
  ItemProgress(Session& session, std::string title, std::size_t count)
      : session_(session), title_(std::move(title)), count_(count) {}
  void done(const lab::WorkerResult& answer) {
    ++finished_.all;
    finished_.lost += answer.died ? 1 : 0;
    finished_.failed += !answer.died && !answer.error.empty() ? 1 : 0;
    const double seconds = seconds_since(begin_);
    if (title_.empty() || session_.options().quiet || !session_.options().notice) return;
    if (finished_.all < count_ && seconds < said_ + 2) return;
    said_ = seconds;
    session_.options().notice(progress_words(title_, count_, finished_, seconds));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }
  Session& session_;
  std::string title_;
  std::size_t count_;
  ItemCounts finished_;
  Clock::time_point begin_ = Clock::now();
  double said_ = 0;
};

// Under --safe the number of processes is limited to that of the threads, because the memory limit applies to
// each process; and they cannot start others.
void bound_processes(const Session& session, lab::Processes& how) {
  if (session.forked() && how.always)
    throw Error("--safe: a process of fabric.lab.parallel or fabric.study starts no others");
  how.at_a_time = std::min(how.at_a_time, omp_get_max_threads());
}

int parallel(Call& call) {
  lua_State* L = call.L();
  const Function work = call.function("work"), done = call.function("done");
  const bool reports = call.has("done");
  const auto count = static_cast<std::size_t>(call.integer("count"));
  Session& session = call.session();
  ItemProgress progress(session, call.text("progress"), count);
  lab::Processes how;
  how.at_a_time = call.has("processes") ? call.count("processes") : omp_get_max_threads();
  const bool collects = call.flag("collect");
  how.always = call.flag("isolated") || (collects && !session.forked());
  if (session.limits() != nullptr) bound_processes(session, how);
  how.stop = [&session] { return session.interrupted(); };
  how.attach = [&session, from = session.log().end()] { return session.log().packed_since(from); };
  how.done = [&](std::size_t i, const lab::WorkerResult& answer) {
    progress.done(answer);
    if (!reports) return;
    lua_State* on = done.push();
    lua_pushinteger(on, static_cast<lua_Integer>(i + 1));
    call_one(on);
    lua_pop(on, 1);
  };
  const auto answers = lab::in_processes(
      count,
      [&](std::size_t i) {
        if (collects && session.forked()) session.log().stop_showing();
        return work_on(work, i);
      },
      how);
  if (session.take_interrupt()) {
    session.rest_hook(session.active());
    session.call_off();
    throw Error("interrupted");
  }
  return push_list(L, answers, [&](const lab::WorkerResult& answer) {
    const WarningLog::LogPosition before = session.log().end();
    session.log().adopt(answer.attached);
    push_numbers(L, answer.values);
    if (collects) put(L, "warnings", [&] { push_warnings(L, session.log().since(before)); });
    if (!answer.error.empty()) put(L, "trouble", answer.error);
    if (answer.died) put(L, "died", true);
  });
}

void push_points(lua_State* L, const lab::Points& points) {
  push_list(L, points, [&](const auto& one) { push_numbers(L, one); });
}

// expected: number of residuals at each point; 0: taken from the first one.
lab::Points evaluated(const Function& evaluate, const lab::Points& points, std::size_t& expected) {
  lua_State* L = evaluate.push();
  push_points(L, points);
  call_one(L);
  want_table(L, -1, "evaluate");
  lab::Points out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    lua_rawgeti(L, -1, static_cast<lua_Integer>(i + 1));
    out.push_back(pop_numbers(L, "evaluate"));
    if (expected == 0) expected = out.back().size();
    if (out.back().size() != expected)
      throw Error("evaluate: expected as many residuals at every point (" + std::to_string(expected) +
                  "), got " + std::to_string(out.back().size()));
  }
  lua_pop(L, 1);
  return out;
}

// Bounded least squares by Levenberg and Marquardt: x, residuals, jacobian (by rows), iterations, converged,
// reason. evaluate(points) returns one list of residuals for each point; tolerance: of the sum of squares and
// of the parameters, relative; difference: step of the differences, over high - low; settle: rounds of
// central differences along combinations that the data determine independently, for residuals in units of
// their deviation.
int least_squares(Call& call) {
  const auto start = call.numbers("start"), low = call.numbers("low"), high = call.numbers("high");
  if (low.size() != start.size() || high.size() != start.size())
    call.refuse("low", "expected low and high for each of " + std::to_string(start.size()) + " parameters");
  std::vector<lab::ParameterBounds> bounds;
  for (std::size_t i = 0; i < low.size(); ++i) bounds.push_back({low[i], high[i]});
  const Function evaluate = call.function("evaluate");
  std::size_t count = 0;
  const std::function<lab::Points(const lab::Points&)> residuals = [&](const lab::Points& points) {
    return evaluated(evaluate, points, count);
  };
  const auto found = lab::settle(
      lab::least_squares(start, bounds, residuals,
                         {call.count("iterations"), call.number("tolerance"), call.number("difference")}),
      bounds, residuals, call.count("settle"));
  return push_record(call.L(), "x", found.x, "residuals", found.residuals, "jacobian", found.jacobian,
                     "iterations", static_cast<double>(found.iterations), "reason", found.reason, "converged",
                     found.converged);
}

// The data determine: deviation of each parameter, correlation (by rows), weakest (the combination determined
// least, of length one in units of scale) and weakest_deviation. jacobian: of residuals in units of their
// deviation, by rows; scale: a size of each parameter.
int identifiability(Call& call) {
  const auto scale = call.numbers("scale"), jacobian = call.numbers("jacobian");
  if (jacobian.size() % scale.size() != 0 || jacobian.size() < scale.size() * scale.size())
    call.refuse("jacobian", "expected at least " + std::to_string(scale.size()) + " rows of " +
                                std::to_string(scale.size()));
  const auto found = lab::identifiability(jacobian, scale);
  return push_record(call.L(), "deviation", found.deviation, "correlation", found.correlation, "weakest",
                     found.weakest, "weakest_deviation", found.weakest_deviation);
}

Argument list(const char* name) { return argument_(name, numbers, "", everything, ""); }

std::vector<Entry> identify_entries() {
  return {
      {"fabric.lab.parallel{}",
       {integer_("count", Range{1, 1e7}, "of items"),
        value_("work", function, "work(i) returns a list of numbers"),
        integer_("processes?", {1, 4096},
                 "parallel processes, each with one thread; default: the threads that the program may use"),
        value_("done?", function, "done(i) is called in this process after each item"),
        flag_("isolated", "each item in a process of its own, even with processes=1"),
        flag_(
            "collect",
            "what the items warn of is not shown but returned, a list warnings with each answer, and logged"),
        value_("progress", text, "progress is shown, preceded by this word").or_else("")},
       "Calls work(i) for items 1 to count in parallel processes. Returns the lists in order; that of a "
       "failed item is empty and has trouble, the message, and died=true when its process ended without an "
       "answer.",
       "local r = require 'fabric'.lab.parallel{ count=3, work=function(i) return { i, i*i } end "
       "}\nassert(r[3][2] == 9)",
       parallel},
      kernel("least_squares{}",
             {list("start"), list("low"), list("high"), value_("evaluate", function, ""),
              integer_("iterations", from_one, "").or_else(50.0),
              number_("tolerance", "", positive, "").or_else(1e-8),
              number_("difference", "", positive, "").or_else(1e-4),
              integer_("settle", not_negative, "").or_else(0.0)},
             least_squares),
      kernel("identifiability{}", {list("jacobian"), list("scale")}, identifiability),
  };
}

}  // namespace

void bind_identify(Session& session) { install(session, identify_entries()); }

}  // namespace fabricsh::script
