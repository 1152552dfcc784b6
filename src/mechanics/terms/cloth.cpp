#include "mechanics/terms/cloth.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "base/error.hpp"
#include "base/shares.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/scatter.hpp"
#include "mechanics/terms/turned.hpp"

namespace fabricsh::mechanics {

Cloth::Cloth(const model::Model& model, const Configuration& configuration,
             const std::vector<Vec3>& directors)
    : model_(model), configuration_(configuration), X_(model.mesh().nodes), rest_(model, directors) {
  set_kinds();
  make_batches();
  std::size_t law = 0;
  for (Batch& batch : batches_) {
    batch.law = law;
    const auto numbers = static_cast<std::size_t>(batch.kind->in_plane) * batch.section->state_size * lanes;
    most_states_ = std::max(most_states_, numbers);
    law += numbers;
  }
  states_ = LawStates(law);
  set_initial_states();
  make_geometry();
  make_force_slots();
  order_batches();
  order_sums();
  rates_.emplace(model_, rest_, batches_, place_);
  strains_.emplace(model_, batches_, place_, states_);
}

// Virgin cloth. Most laws start from zeros, which are there.
void Cloth::set_initial_states() {
  const auto starts_from_zero = [](const section::Point& p) { return !law::has_initial(*p.law); };
  if (std::all_of(model_.sections().begin(), model_.sections().end(), [&](const section::Section& s) {
        return std::all_of(s.points.begin(), s.points.end(), starts_from_zero);
      }))
    return;
  const auto strengths = strengths_of_elements();
  std::vector<double> numbers;
  for (const Batch& batch : batches_)
    for (int l = 0; l < lanes; ++l) {
      const Index e = batch.element[l];
      law::Site site = site_of(e);
      site.strength = strengths[static_cast<std::size_t>(e)];
      const auto folding = readings().fold_tensions(e);
      for (const auto& point : batch.section->points) {
        site.thickness = batch.section->thickness_of(point.ply);
        const double cosine = std::pow(std::cos(point.angle), 2);
        for (std::size_t i = 0; i < 2; ++i)
          site.folding[i] = (cosine * folding[i] + (1 - cosine) * folding[1 - i]) / batch.section->thickness;
        numbers.resize(static_cast<std::size_t>(law::state_size(*point.law)));
        try {
          law::set_initial(*point.law, site, numbers.data());
        } catch (const Error& refusal) {
          throw Error("card '" + model_.card_of(e).name + "', element " + std::to_string(e + 1) + ": " +
                      refusal.what());
        }
        for (int g = 0; g < batch.kind->in_plane; ++g)
          states_.set(batch.law + (g * batch.section->state_size + point.state) * lanes + l, numbers);
      }
    }
}

std::vector<std::array<double, 2>> Cloth::strengths_of_elements() const {
  const auto& mesh = model_.mesh();
  std::vector<std::array<double, 2>> out(mesh.elements.size(), {1, 1});
  for (const auto& given : model_.all<model::StrengthGiven>())
    for (const Index e : mesh.elements_in(mesh.set(given.set)))
      for (int family = 0; family < 2; ++family)
        out[static_cast<std::size_t>(e)][static_cast<std::size_t>(family)] *=
            given.factor *
            (given.modulus > 0 ? weibull_strength(given.modulus, draw(given.seed, e, family)) : 1);
  return out;
}

void Cloth::update_in_place() {
  std::vector<std::size_t> starts;
  starts.reserve(batches_.size() + 1);
  for (const Batch& batch : batches_) starts.push_back(batch.law);
  starts.push_back(states_.committed().size());
  states_.update_in_place(std::move(starts), batches_.front().kind->kernels.width);
}

void Cloth::set_kinds() {
  for (const auto& section : model_.sections()) {
    const int points = static_cast<int>(section.points.size());
    const element::Shell4Layout four(points);
    const element::Shell3Layout three(points);
    kinds_.push_back({element::shell4_kernels(best_isa()), 4, element::gauss_points, element::shell4_dofs,
                      four.point(0, 0), four.size()});
    kinds_.push_back({element::shell3_kernels(best_isa()), 3, element::shell3_points, element::shell3_dofs,
                      three.point(0, 0), three.size()});
  }
}

void Cloth::make_batches() {
  const auto& mesh = model_.mesh();
  const auto colours = colour(mesh);
  const int count = *std::max_element(colours.begin(), colours.end()) + 1;
  const auto regions = static_cast<int>(model_.sections().size());
  place_.resize(mesh.elements.size());
  node_element_.assign(mesh.nodes.size(), -1);
  for (int c = 0; c < count; ++c) {
    colour_start_.push_back(static_cast<Index>(batches_.size()));
    for (int r = 0; r < regions; ++r) {
      add_batches(colours, c, false, r);
      add_batches(colours, c, true, r);
    }
  }
  colour_start_.push_back(static_cast<Index>(batches_.size()));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const auto n : mesh.elements[e])
      if (n >= 0) node_element_[n] = static_cast<Index>(e);
}

