#include "mechanics/stiffness.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"

namespace fabricsh::mechanics {

namespace {

using element::shell4_dofs;
using Column = Eigen::Matrix<double, 5, 1>;
using Dense = Eigen::Matrix<double, shell4_dofs, shell4_dofs>;
constexpr int kEntries = shell4_dofs * shell4_dofs;

std::array<Index, shell4_dofs> equations_of(const Freedoms& freedoms, const std::array<Index, 4>& nodes) {
  std::array<Index, shell4_dofs> eq;
  for (int a = 0; a < 4; ++a)
    for (int i = 0; i < 5; ++i) eq[5 * a + i] = nodes[a] < 0 ? held : freedoms.nodes[nodes[a]].equation[i];
  return eq;
}

// Rotates the translations of nodes with oblique frames into these frames.
void into_frames(const Freedoms& freedoms, const std::array<Index, 4>& nodes, Dense& K) {
  for (int a = 0; a < 4; ++a) {
    if (nodes[a] < 0 || !freedoms.nodes[nodes[a]].oblique) continue;
    const NodeFreedoms& node = freedoms.nodes[nodes[a]];
    K.middleRows<3>(5 * a) = (node.frame * K.middleRows<3>(5 * a)).eval();
    K.middleCols<3>(5 * a) = (K.middleCols<3>(5 * a) * node.frame.transpose()).eval();
  }
}

std::vector<Index> ends_of_blocks(const Dofs& dofs) {
  std::vector<Index> end(static_cast<std::size_t>(dofs.unknowns()), -1);
  for (const NodeFreedoms& node : dofs.freedoms().nodes) {
    const Index last = *std::max_element(node.equation.begin(), node.equation.end());
    for (const Index eq : node.equation)
      if (eq >= 0) end[eq] = last;
  }
  for (const RigidBody& body : dofs.freedoms().bodies)
    for (Index i = 0; i < 6; ++i) end[body.equation + i] = body.equation + 5;
  return end;
}

// Adds the blocks of an element tangent to their slots; entry (r, c) is k[(rows * c + r) * stride].
void add_blocks(const double* k, int stride, int rows, std::span<const ElementBlock> blocks,
                const signed char* offset, double* value) {
  for (const ElementBlock& block : blocks) {
    if (!block.used()) continue;
    const signed char* of_row = offset + 5 * block.row;
    const bool whole = of_row[0] == 0 && of_row[4] == 4;
    const double* from = k + 5L * (static_cast<long>(rows) * block.column + block.row) * stride;
    for (int c = 0; c < 5; ++c, from += static_cast<long>(rows) * stride) {
      if (block.slot[c] == ElementBlock::none) continue;
      double* to = value + block.slot[c];
      if (whole) {
        for (int i = 0; i < 5; ++i) to[i] += from[i * stride];
        continue;
      }
      for (int i = 0; i < 5; ++i)
        if (of_row[i] >= 0) to[of_row[i]] += from[i * stride];
    }
  }
}

// Two numbers that are added at once.
using Two = double __attribute__((vector_size(16)));
inline Two two_at(const double* p) {
  Two v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline void add_two(Two v, double* p) {
  v += two_at(p);
  __builtin_memcpy(p, &v, sizeof v);
}

// Adds five numbers each of two elements, which are side by side in `from`, to consecutive entries.
inline void add_five(const double* from, double* first, double* second) {
  for (int i = 0; i < 4; i += 2) {
    const Two a = two_at(from + i * lanes), b = two_at(from + (i + 1) * lanes);
    add_two(__builtin_shufflevector(a, b, 0, 2), first + i);
    add_two(__builtin_shufflevector(a, b, 1, 3), second + i);
  }
  first[4] += from[4 * lanes];
  second[4] += from[4 * lanes + 1];
}

// Whether two elements have the same blocks, and every unknown of their nodes is in the matrix.
bool alike(std::span<const ElementBlock> a, std::span<const ElementBlock> b, const signed char* offsets) {
  const auto is_whole = [](const signed char* of) {
    for (int n = 0; n < 4; ++n)
      if (of[5 * n] != 0 || of[5 * n + 4] != 4) return false;
    return true;
  };
  if (!is_whole(offsets) || !is_whole(offsets + shell4_dofs)) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].row != b[i].row || a[i].column != b[i].column || a[i].used() != b[i].used()) return false;
  return true;
}

// The same as add_blocks() for two elements that are alike, in neighbouring lanes.
void add_blocks_of_two(const double* k, int rows, std::span<const ElementBlock> first,
                       std::span<const ElementBlock> second, double* value) {
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!first[i].used()) continue;
    const double* from = k + 5L * (static_cast<long>(rows) * first[i].column + first[i].row) * lanes;
    for (int c = 0; c < 5; ++c, from += static_cast<long>(rows) * lanes)
      add_five(from, value + first[i].slot[c], value + second[i].slot[c]);
  }
}

