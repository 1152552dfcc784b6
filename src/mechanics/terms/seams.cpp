#include "mechanics/terms/seams.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/sewing.hpp"

namespace fabricsh::mechanics {

namespace {

// Share of m / dt^2 that drawing threads have, m being the mass of both edges taken together and dt the
// largest step of the cloth: with it their own frequency does not limit a step.
constexpr double kStiff = 0.2;
constexpr double kDamped = 0.7;  // of their critical damping
constexpr double kReady = 0.8;   // share of the time of sewing at which the edges are to meet
constexpr double kLeads = 0.05;  // of that time: how fast a target leads as far as the thread is stretched
constexpr double kHand = 100;  // N/m, the pull of a thread that is led around a body, per length of its edge
constexpr double kHarder = 3;  // times as much at most, in proportion to the time that it takes
constexpr double kPresses = 0.1;         // share of the pull against a body that may press on it
constexpr double kTurned = 3;            // by how much at most what is left of the pull along it is enlarged
constexpr double kAverage = 1e-3;        // s, over which what presses is averaged
constexpr double kMeet = 0.01;           // of a mean edge: a seam that a body presses on closes from there
constexpr double kPatience = 0.25;       // of the time of a late seam, in which its gap has to fall
constexpr double kNoNearer = 0.98;       // of that gap, at most
constexpr double kSlow = 0.2;            // of a thread's own frequency: the same, in motion
constexpr double kStiffestThread = 0.5;  // as for springs of tears: share of m / dt^2 on their way back
constexpr double kThreadOrigin =
    1e-3;  // and in steps that iterate: of the opening at which they carry nothing more

// From 0 to 1, with rates of zero at both ends.
double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

}  // namespace

// --- one thread

double Thread::stiffness() const {
  if (!is_softening()) return k;
  const double onset = strength / k;
  return strength * std::max(0.0, 1 - (widest - onset) / (vanishes() - onset)) / widest;
}

double Thread::stiffness_rate() const {
  if (!is_softening() || !(widest > widest_before) || widest >= vanishes()) return 0;
  return -(strength / (vanishes() - strength / k) + stiffness()) / widest;
}

// The work on the way to the largest opening, less what comes back.
double Thread::fracture() const {
  if (!is_softening()) return 0;
  const double onset = strength / k, end = std::min(widest, vanishes());
  const double work = strength * onset / 2 + (end - onset) * (strength + stiffness() * end) / 2;
  return work - stiffness() * end * end / 2;
}

// Calls pass(trial, committed) for all that a step changes.
template <class Pass>
static void each_state(Thread& t, Pass pass) {
  pass(t.gap, t.gap_before), pass(t.target, t.target_before), pass(t.shift, t.shift_before);
  pass(t.damping, t.damping_before), pass(t.lost, t.lost_before), pass(t.widest, t.widest_before);
  for (Thread::End& end : t.ends) pass(end.x, end.x_before), pass(end.aside, end.aside_before);
}

void Thread::commit() {
  each_state(*this, [](const auto& trial, auto& committed) { committed = trial; });
}

void Thread::rollback() {
  each_state(*this, [](auto& trial, const auto& committed) { trial = committed; });
}

void Thread::keep(Archive& archive) {
  for (Vec3* v : {&gap_before, &target_before, &shift_before, &damping_before})
    archive(v->x(), v->y(), v->z());
  archive(lost_before, widest_before, speed, most);
  for (End& end : ends)
    for (Vec3* v : {&end.x_before, &end.pressed, &end.aside_before}) archive(v->x(), v->y(), v->z());
  if (archive.reading()) rollback();
}

// It never leads the gap by more than the thread bears, so that an edge that is caught is not torn loose.
Vec3 Thread::led(const Vec3& wanted, double dt, double most_now) const {
  const auto towards = [](const Vec3& from, const Vec3& to, double length) {
    const double way = (to - from).norm();
    return way > length ? Vec3(from + length / way * (to - from)) : to;
  };
  return towards(gap_before, towards(target_before, wanted, speed * dt), most_now / k + speed * dt);
}

// --- all of them

Seams::Seams(const model::Model& model, const Configuration& configuration, const Cloth& cloth,
             const Dofs& dofs)
    : model_(model), configuration_(configuration), cloth_(cloth), dofs_(dofs) {
  const auto& stitches = dofs.stitches();
  const double step = cloth.stable_step(true);
  std::map<Index, std::vector<Index>> around;
  for (const auto& s : stitches) around[s.node];
  for (const auto& e : model.mesh().elements)
    for (const Index n : e)
      if (const auto at = around.find(n); n >= 0 && at != around.end())
        for (const Index other : e)
          if (other >= 0) at->second.push_back(other);
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    Thread thread;
    double inverse = 1 / cloth.mass()[stitches[i].node];
    for (const auto& lead : stitches[i].leads) inverse += lead.weight * lead.weight / cloth.mass()[lead.node];
    thread.k = kStiff / (inverse * step * step);
    thread.pace = kSlow * std::sqrt(thread.k * inverse);
    thread.c = 2 * kDamped * std::sqrt(thread.k / inverse);
    if (seam(i).stiffness) {
      thread.k = *seam(i).stiffness * stitches[i].length;
      thread.strength = seam(i).strength.value_or(0) * stitches[i].length;
      thread.energy = seam(i).energy.value_or(0) * stitches[i].length;
    }
    thread.start = thread.gap = thread.target = dofs.gap(stitches[i], configuration.x());
    if (!seam(i).over) thread.start = thread.target = Vec3::Zero();
    thread.commit();
    threads_.push_back(thread);
    around_.push_back(around.at(stitches[i].node));
    breaks_ = breaks_ || has_strength(i);
  }
  late_.resize(dofs.seams().size());
  burst_.assign(stitches.size(), 0);
  springs_.resize(stitches.size());
  share_.assign(stitches.size(), 0);
  carried_.assign(stitches.size(), Vec3::Zero());
  list_joined();
}

