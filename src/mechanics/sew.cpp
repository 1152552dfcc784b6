// Seams in the map from unknowns to nodes: which nodes follow at the start, and what happens where stitches
// close and open during a run.
#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/sewing.hpp"

namespace fabricsh::mechanics {

void Dofs::begin_seams(const model::Model& model) {
  if (model.all<model::Seam>().empty()) return;
  stitches_ = model::work_out_seams(model);
  seams_ = model.all<model::Seam>();
  ties_ = freedoms_.followers;
  for (const NodeFreedoms& node : freedoms_.nodes) {
    unsewn_.push_back(node.equation);
    for (Index& equation : unsewn_.back())
      if (equation >= 0) equation = 0;
  }
  for (const model::Stitch& s : stitches_) {
    seam_nodes_.push_back(s.node);
    for (const model::Lead& lead : s.leads) seam_nodes_.push_back(lead.node);
  }
  std::sort(seam_nodes_.begin(), seam_nodes_.end());
  seam_nodes_.erase(std::unique(seam_nodes_.begin(), seam_nodes_.end()), seam_nodes_.end());
  sewn_.parted.assign(stitches_.size(), 0);
  const SewnEdges edges{model.mesh(), stitches_, [this](Index n) { return X_[n]; },
                        [this](Index n) { return directors_[n]; }};
  for (std::size_t s = 0; s < seams_.size(); ++s)
    sewn_.turning.push_back(seams_[s].over ? 0 : edges.turning(seams_[s], s));
  for (const model::Stitch& s : stitches_) sewn_.closed.push_back(seams_[s.seam].stiffness ? 0 : 1);
  follow_seams();  // refuses now what could not be closed later
  for (std::size_t i = 0; i < stitches_.size(); ++i)
    if (seams_[stitches_[i].seam].over) sewn_.closed[i] = 0;
  follow_seams();
}

// Makes the equations of the nodes and what follows what, from the stitches that are closed.
void Dofs::follow_seams() {
  auto followers = sewn_followers(stitches_, sewn_, freedoms_.nodes, unsewn_);
  for (const Index n : seam_nodes_) freedoms_.nodes[n].equation = unsewn_[static_cast<std::size_t>(n)];
  for (const auto& f : followers) {
    auto& equation = freedoms_.nodes[f.node].equation;
    equation[static_cast<std::size_t>(f.component)] = tied;
    if (f.component == 3) equation[4] = tied;
  }
  followers.insert(followers.end(), ties_.begin(), ties_.end());
  std::sort(followers.begin(), followers.end(), [](const auto& a, const auto& b) {
    return a.node != b.node ? a.node < b.node : a.component < b.component;
  });
  freedoms_.followers = std::move(followers);
  freedoms_.number(joints_);
}

bool Dofs::has_parted(Index node) const {
  for (std::size_t i = 0; i < stitches_.size(); ++i) {
    const auto& s = stitches_[i];
    if (sewn_.parted[i] != 0 &&
        (s.node == node ||
         std::any_of(s.leads.begin(), s.leads.end(), [&](const auto& l) { return l.node == node; })))
      return true;
  }
  return false;
}

Vec3 Dofs::gap(const model::Stitch& stitch, std::span<const double> x) {
  Vec3 way = at(x, stitch.node);
  for (const model::Lead& lead : stitch.leads) way -= lead.weight * at(x, lead.node);
  return way;
}

void Dofs::check_gaps(const Sewn& before, double within) const {
  for (std::size_t i = 0; i < stitches_.size(); ++i) {
    if (sewn_.closed[i] == 0 || before.closed[i] != 0) continue;
    const double apart = gap(stitches_[i], std::as_const(configuration_).x()).norm();
    if (!(apart <= within))
      throw Error("seam " + seams_[stitches_[i].seam].name() + ": node " +
                  std::to_string(stitches_[i].node + 1) + " is " + fabricsh::number(apart) +
                  " m from where it is sewn to: expected at most " + fabricsh::number(within) + " m");
  }
}

// Moves the leads towards what is to follow them, so that the centre of mass stays where it is, and the
// followers to their leads.
void Dofs::meet_seams(std::span<const double> mass, std::span<const double> rotary) {
  struct Pull {
    Vec3 x = Vec3::Zero(), d = Vec3::Zero(), mass = Vec3::Zero();
    double rotary = 0;
  };
  std::map<Index, Pull> pulls;
  const auto x = configuration_.x(), d = configuration_.d(), b1 = configuration_.b1();
  for (const auto& f : freedoms_.followers) {
    if (!f.sewn) continue;
    Vec3 other = Vec3::Zero();
    for (const auto& lead : f.leads)
      other += lead.weight * (f.component < 3 ? Vec3(at(x, lead.node)) : Vec3(at(d, lead.node)));
    if (f.component == 3) other.normalize();
    for (const auto& lead : f.leads) {
      Pull& pull = pulls[lead.node];
      if (f.component == 3) {
        pull.d += lead.weight * rotary[f.node] * (at(d, f.node) - other);
        pull.rotary += lead.weight * rotary[f.node];
      } else {
        pull.x[f.component] += lead.weight * mass[f.node] * (at(x, f.node)[f.component] - other[f.component]);
        pull.mass[f.component] += lead.weight * mass[f.node];
      }
    }
  }
  for (const auto& [n, pull] : pulls) {
    const auto& equation = freedoms_.nodes[n].equation;
    for (int c = 0; c < 3; ++c)
      if (equation[static_cast<std::size_t>(c)] >= 0) at(x, n)[c] += pull.x[c] / (mass[n] + pull.mass[c]);
    if (equation[3] < 0 || !(pull.rotary > 0)) continue;
    const Vec3 direction = (at(d, n) + pull.d / (rotary[n] + pull.rotary)).normalized(), first = at(b1, n);
    at(d, n) = direction;
    at(b1, n) = (first - first.dot(direction) * direction).normalized();
    realign(n);
  }
  follow();
  configuration_.touch();
}

std::vector<Dofs::DofRow> Dofs::row_of(Index n) const {
  std::vector<Link> links;
  this->links(n, links);
  const Configuration& s = configuration_;
  const Vec3 b1 = at(s.b1(), n), b2 = Vec3(at(s.d(), n)).cross(b1);
  const Mat3 frame = freedoms_.nodes[n].frame.transpose();
  std::vector<DofRow> row;
  for (const Link& l : links)
    if (l.equation >= 0)
      row.push_back({l.equation, frame * l.column.head<3>(), l.column[3] * b1 + l.column[4] * b2});
  return row;
}

// The velocity of an unknown is the mean of those of all nodes that it moves, by their masses and weights:
// the momentum stays.
Transfer Dofs::transfer_seams(const std::vector<std::array<Index, 5>>& before, Index bodies_before,
                              const std::vector<std::vector<DofRow>>& rows, std::span<const double> mass,
                              std::span<const double> rotary) const {
  std::vector<Index> from(static_cast<std::size_t>(freedoms_.unknowns), -1);
  for (std::size_t n = 0; n < before.size(); ++n)
    for (std::size_t c = 0; c < 5; ++c)
      if (const Index now = freedoms_.nodes[n].equation[c]; now >= 0)
        from[static_cast<std::size_t>(now)] = before[n][c];
  for (const RigidBody& body : freedoms_.bodies)
    for (Index i = 0; i < 6; ++i)
      from[static_cast<std::size_t>(body.equation + i)] =
          bodies_before + body.equation - freedoms_.bodies.front().equation + i;
  std::map<Index, std::map<Index, double>> mixed;  // new unknown, old unknown, weight
  std::map<Index, double> whole;
  for (std::size_t k = 0; k < seam_nodes_.size(); ++k) {
    const Index n = seam_nodes_[k];
    for (const DofRow& now : row_of(n)) {
      whole[now.equation] += mass[n] * now.x.norm() + rotary[n] * now.d.norm();
      auto& parts = mixed[now.equation];
      for (const DofRow& old : rows[k])
        if (const double w = mass[n] * now.x.dot(old.x) + rotary[n] * now.d.dot(old.d); w != 0)
          parts[old.equation] += w;
    }
  }
  Transfer out;
  for (Index i = 0; i < freedoms_.unknowns; ++i) {
    std::vector<Transfer::WeightedUnknown> row;
    if (const auto found = mixed.find(i); found != mixed.end())
      for (const auto& [old, weight] : found->second) row.push_back({old, weight / whole[i]});
    else
      row.push_back({from[static_cast<std::size_t>(i)], 1});
    out.add(row);
  }
  return out;
}

std::optional<Transfer> Dofs::sew(Sewn next, std::span<const double> mass, std::span<const double> rotary,
                                  double within) {
  if (next == sewn_) return {};
  std::vector<std::array<Index, 5>> equations;
  for (const NodeFreedoms& node : freedoms_.nodes) equations.push_back(node.equation);
  const Index bodies = freedoms_.bodies.empty() ? 0 : freedoms_.bodies.front().equation;
  std::vector<std::vector<DofRow>> rows;
  for (const Index n : seam_nodes_) rows.push_back(row_of(n));
  const Sewn before = std::exchange(sewn_, std::move(next));
  try {
    check_gaps(before, within);
    follow_seams();
  } catch (const Error&) {
    sewn_ = before;
    throw;
  }
  number();
  bool closes = false;
  for (std::size_t i = 0; i < stitches_.size(); ++i)
    closes = closes || (sewn_.closed[i] != 0 && before.closed[i] == 0);
  if (closes) meet_seams(mass, rotary);
  return transfer_seams(equations, bodies, rows, mass, rotary);
}

bool Dofs::resew(Sewn sewn) {
  if (sewn == sewn_) return false;
  sewn_ = std::move(sewn);
  follow_seams();
  number();
  return true;
}

}  // namespace fabricsh::mechanics
