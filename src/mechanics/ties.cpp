// Ties are eliminated: followers take the weighted sum of their leads' displacements, and rigid sets have six
// unknowns. The forces on a tied node are passed to its leads by the columns of its links, the same columns
// that give its increments.
#include <algorithm>

#include "geometry/node_view.hpp"
#include "mechanics/dofs.hpp"

namespace fabricsh::mechanics {

namespace {
using Column = Eigen::Matrix<double, 5, 1>;
}

namespace {

// Of a follower, from the directors of its leads.
template <class Directors>
Vec3 director_of(const model::Follower& f, const Directors& of_node) {
  if (f.leads.size() == 1) return of_node(f.leads[0].node);
  Vec3 sum = Vec3::Zero();
  for (const auto& lead : f.leads) sum += lead.weight * of_node(lead.node);
  return sum.normalized();
}

auto first_follower(const std::vector<model::Follower>& all, Index node) {
  return std::lower_bound(all.begin(), all.end(), node,
                          [](const model::Follower& a, Index b) { return a.node < b; });
}

}  // namespace

// The directors of nodes tied together are replaced by their mean, because each side of a seam sees only half
// of the elements.
void Dofs::meet_directors() {
  std::vector<Vec3> sum = directors_;
  for (const auto& f : freedoms_.followers)
    if (f.component == 3)
      for (const auto& lead : f.leads) sum[lead.node] += lead.weight * directors_[f.node];
  for (const auto& f : freedoms_.followers)
    if (f.component == 3)
      for (const auto& lead : f.leads) directors_[lead.node] = sum[lead.node].normalized();
  for (const auto& f : freedoms_.followers)
    if (f.component == 3) directors_[f.node] = director_of(f, [this](Index n) { return directors_[n]; });
}

Vec3 Dofs::centroid(const RigidBody& body, std::span<const double> x) const {
  Vec3 sum = Vec3::Zero();
  for (const Index n : body.nodes) sum += at(x, n);
  return sum / static_cast<double>(body.nodes.size());
}

void Dofs::leads(Index n, std::vector<AxisLead>& out) const {
  out.clear();
  const auto& equation = freedoms_.nodes[n].equation;
  Vec3 own = Vec3::Ones();
  for (int c = 0; c < 3; ++c)
    if (equation[c] == tied) own[c] = 0;
  if (!own.isZero(0)) out.push_back({n, own});
  if (!freedoms_.ties(n)) return;
  for (auto f = first_follower(freedoms_.followers, n); f != freedoms_.followers.end() && f->node == n; ++f) {
    if (f->component == 3) continue;
    for (const auto& lead : f->leads) {
      auto at = std::find_if(out.begin(), out.end(),
                             [&](const AxisLead& other) { return other.node == lead.node; });
      if (at == out.end()) at = out.insert(at, {lead.node, Vec3::Zero()});
      at->weight[f->component] += lead.weight;
    }
  }
}

void Dofs::links(Index n, std::vector<Link>& out) const {
  out.clear();
  const NodeFreedoms& node = freedoms_.nodes[n];
  if (const Index which = freedoms_.body(n); which >= 0) {
    const RigidBody& body = freedoms_.bodies[which];
    const Configuration& s = configuration_;
    const Vec3 r = at(s.x(), n) - centroid(body, s.x()), d = at(s.d(), n), b1 = at(s.b1(), n);
    for (int i = 0; i < 3; ++i) out.push_back({body.equation + i, Column::Unit(i)});
    for (int i = 0; i < 3; ++i) {
      const Vec3 spin = Vec3::Unit(i).cross(d);
      Column c;
      c << Vec3::Unit(i).cross(r), b1.dot(spin), d.cross(b1).dot(spin);
      out.push_back({body.equation + 3 + i, c});
    }
    return;
  }
  for (int c = 0; c < 5; ++c)
    if (node.equation[c] != tied && node.equation[c] != held)
      out.push_back({node.equation[c], Column::Unit(c)});
  for (auto f = first_follower(freedoms_.followers, n); f != freedoms_.followers.end() && f->node == n; ++f)
    for (const auto& lead : f->leads) {
      const NodeFreedoms& from = freedoms_.nodes[lead.node];
      if (f->component == 3) {
        if (f->leads.size() > 1)
          mixed_links(*f, lead, out);
        else
          for (int c = 3; c < 5; ++c)
            if (from.equation[c] != held) out.push_back({from.equation[c], Column::Unit(c)});
        continue;
      }
      for (int j = 0; j < 3; ++j)
        if (const double w = lead.weight * from.frame(j, f->component); w != 0 && from.equation[j] != held)
          out.push_back({from.equation[j], w * Column::Unit(f->component)});
    }
}

// The director of a follower of several leads has the direction of their weighted sum s: its rate is the part
// of theirs across it, over |s|.
void Dofs::mixed_links(const model::Follower& f, const model::Lead& lead, std::vector<Link>& out) const {
  const Configuration& now = configuration_;
  Vec3 sum = Vec3::Zero();
  for (const auto& l : f.leads) sum += l.weight * at(now.d(), l.node);
  const Vec3 d = at(now.d(), f.node), b1 = at(now.b1(), f.node), b2 = d.cross(b1);
  const Vec3 of_lead = at(now.d(), lead.node), first = at(now.b1(), lead.node);
  const Vec3 rates[2] = {first, of_lead.cross(first)};
  for (int c = 3; c < 5; ++c) {
    const Index equation = freedoms_.nodes[lead.node].equation[static_cast<std::size_t>(c)];
    if (equation == held) continue;
    const Vec3 rate = lead.weight / sum.norm() * rates[c - 3];
    Column column = Column::Zero();
    column[3] = b1.dot(rate);
    column[4] = b2.dot(rate);
    out.push_back({equation, column});
  }
}

// Moves the tied nodes after all others: bodies from the iterate, followers from their leads.
void Dofs::apply_ties(std::span<const double> delta, double scale) {
  const std::size_t n = X_.size();
  const std::span<const double> base = iterate();
  const auto x = configuration_.x(), d = configuration_.d(), b1 = configuration_.b1();
  for (const RigidBody& body : freedoms_.bodies) {
    if (delta.empty()) break;
    const Vec3 c = centroid(body, base);
    const double* step = delta.data() + body.equation;
    const Vec3 move = scale * Vec3(step[0], step[1], step[2]), turn = scale * Vec3(step[3], step[4], step[5]);
    const Mat3 R = turn.norm() > 0 ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix()
                                   : Mat3::Identity();
    for (const Index i : body.nodes) {
      at(x, i) = c + move + R * (at(base, i) - c);
      at(d, i) = (R * at(base.subspan(3 * n), i)).normalized();
      at(b1, i) = R * at(base.subspan(6 * n), i);
    }
  }
  follow();
}

// Moves the followers to their leads.
void Dofs::follow() {
  const auto x = configuration_.x(), d = configuration_.d(), b1 = configuration_.b1();
  for (const auto& f : freedoms_.followers) {
    if (f.component == 3) {
      const Vec3 director = director_of(f, [&d](Index n) { return Vec3(at(d, n)); });
      const Vec3 first = at(b1, f.leads[0].node);
      at(d, f.node) = director;
      at(b1, f.node) = f.leads.size() == 1 ? first : (first - first.dot(director) * director).normalized();
      continue;
    }
    double u = 0;
    for (const auto& lead : f.leads)
      u += lead.weight * (x[3 * lead.node + f.component] - (f.sewn ? 0 : X_[lead.node][f.component]));
    x[3 * f.node + f.component] = (f.sewn ? 0 : X_[f.node][f.component]) + u;
  }
}

void Dofs::add_tied_residual(std::span<const double> external, std::span<const double> internal_x,
                             std::span<const double> internal_d, std::span<const double> on_d,
                             const std::vector<Vec3>* moments, std::span<double> r) const {
  const Configuration& s = configuration_;
  for (const RigidBody& body : freedoms_.bodies)
    for (Index i = 0; i < 6; ++i) r[body.equation + i] = 0;
  std::vector<Link> node;
  for (const Index i : tied_nodes_) {
    const Vec3 b1 = at(s.b1(), i), b2 = Vec3(at(s.d(), i)).cross(b1);
    Column f;
    const Vec3 internal = at(internal_d, i),
               turning = on_d.empty() ? Vec3(-internal) : Vec3(at(on_d, i) - internal);
    f << freedoms_.nodes[i].frame * (at(external, i) - at(internal_x, i)), b1.dot(turning), b2.dot(turning);
    // The untied degrees of freedom of this node have been added already.
    for (int c = 0; c < 5; ++c)
      if (freedoms_.nodes[i].equation[c] != tied && !(c == 4 && freedoms_.nodes[i].equation[3] == tied))
        f[c] = 0;
    links(i, node);
    for (const Link& l : node)
      if (l.equation >= 0) r[l.equation] += l.column.dot(f);
    // A director cannot rotate about itself: that part of a moment acts on the body only.
    if (const Index which = freedoms_.body(i); which >= 0 && moments != nullptr) {
      const Vec3 drill = (*moments)[i].dot(at(s.d(), i)) * at(s.d(), i);
      for (int k = 0; k < 3; ++k) r[freedoms_.bodies[which].equation + 3 + k] += drill[k];
    }
  }
}

// The force, internal minus external, that the followers of a node pass to it, N, global.
Vec3 Dofs::tied_force(Index lead, std::span<const double> internal_x,
                      std::span<const double> external) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& [which, k] : led_[lead]) {
    const auto& f = freedoms_.followers[which];
    if (f.component == 3) continue;
    const Index i = 3 * f.node + f.component;
    sum[f.component] += f.leads[k].weight * (internal_x[i] - external[i]);
  }
  return sum;
}

}  // namespace fabricsh::mechanics