// Prefetches the five rows of a node in a column, which may be on two cache lines.
template <int locality>
inline void prefetch_rows(const double* first) {
  __builtin_prefetch(first, 1, locality);
  if ((reinterpret_cast<std::uintptr_t>(first) & 63u) > 24) __builtin_prefetch(first + 4, 1, locality);
}

template <int locality>
inline void prefetch_block(const ElementBlock& block, const double* value) {
  if (!block.used()) return;
  for (const std::uint32_t slot : block.slot)
    if (slot != ElementBlock::none) prefetch_rows<locality>(value + slot);
}

}  // namespace

Stiffness::Stiffness(const Dofs& dofs, std::span<const Batch> batches, std::span<const BatchLane> places,
                     bool upper)
    : dofs_(dofs), batches_(batches), upper_(upper) {
  list_tied_elements(places);
  if (upper) block_end_ = ends_of_blocks(dofs);
  make_pattern();
  make_slots();
}

void Stiffness::list_tied_elements(std::span<const BatchLane> places) {
  if (!dofs_.has_ties()) return;
  const Freedoms& freedoms = dofs_.freedoms();
  tied_place_.assign(batches_.size() * lanes, -1);
  for (const BatchLane place : places) {
    const auto& nodes = batches_[place.batch].nodes[place.lane];
    if (!std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return n >= 0 && freedoms.ties(n); }))
      continue;
    tied_place_[place.batch * lanes + place.lane] = static_cast<Index>(tied_elements_.size());
    tied_elements_.push_back(place);
  }
  tied_tangent_.resize(tied_elements_.size() * kEntries);
}

namespace {

// Adds the unknowns on which a node's degrees of freedom depend.
void add_unknowns(const Dofs& dofs, Index node, std::vector<Index>& out) {
  if (node < 0) return;
  std::vector<Link> links;
  if (dofs.freedoms().ties(node)) {
    dofs.links(node, links);
    for (const Link& l : links)
      if (l.equation >= 0) out.push_back(l.equation);
    return;
  }
  for (const Index eq : dofs.freedoms().nodes[node].equation)
    if (eq >= 0) out.push_back(eq);
}

void couple_all(const std::vector<Index>& unknowns, std::vector<std::vector<Index>>& columns) {
  for (const Index c : unknowns) columns[c].insert(columns[c].end(), unknowns.begin(), unknowns.end());
}

}  // namespace

void Stiffness::keep_upper(std::vector<std::vector<Index>>& columns) const {
  for (std::size_t c = 0; c < columns.size() && upper_; ++c)
    std::erase_if(columns[c], [&](Index r) { return r > block_end_[c]; });
}

