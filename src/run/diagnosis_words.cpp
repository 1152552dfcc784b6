// The report of a failed step, composed from the measurements made in it.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/number.hpp"
#include "law/check.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/diagnosis.hpp"
#include "run/place_text.hpp"

namespace fabricsh::run {

namespace {

constexpr double kWideRatio = 1e6;  // of stiffnesses: above it Newton's steps lose half their digits
constexpr double kBeyond = 1.5;     // factor on the tested strain
constexpr double kYarnsMeet = 65;   // degrees of shear, from which yarns are told to be about to meet
constexpr std::size_t kShown = 8;   // number of residuals and attempts shown

const char* branch_word(law::LoadBranch branch) {
  return branch == law::LoadBranch::virgin ? "loading" : law::name(branch);
}

// The course of the residuals in an attempt.
enum class Course { none, falls, stands, swings, grows };
constexpr const char* course_words[] = {"", "still falling", "at a standstill", "swinging", "growing"};

Course course_of(const std::vector<double>& r) {
  if (r.size() >= 2 && r.back() < 0.1 * r[r.size() - 2]) return Course::falls;
  if (r.size() < 4) return Course::none;
  const auto last = r.end() - 4;
  int falls = 0;
  for (int i = 1; i < 4; ++i) falls += last[i] < last[i - 1] ? 1 : 0;
  if (falls == 3 && last[3] < 0.5 * last[0]) return Course::falls;
  const auto [least, most] = std::minmax_element(last, r.end());
  if (*most < 2 * *least) return Course::stands;
  return *most == r.back() && last[3] > 10 * last[0] ? Course::grows : Course::swings;
}

std::string try_text(const Try& t) {
  std::string text = "a step of " + number(t.step) + " s: ";
  text += t.reason.empty() ? solver::describe(t.status) : t.reason;
  if (t.residuals.empty()) return text;
  const std::size_t from = t.residuals.size() > kShown ? t.residuals.size() - kShown : 0;
  text += "; residuals" + std::string(from > 0 ? " ..." : "");
  for (std::size_t i = from; i < t.residuals.size(); ++i) text += " " + number(t.residuals[i]);
  if (const Course course = course_of(t.residuals); course != Course::none)
    text += std::string(" (") + course_words[static_cast<std::size_t>(course)] + ")";
  return text;
}

// Empty, or ", tested to 0.26".
std::string tested_text(double strain, double tested) {
  return tested > 0 && std::abs(strain) > tested ? " (tested to " + number(tested) + ")" : "";
}

double beyond(const Diagnosis& f) {
  const auto ratio = [](double strain, double tested) { return tested > 0 ? strain / tested : 0; };
  return std::max({ratio(f.site.E11, f.tested.warp), ratio(f.site.E22, f.tested.weft),
                   ratio(std::abs(f.site.E12), f.tested.shear)});
}

std::string switch_text(const Diagnosis& f) {
  std::string text;
  const auto add = [&](const char* yarn, law::LoadBranch before, law::LoadBranch after) {
    text += (text.empty() ? "" : ", ") + std::string(yarn) + " " + branch_word(before);
    if (before != after) text += " -> " + std::string(branch_word(after));
  };
  add("warp", f.site.before.warp, f.site.after.warp);
  add("weft", f.site.before.weft, f.site.after.weft);
  add("shear", f.site.before.shear, f.site.after.shear);
  return text;
}

// A remedy that a static run has not tried: each one leads to the next, and none back.
std::string next_way(const Diagnosis& f) {
  if (!f.both && !f.arc) return "method=\"either\"";
  return f.stabilised || f.arc ? "fabric.dynamic with damping" : "stabilise=true";
}

void advise_on_mechanism(const Diagnosis& f, std::vector<std::string>& all) {
  const auto& m = f.mechanism;
  if (m.ways > 1) {  // no single support can prevent them all
    all.push_back("supports that leave no part free (they leave the sheet free to " + m.words + "), " +
                  (f.bends && !f.relaxed ? "method=\"relaxation\", " : "") +
                  "or fabric.dynamic with damping");
    return;
  }
  std::string support = "a support that prevents it";
  if (m.driven) {
    std::ostringstream stiffness;
    stiffness.precision(1);
    stiffness << m.stiffness;
    support += " (a small one is m:spring(\"all\", { " + std::string(1, "xyz"[m.axis]) + "=" +
               stiffness.str() + " }))";
  }
  all.push_back((f.bends && !f.relaxed ? "method=\"relaxation\", " : "") +
                std::string("motion, fabric.dynamic with damping, or ") + support +
                ": the supports leave the sheet free to " + m.words +
                (m.driven ? ", and the loads drive it" : ""));
}

bool ends_singular(const Diagnosis& f) {
  return !f.tries.empty() && f.tries.back().status == solver::NewtonStatus::singular && !f.dynamic;
}

// Yarns that turn onto each other take the area of their element, whatever its size; where a held edge ends,
// a finer mesh has more of that.
std::string advice_on_inverted(const Diagnosis& f) {
  const std::string less = f.moved > 0 ? "less stroke" : "less load",
                    where = " (element " + std::to_string(f.site.inverted + 1) + " is turned inside out";
  if (f.site.shear_angle < kYarnsMeet) return less + ", or a finer mesh there" + where + ")";
  return less + ", or a card whose shear stiffens before its yarns meet, as cloth does" + where +
         ": the shear angle of element " + std::to_string(f.site.sheared + 1) + " has come to " +
         number(f.site.shear_angle, 2) +
         " degrees, at 90 warp and weft lie on each other and an element has no area; a finer mesh does not "
         "help)";
}

void advise_on_tangent(const Diagnosis& f, std::vector<std::string>& all) {
  const bool named = f.mechanism.ways > 0 && !f.mechanism.driven;  // otherwise it has advice of its own
  const std::string pivots = std::to_string(f.last.negative_pivots) + " negative pivots";
  if (ends_singular(f))
    all.push_back("supports that leave no part free to move, fix(\"all\", \"z\") for a flat sheet; or " +
                  next_way(f) + " (the tangent is singular" +
                  (named ? ": the supports leave the sheet free to " + f.mechanism.words : "") + ")");
  if (f.last.negative_pivots > 0 && !f.arc && !f.dynamic)
    all.push_back(next_way(f) +
                  " for folds, wrinkles and snaps, control=\"arc\" for a limit point (the last tangent has " +
                  pivots + ")");
  if (f.site.inverted >= 0) all.push_back(advice_on_inverted(f));
  if (f.site.turned >= 0)
    all.push_back("a smaller step, or a finer mesh there (the director at node " +
                  std::to_string(f.site.turned + 1) + " is turned over, the elements about it are sound)");
}

void advise_on_iterations(const Diagnosis& f, std::vector<std::string>& all) {
  const Try& last = f.tries.back();
  const double residual = last.residuals.empty() ? 1 : last.residuals.back();
  const Course course = course_of(last.residuals);
  const bool few = last.status == solver::NewtonStatus::too_many_iterations;
  if (few && course == Course::falls)
    all.push_back("more max_iterations, set{ max_iterations=" +
                  std::to_string(std::max<std::size_t>(20, 2 * last.residuals.size())) +
                  " } (the residual is still falling)");
  if (few && course == Course::stands && residual < 1e-5)
    all.push_back("a larger tolerance, set{ tolerance=" + number(10 * residual) +
                  " } (the residual stands at " + number(residual) + ")");
  if (f.moved > f.size && f.tries.size() < 4)
    all.push_back("a smaller step, or more max_cuts (a support moves by " + number(f.moved) +
                  " m in a step, an element is " + number(f.size) + " m)");
  if (f.site.switching > 0 && course == Course::swings)
    all.push_back((f.stabilised || f.dynamic ? "a smaller step" : next_way(f)) + " (" +
                  std::to_string(f.site.switching) + " of " + std::to_string(f.site.elements) +
                  " elements switch branches, the residual swings)");
  if (last.status == solver::NewtonStatus::blocked)
    all.push_back(
        "a stiffer contact where they press, stiffness= of m:contact, or more room for it, thickness=; "
        "slower "
        "motion; or a larger gap for cloth between tools");
  if (last.status == solver::NewtonStatus::law_failed && f.site.reason.empty())
    all.push_back("a smaller step, and a check of the units of loads and motions (a strain is not finite)");
}

bool slides_in_statics(const Diagnosis& f) { return f.sliding > 0 && !f.dynamic; }

// Cloth that friction alone holds has no equilibrium beyond its limit, whatever solver looks for one.
void advise_on_sliding(const Diagnosis& f, std::vector<std::string>& all) {
  if (slides_in_statics(f))
    all.push_back("motion, fabric.dynamic with damping, a support that holds what slides, or more friction");
}

// Bending along stiff yarns couples the splay of the directors with the bending of an element in its plane.
// Quadrilaterals that are long across these yarns resist that by weft and twist alone.
void advise_on_shape(const Diagnosis& f, std::vector<std::string>& all) {
  constexpr double elongated = 4, anisotropic = 1e3;
  if (f.aspect < elongated || f.site.stiffness_ratio < anisotropic || f.dynamic) return;
  all.push_back(
      "elements that are less elongated, or triangles (element " + std::to_string(f.site.element + 1) +
      " is " + number(f.aspect, 2) + " times as long as wide, and one direction of it " +
      number(f.site.stiffness_ratio, 2) +
      " times as stiff as another: bent along the stiff yarns such a quadrilateral has a weak mode of "
      "twist and weft)");
}

void advise_on_cloth(const Diagnosis& f, std::vector<std::string>& all) {
  if (beyond(f) > kBeyond)
    all.push_back("a check of the card, card:check(), and of the units of the stroke (strained " +
                  number(beyond(f)) + " times as far as it was tested)");
  if (f.site.stiffness_ratio > kWideRatio && !f.dynamic)
    all.push_back(std::string("fabric.dynamic with damping") +
                  (f.both || f.arc ? "" : ", or " + next_way(f)) + " (one direction of element " +
                  std::to_string(f.site.element + 1) + " is " + number(f.site.stiffness_ratio) +
                  " times as stiff as another)");
  if (2 * f.site.slack > f.site.elements && !f.dynamic)
    all.push_back(next_way(f) + (f.stabilised ? " (" : ", or fabric.dynamic (") +
                  std::to_string(f.site.slack) + " of " + std::to_string(f.site.elements) +
                  " elements are slack both ways)");
}

// Inputs at full value at time 0, if there are any: "loads", "motion" or "loads and motions".
std::string jumping(const Jumps& jump) {
  if (jump.motions.empty()) return "loads";
  return jump.loads.empty() ? "motion" : "loads and motions";
}

std::string cause_of(const Diagnosis& f) {
  if (slides_in_statics(f))
    return "friction is at its limit and cloth slides: pairs with " + number(f.sliding) +
           " N of it slide, most of all " + f.slides + "; " + solver::describe(f.last.status);
  if (f.last.status == solver::NewtonStatus::blocked && f.site.reason.empty() && !f.nearest.empty())
    return solver::describe(f.last.status) + (": the nearest are " + f.nearest);
  return f.site.reason.empty() ? solver::describe(f.last.status) : f.site.reason;
}

// "; the residual 0.1 (tolerance 1e-10) sits at node 3, element 2, where the warp is switching"
std::string place_of(const Diagnosis& f, double tolerance) {
  std::string text;
  if (f.site.node >= 0 && !f.last.residuals.empty())
    text += "; the residual " + number(f.last.residuals.back()) + " (tolerance " + number(tolerance) +
            ") sits at node " + std::to_string(f.site.node + 1);
  if (f.site.element >= 0) text += ", element " + std::to_string(f.site.element + 1);
  if (!f.site.yarn.empty() && !slides_in_statics(f))
    text += ", where the " + f.site.yarn + " is switching between branches";
  return text;
}

// "no step beyond time 0.1 s"; or, if the forces cannot be computed with any step, "stopped at time 0.1 s".
std::string ends(const Diagnosis& f) {
  return (f.broken() ? "stopped at time " : "no step beyond time ") + number(f.time) + " s";
}

}  // namespace

std::string Diagnosis::message(double step, double largest, int cuts, double tolerance) const {
  return ends(*this) + ": " + cause_of(*this) + " in a step of " + number(step) + " s" +
         (jumps ? ", the first one, with all of the " + jumping(jump) + " of time 0" : "") +
         " (the largest is " + number(largest) + " s; " + std::to_string(cuts) + " tries)" +
         place_of(*this, tolerance) + ".\nTry: " + advice().front() + ".";
}

std::vector<std::string> Diagnosis::advice() const {
  const Diagnosis& f = *this;
  std::vector<std::string> all;
  if (f.broken()) return {"a new run after correcting what the message names: a smaller step does not help"};
  // A part that is free to move moves under a small load too.
  const bool free = f.mechanism.driven || ends_singular(f);
  advise_on_sliding(f, all);
  if (!f.loose.empty()) all.push_back(f.loose);
  if (f.mechanism.driven) advise_on_mechanism(f, all);
  advise_on_shape(f, all);
  if (free) advise_on_tangent(f, all);
  if (f.jumps) {
    const bool moves = !f.jump.motions.empty(), loads = !moves || !f.jump.loads.empty();
    const std::string relaxes = !moves && !f.relaxed && !f.arc ? "method=\"relaxation\", or " : "";
    all.push_back(relaxes +
                  (!moves  ? "loads that grow from 0, fabric.ramp(load, duration)"
                   : loads ? "loads and motions that grow from 0, fabric.ramp(way, duration)"
                           : "motions that grow from 0, fabric.ramp(way, duration)") +
                  " (all of them are there at time 0, and a shorter step has no less of them)");
    if (!free) return all;  // what else was seen is of the jump
  }
  if (f.last.status == solver::NewtonStatus::unstable)
    all.push_back(next_way(f) +
                  ", or a small force or imperfection to the side that is wanted (the shape is a "
                  "balance that is not stable)");
  if (f.last.status == solver::NewtonStatus::turned_back)
    all.push_back(
        "a history that begins below the lowest load of the path (table{ {0, -1}, {2, 1} }), or a smaller "
        "step, so that the path is not followed backwards");
  if (!free) advise_on_tangent(f, all);
  if (!f.tries.empty()) advise_on_iterations(f, all);
  advise_on_cloth(f, all);
  if (!f.mechanism.driven && f.mechanism.ways == 1 && !ends_singular(f)) advise_on_mechanism(f, all);
  if (all.empty())
    all.push_back(f.dynamic ? "a smaller step, or scheme=\"explicit\""
                            : next_way(f) + ", a smaller step, or more max_cuts");
  return all;
}

std::string Diagnosis::report() const {
  const Diagnosis& f = *this;
  std::string text = ends(f) + "\n";
  const std::size_t from = f.tries.size() > kShown ? f.tries.size() - kShown : 0;
  if (from > 0) text += "tried      " + std::to_string(from) + " larger steps\n";
  for (std::size_t i = from; i < f.tries.size(); ++i) text += "tried      " + try_text(f.tries[i]) + "\n";
  const ResidualSite& b = f.site;
  if (f.jumps)
    text += "jump       " + full_text(f.jump) +
            " there in full at time 0: the first step goes from cloth without load to all of it, and what is "
            "said below is of that attempt\n";
  if (b.node >= 0)
    text += "node       " + std::to_string(b.node + 1) + " at " + place_text(b.x) + " has the residual, " +
            (b.rotation ? "as a moment on its director" : "as a force") + "\n";
  if (!b.reason.empty()) text += "reason     " + b.reason + "\n";
  if (b.element >= 0) {
    text += "element    " + std::to_string(b.element + 1) + " about " + place_text(b.centre) + "\n";
    text += "strain     E11 " + number(b.E11) + tested_text(b.E11, f.tested.warp) + ", E22 " + number(b.E22) +
            tested_text(b.E22, f.tested.weft) + ", E12 " + number(b.E12) +
            tested_text(b.E12, f.tested.shear) + "\n";
    text += "switches   " + switch_text(f) + "\n";
    text += "elements   " + std::to_string(b.switching) + " of " + std::to_string(b.elements) +
            " switch branches in the step, " + std::to_string(b.slack) + " are slack both ways\n";
  }
  if (b.stiffness_ratio > 0)
    text +=
        "stiffness  the stiffest direction of the element over the softest: " + number(b.stiffness_ratio) +
        "\n";
  for (const std::string& a : advice()) text += "try        " + a + "\n";
  text.pop_back();
  return text;
}

std::string touching_text(const mechanics::Assembly& assembly) {
  const mechanics::Contacts* contact = assembly.terms().find<mechanics::Contacts>();
  if (contact == nullptr) return {};
  const auto nearest = contact->readings().nearest();
  const std::size_t pairs = contact->readings().touching();
  std::string text =
      "\ncontact    " + std::to_string(pairs) + (pairs == 1 ? " pair touches" : " pairs touch");
  if (pairs > 0)
    text += "; the nearest, " + contact->surfaces().words(nearest.point) + ", is " + number(nearest.gap) +
            " m above the smallest distance that contact allows";
  return text;
}

}  // namespace fabricsh::run
