#include "run/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/contact.hpp"
#include "model/parts.hpp"
#include "run/beginning.hpp"
#include "run/run.hpp"
#include "solver/eigen.hpp"

namespace fabricsh::run {

namespace {

// Of the sums of the absolute entries: what is added to a stiffness so that it has factors where cloth moves
// freely, and what counts as none, as in solver/stability.cpp. Shares of the fastest displacements' rates.
constexpr double kShift = 1e-10, kNoStiffnessOfMode = 1e-13;
constexpr double kAlmostSymmetric = 1e-9;  // of entries above and below the diagonal
constexpr int kMostModes = 400;            // modes

// The matrices of a model in a state.
class Linearised {
 public:
  explicit Linearised(const std::shared_ptr<model::Model>& model, const char* call)
      : model_(compiled(model)), assembly_(*model_), call_(call), unconnected_(model::unconnected(*model_)) {
    take_bodies();
    if (const auto* const contact = std::as_const(assembly_).terms().find<mechanics::Contacts>())
      contact->check_start();
    assembly_.set_time(0);
    if (!assembly_.forces({})) throw Error("the law fails at rest");
  }
  Linearised(const Run& run, const char* call) : model_(run.shared_model()), assembly_(*model_), call_(call) {
    take_bodies();
    assembly_.begin_from(run.assembly(), true);
  }
  // The cloth of a run in its state, with the supports and loads of another model of it.
  Linearised(const Run& run, const std::shared_ptr<model::Model>& model, const char* call)
      : model_(compiled(model)), assembly_(*model_), call_(call) {
    assembly_.begin_from(run.assembly(), true);
  }