Seams::State Seams::state(std::size_t i) const {
  const Sewn& sewn = dofs_.sewn();
  if (sewn.closed[i] != 0) return State::closed;
  if (burst_[i] != 0) return State::burst;
  if (seam(i).stiffness && (sewn.parted[i] == 0 || has_burst(i))) return State::own;
  return sewn.parted[i] != 0 ? State::open : State::drawn;
}

bool Seams::has_burst(std::size_t i) const { return burst_[i] != 0 || threads_[i].is_softening(); }

Vec3 Seams::nominal(std::size_t i, double time) const {
  const auto& over = seam(i).over;
  return over ? Vec3((1 - smooth(time / (kReady * *over))) * threads_[i].start) : Vec3(Vec3::Zero());
}

double Seams::closing_speed(std::size_t i) const {
  constexpr double steepest = 15.0 / 8;  // of smooth(), in the middle
  const auto& over = seam(i).over;
  return over ? steepest * threads_[i].start.norm() / (kReady * *over) : 0;
}

// The target leads what is wanted by an integral of how far the thread is stretched, so that the edges meet
// whatever they carry.
void Seams::pull(const law::Step& step, const Trial& trial, std::size_t i) {
  Thread& t = threads_[i];
  t.gap = dofs_.gap(dofs_.stitches()[i], trial.configuration.x());
  if (step.dt > 0) {
    const auto& over = seam(i).over;
    const bool drawing = over && (state(i) == State::drawn || time_before_ < *over);
    const bool moves = drawing && trial.motion != nullptr && trial.motion->moves();
    t.shift = t.shift_before;
    const Vec3 before = nominal(i, time_before_);
    const bool follows = !t.is_led() || t.target_before == before - t.shift_before;
    if (over && !seam(i).stiffness && follows) {
      const double pace = std::min(1 / (kLeads * *over), moves ? t.pace : 1 / step.dt);
      t.shift += std::min(1.0, pace * step.dt) * (t.gap_before - before);
    }
    t.target = nominal(i, trial.time) - t.shift;
    if (t.is_led()) {
      const double late = std::clamp(time_before_ / *over, 1.0, kHarder);
      t.target = t.led(t.target, step.dt, late * t.most);
    }
    const Vec3 stretch = (t.gap - t.gap_before) - (t.target - t.target_before);
    t.damping = moves ? Vec3(t.c / step.dt * stretch) : Vec3(Vec3::Zero());
    const double late = moves ? trial.motion->weight_of_end() : 0.5;
    double lost = (late * t.damping + (1 - late) * t.damping_before).dot(stretch);
    // Where the stretch swings from one implicit step to the next, the mean of the forces would give energy
    // back: that is an error of the ledger.
    if (moves && trial.motion->damping_weight() > 0) lost = std::max(lost, 0.0);
    t.lost = t.lost_before + lost;
  }
  if (t.is_led()) deflect(i, trial.configuration.x());
  t.widest = t.widest_before;
  if (t.strength > 0) t.widest = std::max(t.widest, parting(i, trial.configuration.x()).norm());
}