void Stiffness::make_pattern() {
  std::vector<std::vector<Index>> columns(dofs_.unknowns());
  std::vector<Index> all;
  for (const Batch& batch : batches_)
    for (int l = 0; l < batch.used; ++l) {
      all.clear();
      for (const Index n : batch.nodes[l]) add_unknowns(dofs_, n, all);
      couple_all(all, columns);
    }
  for (const RigidBody& body : dofs_.freedoms().bodies)
    for (Index i = 0; i < 6; ++i)
      for (Index j = 0; j < 6; ++j) columns[body.equation + i].push_back(body.equation + j);
  keep_upper(columns);
  linear::Pattern made(std::move(columns));
  made.upper = upper_;
  own_ = pattern_ = std::make_shared<const linear::Pattern>(std::move(made));
}

void Stiffness::couple(std::span<const NodePair> pairs) {
  if (pairs.empty() && pattern_ == own_) return;
  std::vector<std::vector<Index>> columns(dofs_.unknowns());
  std::vector<Index> all;
  for (const auto& [a, b] : pairs) {
    all.clear();
    add_unknowns(dofs_, a, all);
    add_unknowns(dofs_, b, all);
    couple_all(all, columns);
  }
  keep_upper(columns);
  pattern_ = pairs.empty() ? own_ : std::make_shared<const linear::Pattern>(own_->with(std::move(columns)));
  make_slots();
}

// The unknowns of a node have consecutive numbers, so that its rows are adjacent in each column. It is
// therefore enough to store one slot for each column of the block of two nodes, and one offset for each row.
void Stiffness::make_slots() {
  find_slots();
  pair_elements();
}

void Stiffness::find_slots() {
  const Freedoms& freedoms = dofs_.freedoms();
  if (pattern_->entries() > static_cast<Index>(ElementBlock::none))
    throw Error("the matrix of the stiffness has more than 4,294,967,295 entries: expected a smaller model");
  blocks_.assign(batches_.size() * lanes * per_element(), {});
  wanted_.assign(batches_.size(), 0);
  offsets_.assign(batches_.size() * lanes * shell4_dofs, -1);
  care_.assign(batches_.size() * lanes, Care::none);
  for (std::size_t b = 0; b < batches_.size(); ++b)
    for (int l = 0; l < batches_[b].used; ++l) {
      const auto eq = equations_of(freedoms, batches_[b].nodes[l]);
      for (const Index e : eq)
        if (e < held && e != tied) care_[b * lanes + l] = Care::driven;
      for (const Index n : batches_[b].nodes[l])
        if (n >= 0 && (freedoms.nodes[n].oblique || freedoms.ties(n))) care_[b * lanes + l] = Care::frames;
      Index first[4];
      for (int a = 0; a < 4; ++a) {
        first[a] = -1;
        for (int i = 5 * a; i < 5 * a + 5; ++i) {
          if (eq[i] < 0) continue;
          if (first[a] < 0) first[a] = eq[i];
          offsets_[(b * lanes + l) * shell4_dofs + i] = static_cast<signed char>(eq[i] - first[a]);
        }
      }
      if (care_[b * lanes + l] != Care::none) wanted_[b] = 0xffff;
      ElementBlock* block = blocks_.data() + (b * lanes + l) * per_element();
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
          if (first[row] < 0 || first[column] < 0 || (upper_ && first[row] > block_end_[first[column]]))
            continue;
          block->row = static_cast<signed char>(row);
          block->column = static_cast<signed char>(column);
          wanted_[b] |= static_cast<std::uint16_t>(1u << (4 * row + column));
          for (int c = 0; c < 5; ++c)
            if (const Index e = eq[5 * column + c]; e >= 0)
              block->slot[c] = static_cast<std::uint32_t>(pattern_->slot(first[row], e));
          ++block;
        }
    }
}