// Makes batches of the elements of one colour, kind and region.
void Cloth::add_batches(const std::vector<int>& colours, int colour, bool triangles, int region) {
  const auto& elements = model_.mesh().elements;
  int lane = lanes;
  for (std::size_t e = 0; e < colours.size(); ++e) {
    if (colours[e] != colour || (elements[e][3] < 0) != triangles) continue;
    if (model_.region_of(static_cast<Index>(e)) != region) continue;
    if (lane == lanes) {
      batches_.emplace_back();
      batches_.back().kind = &kinds_[2 * region + (triangles ? 1 : 0)];
      batches_.back().section = &model_.sections()[region];
      lane = 0;
    }
    Batch& batch = batches_.back();
    place_[e] = {static_cast<Index>(batches_.size()) - 1, lane};
    // Empty lanes repeat the last element of the batch; their results are not used.
    for (int l = lane; l < lanes; ++l) {
      batch.element[l] = static_cast<Index>(e);
      batch.nodes[l] = elements[e];
    }
    batch.used = ++lane;
  }
}

namespace {

template <std::size_t corners>
void put_geometry(const section::Section& section, const RestShape& rest, Index e,
                  const element::WarpAt& warp, double* geometry, int lane) {
  element::Placed<corners> reference, unbent;
  for (std::size_t a = 0; a < corners; ++a) {
    reference.X[a] = rest.X(e, static_cast<int>(a));
    reference.D[a] = rest.D(e, static_cast<int>(a));
    unbent.X[a] = rest.unbent(e) == nullptr ? reference.X[a] : rest.unbent(e)->X[a];
    unbent.D[a] = rest.unbent(e) == nullptr ? reference.D[a] : rest.unbent(e)->D[a];
  }
  if constexpr (corners == 3)
    element::shell3_rest_geometry(section, reference, unbent, warp, geometry, lane, lanes);
  else
    element::shell4_rest_geometry(section, reference, unbent, warp, geometry, lane, lanes);
}

}  // namespace

void Cloth::make_geometry() {
  mass_.assign(X_.size(), 0);
  mass_moment_.assign(X_.size(), 0);
  LineVector numbers;
  for (Batch& batch : batches_) {
    numbers.assign(static_cast<std::size_t>(batch.kind->geometry_size) * lanes, 0);
    put_geometry(batch, numbers.data());
    const auto entry = geometry_.keep(batch, numbers, [&] {
      return batch.kind->corners == 3 ? element::shell3_sharing(*batch.section, numbers.data())
                                      : element::shell4_sharing(*batch.section, numbers.data());
    });
    batch.geometry = entry.numbers;
    batch.sharing = entry.sharing;
    for (int l = 0; l < batch.used; ++l) add_mass(batch, l);
  }
  geometry_.finish();
}