  mechanics::Assembly& assembly() { return assembly_; }
  const model::Model& model() const { return *model_; }
  // The symmetric part of the tangent.
  linear::Matrix stiffness(law::AtSwitch at) {
    linear::Matrix K, S;
    const double now = std::as_const(assembly_).state().time();
    if (!assembly_.tangent({now, 0, at}, K, {}, {})) throw Error("the law fails in this state");
    linear::Vector D;
    linear::absolute_sums(K, D);
    unsymmetric_ = linear::symmetric_part(K, D, S) > kAlmostSymmetric;
    return bodies_ == nullptr ? S : with_bodies(S);
  }
  // That of the law alone, without what stresses and loads add.
  linear::Matrix law_stiffness() {
    linear::Matrix K, S;
    if (!assembly_.material_tangent(K, {}, {})) throw Error("the law fails in this state");
    linear::Vector D;
    linear::absolute_sums(K, D);
    linear::symmetric_part(K, D, S);
    return S;
  }
  // Directors have next to no inertia: that of the thickness is no more than (pi t / wavelength)^2 / 12 of
  // the mass, and where cloth bends more easily than a solid sheet it would let directors of quadrilaterals
  // swing alternately, which no shear resists, among the lowest modes.
  linear::Matrix mass() {
    constexpr double share = 1e-6;
    std::vector<double> rotary = assembly_.cloth().rotary_inertia(false);
    for (double& inertia : rotary) inertia *= share;
    linear::Matrix M(assembly_.pattern());
    assembly_.add_diagonal(assembly_.cloth().mass(), rotary, M);
    return bodies_ == nullptr ? M : with_masses(M);
  }
  // 1/s^2: the largest rate of a single displacement.
  double fastest(const linear::Matrix& K, const linear::Matrix& M) const {
    linear::Vector D;
    linear::absolute_sums(K, D);
    double most = 0;
    for (mechanics::Index i = 0; i < K.size(); ++i)
      if (is_place(i)) most = std::max(most, D[i] / M.value[static_cast<std::size_t>(M.pattern->slot(i, i))]);
    return most;
  }
  mechanics::NodalRates spread(const linear::Vector& unknowns) const {
    mechanics::NodalRates out;
    const auto of_cloth = static_cast<std::size_t>(assembly_.dofs().unknowns());
    assembly_.dofs().spread_rates(linear::Vector(unknowns.begin(), unknowns.begin() + of_cloth), still(),
                                  out);
    return out;
  }
  std::shared_ptr<const Shape> shape(const mechanics::NodalRates& way) const {
    auto shape = std::make_shared<Shape>();
    shape->mesh = model_->mesh_pointer();
    const auto x = assembly_.state().x();
    double most = 0;
    Vec3 largest = Vec3::Zero();
    const auto nodes = static_cast<std::ptrdiff_t>(assembly_.state().nodes());
    for (std::ptrdiff_t n = 0; n < nodes; ++n) {
      shape->from.push_back(at(x, n));
      shape->way.push_back(at(way.x, n));
      // Of ways that differ by rounding alone the first one.
      if (shape->way.back().norm() > most * (1 + 1e-6)) {
        most = shape->way.back().norm();
        largest = shape->way.back();
      }
    }
    Eigen::Index along = 0;
    largest.cwiseAbs().maxCoeff(&along);
    if (largest[along] < 0) most = -most;
    for (Vec3& way_of_node : shape->way) way_of_node /= most == 0 ? 1 : most;
    return shape;
  }
  // kg: what supports that shake along an axis shake with them, less what they hold. All effective masses
  // along it have this sum.
  Vec3 mass_that_moves(const linear::Matrix& M) {
    const auto& masses = assembly_.cloth().mass();
    const std::vector<double> none(3 * masses.size());
    linear::Vector push(static_cast<std::size_t>(assembly_.dofs().unknowns()));
    Vec3 all = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> along(none.size());
      for (std::size_t n = 0; n < masses.size(); ++n)
        along[3 * n + static_cast<std::size_t>(axis)] = masses[n];
      assembly_.dofs().residual(along, none, none, {}, nullptr, push);
      for (mechanics::Index i = 0; i < assembly_.dofs().unknowns(); ++i)
        if (!assembly_.dofs().turns(i))
          all[axis] += push[i] * push[i] / M.value[static_cast<std::size_t>(M.pattern->slot(i, i))];
    }
    for (const int k : of_bodies_)
      if (k % 6 < 3)
        all[k % 6] += bodies_->bodies().equations().mass_matrix(static_cast<std::size_t>(k / 6))(0, 0);
    return all;
  }
  // kg: of a motion, by the rigid bodies in it.
  Vec3 momentum_of_bodies(const linear::Vector& unknowns) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < of_bodies_.size(); ++i)
      if (const int k = of_bodies_[i]; k % 6 < 3)
        sum[k % 6] += bodies_->bodies().equations().mass_matrix(static_cast<std::size_t>(k / 6))(0, 0) *
                      unknowns[static_cast<std::size_t>(assembly_.dofs().unknowns()) + i];
    return sum;
  }
  std::vector<std::string> words() const {
    std::vector<std::string> all;
    const std::string call = call_;
    for (const std::string& words : unconnected_) all.push_back("warning: " + words);
    if (unsymmetric_)
      all.push_back(call +
                    ": the tangent is not symmetric, as with friction, moments or pressure on cloth with "
                    "free edges: these are modes of its symmetric part");
    const auto* const contact = assembly_.terms().find<mechanics::Contacts>();
    if (contact != nullptr)
      all.push_back(
          call + ": contact stays as it is in this state: " + std::to_string(contact->readings().touching()) +
          (contact->readings().touching() == 1 ? " place touches" : " places touch") +
          " and remain closed, all others remain open");
    return all;
  }

 private:
  static std::shared_ptr<model::Model> compiled(const std::shared_ptr<model::Model>& model) {
    model->validate();
    model->divide_zones();
    if (model->mesh().whole) model->seal();  // its mesh is another one from here on
    return model;
  }
  // Free bodies have six further unknowns each behind those of the cloth: places, and turns about their
  // centres.
  void take_bodies() {
    if (assembly_.dofs().unknowns() == 0) throw Error("every node of the model is held: nothing can move");
    auto* const contact = assembly_.terms().find<mechanics::Contacts>();
    if (contact == nullptr || !contact->bodies().any_free()) return;
    if (call_ != std::string_view("modes"))
      throw Error(
          "the model has a rigid body that moves freely, and is not multiplied with the loads: expected "
          "bodies "
          "that stand or are moved");
    if (const std::string& body = contact->bodies().without_mass(); !body.empty())
      throw Error("the " + body + " moves freely and has no mass: expected one, mass=");
    contact->go_static(0);
    bodies_ = contact;
    for (std::size_t f = 0; 6 * f < contact->unknowns().own_unknowns(); ++f)
      for (int c = 0; c < 6; ++c)
        if (contact->bodies().equations().freedom(f)[c] != 0)
          of_bodies_.push_back(static_cast<int>(6 * f) + c);
  }
  bool is_place(mechanics::Index unknown) const {
    const mechanics::Index cloth = assembly_.dofs().unknowns();
    return unknown < cloth ? !assembly_.dofs().turns(unknown)
                           : of_bodies_[static_cast<std::size_t>(unknown - cloth)] % 6 < 3;
  }
  // A matrix of the cloth beside zeros for the bodies, in the pattern that both have together.
  linear::Matrix beside_bodies(const linear::Matrix& of_cloth) const {
    linear::Matrix out(whole_);
    for (mechanics::Index c = 0; c < of_cloth.size(); ++c)
      for (mechanics::Index i = of_cloth.pattern->column[static_cast<std::size_t>(c)];
           i < of_cloth.pattern->column[static_cast<std::size_t>(c) + 1]; ++i)
        out.add(of_cloth.pattern->row[static_cast<std::size_t>(i)], c,
                of_cloth.value[static_cast<std::size_t>(i)]);
    out.ranks = of_cloth.ranks;
    return out;
  }
  linear::Matrix with_bodies(const linear::Matrix& of_cloth) {
    const auto rest = bodies_->unknowns().at_rest();
    const mechanics::Index n = of_cloth.size(), m = static_cast<mechanics::Index>(of_bodies_.size());
    const std::vector<double> none(3 * assembly_.cloth().mass().size(), 0);
    std::vector<linear::Vector> coupled;
    std::vector<std::vector<linear::Index>> columns(static_cast<std::size_t>(n + m));
    for (mechanics::Index c = 0; c < n; ++c)
      for (mechanics::Index i = of_cloth.pattern->column[static_cast<std::size_t>(c)];
           i < of_cloth.pattern->column[static_cast<std::size_t>(c) + 1]; ++i)
        columns[static_cast<std::size_t>(c)].push_back(of_cloth.pattern->row[static_cast<std::size_t>(i)]);
    for (mechanics::Index k = 0; k < m; ++k) {
      coupled.emplace_back(static_cast<std::size_t>(n));
      const auto of_body = static_cast<std::size_t>(of_bodies_[static_cast<std::size_t>(k)]);
      assembly_.dofs().residual(rest.on_nodes[of_body], none, none, {}, nullptr, coupled.back());
      for (mechanics::Index r = 0; r < n + m; ++r) {
        if (r < n && coupled.back()[static_cast<std::size_t>(r)] == 0) continue;
        columns[static_cast<std::size_t>(n + k)].push_back(r);
        if (r < n) columns[static_cast<std::size_t>(r)].push_back(n + k);
      }
    }
    whole_ = std::make_shared<const linear::Pattern>(std::move(columns));
    linear::Matrix out = beside_bodies(of_cloth);
    for (mechanics::Index k = 0; k < m; ++k) {
      for (mechanics::Index r = 0; r < n; ++r)
        if (const double value = coupled[static_cast<std::size_t>(k)][static_cast<std::size_t>(r)];
            value != 0) {
          out.add(r, n + k, value);
          out.add(n + k, r, value);
        }
      const int of_k = of_bodies_[static_cast<std::size_t>(k)];
      for (mechanics::Index l = 0; l < m; ++l)
        out.add(n + l, n + k, rest.stiffness(of_bodies_[static_cast<std::size_t>(l)], of_k));
    }
    for (std::size_t v = 0; v < out.ranks.columns.size(); ++v)
      for (const int k : of_bodies_)
        out.ranks.columns[v].push_back(rest.of_volumes[static_cast<std::size_t>(k)][v]);
    return out;
  }
  linear::Matrix with_masses(const linear::Matrix& of_cloth) const {
    linear::Matrix out = beside_bodies(of_cloth);
    const mechanics::Index n = of_cloth.size();
    for (std::size_t k = 0; k < of_bodies_.size(); ++k)
      for (std::size_t l = 0; l < of_bodies_.size(); ++l)
        if (of_bodies_[k] / 6 == of_bodies_[l] / 6)
          out.add(n + static_cast<mechanics::Index>(k), n + static_cast<mechanics::Index>(l),
                  bodies_->bodies().equations().mass_matrix(static_cast<std::size_t>(of_bodies_[k] / 6))(
                      of_bodies_[k] % 6, of_bodies_[l] % 6));
    return out;
  }
  std::vector<double> still() const {
    return std::vector<double>(assembly_.dofs().freedoms().motions.size(), 0.0);
  }

  std::shared_ptr<model::Model> model_;
  mechanics::Assembly assembly_;
  const char* call_;
  std::vector<std::string> unconnected_ = {};  // which the run has said otherwise
  bool unsymmetric_ = false;
  const mechanics::Contacts* bodies_ = nullptr;   // null: no body moves freely
  std::vector<int> of_bodies_;                    // of their numbers, 6 each, those that are unknowns
  std::shared_ptr<const linear::Pattern> whole_;  // of cloth and bodies
};

