// How far the answer of a step depends on the way between its ends: a step against two halves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "base/number.hpp"
#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"
#include "run/static.hpp"

namespace fabricsh::run {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLong = 0.125;      // of the run
constexpr double kMost = 0.5;        // of the run: longer steps are also compared with four parts
constexpr double kSmall = 2e-3;      // below it the next steps are not asked
constexpr double kLeast = 1.0 / 64;  // of the run: a shorter step may err as much as one of this length
// The halves need not be solved better than the error is asked for.
const solver::NewtonOptions kHalves{1e-5, 12};
constexpr double kFarAway = 1e3;  // of the model's size, in a step
constexpr double kRounding =
    1e3 * std::numeric_limits<double>::epsilon();  // of displacements, over the cloth's size

bool remembers(const card::Card& card) {
  const auto& bending = card.bending;
  return std::holds_alternative<card::Woven>(card.law) ||
         (bending && (bending->friction_warp || bending->friction_weft));
}

// The middle between two configurations, whose directors and frames are unit vectors.
std::vector<double> middle(std::span<const double> from, std::span<const double> to) {
  std::vector<double> half(to.size());
  for (std::size_t i = 0; i < half.size(); ++i) half[i] = (from[i] + to[i]) / 2;
  const auto nodes = half.size() / 9;
  for (std::size_t n = 0; n < nodes; ++n) {
    const auto d = static_cast<std::ptrdiff_t>(nodes + n), b = static_cast<std::ptrdiff_t>(2 * nodes + n);
    Vec3 director = at(half, d), axis = at(half, b);
    if (!(director.norm() > 0.1)) director = at(to, d);
    director.normalize();
    axis -= axis.dot(director) * director;
    if (!(axis.norm() > 0.1)) axis = director.unitOrthogonal();
    at(half, d) = director;
    at(half, b) = axis.normalized();
  }
  return half;
}

// Of the first `numbers` entries, three per node.
double largest_distance(std::span<const double> a, std::span<const double> b, std::size_t numbers) {
  double most = 0;
  for (std::size_t n = 0; n < numbers / 3; ++n) {
    const auto node = static_cast<std::ptrdiff_t>(n);
    most = std::max(most, (at(a, node) - at(b, node)).norm());
  }
  return most;
}

// Of the largest displacements along x, y and z: they are those of a mirror image, too, which is as good.
double difference_of_sizes(std::span<const double> a, std::span<const double> b, std::span<const double> X) {
  double most[2][3] = {}, difference = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    most[0][i % 3] = std::max(most[0][i % 3], std::abs(a[i] - X[i]));
    most[1][i % 3] = std::max(most[1][i % 3], std::abs(b[i] - X[i]));
  }
  for (int i = 0; i < 3; ++i) difference = std::max(difference, std::abs(most[0][i] - most[1][i]));
  return difference;
}

}  // namespace

bool Static::depends_on_path() const {
  const auto& regions = model_->regions();
  return std::any_of(regions.begin(), regions.end(), [](const auto& region) {
    const auto& plies = region.options.plies;
    return plies.empty()
               ? remembers(region.card)
               : std::any_of(plies.begin(), plies.end(), [](const auto& p) { return remembers(p.card); });
  });
}

void Static::put(std::span<const double> kinematics) {
  std::copy(kinematics.begin(), kinematics.end(), assembly_->state().kinematics().begin());
  assembly_->state().touch();
}

// Beginning between or at known shapes, a few iterations are enough. Where that does not get there, or is not
// wanted, it is solved as any step is.
bool Static::solve_part(double end, std::span<const double> guess) {
  const auto converges = [](const solver::NewtonResult& result) {
    return result.status == solver::NewtonStatus::converged;
  };
  const auto from_guess = [&] {
    put(guess);
    problem_->accept();
    problem_->apply_increment(std::vector<double>(static_cast<std::size_t>(problem_->size())), 0);
  };
  if (!afresh_) {
    problem_->set_time(end);
    from_guess();
    if (converges(newton_->correct(*problem_, kHalves))) return true;
    if (has_energy_) {
      rollback();
      from_guess();
      if (converges(stable_->correct(*problem_, {kHalves.tolerance, options_.max_iterations}))) return true;
    }
  }
  const Diagnosis step = step_;
  const bool relaxing = relaxing_, crept = crept_;
  StepReport unseen;
  const bool solved = attempt(end, unseen);
  hard_parts_ = hard_parts_ || unseen.iterations > kStaticIterations.many;
  step_ = step;
  relaxing_ = relaxing;
  crept_ = crept;
  return solved;
}

bool Static::by_shares() const { return assembly_->terms().find<mechanics::Contacts>() != nullptr; }