Vec3 Seams::parting(std::size_t i, std::span<const double> x) const {
  const Vec3 out = outward(i, x), gap = Dofs::gap(dofs_.stitches()[i], x);
  const double along = gap.dot(out);
  return along < 0 ? gap : Vec3(gap - along * out);
}

Vec3 Seams::way(std::size_t i, std::span<const double> x) const {
  return springs_[i].offset * springs_[i].force.normalized() - Dofs::gap(dofs_.stitches()[i], x);
}

// A force on the node, internal, and its counterpart on what it is sewn to.
void Seams::put(std::size_t i, const Vec3& force, std::span<double> on_x) const {
  const auto& stitch = dofs_.stitches()[i];
  at(on_x, stitch.node) += force;
  for (const auto& lead : stitch.leads) at(on_x, lead.node) -= lead.weight * force;
}

void Seams::put_aside(std::size_t i, std::span<double> on_x) const {
  const auto& stitch = dofs_.stitches()[i];
  at(on_x, stitch.node) -= threads_[i].ends[0].aside;
  for (const auto& lead : stitch.leads) at(on_x, lead.node) -= lead.weight * threads_[i].ends[1].aside;
}

Outcome Seams::add_forces(const law::Step& step, const Trial& trial, Forces& forces) {
  for (std::size_t i = 0; i < threads_.size(); ++i) switch (state(i)) {
      case State::drawn:
      case State::own:
        pull(step, trial, i);
        if (has_strength(i))
          share_[i] =
              dofs_.sewn().parted[i] != 0 ? 0 : threads_[i].k * threads_[i].widest / threads_[i].strength;
        put(i, threads_[i].force(), forces.on_x);
        if (threads_[i].is_led()) put_aside(i, forces.on_x);
        break;
      case State::burst:
        put(i, -springs_[i].pull(way(i, trial.configuration.x())), forces.on_x);
        break;
      case State::closed:
      case State::open:
        break;
    }
  if (breaks_) measure(trial.configuration.x(), forces.on_x);
  return {};
}

void Seams::couple(const Trial&, std::vector<NodePair>& pairs) {
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (state(i) == State::closed || state(i) == State::open) continue;
    const auto& stitch = dofs_.stitches()[i];
    for (std::size_t a = 0; a < stitch.leads.size(); ++a) {
      pairs.emplace_back(stitch.node, stitch.leads[a].node);
      for (std::size_t b = 0; b < a; ++b) pairs.emplace_back(stitch.leads[a].node, stitch.leads[b].node);
    }
  }
}

// Of the force on the stitch's node by that node. A thread that softens does so along what parts it; the way
// back, and across, it is a spring.
Mat3 Seams::tangent(const Trial& trial, std::size_t i) const {
  const auto x = trial.configuration.x();
  if (state(i) == State::burst) return springs_[i].stiffness(way(i, x), false);
  const Thread& t = threads_[i];
  const bool implicit = trial.motion != nullptr && trial.motion->damping_weight() > 0;
  const double c = implicit && trial.motion->dt() > 0 ? t.c / trial.motion->dt() : 0;
  Mat3 k = (t.stiffness() + c) * Mat3::Identity();
  if (const double rate = t.stiffness_rate(); rate < 0) {
    const Vec3 apart = parting(i, x);
    k += rate / apart.norm() * apart * apart.transpose();
  }
  return k;
}

