// Tangents of all elements: batches of a colour in parallel, colours one after the other, fixed slots.
#include <algorithm>
#include <cmath>

#include "assembly/assembly.hpp"
#include "assembly/batch.hpp"
#include "base/error.hpp"
#include "tensor/node_view.hpp"

namespace fabricsh::assembly {

namespace {

using element::shell4_dofs;
constexpr int kEntries = shell4_dofs * shell4_dofs;
constexpr int kBlocks = 4 * shell4_dofs;  // slots of an element

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
  make_slots();
}

// A node's unknowns are numbered one after the other, so that its rows in a column are neighbours: one slot
// for each column of the element and node, and one offset for each row.
void Assembly::make_slots() {
  slots_.assign(batches_.size() * lanes * kBlocks, -1);
  offsets_.assign(batches_.size() * lanes * shell4_dofs, -1);
  care_.assign(batches_.size() * lanes, Care::none);
  for (std::size_t b = 0; b < batches_.size(); ++b)
    for (int l = 0; l < batches_[b].used; ++l) {
      const auto eq = equations_of(freedoms_, batches_[b].nodes[l]);
      for (const Index e : eq)
        if (e < held && e != tied) care_[b * lanes + l] = Care::driven;
      for (const Index n : batches_[b].nodes[l])
        if (n >= 0 && (freedoms_.nodes[n].oblique || freedoms_.ties(n))) care_[b * lanes + l] = Care::frames;
      Index first[4];
      for (int a = 0; a < 4; ++a) {
        first[a] = -1;
        for (int i = 5 * a; i < 5 * a + 5; ++i) {
          if (eq[i] < 0) continue;
          if (first[a] < 0) first[a] = eq[i];
          offsets_[(b * lanes + l) * shell4_dofs + i] = static_cast<signed char>(eq[i] - first[a]);
        }
      }
      Index* slot = slots_.data() + (b * lanes + l) * kBlocks;
      for (int c = 0; c < shell4_dofs; ++c)
        for (int a = 0; a < 4; ++a) {
          if (first[a] < 0 || eq[c] < 0) continue;
          const auto begin = pattern_.row.begin() + pattern_.column[eq[c]];
          const auto end = pattern_.row.begin() + pattern_.column[eq[c] + 1];
          slot[4 * c + a] = std::lower_bound(begin, end, first[a]) - pattern_.row.begin();
        }
    }
}

namespace {

using Dense = Eigen::Matrix<double, shell4_dofs, shell4_dofs>;

// Turns the translations of oblique nodes into their frames.
void into_frames(const Freedoms& freedoms, const std::array<Index, 4>& nodes, Dense& K) {
  for (int a = 0; a < 4; ++a) {
    if (nodes[a] < 0 || !freedoms.nodes[nodes[a]].oblique) continue;
    const NodeFreedoms& node = freedoms.nodes[nodes[a]];
    K.middleRows<3>(5 * a) = (node.frame * K.middleRows<3>(5 * a)).eval();
    K.middleCols<3>(5 * a) = (K.middleCols<3>(5 * a) * node.frame.transpose()).eval();
  }
}

// The columns of an element tangent into their slots: entry (r, c) at k[(rows * c + r) * stride].
void add_columns(const double* k, int stride, int corners, int rows, const Index* slot,
                 const signed char* offset, double* value) {
  bool whole[4];
  for (int a = 0; a < corners; ++a) whole[a] = offset[5 * a] == 0 && offset[5 * a + 4] == 4;
  for (int c = 0; c < 5 * corners; ++c, slot += 4) {
    const double* column = k + static_cast<long>(rows) * c * stride;
    for (int a = 0; a < corners; ++a) {
      if (slot[a] < 0) continue;
      double* to = value + slot[a];
      const double* from = column + 5L * a * stride;
      if (whole[a]) {
        for (int i = 0; i < 5; ++i) to[i] += from[i * stride];
        continue;
      }
      for (int i = 0; i < 5; ++i)
        if (offset[5 * a + i] >= 0) to[offset[5 * a + i]] += from[i * stride];
    }
  }
}

}  // namespace

void Assembly::scatter_tangent(const Batch& batch, const double* K, solver::SparseMatrix& out,
                               std::span<const double> lead, std::span<double> product) {
  const Index b = &batch - batches_.data();
  const int corners = batch.kind->corners, dofs = batch.kind->dofs;
  for (int l = 0; l < batch.used; ++l) {
    const Index element = b * lanes + l;
    if (care_[element] == Care::frames || (care_[element] == Care::driven && !lead.empty()))
      scatter_with_care(batch, l, K, out, lead, product);
    else
      add_columns(K + l, lanes, corners, dofs, slots_.data() + element * kBlocks,
                  offsets_.data() + element * shell4_dofs, out.value.data());
  }
}

// An element with oblique, tied or driven nodes, by way of its whole matrix; a triangle fills its first
// fifteen rows and columns.
void Assembly::scatter_with_care(const Batch& batch, int lane, const double* K, solver::SparseMatrix& out,
                                 std::span<const double> lead, std::span<double> product) {
  const Index element = (&batch - batches_.data()) * lanes + lane;
  const int dofs = batch.kind->dofs;
  Dense k = Dense::Zero();
  for (int c = 0; c < dofs; ++c)
    for (int r = 0; r < dofs; ++r) k(r, c) = K[(dofs * c + r) * lanes + lane];
  into_frames(freedoms_, batch.nodes[lane], k);
  if (!tied_place_.empty() && tied_place_[element] >= 0) {
    std::copy_n(k.data(), kEntries, tied_tangent_.data() + tied_place_[element] * kEntries);
    return;
  }
  add_columns(k.data(), 1, batch.kind->corners, shell4_dofs, slots_.data() + element * kBlocks,
              offsets_.data() + element * shell4_dofs, out.value.data());
  if (lead.empty()) return;
  const auto eq = equations_of(freedoms_, batch.nodes[lane]);
  for (int c = 0; c < dofs; ++c) {
    if (eq[c] >= 0 || eq[c] == held) continue;
    const double move = lead_of(motion_of(eq[c]), lead);
    for (int r = 0; r < dofs; ++r)
      if (eq[r] >= 0) product[eq[r]] += k(r, c) * move;
  }
}

// Increment of a driven freedom: a displacement, or for a turned director its angle times the rate of q1 or
// q2.
double Assembly::lead_of(Index motion, std::span<const double> lead) const {
  const DrivenFreedom& m = freedoms_.motions[motion];
  if (m.component < 3) return lead[motion];
  const auto& s = std::as_const(*state_);
  const Vec3 d = at(s.d(), m.node), b1 = at(s.b1(), m.node);
  const Vec3 rate = freedoms_.nodes[m.node].turn_axis->cross(d);
  return lead[motion] * rate.dot(m.component == 3 ? b1 : Vec3(d.cross(b1)));
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

Index Assembly::element_tangents(fabric::AtSwitch at, bool law_only, solver::SparseMatrix& K,
                                 std::span<const double> lead, std::span<double> product) {
  std::fill(K.value.begin(), K.value.end(), 0.0);
  std::fill(product.begin(), product.end(), 0.0);
  double* trial = state_->evaluate_law().data();
  Index failed = -1;
  for (std::size_t c = 0; c + 1 < colour_start_.size(); ++c) {
#pragma omp parallel for schedule(static) \
    reduction(max                         \
              : failed) if (colour_start_[c + 1] - colour_start_[c] >= few_batches)
    for (Index b = colour_start_[c]; b < colour_start_[c + 1]; ++b) {
      alignas(64) double k[kEntries * lanes];
      failed = std::max(failed, evaluate(b, at, trial, k, law_only));
      scatter_tangent(batches_[b], k, K, lead, product);
    }
  }
  return failed;
}

bool Assembly::tangent(fabric::AtSwitch at, solver::SparseMatrix& K, std::span<const double> lead,
                       std::span<double> product) {
  failed_element_ = element_tangents(at, false, K, lead, product);
  sum_forces();
  scatter_tied(K, lead, product);
  add_load_stiffness(K, lead, product);
  add_body_stiffness(K);
  return failed_element_ < 0;
}

bool Assembly::material_tangent(solver::SparseMatrix& K, std::span<const double> lead,
                                std::span<double> product) {
  failed_element_ = element_tangents(fabric::AtSwitch::loading, true, K, lead, product);
  scatter_tied(K, lead, product);
  return failed_element_ < 0;
}

Index Assembly::inverted_element() const {
  Index first = -1;
  for (const Batch& batch : batches_) {
    alignas(64) double x[12 * lanes], d[12 * lanes];
    gather(batch, x, d, nullptr);
    const unsigned lost =
        batch.kind->kernels.inverted({nullptr, x, d, nullptr, nullptr, nullptr}) & ((1u << batch.used) - 1);
    for (int l = 0; l < batch.used; ++l)
      if ((lost >> l & 1u) != 0 && (first < 0 || batch.element[l] < first)) first = batch.element[l];
  }
  return first;
}

}  // namespace fabricsh::assembly