void Cloth::put_geometry(const Batch& batch, double* geometry) const {
  for (int l = 0; l < lanes; ++l) {
    const Index e = batch.element[l];
    const auto warp = [this, e](const Vec3& X, const Vec3& n) { return rest_.warp(e, X, n); };
    try {
      if (batch.kind->corners == 3)
        mechanics::put_geometry<3>(*batch.section, rest_, e, warp, geometry, l);
      else
        mechanics::put_geometry<4>(*batch.section, rest_, e, warp, geometry, l);
    } catch (const element::DegenerateElement& refusal) {
      throw Error((model_.reference_of(e).mesh ? "model: field 'reference': element " : "mesh: element ") +
                  std::to_string(e + 1) + " " + refusal.what());
    }
  }
}

void Cloth::scale_mass(bool keep) {
  if (keep) return rates_->keep_mass();
  if (const std::vector<double>& times = rates_->mass_times(); !times.empty())
    std::transform(mass_.begin(), mass_.end(), times.begin(), mass_.begin(), std::multiplies<>());
}

void Cloth::add_mass(const Batch& batch, int lane) {
  const auto& section = *batch.section;
  const int points = static_cast<int>(section.points.size());
  double mass = 0, moment = 0;  // kg, kg m
  for (int g = 0; g < batch.kind->in_plane; ++g)
    for (int k = 0; k < points; ++k) {
      const double m =
          section.points[k].density * batch.geometry[(batch.kind->point(g, k, points) + 7) * lanes + lane];
      mass += m;
      moment += m * section.thickness / 2 * (section.points[k].zeta - section.offset);
    }
  for (int a = 0; a < batch.kind->corners; ++a) {
    mass_[batch.nodes[lane][a]] += mass / batch.kind->corners;
    mass_moment_[batch.nodes[lane][a]] += moment / batch.kind->corners;
  }
}

// --- forces

void Cloth::make_force_slots() {
  std::size_t size = 0;
  for (Batch& batch : batches_) {
    batch.force = size;
    size += 6 * static_cast<std::size_t>(batch.kind->corners) * lanes;
  }
  if (size > std::numeric_limits<std::uint32_t>::max()) throw Error("mesh: more elements than 170 million");
  element_force_.assign(size, 0);
  first_slot_.assign(X_.size() + 1, 0);
  for (const auto& e : model_.mesh().elements)
    for (const auto n : e)
      if (n >= 0) ++first_slot_[n + 1];
  for (std::size_t n = 0; n < X_.size(); ++n) first_slot_[n + 1] += first_slot_[n];
  force_slots_.resize(first_slot_.back());
  auto next = first_slot_;
  for (const BatchLane place : place_) {
    const Batch& batch = batches_[place.batch];
    for (int a = 0; a < batch.kind->corners; ++a) {
      const auto on_x = static_cast<std::uint32_t>(batch.force + 3 * a * lanes + place.lane);
      force_slots_[next[batch.nodes[place.lane][a]]++] = {
          on_x, on_x + static_cast<std::uint32_t>(3 * batch.kind->corners * lanes)};
    }
  }
}