void Seams::add_tangent(const Trial& trial, TangentSink& sink) const {
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (state(i) == State::closed || state(i) == State::open) continue;
    const auto& stitch = dofs_.stitches()[i];
    const Mat3 k = tangent(trial, i);
    sink.on_positions(stitch.node, stitch.node, k);
    for (const auto& a : stitch.leads) {
      sink.on_positions(stitch.node, a.node, -a.weight * k);
      sink.on_positions(a.node, stitch.node, -a.weight * k);
      for (const auto& b : stitch.leads) sink.on_positions(a.node, b.node, a.weight * b.weight * k);
    }
  }
}

void Seams::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  double stored = 0, bridged = 0, lost = 0, fracture = 0;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const Thread& t = threads_[i];
    const State now = state(i);
    lost += t.lost;
    fracture += t.fracture();
    if (now == State::drawn || now == State::own)
      stored += t.stiffness() * (t.gap - t.target).squaredNorm() / 2;
    if (burst_[i] == 0) continue;
    bridged += springs_[i].stored(way(i, trial.configuration.x()));
    fracture += springs_[i].lost();
  }
  out.push_back({"threads", Account::stored, stored + bridged});
  out.push_back({"sewing", Account::dissipated, lost});
  out.push_back({"fracture", Account::dissipated, fracture});
}

// Of what shortens the threads.
StepWork Seams::step_work() const {
  StepWork sum;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const Thread& t = threads_[i];
    if (!seam(i).over || (state(i) != State::drawn && state(i) != State::own)) continue;
    const Vec3 before = t.stiffness() * (t.gap_before - t.target_before) + t.damping_before;
    const Vec3 way = t.target - t.target_before;
    const double change = (before - t.force()).dot(way) / 2;
    sum += {-(t.force() + before).dot(way) / 2, std::abs(change), change};
    for (const Thread::End& end : t.ends) {
      const Vec3 moved = end.x - end.x_before;
      const double more = (end.aside - end.aside_before).dot(moved) / 2;
      sum += {(end.aside + end.aside_before).dot(moved) / 2, std::abs(more), more};
    }
  }
  return sum;
}

// --- strength

// From the sheet across its edge, at the stitch's node; unit, or zero where the sheet gives no direction.
Vec3 Seams::outward(std::size_t i, std::span<const double> x) const {
  Vec3 mean = Vec3::Zero();
  for (const Index n : around_[i]) mean += at(x, n);
  const Vec3 out = at(x, dofs_.stitches()[i].node) - mean / static_cast<double>(around_[i].size());
  return out.norm() > 0 ? Vec3(out.normalized()) : Vec3(Vec3::Zero());
}

// A pressure of the edges against each other does not break the seam.
double Seams::share_of(std::size_t i, std::span<const double> x) const {
  const Vec3 out = outward(i, x);
  const double along = traction_[i].dot(out);
  const Vec3 parting = along > 0 ? traction_[i] : Vec3(traction_[i] - along * out);
  return parting.norm() / *seam(i).strength;
}

void Seams::list_joined() {
  joined_.clear();
  for (const auto& f : dofs_.freedoms().followers)
    if (f.sewn && f.component < 3) joined_.push_back(f);
}

