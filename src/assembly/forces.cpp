// Forces of all elements: batches in parallel into slots of their own, then nodes in parallel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"
#include "base/error.hpp"

namespace fabricsh::assembly {

void Assembly::make_force_slots() {
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
  for (const Place place : place_) {
    const Batch& batch = batches_[place.batch];
    for (int a = 0; a < batch.kind->corners; ++a) {
      const auto on_x = static_cast<std::uint32_t>(batch.force + 3 * a * lanes + place.lane);
      force_slots_[next[batch.nodes[place.lane][a]]++] = {
          on_x, on_x + static_cast<std::uint32_t>(3 * batch.kind->corners * lanes)};
    }
  }
}

void Assembly::gather(const Batch& batch, double* x, double* d, double* b) const {
  const auto& s = std::as_const(*state_);
  const double* px = s.x().data();
  const double* pd = s.d().data();
  const double* pb = px + 6 * X_.size();
  const int corners = batch.kind->corners;
  for (int l = 0; l < lanes; ++l)
    for (int a = 0; a < corners; ++a) {
      const Index n = 3 * batch.nodes[l][a];
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

// Forces of one batch into its slots, and its tangent if K is not null. Returns an element whose law failed,
// or -1. trial: the law's trial states.
Index Assembly::evaluate(Index b, fabric::AtSwitch at, double* trial, double* K, bool law_only) {
  alignas(64) double x[12 * lanes], d[12 * lanes], basis[24 * lanes];
  const Batch& batch = batches_[b];
  const auto& kernels = batch.kind->kernels;
  gather(batch, x, d, K == nullptr ? nullptr : basis);
  const double* committed = std::as_const(*state_).committed_law().data();
  const element::ShellBatch data{geometry_.data() + batch.geometry,
                                 x,
                                 d,
                                 basis,
                                 committed + batch.law,
                                 trial + batch.law,
                                 batch.sharing,
                                 law_only};
  double* f = element_force_.data() + batch.force;
  const unsigned failed = (K == nullptr ? kernels.force(model_.section(), at, data, f)
                                        : kernels.tangent(model_.section(), at, data, f, K)) &
                          ((1u << batch.used) - 1);
  if (!tested_.empty() && !law_only) share_[b] = share_of(batch, trial);
  return failed == 0 ? -1 : batch.element[__builtin_ctz(failed)];
}

// Elements in their order, node by node; then the loads.
void Assembly::sum_forces() {
  const auto nodes = static_cast<Index>(X_.size());
  const double* f = element_force_.data();
#pragma omp parallel for schedule(static) if (nodes >= few_batches * lanes)
  for (Index n = 0; n < nodes; ++n) {
    double sum[6] = {};
    for (auto s = first_slot_[n]; s < first_slot_[n + 1]; ++s)
      for (int i = 0; i < 3; ++i) {
        sum[i] += f[force_slots_[s].on_x + i * lanes];
        sum[3 + i] += f[force_slots_[s].on_d + i * lanes];
      }
    std::copy_n(sum, 3, force_x_.data() + 3 * n);
    std::copy_n(sum + 3, 3, force_d_.data() + 3 * n);
  }
  const auto& s = std::as_const(*state_);
  loads_->add_to_internal(s.x(), s.d(), X_, force_x_, force_d_);
}

bool Assembly::forces(fabric::AtSwitch at) {
  const auto batches = static_cast<Index>(batches_.size());
  double* trial = state_->evaluate_law().data();
  Index failed = -1;
#pragma omp parallel for schedule(static) reduction(max : failed) if (batches >= few_batches)
  for (Index b = 0; b < batches; ++b) failed = std::max(failed, evaluate(b, at, trial, nullptr));
  sum_forces();
  failed_element_ = failed;
  return failed < 0;
}

}  // namespace fabricsh::assembly