// Finds the elements that are added to the matrix together with the next one.
void Stiffness::pair_elements() {
  paired_.assign(batches_.size() * lanes, false);
  for (std::size_t b = 0; b < batches_.size(); ++b)
    for (int l = 0; l + 1 < batches_[b].used; ++l) {
      const auto e = static_cast<Index>(b * lanes + l);
      if (care_[e] != Care::none || care_[e + 1] != Care::none ||
          !alike(blocks_of(e, 1), blocks_of(e + 1, 1), offsets_.data() + e * shell4_dofs))
        continue;
      paired_[e] = true;
      ++l;
    }
}

// Prefetches the entries that a batch adds to. They are scattered over the matrix, so that the processor does
// not prefetch them by itself.
void Stiffness::fetch(Index b, const Target& to) const {
  for (const ElementBlock& block : blocks_of(b * lanes, batches_[b].used))
    prefetch_block<2>(block, to.K.value.data());
}

void Stiffness::scatter(Index b, const double* K, const Target& to) {
  const Batch& batch = batches_[b];
  if (to.read != nullptr) (*to.read)(b, K);
  for (int l = 0; l < batch.used; ++l) {
    const Index element = b * lanes + l;
    if (paired_[element]) {
      add_blocks_of_two(K + l, batch.kind->dofs, blocks_of(element, 1), blocks_of(element + 1, 1),
                        to.K.value.data());
      ++l;
      continue;
    }
    if (care_[element] == Care::frames || (care_[element] == Care::driven && !to.lead.empty()))
      scatter_with_care(batch, element, l, K, to);
    else
      add_blocks(K + l, lanes, batch.kind->dofs, blocks_of(element, 1),
                 offsets_.data() + element * shell4_dofs, to.K.value.data());
  }
}

// Adds an element with oblique, tied or driven nodes through its whole matrix; a triangle uses only the first
// fifteen rows and columns.
void Stiffness::scatter_with_care(const Batch& batch, Index element, int lane, const double* K,
                                  const Target& to) {
  const Freedoms& freedoms = dofs_.freedoms();
  const int dofs = batch.kind->dofs;
  Dense k = Dense::Zero();
  for (int c = 0; c < dofs; ++c)
    for (int r = 0; r < dofs; ++r) k(r, c) = K[(dofs * c + r) * lanes + lane];
  into_frames(freedoms, batch.nodes[lane], k);
  if (!tied_place_.empty() && tied_place_[element] >= 0) {
    std::copy_n(k.data(), kEntries, tied_tangent_.data() + tied_place_[element] * kEntries);
    return;
  }
  add_blocks(k.data(), 1, shell4_dofs, blocks_of(element, 1), offsets_.data() + element * shell4_dofs,
             to.K.value.data());
  if (to.lead.empty()) return;
  const auto eq = equations_of(freedoms, batch.nodes[lane]);
  for (int c = 0; c < dofs; ++c) {
    if (eq[c] >= 0 || eq[c] == held) continue;
    const double move = dofs_.lead_of(motion_of(eq[c]), to.lead);
    for (int r = 0; r < dofs; ++r)
      if (eq[r] >= 0) to.product[eq[r]] += k(r, c) * move;
  }
}

void Stiffness::scatter_tied(const Target& to) const {
  std::vector<Link> node[4];
  for (std::size_t e = 0; e < tied_elements_.size(); ++e) {
    const BatchLane place = tied_elements_[e];
    const Batch& batch = batches_[place.batch];
    const auto& nodes = batch.nodes[place.lane];
    const Eigen::Map<const Dense> k(tied_tangent_.data() + e * kEntries);
    const int corners = batch.kind->corners;
    for (int a = 0; a < corners; ++a) dofs_.links(nodes[a], node[a]);
    for (int b = 0; b < corners; ++b)
      for (const Link& column : node[b]) {
        const Eigen::Matrix<double, shell4_dofs, 1> kc = k.middleCols<5>(5 * b) * column.column;
        for (int a = 0; a < corners; ++a)
          for (const Link& row : node[a])
            add_entry(row.equation, column.equation, row.column.dot(kc.segment<5>(5 * a)), to);
      }
  }
}