// The force of the seam on a node gives it the acceleration of its joint: S = f + m a, with its internal
// force f and a = -sum f / sum m over all nodes of the joint.
void Seams::measure(std::span<const double> x, std::span<const double> on_x) {
  std::map<Index, std::array<std::pair<double, double>, 3>> sums;  // of each joint: force, mass
  const auto& mass = cloth_.mass();
  const auto& nodes = dofs_.freedoms().nodes;
  for (const auto& f : joined_)
    for (const auto& lead : f.leads) {
      const auto c = static_cast<std::size_t>(f.component);
      auto& sum = sums.try_emplace(lead.node).first->second[c];
      if (sum.second == 0) sum = {at(on_x, lead.node)[f.component], mass[lead.node]};
      sum.first += lead.weight * at(on_x, f.node)[f.component];
      sum.second += lead.weight * mass[f.node];
    }
  const auto acceleration = [&](Index n, std::size_t c) {
    const auto found = sums.find(n);
    if (found == sums.end() || found->second[c].second == 0 || nodes[n].equation[c] < 0) return 0.0;
    return -found->second[c].first / found->second[c].second;
  };
  const auto& stitches = dofs_.stitches();
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    carried_[i].setZero();
    if (!has_strength(i) || state(i) == State::own) continue;
    share_[i] = 0;
    if (state(i) != State::closed) continue;
    const Index n = stitches[i].node;
    for (std::size_t c = 0; c < 3; ++c) {
      const Index equation = nodes[n].equation[c];
      if (is_prescribed(equation)) continue;
      double a = equation >= 0 ? acceleration(n, c) : 0;
      if (equation == tied)
        for (const auto& f : joined_)
          if (f.node == n && f.component == static_cast<int>(c))
            for (const auto& lead : f.leads) a += lead.weight * acceleration(lead.node, c);
      carried_[i][static_cast<int>(c)] = at(on_x, n)[static_cast<int>(c)] + mass[n] * a;
    }
  }
  spread();
  for (std::size_t i = 0; i < stitches.size(); ++i)
    if (has_strength(i) && state(i) == State::closed) share_[i] = share_of(i, x);
}

// Force per length of the seam on each closed stitch. Where the edges have different spacings, single
// stitches carry more and less than the seam does in the mean over the longer of the elements beside it: that
// mean is what is compared with the strength.
void Seams::spread() {
  const auto& stitches = dofs_.stitches();
  std::map<Index, std::pair<Vec3, double>> sums;  // at each node that stitches follow: N, m
  const auto each = [&](auto&& visit) {
    for (std::size_t i = 0; i < stitches.size(); ++i)
      if (has_strength(i) && state(i) == State::closed)
        for (const auto& lead : stitches[i].leads) visit(i, lead);
  };
  each([&](std::size_t i, const model::Lead& lead) {
    auto& [force, length] = sums.try_emplace(lead.node, Vec3::Zero(), 0.0).first->second;
    force += lead.weight * carried_[i];
    length += lead.weight * stitches[i].length;
  });
  traction_.assign(stitches.size(), Vec3::Zero());
  each([&](std::size_t i, const model::Lead& lead) {
    const auto& [force, length] = sums.at(lead.node);
    traction_[i] += lead.weight / length * force;
  });
}

Seams::WorstStitch Seams::worst() const {
  const auto most = std::max_element(share_.begin(), share_.end());
  if (most == share_.end() || !(*most > 0)) return {};
  const auto i = static_cast<std::size_t>(most - share_.begin());
  return {*most, *seam(i).strength, seam(i).name(),
          dofs_.reference()[static_cast<std::size_t>(dofs_.stitches()[i].node)]};
}

Sewn Seams::let_go(double step) {
  Sewn next = dofs_.sewn();
  const auto& stitches = dofs_.stitches();
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    if (!(share_[i] >= 1)) continue;
    next.parted[i] = 1;
    if (state(i) != State::closed) continue;
    double inverse = 1 / cloth_.mass()[stitches[i].node];
    for (const auto& lead : stitches[i].leads)
      inverse += lead.weight * lead.weight / cloth_.mass()[lead.node];
    next.closed[i] = 0;
    CohesiveSpring spring;
    spring.force = carried_[i];
    spring.energy = *seam(i).energy * stitches[i].length;
    spring.offset = step > 0 ? carried_[i].norm() * step * step * inverse / kStiffestThread
                             : kThreadOrigin * spring.vanishes();
    ready_.push_back(spring);
    ready_at_.push_back(i);
  }
  return next;
}

// --- opening and closing

void Seams::decide_turning(Sewn& next) const {
  const auto x = configuration_.x(), d = configuration_.d();
  const SewnEdges edges{model_.mesh(), dofs_.stitches(), [x](Index n) { return Vec3(at(x, n)); },
                        [d](Index n) { return Vec3(at(d, n)); }};
  std::vector<char> closed(next.turning.size(), 0), closes = closed;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (dofs_.sewn().closed[i] != 0) closed[dofs_.stitches()[i].seam] = 1;
    if (next.closed[i] != 0) closes[dofs_.stitches()[i].seam] = 1;
  }
  for (std::size_t s = 0; s < closes.size(); ++s)
    if (closes[s] != 0 && closed[s] == 0) next.turning[s] = edges.turning(dofs_.seams()[s], s);
}