// K + m M, and its factors, with an m from `least` on for which they exist.
struct Shifted {
  linear::Matrix A;
  double shift = 0;
  std::unique_ptr<linear::LinearSolver> solver = linear::with_ranks(linear::make_symmetric_solver());
};

bool is_definite(Shifted& shifted) {
  return shifted.solver->factorise(shifted.A) && shifted.solver->report().negative_pivots == 0;
}

void shift_by(const linear::Matrix& K, const linear::Matrix& M, double m, Shifted& out) {
  out.shift = m;
  out.A = K;
  for (std::size_t i = 0; i < out.A.value.size(); ++i) out.A.value[i] += m * M.value[i];
}

void make_definite(const linear::Matrix& K, const linear::Matrix& M, double least, Shifted& out) {
  shift_by(K, M, least, out);
  for (int i = 0; !is_definite(out) && i < 16; ++i) shift_by(K, M, out.shift * 10, out);
}

// How many eigenvalues of A x = theta B x are above one that is none of them: by Sylvester's law of inertia
// the negative ones of B - A / theta. -1: the factors do not tell.
mechanics::Index count_above(const linear::Matrix& A, const linear::Matrix& B, double theta) {
  Shifted at;
  shift_by(B, A, -1 / theta, at);
  at.solver = linear::with_ranks(linear::make_unsymmetric_solver());
  return at.solver->factorise(at.A) ? at.solver->report().negative_pivots : -1;
}