std::vector<double> Static::held_by_supports() const {
  std::vector<double> force(3 * assembly_->dofs().reference().size());
  for (std::size_t n = 0; n < force.size() / 3; ++n)
    at(force, static_cast<std::ptrdiff_t>(n)) = assembly_->dofs().support_force(
        static_cast<mesh::Index>(n), assembly_->internal().on_x, problem_->external());
  return force;
}

// Pivots of a part that nothing holds are rounded: where they pass for a stiffness, it goes this far.
bool Static::flies_away() const {
  const auto& state = std::as_const(*assembly_).state();
  const double size = box_of(assembly_->dofs().reference()).size().norm();
  return largest_distance(state.committed_kinematics(), state.x(), state.x().size()) > kFarAway * size;
}

// m: displacements up to here are none. Positions are rounded; and of cloth that is under tension from the
// start forces are solved to a share of what holds it, whose displacement is that share of its stretch.
double Static::no_displacement(double force) const {
  const double stretch = force > 0 ? std::max(0.0, initial_energy_) / force : 0;
  return kRounding * box_of(assembly_->dofs().reference()).size().norm() + kHalves.tolerance * stretch;
}

// The step from the committed state to the trial state at `to` is made again in two halves, or in four parts
// that are solved afresh. Halves begin at the shapes that are known. Returns by how much the end differs: the
// largest distance of a node over the largest displacement so far, the largest difference of a support's
// force over the largest force, or, of a step in which the cloth falls, the difference of the energy stored
// over the most that was. NaN: the parts have no answer.
Static::Halves Static::compare_parts(int parts, double end, const StepEnd& to) {
  const auto& state = std::as_const(*assembly_).state();
  const std::vector<double> from(state.committed_kinematics().begin(), state.committed_kinematics().end());
  std::vector<double> reference;
  for (const Vec3& X : assembly_->dofs().reference()) reference.insert(reference.end(), X.begin(), X.end());
  const auto numbers = reference.size();
  const double start = committed_time();
  double way = now_.way;
  for (const std::vector<double>& shape : {from, to.kinematics})
    way = std::max(way, largest_distance(shape, reference, numbers));
  now_.way = way;
  rollback();
  for (int i = 1; i < parts; ++i) {
    const double time = start + i * (end - start) / parts;
    if (!solve_part(time, middle(from, to.kinematics))) return {};
    way = now_.way = std::max(way, largest_distance(state.x(), reference, numbers));
    assembly_->finish_step();
    problem_->commit(time);
  }
  if (!solve_part(end, to.kinematics)) return {};
  const double force = now_.path_force = std::max(now_.path_force, problem_->force_scale());
  const auto now = state.x();
  const auto pulls = held_by_supports();
  const double moved = afresh_ ? difference_of_sizes(now, to.kinematics, reference)
                               : largest_distance(now, to.kinematics, numbers),
               pulled = afresh_ ? difference_of_sizes(pulls, to.pulls, std::vector<double>(numbers))
                                : largest_distance(pulls, to.pulls, numbers),
               fallen = falls_ ? std::abs(energy().stored - to.stored) : 0;
  const double nothing = no_displacement(force);
  if (way <= nothing) return {0, 0, 0, 0, parts};
  const double error = std::max({moved > nothing ? moved / way : 0, force > 0 ? pulled / force : 0,
                                 fallen > 0 ? fallen / now_.most_stored : 0});
  if (error < kHalves.tolerance) return {0, 0, 0, 0, parts};  // below it the halves say nothing
  return {error, moved, pulled, fallen, parts};
}

// Where a step of almost the whole run and its halves are both hard to solve and end at the same shape, four
// parts are asked, too: of several stable shapes both may have found the second best, as loads that come up
// more slowly do not. The trial state is afterwards what it was.
Static::Halves Static::path_error(double end, StepReport& report) {
  const auto& state = std::as_const(*assembly_).state();
  const StepEnd to{
      {state.kinematics().begin(), state.kinematics().end()}, held_by_supports(), energy().stored};
  const std::string start = save_state();
  const double committed_start = committed_time();
  hard_parts_ = false;
  Halves error = compare_parts(2, end, to);
  const double part = (end - committed_start) / (duration_ - began());
  if (afresh_ && hard_parts_ && !by_shares() && part > kMost && error.error <= usual_path) {
    go_back(start);
    if (const Halves more = compare_parts(4, end, to); more.error > error.error) error = more;
  }
  const double way = now_.way, force = now_.path_force;
  go_back(start);
  now_.way = way;
  now_.path_force = force;
  if (by_shares()) {
    if (!attempt(end, report)) give_up(report);
    return error;
  }
  problem_->set_time(end);
  put(to.kinematics);
  // The forces as the step ended: those that come with a tangent are rounded differently.
  linear::Matrix K;
  linear::Vector r(static_cast<std::size_t>(problem_->size()));
  if (step_.last.stability == solver::Stability::unchecked)
    problem_->residual(r);
  else
    problem_->tangent(K);
  trial_time_ = end;
  return error;
}