// Sorts the batches by their first element, so that consecutive batches share nodes.
void Cloth::order_batches() {
  order_.resize(batches_.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  std::stable_sort(order_.begin(), order_.end(),
                   [this](Index a, Index b) { return batches_[a].element[0] < batches_[b].element[0]; });
}

// Finds between which batches each node gets its forces. Nodes without elements count as finished by the
// first batch.
void Cloth::order_sums() {
  const std::size_t nodes = X_.size(), batches = batches_.size();
  std::vector<std::uint32_t> last(nodes, 0);
  begun_.assign(nodes, 0);
  std::vector<bool> met(nodes, false);
  for (std::size_t i = 0; i < batches; ++i) {
    const Batch& batch = batches_[order_[i]];
    for (int l = 0; l < batch.used; ++l)
      for (int a = 0; a < batch.kind->corners; ++a) {
        const Index n = batch.nodes[l][a];
        last[n] = static_cast<std::uint32_t>(i);
        if (!met[n]) begun_[n] = last[n];
        met[n] = true;
      }
  }
  first_finished_.assign(batches + 1, 0);
  for (const auto i : last) ++first_finished_[i + 1];
  std::partial_sum(first_finished_.begin(), first_finished_.end(), first_finished_.begin());
  finished_.resize(nodes);
  auto next = first_finished_;
  for (std::size_t n = 0; n < nodes; ++n) finished_[next[last[n]]++] = static_cast<std::uint32_t>(n);
}

// Prefetches the numbers that the forces of a batch read. They are far from those of the batch before, so
// that the processor does not prefetch them by itself.
void Cloth::fetch(const Batch& batch, const double* trial) const {
  const BatchKind& kind = *batch.kind;
  const long states = static_cast<long>(kind.in_plane) * batch.section->state_size * lanes;
  const double* law = states_.committed().data() + batch.law;
  for (long i = 0; i < states; i += lanes) __builtin_prefetch(law + i);
  for (long i = 0; i < states && trial != nullptr; i += lanes) __builtin_prefetch(trial + batch.law + i, 1);
  if (batch.sharing != element::Sharing::element) return;
  const double* geometry = batch.geometry;
  const auto columns = [geometry](int first, int count, int stride = 1) {
    for (int i = 0; i < count; ++i) __builtin_prefetch(geometry + (first + i * stride) * lanes);
  };
  using Layout = element::Shell4Layout;
  columns(0, Layout::distortion);
  columns(Layout::modes, element::kEnhanced, element::kSamples);
  columns(Layout::modes + 2, element::kEnhanced, element::kSamples);
  columns(kind.first_point, Layout::transform);
}

// Batches of one colour do not follow each other in the mesh, so that the processor does not prefetch their
// nodes.
void Cloth::fetch_nodes(const Batch& batch) const {
  const double *const x = configuration_.x().data(), *const d = configuration_.d().data(),
                      *const b1 = configuration_.b1().data();
  for (const auto& nodes : batch.nodes)
    for (const int a : {0, 2})
      for (const double* from : {x, d, b1}) __builtin_prefetch(from + 3 * nodes[a]);
}

void Cloth::read_leaders_of(const Joints& joints) {
  joints_ = &joints;
  find_sources();
}

void Cloth::find_sources() {
  if (joints_ == nullptr || !joints_->any()) return;
  sources_.resize(batches_.size());
  for (std::size_t b = 0; b < batches_.size(); ++b)
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < batches_[b].kind->corners; ++a)
        sources_[b][l][a] = joints_->leader(batches_[b].nodes[l][a]);
}

void Cloth::gather(const Batch& batch, double* x, double* d, double* b) const {
  const auto& nodes = sources_.empty() ? batch.nodes : sources_[&batch - batches_.data()];
  const double* px = configuration_.x().data();
  const double* pd = configuration_.d().data();
  const double* pb = configuration_.b1().data();
  const int corners = batch.kind->corners;
  for (int l = 0; l < lanes; ++l)
    for (int a = 0; a < corners; ++a) {
      const Index n = 3 * nodes[l][a];
      for (int i = 0; i < 3; ++i) {
        x[(3 * a + i) * lanes + l] = px[n + i];
        d[(3 * a + i) * lanes + l] = pd[n + i];
      }
      if (b == nullptr) continue;
      const Eigen::Map<const Vec3> dd(pd + n), b1(pb + n);
      const Vec3 b2 = dd.cross(b1);
      for (int i = 0; i < 3; ++i) {
        b[(6 * a + i) * lanes + l] = b1[i];
        b[(6 * a + 3 + i) * lanes + l] = b2[i];
      }
    }
}

// The same of three numbers per node.
void Cloth::gather(const Batch& batch, std::span<const double> from, double* to) const {
  for (int l = 0; l < lanes; ++l)
    for (int a = 0; a < batch.kind->corners; ++a)
      for (int i = 0; i < 3; ++i) to[(3 * a + i) * lanes + l] = from[3 * batch.nodes[l][a] + i];
}

void Cloth::take_branches(Branches which) {
  keeps_branches_ = which != Branches::own;
  if (which == Branches::anew) branches_.assign(states_.committed().size(), 0.0);
}