// How many eigenvalues above the last of those that have been found are not among them.
mechanics::Index missing(const linear::Matrix& A, const linear::Matrix& B, const solver::Eigenpairs& found) {
  constexpr double apart = 1e-6;  // of an eigenvalue, above which another one is not the same
  if (found.value.size() < 2 || !(found.value.back() > 0)) return 0;
  const double cut = found.value.back() * (1 + apart);
  const auto have =
      std::count_if(found.value.begin(), found.value.end(), [cut](double theta) { return theta > cut; });
  return std::max<mechanics::Index>(0, count_above(A, B, cut) - have);
}

// The largest eigenvalues of A x = theta B x, counted: where some are missing they are looked for among more
// of them, and where they stay away that is said.
solver::Eigenpairs counted_pairs(const linear::Matrix& A, Shifted& B, int count, const std::string& call,
                                 std::vector<std::string>& words) {
  constexpr int more = 16;
  auto found = solver::largest_eigenpairs(A, B.A, *B.solver, count);
  mechanics::Index lost = missing(A, B.A, found);
  if (lost == 0) return found;
  found = solver::largest_eigenpairs(A, B.A, *B.solver, count + static_cast<int>(lost) + more);
  lost = missing(A, B.A, found);
  if (lost > 0)
    words.push_back("warning: " + call + ": " + std::to_string(lost) + (lost == 1 ? " is" : " are") +
                    " missing among these by the count of negative pivots: ask for another count");
  const auto kept = std::min(found.value.size(), static_cast<std::size_t>(count));
  found.value.resize(kept);
  found.shape.resize(kept);
  found.converged = found.converged || kept == static_cast<std::size_t>(count);
  return found;
}