double Seams::widest(std::size_t s) const {
  double most = 0;
  for (std::size_t i = 0; i < threads_.size(); ++i)
    if (dofs_.stitches()[i].seam == s && state(i) == State::drawn)
      most = std::max(most, dofs_.gap(dofs_.stitches()[i], configuration_.x()).norm());
  return most;
}

bool Seams::is_pressed(std::size_t s) const {
  if (contact_ == nullptr) return false;
  const std::vector<char> pressed = contact_->pressed_by_bodies();
  const auto at_node = [&](Index n) { return pressed[static_cast<std::size_t>(n)] != 0; };
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const model::Stitch& stitch = dofs_.stitches()[i];
    if (stitch.seam != s || state(i) != State::drawn) continue;
    if (at_node(stitch.node) || std::any_of(stitch.leads.begin(), stitch.leads.end(),
                                            [&](const auto& lead) { return at_node(lead.node); }))
      return true;
  }
  return false;
}

void Seams::lead_around(std::size_t stitch, double speed) {
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    const model::Stitch& at_stitch = dofs_.stitches()[i];
    if (at_stitch.seam != dofs_.stitches()[stitch].seam || seam(i).stiffness) continue;
    Thread& t = threads_[i];
    t.speed = speed;
    t.most = kHand * at_stitch.length;
    deflect(i, configuration_.x());
    t.commit();
  }
}

// At what the stitch's node is sewn to.
Vec3 Seams::on_place(std::size_t i, std::span<const Vec3> at_nodes) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& lead : dofs_.stitches()[i].leads)
    sum += lead.weight * at_nodes[static_cast<std::size_t>(lead.node)];
  return sum;
}

// A hand that draws cloth over a body does not press it against it, which would hold it by friction: the part
// of the pull against a pressing surface turns along it. The pull keeps its size, as far as kTurned allows.
void Seams::deflect(std::size_t i, std::span<const double> x) {
  Thread& t = threads_[i];
  t.ends[0].x = at(x, dofs_.stitches()[i].node);
  t.ends[1].x = t.ends[0].x - t.gap;
  double sign = -1;
  for (Thread::End& end : t.ends) {
    const Vec3 pull = sign * t.force();
    const double pressed = end.pressed.norm(), into = pressed > 0 ? -pull.dot(end.pressed) / pressed : 0;
    end.aside.setZero();
    sign = 1;
    if (!(into > 0)) continue;
    const double share = std::min(1.0, pressed / (kPresses * into));
    const Vec3 along = pull + share * into / pressed * end.pressed;
    end.aside = std::min(kTurned, pull.norm() / std::max(along.norm(), 1e-12 * into)) * along - pull;
  }
}

void Seams::average_pressing() {
  if (contact_ == nullptr) return;
  const auto pressing = contact_->nodal_forces();
  const double part = std::min(1.0, (configuration_.time() - time_before_) / kAverage);
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (!threads_[i].is_led() || state(i) != State::drawn) continue;
    auto& ends = threads_[i].ends;
    ends[0].pressed +=
        part * (pressing[static_cast<std::size_t>(dofs_.stitches()[i].node)] - ends[0].pressed);
    ends[1].pressed += part * (on_place(i, pressing) - ends[1].pressed);
  }
}

bool Seams::draws() const {
  for (std::size_t i = 0; i < threads_.size(); ++i)
    if (state(i) == State::drawn) return true;
  return false;
}

std::optional<Seams::Lagging> Seams::lagging(std::optional<std::size_t> of_seam) const {
  std::optional<Lagging> most;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (state(i) != State::drawn || !seam(i).over) continue;
    if (of_seam && *of_seam != dofs_.stitches()[i].seam) continue;
    const double gap = threads_[i].gap_before.norm(), wanted = nominal(i, time_before_).norm();
    if (!most || gap - wanted > most->gap - most->wanted)
      most = Lagging{i, gap, wanted, at(configuration_.x(), dofs_.stitches()[i].node)};
  }
  return most;
}