// Computes the forces of one batch into its slots, and its tangent if it is asked for. trial: where the
// batch's trial states are written, null in place. Returns an element whose law failed, or -1.
Index Cloth::evaluate(Index b, const law::Step& step, double* trial, const TangentOf& tangent) {
  alignas(64) double x[12 * lanes], d[12 * lanes], basis[24 * lanes];
  const Batch& batch = batches_[b];
  const auto& kernels = batch.kind->kernels;
  gather(batch, x, d, tangent.K == nullptr ? nullptr : basis);
  const bool in_place = states_.in_place();
  double* const now = states_.now() + batch.law;
  element::ShellBatch data{batch.geometry, x, d, basis, now, trial, batch.sharing, tangent.law_only};
  data.wanted = tangent.wanted;
  if (keeps_branches_ && tangent.K != nullptr && !tangent.law_only) data.now = branches_.data() + batch.law;
  alignas(64) double before_x[12 * lanes], before_d[12 * lanes];
  if (!tangent.before.empty()) {
    const std::size_t n = tangent.before.size() / 3;
    gather(batch, tangent.before.first(n), before_x);
    gather(batch, tangent.before.subspan(n, n), before_d);
    data.before_x = before_x;
    data.before_d = before_d;
  }
  // K_M is that of the configuration before.
  const bool turns = tangent.law_only && !tangent.before.empty();
  alignas(64) double before_b[24 * lanes];
  if (turns) {
    const std::size_t n = tangent.before.size() / 3;
    const auto nodes = [&](int l, int a) { return sources_.empty() ? batch.nodes[l][a] : sources_[b][l][a]; };
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < batch.kind->corners; ++a) {
        const double* const first = tangent.before.data() + 2 * n + 3 * nodes(l, a);
        const double* const director = first - n;
        const Vec3 b1(first[0], first[1], first[2]),
            b2 = Vec3(director[0], director[1], director[2]).cross(b1);
        for (int i = 0; i < 3; ++i) {
          before_b[(6 * a + i) * lanes + l] = b1[i];
          before_b[(6 * a + 3 + i) * lanes + l] = b2[i];
        }
      }
    data.x = before_x, data.d = before_d, data.b = before_b;
    data.before_x = data.before_d = nullptr;
  }
  double* log = nullptr;
  if (in_place) {
    data.changed = states_.changed() + batch.law / lanes;
    data.now = now;
    log = states_.begin_group(static_cast<std::size_t>(b));
    data.log = &log;
  }
  double* f = element_force_.data() + batch.force;
  const unsigned failed = (tangent.K == nullptr ? kernels.force(*batch.section, step, data, f)
                                                : kernels.tangent(*batch.section, step, data, f, tangent.K)) &
                          ((1u << batch.used) - 1);
  if (in_place) states_.end_group(log);
  if (turns) turn_tangent(batch.kind->corners, {before_x, before_b}, {x, basis}, tangent.wanted, tangent.K);
  const double* const reached = in_place ? now : trial;
  if (!tangent.law_only) look_for_astray(b, x, d);
  if (!tangent.law_only && !tangent.known) strains_->record(b, reached);
  if (sums_expected_ && tangent.K == nullptr)
    batch_energies(batch, x, d, reached, sums_.data() + b * law::energy_values * lanes);
  return failed == 0 ? -1 : batch.element[__builtin_ctz(failed)];
}

// Adds for each node the forces of its elements in their order.
void Cloth::sum_forces(Forces& forces) const {
  const auto nodes = static_cast<Index>(X_.size());
  for_each_index(nodes, nodes >= few_batches * lanes, [&](Index n) { sum_node(n, forces); });
}