// Adds one number to K or, for a driven column, to the product.
void Stiffness::add_entry(Index r, Index c, double v, const Target& to) const {
  if (r < 0 || c == held || v == 0) return;
  if (c < held) {
    if (!to.lead.empty()) to.product[r] += v * dofs_.lead_of(motion_of(c), to.lead);
    return;
  }
  to.K.add(r, c, v);
}

namespace {

// The place of an entry in its column: mostly the same for all columns of a node, and looked for if not.
Index slot_near(const linear::Pattern& pattern, Index r, Index c, Index& place) {
  const Index guess = pattern.column[c] + place;
  if (guess >= pattern.column[c + 1] || pattern.row[guess] != r)
    place = pattern.slot(r, c) - pattern.column[c];
  return pattern.column[c] + place;
}

// Where the rows of node a were in the columns of node b when such a block was last added: a guess, which is
// checked.
Index& last_place(Index a, Index b) {
  thread_local std::array<Index, 4096> places{};
  return places[static_cast<std::size_t>(97 * a + b) % places.size()];
}

// Adds a block of two nodes without ties, from their equation number `first` on. The rows of a node follow
// each other in each column.
template <int n>
void add_free(const Dofs& dofs, bool upper, Index a, Index b, int first, const Eigen::Matrix<double, n, n>& k,
              const Stiffness::Target& to) {
  Index& place = last_place(a, b);
  const auto &rows = dofs.freedoms().nodes[a].equation, &columns = dofs.freedoms().nodes[b].equation;
  for (int j = 0; j < n; ++j) {
    const Index c = columns[first + j];
    if (c == held || (c < held && to.lead.empty())) continue;
    const double led = c < held ? dofs.lead_of(motion_of(c), to.lead) : 0;
    Index slot = -1, row = 0;
    for (int i = 0; i < n; ++i) {
      const Index r = rows[first + i];
      if (r < 0 || k(i, j) == 0) continue;
      if (c < held) {
        to.product[r] += k(i, j) * led;
      } else if (!upper || r <= c) {
        if (slot < 0) slot = slot_near(*to.K.pattern, row = r, c, place);
        to.K.value[slot + r - row] += k(i, j);
      }
    }
  }
}

}  // namespace

void Stiffness::add_block(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k, const Target& to) const {
  if (!dofs_.has_ties() || (!dofs_.freedoms().ties(a) && !dofs_.freedoms().ties(b)))
    return add_free<5>(dofs_, upper_, a, b, 0, k, to);
  std::vector<Link> A, B;
  dofs_.links(a, A);
  dofs_.links(b, B);
  for (const Link& column : B) {
    const Column kc = k * column.column;
    for (const Link& row : A) add_entry(row.equation, column.equation, row.column.dot(kc), to);
  }
}

void Stiffness::add_diagonal(std::span<const double> c_x, std::span<const double> c_d,
                             linear::Matrix& K) const {
  const Target to{K, {}, {}};
  for (Index n = 0; n < static_cast<Index>(dofs_.reference().size()); ++n) {
    if (dofs_.freedoms().ties(n)) {
      Column c;
      c << c_x[n], c_x[n], c_x[n], c_d[n], c_d[n];
      add_block(n, n, c.asDiagonal(), to);
      continue;
    }
    const auto& eq = dofs_.freedoms().nodes[n].equation;
    Index place = 0;  // in a node's next column one further
    for (int c = 0; c < 5; ++c)
      if (const double v = c < 3 ? c_x[n] : c_d[n]; eq[c] >= 0 && v != 0)
        K.value[slot_near(*K.pattern, eq[c], eq[c], place)] += v, ++place;
  }
}