// The ratio of a way to its shape, whose largest displacement is 1.
double size_of(const mechanics::NodalRates& way, const Shape& shape) {
  double along = 0, square = 0;
  for (std::size_t n = 0; n < shape.way.size(); ++n) {
    along += at(way.x, static_cast<std::ptrdiff_t>(n)).dot(shape.way[n]);
    square += shape.way[n].squaredNorm();
  }
  return square > 0 ? along / square : 0;
}

Modes<VibrationMode> vibrations(Linearised& at, const ModesWanted& wanted) {
  const linear::Matrix K = at.stiffness(law::AtSwitch::unloading), M = at.mass();
  const double fastest = at.fastest(K, M);
  Shifted shifted;
  make_definite(K, M, kShift * fastest, shifted);
  int count = wanted.count;
  if (wanted.below) {
    const double omega = 2 * std::numbers::pi * *wanted.below;
    const auto there = count_above(M, K, 1 / (omega * omega));
    if (wanted.all_below && there > kMostModes)
      throw Error("field 'below': there are " + std::to_string(there) + " modes below " +
                  number(*wanted.below) + " Hz: expected a frequency with at most " +
                  std::to_string(kMostModes) + " below it");
    if (there >= 0)
      count = static_cast<int>(wanted.all_below ? there : std::min<mechanics::Index>(there, count));
  }
  Modes<VibrationMode> out{{}, at.words(), at.mass_that_moves(M)};
  const auto found = counted_pairs(M, shifted, count, "modes", out.words);
  const auto& masses = at.assembly().cloth().mass();
  for (std::size_t i = 0; i < found.value.size(); ++i) {
    const double theta = found.value[i];
    if (!(theta > 0)) break;
    const double square = 1 / theta - shifted.shift;  // 1/s^2
    const bool nothing = std::abs(square) <= kNoStiffnessOfMode * fastest;
    const mechanics::NodalRates way = at.spread(found.shape[i]);
    Vec3 part = Vec3::Zero();
    for (std::size_t n = 0; n < masses.size(); ++n)
      part += masses[n] * fabricsh::at(way.x, static_cast<std::ptrdiff_t>(n));
    part += at.momentum_of_bodies(found.shape[i]);
    VibrationMode mode;
    mode.mass = part.cwiseAbs2() / theta;
    if (!nothing && square > 0) mode.frequency = std::sqrt(square) / (2 * std::numbers::pi);
    if (!nothing && square < 0) mode.growth = std::sqrt(-square);
    if (wanted.below && mode.frequency >= *wanted.below) break;
    mode.shape = at.shape(way);
    if (const double size = size_of(way, *mode.shape); size != 0) {
      mode.own_mass = theta / (size * size);
      mode.participation = part * size / theta;
    }
    out.modes.push_back(std::move(mode));
  }
  if (!found.converged)
    out.words.push_back("modes: only " + std::to_string(found.value.size()) + " of " + std::to_string(count) +
                        " modes have been found");
  const auto grows =
      std::count_if(out.modes.begin(), out.modes.end(), [](const auto& m) { return m.growth > 0; });
  if (grows > 0)
    out.words.push_back("modes: the state is not a stable equilibrium: " + std::to_string(grows) +
                        (grows == 1 ? " mode grows" : " modes grow") +
                        " instead of swinging, at the rate in its field 'growth'");
  return out;
}