bool Seams::is_over(std::size_t i, double time) const { return time >= *seam(i).over * (1 - 1e-9); }

// A body that presses on an edge would be passed through where the edges are moved together: such a seam
// waits.
std::optional<Seams::Lagging> Seams::stuck() {
  std::optional<Lagging> found;
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (state(i) != State::drawn || !is_over(i, time_before_)) continue;
    const std::size_t s = dofs_.stitches()[i].seam;
    Late& late = late_[s];
    if (late.since < 0 && !threads_[i].is_led() && !is_pressed(s)) continue;
    if (late.told || (late.since >= 0 && time_before_ < late.since + kPatience * *seam(i).over)) continue;
    const double gap = widest(s);
    late.told = !found && late.since >= 0 && gap > kNoNearer * late.gap;
    if (late.told) found = lagging(s);
    late.since = time_before_;
    late.gap = gap;
  }
  return found;
}

Sewn Seams::due(double time) const {
  Sewn next = dofs_.sewn();
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    if (state(i) != State::drawn || !is_over(i, time)) continue;
    const std::size_t s = dofs_.stitches()[i].seam;
    if (late_[s].since < 0 || widest(s) <= kMeet * dofs_.length()) next.closed[i] = 1;
  }
  if (next != dofs_.sewn()) decide_turning(next);
  return next;
}

// The forces of springs that begin are those that the closed seam carried.
void Seams::renumbered(Forces& forces) {
  for (std::size_t k = 0; k < ready_.size(); ++k) {
    const std::size_t i = ready_at_[k];
    springs_[i] = ready_[k];
    burst_[i] = 1;
    put(i, -ready_[k].force, forces.on_x);
  }
  ready_.clear();
  ready_at_.clear();
  list_joined();
  for (std::size_t i = 0; i < share_.size(); ++i)
    if (dofs_.sewn().parted[i] != 0) share_[i] = 0;
  if (breaks_) measure(configuration_.x(), forces.on_x);
  committed_share_ = worst().share;
}

void Seams::commit() {
  average_pressing();
  time_before_ = configuration_.time();
  for (Thread& thread : threads_) thread.commit();
  for (CohesiveSpring& spring : springs_) spring.committed = spring.widest;
  committed_share_ = worst().share;
}

void Seams::rollback() {
  for (Thread& thread : threads_) thread.rollback();
  for (CohesiveSpring& spring : springs_) spring.widest = spring.committed;
}

void Seams::keep(Archive& archive) {
  for (Thread& thread : threads_) thread.keep(archive);
  archive(burst_, share_, springs_, time_before_, late_);
  if (!archive.reading()) return;
  list_joined();
  rollback();
  committed_share_ = worst().share;
}

std::vector<std::string> Seams::describe() const {
  std::vector<std::string> lines;
  for (std::size_t s = 0; s < dofs_.seams().size(); ++s) {
    const model::Seam& seam = dofs_.seams()[s];
    double length = 0, farthest = 0;
    std::size_t count = 0, between = 0;
    for (const auto& stitch : dofs_.stitches()) {
      if (stitch.seam != s) continue;
      length += stitch.length;
      farthest = std::max(farthest, dofs_.gap(stitch, configuration_.x()).norm());
      ++count;
      between += stitch.leads.size() > 1 ? 1 : 0;
    }
    std::string line =
        "seam " + seam.name() + ": " + std::to_string(count) + " stitches over " + number(length) + " m";
    if (between > 0) line += ", " + std::to_string(between) + " of them between two nodes";
    line += seam.over
                ? ", drawn together from up to " + number(farthest) + " m over " + number(*seam.over) + " s"
                : ", closed at the start";
    if (!seam.over && !seam.stiffness)
      line += dofs_.sewn().turning[s] != 0 ? ", bends as one piece" : ", a hinge";
    lines.push_back(line);
  }
  return lines;
}

}  // namespace fabricsh::mechanics