// K already contains the director's own second variation, -(f.d) on its two rotations. The rest is the
// force along the sphere, and a moment about the director.
void Stiffness::add_body_stiffness(const Configuration& s, std::span<const double> internal_x,
                                   std::span<const double> internal_d, std::span<const double> external,
                                   const std::vector<Vec3>* moments, const Target& to) const {
  for (const RigidBody& body : dofs_.freedoms().bodies) {
    Mat3 k = Mat3::Zero();
    const Vec3 c = dofs_.centroid(body, s.x());
    for (const Index n : body.nodes) {
      const Vec3 d = at(s.d(), n), f = at(internal_d, n), along = f - f.dot(d) * d;
      k += turning_stiffness(at(s.x(), n) - c, at(internal_x, n) - at(external, n)) +
           turning_stiffness(d, along);
      if (moments == nullptr) continue;
      const Vec3& moment = (*moments)[n];
      const Vec3 drill = moment.dot(d) * d;
      // The derivative of the moment, in the exponential map about the trial configuration.
      k -= d * d.cross(moment).transpose() - cross_matrix(drill) / 2;
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        add_entry(body.equation + 3 + i, body.equation + 3 + j, k(i, j), {to.K, {}, {}});
  }
}

bool Stiffness::Sink::through_ties(Index a, Index b) const {
  const Freedoms& freedoms = stiffness_.dofs_.freedoms();
  return stiffness_.dofs_.has_ties() && (freedoms.ties(a) || freedoms.ties(b));
}

void Stiffness::Sink::on_positions_apart(Index a, Index b, const Mat3& k, const Mat3& apart) {
  if (apart_ == nullptr || apart.isZero(0)) return add_positions(a, b, k, to_);
  if (!std::exchange(has_apart_, true)) {
    apart_->pattern = to_.K.pattern;
    apart_->value.assign(to_.K.value.size(), 0.0);
  }
  add_positions(a, b, k - apart, to_);
  add_positions(a, b, apart, {*apart_, to_.lead, to_.product});
}

void Stiffness::Sink::add_positions(Index a, Index b, const Mat3& k, const Target& to) {
  const auto& nodes = stiffness_.dofs_.freedoms().nodes;
  Mat3 turned = k;
  if (nodes[a].oblique) turned = nodes[a].frame * turned;
  if (nodes[b].oblique) turned = turned * nodes[b].frame.transpose();
  if (through_ties(a, b)) {
    Eigen::Matrix<double, 5, 5> block = Eigen::Matrix<double, 5, 5>::Zero();
    block.topLeftCorner<3, 3>() = turned;
    return stiffness_.add_block(a, b, block, to);
  }
  add_free<3>(stiffness_.dofs_, stiffness_.upper_, a, b, 0, turned, to);
}

void Stiffness::Sink::on_nodes(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k) {
  const auto& nodes = stiffness_.dofs_.freedoms().nodes;
  Eigen::Matrix<double, 5, 5> block = k;
  block.topRows<3>() = nodes[a].frame * k.topRows<3>();
  block.leftCols<3>() *= nodes[b].frame.transpose();
  stiffness_.add_block(a, b, block, to_);
}

void Stiffness::Sink::on_lead(Index a, const Vec3& force) {
  if (to_.product.empty()) return;
  Column f = Column::Zero();
  f.head<3>() = stiffness_.dofs_.freedoms().nodes[a].frame * force;
  std::vector<Link> links;
  stiffness_.dofs_.links(a, links);
  for (const Link& row : links)
    if (row.equation >= 0) to_.product[row.equation] += row.column.dot(f);
}

void Stiffness::Sink::on_director(Index a, const Eigen::Matrix2d& k) {
  if (through_ties(a, a)) {
    Eigen::Matrix<double, 5, 5> block = Eigen::Matrix<double, 5, 5>::Zero();
    block.bottomRightCorner<2, 2>() = k;
    return stiffness_.add_block(a, a, block, to_);
  }
  add_free<2>(stiffness_.dofs_, stiffness_.upper_, a, a, 3, k, to_);
}

}  // namespace fabricsh::mechanics