std::string unchanged_text(const mechanics::Dofs& dofs) {
  if (!dofs.joints().opened().empty()) return "joints have opened";
  const auto& closed = dofs.sewn().closed;
  if (std::any_of(closed.begin(), closed.end(), [](auto c) { return c != 0; })) return "seams have closed";
  return {};
}

// The factors at which B - lambda `lost` has no stiffness against a motion.
Modes<BucklingMode> factors(const Linearised& at, const linear::Matrix& lost, const linear::Matrix& B,
                            const linear::Matrix& M, int count) {
  Shifted shifted;
  shift_by(B, M, 0, shifted);
  if (!is_definite(shifted)) {
    shift_by(B, M, kShift * at.fastest(B, M), shifted);
    if (!is_definite(shifted))
      throw Error(
          "the cloth is unstable before these loads are multiplied: expected a state in which it is stable");
  }
  Modes<BucklingMode> out{{}, at.words()};
  const auto found = counted_pairs(lost, shifted, count, "buckling", out.words);
  for (std::size_t i = 0; i < found.value.size() && found.value[i] > 0; ++i)
    out.modes.push_back({1 / found.value[i], at.shape(at.spread(found.shape[i]))});
  if (out.modes.empty())
    out.words.push_back(
        "buckling: no factor of these loads above zero makes the cloth unstable: it is pulled");
  else if (!found.converged)
    out.words.push_back("buckling: only " + std::to_string(out.modes.size()) + " of " +
                        std::to_string(count) + " factors have been found");
  return out;
}

// Effect of a model's loads and motions beyond those of a state, linearly: the way of the cloth under them,
// and the stiffness that is lost by the stresses of that way and by loads that follow the cloth.
class Perturbation {
 public:
  Perturbation(Linearised& base, Linearised& more) : base_(base), more_(more) {
    check_supports();
    find_motions();
    find_way();
  }
  linear::Matrix lost() {
    // Stresses along the way are those of a small part of it, so that any size gives the same factor.
    constexpr double part = 1e-5;  // of an element
    double most = 0;
    for (const double d : nodal_way_.x) most = std::max(most, std::abs(d));
    const double share = part * base_.assembly().cloth().rates().smallest_size() / most;
    linear::Matrix of_loads = difference(lost_here(more_), lost_here(base_), 1);
    const linear::Matrix before = lost_here(moved());
    settle(share);
    const linear::Matrix along = difference(lost_here(moved()), before, 1 / share);
    moved().assembly().rollback();
    for (std::size_t i = 0; i < of_loads.value.size(); ++i) of_loads.value[i] += along.value[i];
    return of_loads;
  }