// The sums stay in registers: an array of them would be written in single numbers and copied in pairs, for
// which the processor waits longer than for the additions.
void Cloth::sum_node(Index n, Forces& forces) const {
  const double* const f = element_force_.data();
  double x = 0, y = 0, z = 0, dx = 0, dy = 0, dz = 0;
  for (auto s = first_slot_[n]; s < first_slot_[n + 1]; ++s) {
    const double* const on_x = f + force_slots_[s].on_x;
    const double* const on_d = f + force_slots_[s].on_d;
    x += on_x[0], y += on_x[lanes], z += on_x[2 * lanes];
    dx += on_d[0], dy += on_d[lanes], dz += on_d[2 * lanes];
  }
  double* const node_x = forces.on_x.data() + 3 * n;
  double* const node_d = forces.on_d.data() + 3 * n;
  node_x[0] = x, node_x[1] = y, node_x[2] = z;
  node_d[0] = dx, node_d[1] = dy, node_d[2] = dz;
}

// Number of batches from which on their numbers have left the cache when the next step needs them.
constexpr Index in_cache = 384;

// Computes the forces of all batches in their order, and sums those of each node as soon as its last batch is
// computed, while they are still in the cache. Each thread has a part of the order; nodes with batches of an
// earlier part are summed when all threads are done. Returns an element whose law failed, or -1.
Index Cloth::evaluate_and_sum(const law::Step& step, double* aside, Forces& forces) {
  const auto batches = static_cast<Index>(batches_.size());
  // The batches of one part; nodes that have others before it come to `later`.
  const auto compute = [&](Index from, Index to, std::vector<std::uint32_t>& later) {
    Index failed = -1;
    for (Index i = from; i < to; ++i) {
      if (i + 1 < to && batches >= in_cache) fetch(batches_[order_[i + 1]], aside);
      const Index b = order_[i];
      failed = std::max(failed, evaluate(b, step, aside == nullptr ? nullptr : aside + batches_[b].law, {}));
      for (auto k = first_finished_[i]; k < first_finished_[i + 1]; ++k) {
        const auto n = finished_[k];
        if (static_cast<Index>(begun_[n]) < from)
          later.push_back(n);
        else
          sum_node(n, forces);
      }
    }
    return failed;
  };
  Index failed = -1;
  if (!in_shares(batches >= few_batches)) {
    std::vector<std::uint32_t> none;
    return compute(0, batches, none);
  }
#pragma omp parallel reduction(max : failed)
  {
    const Index threads = omp_get_num_threads(), self = omp_get_thread_num();
    std::vector<std::uint32_t> later;
    failed = compute(batches * self / threads, batches * (self + 1) / threads, later);
#pragma omp barrier
    for (const auto n : later) sum_node(n, forces);
  }
  return failed;
}

// A law fails if a strain is not finite. Then an iterate nearer to the last one may succeed, unless the
// committed state itself is not finite.
Outcome Cloth::outcome(Index failed) {
  if (failed < 0) return {};
  if (states_.in_place()) states_.rollback();
  const auto committed = states_.committed();
  const BatchLane place = place_[failed];
  const Batch& batch = batches_[place.batch];
  const int numbers = batch.kind->in_plane * batch.section->state_size;
  const double* state = committed.data() + batch.law + place.lane;
  for (int i = 0; i < numbers; ++i)
    if (!std::isfinite(state[static_cast<long>(i) * lanes]))
      return {Answer::broken, failed, "its state is not a number"};
  return {Answer::cut, failed};
}

Outcome Cloth::add_forces(const law::Step& step, const Trial&, Forces& forces) {
  double* aside = states_.evaluate().data();
  if (sums_expected_) sums_.resize(batches_.size() * law::energy_values * lanes);
  const Index failed = evaluate_and_sum(step, aside, forces);
  evaluated_ = {configuration_.version(), step};
  astray_version_ = configuration_.version();
  sums_version_ = sums_expected_ ? configuration_.version() : 0;
  return outcome(failed);
}

// The energies summed are those of the state just committed, so only their version number changes.
void Cloth::commit() {
  states_.commit();
  sums_version_ = sums_version_ + 1 == configuration_.version() ? configuration_.version() : 0;
}

namespace {
bool same(const law::Step& a, const law::Step& b) { return a.t0 == b.t0 && a.dt == b.dt && a.at == b.at; }
}  // namespace