bool Static::left_shape() const { return step_.last.left_unstable > 0 || relaxing_ || crept_; }

// A search for the least energy finds lower ones in a long step than those along the way. Beside contact no
// other step is compared.
bool Static::falls() const {
  return by_shares() && (left_shape() || step_.last.iterations > kStaticIterations.many) &&
         energy().stored < now_.stored - usual_path * now_.most_stored;
}

// In a step of many iterations the shape may be another one in two halves, with any law: these are then
// solved afresh, and in runs of a few steps without being asked for. Otherwise only laws that remember their
// path are asked; without `path` with contact, whose steps are short, only where the cloth falls, and else
// the more seldom the less the steps err.
bool Static::asks_path(double part) {
  if (arc_) return false;
  const bool many = step_.last.iterations > kStaticIterations.many;
  falls_ = falls();
  afresh_ = by_shares() || (many && (options_.path || part > kLong));
  if (falls_) return true;
  if (options_.path) return remembers_path_ || many;
  if (by_shares()) return false;
  return afresh_ || (remembers_path_ && static_cast<std::int64_t>(reports_.size()) >= now_.path_next);
}

// Whether the step that has been solved is short enough.
bool Static::follows_path(double end, StepReport& report) {
  report.path = kUnknown;
  now_.path_ratio = 0;
  const double part = (end - committed_time()) / (duration_ - began());
  if (!asks_path(part)) return true;
  halves_ = path_error(end, report);
  report.path = halves_.error;
  now_.path_ratio = options_.path ? report.path / (*options_.path * std::max(part, kLeast)) : 0;
  if (falls_ && report.path > usual_path) return false;
  return !options_.path || now_.path_ratio <= 1;
}

void Static::note_path(const StepReport& report) {
  if (std::isnan(report.path)) {
    if ((falls_ || (options_.path && remembers_path_)) && !warned("path"))
      warn("path", "warning: static: the step of " + number(report.step) + " s at time " +
                       number(report.time) +
                       " s could not be compared with two halves, which have no equilibrium that is found: "
                       "whether " +
                       (falls_ ? "the cloth, which falls in it to another shape, does so in shorter steps"
                               : "laws that remember their path need shorter steps") +
                       " is not known");
    return;
  }
  const auto steps = static_cast<std::int64_t>(reports_.size());
  // A fall is no measure of the steps before it.
  const auto stands_for =
      falls_ ? 1.0 : static_cast<double>(std::max<std::int64_t>(1, steps - now_.path_asked));
  now_.path_gap = options_.path ? 1 : report.path < kSmall ? 2 * now_.path_gap : 1;
  now_.path_moved += stands_for * halves_.moved;
  now_.path_pulled += stands_for * halves_.pulled;
  now_.path_fallen += halves_.fallen;
  now_.path_asked = steps;
  now_.path_next = steps + now_.path_gap;
  if (report.path <= now_.path_worst) return;
  now_.path_worst = report.path;
  now_.path_parts = halves_.parts;
  now_.path_step = report.step;
  now_.path_time = report.time;
}

// At the end the errors of the steps are compared with the largest displacement and force of the run, which
// are small while it begins.
void Static::watch_path() {
  const double said = options_.path.value_or(usual_path),
               sum = std::max({now_.way > 0 ? now_.path_moved / now_.way : 0,
                               now_.path_force > 0 ? now_.path_pulled / now_.path_force : 0,
                               now_.most_stored > 0 ? now_.path_fallen / now_.most_stored : 0});
  if (warned("path") || sum <= said) return;
  warn("path", "warning: static: by time " + number(time()) + " s the steps are long: in " +
                   (now_.path_parts > 2 ? "four parts" : "two halves") + " they end " + number(100 * sum, 2) +
                   " % of the largest displacement, force or energy elsewhere, most that of " +
                   number(now_.path_step) + " s at time " + number(now_.path_time) + " s. Expected at most " +
                   number(100 * said) +
                   (options_.path ? " %, which the smallest step does not reach: a smaller min_step, or more "
                                    "max_cuts"
                                  : " %" + advice("path=0.01 cuts the steps where it is needed, or step=" +
                                                      number(now_.step.largest() / 4),
                                                  now_.step.largest() / 4)));
}

}  // namespace fabricsh::run