 private:
  double now() const { return std::as_const(base_.assembly()).state().time(); }
  // Where supports do not move, loads that follow the cloth must not change along the way: those of the state
  // alone do.
  Linearised& moved() { return moves_ ? more_ : base_; }
  void move(double share) {
    std::vector<double> targets = here_;
    for (std::size_t m = 0; m < targets.size(); ++m) targets[m] += share * lead_[m];
    if (!moves_) targets = base_.assembly().dofs().targets(now());
    moved().assembly().apply_increment(way_, share, targets);
  }
  // Goes a share of the way. Yarns that unload along another line answer otherwise than the tangent has it:
  // then the way is corrected.
  void settle(double share) {
    constexpr int most_corrections = 20;
    constexpr double balanced = 1e-5;  // of the load
    mechanics::Assembly& assembly = moved().assembly();
    const std::vector<double> at_rest = residual(moved());
    assembly.begin_iterate();
    for (int i = 0; i < most_corrections; ++i) {
      move(share);
      linear::Matrix K;
      if (!assembly.tangent({now(), 0, law::AtSwitch::loading}, K, {}, {})) break;
      std::vector<double> r = residual(moved());
      double left = 0, all = 0;
      for (std::size_t k = 0; k < r.size(); ++k) {
        r[k] = load_[k] + (r[k] - at_rest[k]) / share;
        left = std::max(left, std::abs(r[k]));
        all = std::max(all, std::abs(linear_load_[k]));
      }
      if (left <= balanced * all) return;
      linear::Vector more(r.size());
      if (!solve(K, r, more)) break;
      for (std::size_t k = 0; k < more.size(); ++k) way_[k] += more[k];
    }
    throw Error("the cloth's answer to a small part of these loads has not been found in this state");
  }
  static bool solve(const linear::Matrix& K, const std::vector<double>& b, linear::Vector& x) {
    const auto solver = linear::with_ranks(linear::make_unsymmetric_solver());
    return solver->factorise(K) && solver->solve(K, b, x) && linear::all_finite(x);
  }
  static linear::Matrix difference(linear::Matrix a, const linear::Matrix& b, double factor) {
    a.ranks = {};
    for (std::size_t i = 0; i < a.value.size(); ++i) a.value[i] = factor * (a.value[i] - b.value[i]);
    return a;
  }
  static linear::Matrix lost_here(Linearised& at) {
    const linear::Matrix K = at.stiffness(law::AtSwitch::loading);
    return difference(at.law_stiffness(), K, 1);
  }
  void check_supports() const {
    const auto& there = base_.assembly().dofs().freedoms().nodes;
    const auto& here = more_.assembly().dofs().freedoms().nodes;
    for (std::size_t n = 0; n < there.size(); ++n)
      for (std::size_t c = 0; c < 5; ++c)
        if (std::max<mechanics::Index>(there[n].equation[c], -1) !=
                std::max<mechanics::Index>(here[n].equation[c], -1) ||
            !there[n].frame.isApprox(here[n].frame))
          throw Error("field 'load': expected the supports of the run, which hold or move the same; node " +
                      std::to_string(n + 1) + " differs");
  }
  void find_motions() {
    const auto &there = base_.assembly().dofs(), &here = more_.assembly().dofs();
    const auto x = std::as_const(more_.assembly()).state().x();
    const auto before = there.targets(now()), after = here.targets(now());
    const auto &motions = here.freedoms().motions, &others = there.freedoms().motions;
    for (std::size_t m = 0; m < motions.size(); ++m) {
      const auto n = motions[m].node;
      const auto same = std::find_if(others.begin(), others.end(), [&](const auto& other) {
        return other.node == n && other.component == motions[m].component;
      });
      double from = 0;  // an angle that is held is none
      if (same != others.end())
        from = before[static_cast<std::size_t>(same - others.begin())];
      else if (motions[m].component < 3)
        from = (here.freedoms().nodes[n].frame * (at(x, n) - here.reference()[n]))[motions[m].component];
      here_.push_back(from);
      lead_.push_back(after[m] - from);
      moves_ = moves_ || lead_.back() != 0;
    }
  }
  std::vector<double> residual(Linearised& at) const {
    std::vector<double> external, r(static_cast<std::size_t>(at.assembly().dofs().unknowns()));
    at.assembly().terms().external(now(), external);
    at.assembly().residual(external, r);
    return r;
  }
  void find_way() {
    load_ = residual(more_);
    const std::vector<double> balanced = residual(base_);
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] -= balanced[i];
    linear::Matrix K, K_more;
    const law::Step step{now(), 0, law::AtSwitch::loading};
    std::vector<double> product(load_.size());
    bool fine = base_.assembly().tangent(step, K, {}, {});
    if (moves_) fine = fine && more_.assembly().tangent(step, K_more, lead_, product);
    if (!fine) throw Error("the law fails in this state");
    linear_load_ = load_;
    double most = 0;
    for (std::size_t i = 0; i < product.size(); ++i)
      most = std::max(most, std::abs(linear_load_[i] -= product[i]));
    if (!(most > kNoLoad * base_.assembly().largest_force()))
      throw Error("field 'load': expected a model with loads or motions beside those of the run at time " +
                  number(now()) + " s, got none");
    way_.resize(load_.size());
    if (!solve(K, linear_load_, way_))
      throw Error("the cloth moves freely in this state: expected supports that hold it");
    more_.assembly().dofs().spread_rates(way_, lead_, nodal_way_);
  }

  static constexpr double kNoLoad = 1e-9;  // of the largest force of the state
  Linearised &base_, &more_;
  std::vector<double> here_, lead_;  // of the driven freedoms: where they are, and how far they move
  bool moves_ = false;
  std::vector<double> load_, linear_load_;  // without and with what the driven freedoms do
  linear::Vector way_;
  mechanics::NodalRates nodal_way_;
};

}  // namespace