// Where the forces of this configuration and step were the last computed, their trial states stay, and those
// of the tangent, which are the same, go into a buffer that does not leave the cache.
Outcome Cloth::scatter_tangents(const law::Step& step, bool law_only, Stiffness& stiffness,
                                const Stiffness::Target& to, std::span<const double> before) {
  const bool kept = !law_only && !states_.in_place() && evaluated_.version == configuration_.version() &&
                    same(evaluated_.step, step);
  double* const aside = kept ? nullptr : states_.evaluate().data();
  if (!kept) evaluated_ = {};
  if (!law_only) astray_version_ = configuration_.version();
  Index failed = -1;
  const auto colours = static_cast<Index>(colour_start_.size()) - 1;
#pragma omp parallel reduction(max : failed) if (colour_start_.back() >= few_batches)
  {
    LineVector buffer(kept ? most_states_ : 0);
    for (Index c = 0; c < colours; ++c) {
      const Index end = colour_start_[c + 1];
#pragma omp for schedule(static)
      for (Index b = colour_start_[c]; b < end; ++b) {
        alignas(64) double k[element::shell4_dofs * element::shell4_dofs * lanes];
        stiffness.fetch(b, to);
        if (b + 1 < end) {
          fetch(batches_[b + 1], aside);
          fetch_nodes(batches_[b + 1]);
        }
        double* const trial = kept ? buffer.data() : aside == nullptr ? nullptr : aside + batches_[b].law;
        failed =
            std::max(failed, evaluate(b, step, trial, {k, law_only, kept, stiffness.wanted(b, to), before}));
        stiffness.scatter(b, k, to);
      }
    }
  }
  return outcome(failed);
}

bool Cloth::symmetric() const {
  return std::all_of(model_.sections().begin(), model_.sections().end(),
                     [](const section::Section& s) { return s.symmetric; });
}

bool Cloth::is_rate_dependent() const {
  for (const auto& section : model_.sections())
    for (const auto& point : section.points)
      if (law::is_rate_dependent(*point.law)) return true;
  return false;
}

// --- reading

Cloth::BendingEnergy Cloth::bending_energy(Index element) const {
  const BatchLane place = place_[element];
  const Batch& batch = batches_[place.batch];
  const auto& section = *batch.section;
  if (!section.bends_apart) return {};
  const BatchKind& kind = *batch.kind;
  alignas(64) double x[12 * lanes], d[12 * lanes], kappa[element::gauss_points * 3 * lanes];
  gather(batch, x, d, nullptr);
  const double* geometry = batch.geometry;
  kind.kernels.curvature(section, {geometry, x, d, nullptr, nullptr, nullptr}, kappa);
  const double* law = states_.current().data() + batch.law;
  BendingEnergy sum;
  for (int g = 0; g < kind.in_plane; ++g) {
    const double area = geometry[(kind.point(g, 0, 1) + 7) * lanes + place.lane] / section.thickness;
    for (int m = 0; m < 3; ++m) {
      law::BendingState<double> state;
      const auto number = [&](int i) {
        const int first = section.bending_state + section.bending_states * m;
        return law[(g * section.state_size + first + i) * lanes + place.lane];
      };
      if (section.bending_state >= 0 && m < 2) state = {number(0), number(1)};
      sum.stored +=
          area * law::bending_stored(section.bending[m], kappa[(3 * g + m) * lanes + place.lane], state);
      sum.lost += area * state.lost;
    }
  }
  return sum;
}

