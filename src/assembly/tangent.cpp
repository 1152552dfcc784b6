// Forces and tangents of all elements: batches of a colour in parallel, colours one after the other, fixed
// slots.
#include <algorithm>
#include <cmath>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"
#include "base/error.hpp"

namespace fabricsh::assembly {

namespace {

using element::shell4_dofs;
constexpr int kEntries = shell4_dofs * shell4_dofs;

std::array<Index, shell4_dofs> equations_of(const Freedoms& freedoms, const std::array<Index, 4>& nodes) {
  std::array<Index, shell4_dofs> eq;
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 5; ++i) eq[5 * a + i] = nodes[a] < 0 ? held : freedoms.nodes[nodes[a]].equation[i];
  return eq;
}

}  // namespace

void Assembly::make_pattern() {
  const Index n = freedoms_.unknowns;
  unknown_node_.assign(n, -1);
  turns_.assign(n, false);
  double edges = 0, count = 0;
  for (const auto& e : model_.mesh().elements) {
    const int sides = e[3] < 0 ? 3 : 4;
    for (int a = 0; a < sides; ++a) edges += (X_[e[a]] - X_[e[(a + 1) % sides]]).norm();
    count += sides;
  }
  length_ = edges / count;
  for (std::size_t i = 0; i < freedoms_.nodes.size(); ++i)
    for (int c = 0; c < 5; ++c)
      if (const Index eq = freedoms_.nodes[i].equation[c]; eq >= 0) {
        unknown_node_[eq] = static_cast<Index>(i);
        turns_[eq] = c >= 3;
      }
  lever_.assign(n, 1);
  for (Index eq = 0; eq < n; ++eq)
    if (turns_[eq]) lever_[eq] = length_;
  list_tied_elements();
  std::vector<std::vector<Index>> rows(n);
  add_link_pattern(rows);
  for (const auto& e : model_.mesh().elements) {
    const auto eq = equations_of(freedoms_, e);
    for (const Index c : eq)
      if (c >= 0)
        for (const Index r : eq)
          if (r >= 0) rows[c].push_back(r);
  }
  pattern_.size = n;
  pattern_.column.assign(1, 0);
  for (auto& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    pattern_.row.insert(pattern_.row.end(), column.begin(), column.end());
    pattern_.column.push_back(static_cast<Index>(pattern_.row.size()));
    std::vector<Index>().swap(column);
  }
  pattern_.value.assign(pattern_.row.size(), 0);
  slots_.assign(batches_.size() * lanes * kEntries, -1);
  for (std::size_t b = 0; b < batches_.size(); ++b)
    for (int l = 0; l < batches_[b].used; ++l) {
      const auto eq = equations_of(freedoms_, batches_[b].nodes[l]);
      Index* slot = slots_.data() + (b * lanes + l) * kEntries;
      for (int r = 0; r < shell4_dofs; ++r)
        for (int c = 0; c < shell4_dofs; ++c) {
          if (eq[r] < 0 || eq[c] < 0) continue;
          const auto first = pattern_.row.begin() + pattern_.column[eq[c]];
          const auto last = pattern_.row.begin() + pattern_.column[eq[c] + 1];
          slot[r * shell4_dofs + c] = std::lower_bound(first, last, eq[r]) - pattern_.row.begin();
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

void Assembly::scatter_force(const Batch& batch, const double* f) {
  const int corners = batch.kind->corners;
  for (int l = 0; l < batch.used; ++l)
    for (int a = 0; a < corners; ++a)
      for (int i = 0; i < 3; ++i) {
        const Index n = 3 * batch.nodes[l][a] + i;
        force_x_[n] += f[(3 * a + i) * lanes + l];
        force_d_[n] += f[(3 * (corners + a) + i) * lanes + l];
      }
}

namespace {

using Dense = Eigen::Matrix<double, shell4_dofs, shell4_dofs, Eigen::RowMajor>;

// Turns the translations of oblique nodes into their frames.
void into_frames(const Freedoms& freedoms, const std::array<Index, 4>& nodes, Dense& K) {
  for (int a = 0; a < 4; ++a) {
    if (nodes[a] < 0 || !freedoms.nodes[nodes[a]].oblique) continue;
    const NodeFreedoms& node = freedoms.nodes[nodes[a]];
    K.middleRows<3>(5 * a) = (node.frame * K.middleRows<3>(5 * a)).eval();
    K.middleCols<3>(5 * a) = (K.middleCols<3>(5 * a) * node.frame.transpose()).eval();
  }
}

}  // namespace

void Assembly::scatter_tangent(const Batch& batch, const double* K, solver::SparseMatrix& out,
                               std::span<const double> lead, std::span<double> product) {
  const Index b = &batch - batches_.data();
  for (int l = 0; l < batch.used; ++l) {
    Dense k;
    if (batch.kind->corners == 4) {
      for (int i = 0; i < kEntries; ++i) k.data()[i] = K[i * lanes + l];
    } else {
      const int n = batch.kind->dofs;
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) k(r, c) = K[(n * r + c) * lanes + l];
      k.rightCols(shell4_dofs - n).setZero();
      k.bottomRows(shell4_dofs - n).setZero();
    }
    into_frames(freedoms_, batch.nodes[l], k);
    if (!tied_place_.empty() && tied_place_[b * lanes + l] >= 0) {
      std::copy_n(k.data(), kEntries, tied_tangent_.data() + tied_place_[b * lanes + l] * kEntries);
      continue;
    }
    const Index* slot = slots_.data() + (b * lanes + l) * kEntries;
    for (int i = 0; i < kEntries; ++i)
      if (slot[i] >= 0) out.value[slot[i]] += k.data()[i];
    if (lead.empty()) continue;
    const auto eq = equations_of(freedoms_, batch.nodes[l]);
    for (int c = 0; c < shell4_dofs; ++c) {
      if (eq[c] >= 0 || eq[c] == held) continue;
      const double move = lead_of(motion_of(eq[c]), lead);
      for (int r = 0; r < shell4_dofs; ++r)
        if (eq[r] >= 0) product[eq[r]] += k(r, c) * move;
    }
  }
}

// Increment of a driven freedom: a displacement, or for a turned director its angle times the rate of q1 or
// q2.
double Assembly::lead_of(Index motion, std::span<const double> lead) const {
  const DrivenFreedom& m = freedoms_.motions[motion];
  if (m.component < 3) return lead[motion];
  const Eigen::Map<const Vec3> d(std::as_const(*state_).d().data() + 3 * m.node),
      b1(state_->b1().data() + 3 * m.node);
  const Vec3 rate = freedoms_.nodes[m.node].turn_axis->cross(d);
  return lead[motion] * rate.dot(m.component == 3 ? Vec3(b1) : Vec3(d.cross(b1)));
}

// One number into K, or through a driven column into the product.
void Assembly::add_entry(Index r, Index c, double v, solver::SparseMatrix& K, std::span<const double> lead,
                         std::span<double> product) const {
  if (r < 0 || c == held || v == 0) return;
  if (c < held) {
    if (!lead.empty()) product[r] += v * lead_of(motion_of(c), lead);
    return;
  }
  const auto first = K.row.begin() + K.column[c], last = K.row.begin() + K.column[c + 1];
  K.value[std::lower_bound(first, last, r) - K.row.begin()] += v;
}

void Assembly::add_load_stiffness(solver::SparseMatrix& K, std::span<const double> lead,
                                  std::span<double> product) const {
  const auto add = [&](Index r, Index c, double v) { add_entry(r, c, v, K, lead, product); };
  const auto through_ties = [&](Index a, Index b) {
    return !tied_elements_.empty() && (freedoms_.ties(a) || freedoms_.ties(b));
  };
  const auto on_x = [&](Index a, Index b, const Mat3& k) {
    const NodeFreedoms &A = freedoms_.nodes[a], &B = freedoms_.nodes[b];
    const Mat3 turned = A.frame * k * B.frame.transpose();
    if (through_ties(a, b)) {
      Eigen::Matrix<double, 5, 5> block = Eigen::Matrix<double, 5, 5>::Zero();
      block.topLeftCorner<3, 3>() = turned;
      return add_block(a, b, block, K, lead, product);
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) add(A.equation[i], B.equation[j], turned(i, j));
  };
  const auto on_q = [&](Index a, const Eigen::Matrix2d& k) {
    if (through_ties(a, a)) {
      Eigen::Matrix<double, 5, 5> block = Eigen::Matrix<double, 5, 5>::Zero();
      block.bottomRightCorner<2, 2>() = k;
      return add_block(a, a, block, K, lead, product);
    }
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        add(freedoms_.nodes[a].equation[3 + i], freedoms_.nodes[a].equation[3 + j], k(i, j));
  };
  const auto& s = std::as_const(*state_);
  loads_->add_stiffness(s.x(), s.d(), state_->b1(), on_x, on_q);
}

bool Assembly::run(fabric::AtSwitch at, bool with_tangent, solver::SparseMatrix* K,
                   std::span<const double> lead, std::span<double> product) {
  std::fill(force_x_.begin(), force_x_.end(), 0.0);
  std::fill(force_d_.begin(), force_d_.end(), 0.0);
  if (with_tangent) std::fill(K->value.begin(), K->value.end(), 0.0);
  std::fill(product.begin(), product.end(), 0.0);
  const auto& section = model_.section();
  double* trial = state_->evaluate_law().data();
  const double* committed = std::as_const(*state_).committed_law().data();
  Index failed = -1;
  for (std::size_t c = 0; c + 1 < colour_start_.size(); ++c) {
    // Few batches are done by one thread: waking the others costs more, above all on a busy machine.
#pragma omp parallel for schedule(static) \
    reduction(max                         \
              : failed) if (colour_start_[c + 1] - colour_start_[c] >= 16)
    for (Index b = colour_start_[c]; b < colour_start_[c + 1]; ++b) {
      alignas(64) double x[12 * lanes], d[12 * lanes], basis[24 * lanes], f[24 * lanes], k[kEntries * lanes];
      const Batch& batch = batches_[b];
      const auto& kernels = batch.kind->kernels;
      gather(batch, x, d, basis);
      const element::Shell4Batch data{
          geometry_.data() + batch.geometry, x, d, basis, committed + batch.law, trial + batch.law};
      unsigned bad =
          with_tangent ? kernels.tangent(section, at, data, f, k) : kernels.force(section, at, data, f);
      bad &= (1u << batch.used) - 1;
      if (bad != 0) failed = std::max(failed, batch.element[__builtin_ctz(bad)]);
      scatter_force(batch, f);
      if (with_tangent) scatter_tangent(batch, k, *K, lead, product);
    }
  }
  const auto& s = std::as_const(*state_);
  loads_->add_to_internal(s.x(), s.d(), X_, force_x_, force_d_);
  if (with_tangent) {
    scatter_tied(*K, lead, product);
    add_load_stiffness(*K, lead, product);
    add_body_stiffness(*K);
  }
  failed_element_ = failed;
  return failed < 0;
}

bool Assembly::forces(fabric::AtSwitch at) { return run(at, false, nullptr, {}, {}); }

bool Assembly::tangent(fabric::AtSwitch at, solver::SparseMatrix& K, std::span<const double> lead,
                       std::span<double> product) {
  return run(at, true, &K, lead, product);
}

}  // namespace fabricsh::assembly