Modes<VibrationMode> vibration_modes(const Run& run, const ModesWanted& wanted) {
  Linearised at(run, "modes");
  return vibrations(at, wanted);
}

Modes<VibrationMode> vibration_modes(const std::shared_ptr<model::Model>& model, const ModesWanted& wanted) {
  Linearised at(model, "modes");
  return vibrations(at, wanted);
}

Modes<BucklingMode> buckling_modes(const Run& run, int count) {
  if (const std::string changed = unchanged_text(run.assembly().dofs()); !changed.empty())
    throw Error("in this run " + changed +
                " since its start, and its tangent is not to be compared with that of "
                "the unloaded cloth");
  Linearised loaded(run, "buckling"), bare(run.shared_model(), "buckling");
  const linear::Matrix K = loaded.stiffness(law::AtSwitch::loading), M = loaded.mass();
  linear::Matrix K0 = loaded.law_stiffness();
  const linear::Matrix whole = bare.stiffness(law::AtSwitch::loading), law = bare.law_stiffness();
  if (whole.value.size() != K.value.size())
    throw Error(
        "contact has closed since the run's start, and the tangent is not to be compared with that of the "
        "unloaded cloth");
  linear::Matrix lost = K;  // stiffness, by the loads and the stresses
  K0.ranks = K.ranks;       // gas resists also without a change of its pressure
  lost.ranks = {};
  double most = 0, largest = 0;
  for (std::size_t i = 0; i < K.value.size(); ++i) {
    K0.value[i] += whole.value[i] - law.value[i];  // springs, bands
    lost.value[i] = K0.value[i] - K.value[i];
    most = std::max(most, std::abs(lost.value[i]));
    largest = std::max(largest, std::abs(K0.value[i]));
  }
  if (!(most > kNoStiffnessOfMode * largest))
    throw Error(
        "the state of this run has no stress: expected one under the loads whose factor is asked for");
  return factors(loaded, lost, K0, M, count);
}

Modes<BucklingMode> buckling_modes(const Run& run, const std::shared_ptr<model::Model>& load, int count) {
  if (const std::string differs = cloth_differs(run.model(), *load, run.duration()); !differs.empty())
    throw Error("field 'load': expected a model of the same cloth; it differs in " + differs);
  if (const std::string differs = contact_differs(run.model(), *load, run.duration()); !differs.empty())
    throw Error("field 'load': expected the bodies and contacts of the run; it differs in " + differs);
  Linearised base(run, "buckling"), more(run, load, "buckling");
  const linear::Matrix K = base.stiffness(law::AtSwitch::loading), M = base.mass();
  const linear::Matrix lost = Perturbation(base, more).lost();
  return factors(base, lost, K, M, count);
}

}  // namespace fabricsh::run