void Cloth::batch_energies(const Batch& batch, const double* x, const double* d, const double* law,
                           double* sum) const {
  const auto& section = *batch.section;
  const int points = static_cast<int>(section.points.size());
  const BatchKind& kind = *batch.kind;
  constexpr int most_points = 9 * element::gauss_points;
  alignas(64) double E[5 * most_points * lanes], one[law::energy_values * lanes];
  std::vector<double, LineAllocator<double>> many;
  double* strain = E;
  if (kind.in_plane * points > most_points) {
    many.resize(static_cast<std::size_t>(5 * kind.in_plane * points * lanes));
    strain = many.data();
  }
  const double* geometry = batch.geometry;
  kind.kernels.strain(section, {geometry, x, d, nullptr, nullptr, nullptr}, strain);
  const auto energies = law::batch_energy(best_isa());
  std::fill_n(sum, law::energy_values * lanes, 0.0);
  for (int g = 0; g < kind.in_plane; ++g)
    for (int k = 0; k < points; ++k) {
      const auto& point = section.points[k];
      energies(*point.law, strain + (g * points + k) * 5 * lanes,
               law + (g * section.state_size + point.state) * lanes, one);
      const double* weight = geometry + (kind.point(g, k, points) + 7) * lanes;
      for (int i = 0; i < law::energy_values; ++i)
        for (int l = 0; l < lanes; ++l) sum[i * lanes + l] += weight[l] * one[i * lanes + l];
    }
}

std::vector<double> Cloth::all_batch_energies() const {
  const auto count = static_cast<Index>(batches_.size());
  constexpr int each = law::energy_values * lanes;
  std::vector<double> per(static_cast<std::size_t>(count) * each);
  for_each_index(count, count >= few_batches, [&](Index b) {
    alignas(64) double x[12 * lanes], d[12 * lanes];
    gather(batches_[b], x, d, nullptr);
    batch_energies(batches_[b], x, d, states_.current().data() + batches_[b].law, per.data() + b * each);
  });
  return per;
}

// Computes batches in parallel, then adds the elements' energies in the order of the elements.
void Cloth::add_energies(const Trial&, std::vector<Energy>& out) const {
  constexpr int each = law::energy_values * lanes;
  const bool summed = sums_version_ == configuration_.version();
  const std::vector<double> per = summed ? std::vector<double>() : all_batch_energies();
  const double* of_batch = summed ? sums_.data() : per.data();
  std::vector<BendingEnergy> bending;
  const bool bends = std::any_of(model_.sections().begin(), model_.sections().end(),
                                 [](const section::Section& s) { return s.bends_apart; });
  if (bends) bending.resize(static_cast<std::size_t>(elements()));
  for_each_index(bending.size(), bending.size() >= few_batches * lanes,
                 [&](std::size_t e) { bending[e] = bending_energy(static_cast<Index>(e)); });
  double sum[law::energy_values] = {}, bent = 0;
  for (Index e = 0; e < elements(); ++e) {
    const BatchLane place = place_[e];
    for (int i = 0; i < law::energy_values; ++i)
      sum[i] += of_batch[place.batch * each + i * lanes + place.lane];
    if (!bends) continue;
    sum[0] += bending[e].stored;
    bent += bending[e].lost;
  }
  out.push_back({"cloth", Account::stored, sum[0]});
  for (std::size_t i = 0; i < law::dissipations; ++i)
    out.push_back({std::string(law::dissipation_names.name[i]), Account::dissipated, sum[1 + i]});
  out.push_back({"bending", Account::dissipated, bent});
  out.push_back({"cloth", Account::created, sum[1 + law::dissipations]});
}

void Cloth::watch_directors(double cosine, std::vector<double> bent) {
  least_cosine_ = cosine;
  most_bent_ = std::move(bent);
  astray_.assign(batches_.size(), 0);
}

void Cloth::look_for_astray(Index b, const double* x, const double* d) {
  if (most_bent_.empty()) return;
  const Batch& batch = batches_[b];
  const unsigned found =
      batch.kind->kernels.astray({nullptr, x, d, nullptr, nullptr, nullptr}, least_cosine_, most_bent_[b]);
  astray_[b] = static_cast<unsigned char>(found & ((1u << batch.used) - 1));
}

std::span<const unsigned char> Cloth::astray() {
  if (astray_version_ == configuration_.version()) return astray_;
  const auto count = static_cast<Index>(batches_.size());
  for_each_index(count, count >= few_batches, [&](Index b) {
    alignas(64) double x[12 * lanes], d[12 * lanes];
    gather(batches_[b], x, d, nullptr);
    look_for_astray(b, x, d);
  });
  astray_version_ = configuration_.version();
  return astray_;
}

}  // namespace fabricsh::mechanics
