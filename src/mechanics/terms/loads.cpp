#include "mechanics/terms/loads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "geometry/node_view.hpp"
#include "geometry/turning.hpp"
#include "mechanics/loads.hpp"
#include "mechanics/mesh_tools.hpp"
#include "mechanics/terms/bulges.hpp"
#include "mechanics/terms/faces.hpp"

namespace fabricsh::mechanics {

namespace {

// A vector history distributed over the nodes of a set.
struct DistributedLoad {
  mesh::NodeSet nodes;
  std::vector<double> weight;
  model::Components value;
  Mat3 frame;
  Vec3 at(double time) const {
    Vec3 total = Vec3::Zero();
    for (int c = 0; c < 3; ++c)
      if (value[c]) total += value[c]->value(time) * frame.row(c).transpose();
    return total;
  }
};

Vec3 value_at(const model::Components& value, double time) {
  Vec3 v = Vec3::Zero();
  for (int c = 0; c < 3; ++c)
    if (value[c]) v[c] = value[c]->value(time);
  return v;
}

bool is_constant(const model::Components& value) {
  return std::all_of(value.begin(), value.end(), [](const auto& h) { return !h || h->is_constant(); });
}

DistributedLoad spread(const mesh::Mesh& mesh, const std::string& set, const model::Components& value,
                       const Mat3& frame, bool total) {
  DistributedLoad s{mesh.set(set), {}, value, frame};
  const Tributary t = tributary(mesh, s.nodes);
  if (!total && t.kind == Tributary::MeasureKind::count)
    throw Error("traction: set '" + set + "' holds neither whole elements nor whole edges");
  s.weight = t.measure;
  if (total)
    for (double& weight : s.weight) weight /= t.total;
  return s;
}

// --- gravity

// Weight on the nodes; also on their directors if the reference surface is not the middle surface.
class Gravity final : public Term, public FollowerLoad {
 public:
  // mass: kg per node; mass_moment: its first moment about the reference surface, kg m.
  Gravity(const model::Model& model, const std::vector<double>& mass, const std::vector<double>& mass_moment)
      : acceleration_(model.gravity()), mass_(mass), mass_moment_(mass_moment) {
    const bool weighs =
        std::any_of(acceleration_.begin(), acceleration_.end(), [](const auto& g) { return bool(g); });
    turns_ = weighs && std::any_of(mass_moment_.begin(), mass_moment_.end(), [](double m) { return m != 0; });
    set_time(0);
  }
  const char* name() const override { return "gravity"; }
  void set_time(double time) override { at_trial_time_ = at(time); }
  void add_dead(double time, std::span<double> on_x) const override {
    const Vec3 gravity = at(time);
    for (std::size_t i = 0; i < mass_.size(); ++i)
      fabricsh::at(on_x, static_cast<Index>(i)) += mass_[i] * gravity;
  }
  bool constant() const override { return is_constant(acceleration_); }
  bool follows_directors() const override { return turns_; }
  void add_follower(double time, const Trial&, std::span<double>, std::span<double> on_d) const override {
    const Vec3 gravity = at(time);
    for (std::size_t i = 0; turns_ && i < mass_.size(); ++i)
      fabricsh::at(on_d, static_cast<Index>(i)) += mass_moment_[i] * gravity;
  }
  Outcome add_forces(const law::Step&, const Trial&, Forces& forces) override {
    for (std::size_t i = 0; turns_ && i < mass_.size(); ++i)
      fabricsh::at(forces.on_d, static_cast<Index>(i)) -= mass_moment_[i] * at_trial_time_;
    return {};
  }

  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    if (!(at_trial_time_.norm() > 0)) return;
    const auto d = trial.configuration.d();
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      if (mass_moment_[i] == 0) continue;
      const auto n = static_cast<Index>(i);
      // The second variation of the director.
      sink.on_director(
          n, (mass_moment_[i] * at_trial_time_).dot(fabricsh::at(d, n)) * Eigen::Matrix2d::Identity());
    }
  }

 private:
  Vec3 at(double time) const { return value_at(acceleration_, time); }
  model::Components acceleration_;
  const std::vector<double>&mass_, &mass_moment_;
  bool turns_ = false;  // whether it acts on directors
  Vec3 at_trial_time_ = Vec3::Zero();
};

// --- dead loads

// Forces and tractions with constant direction, per reference area. Error: a traction on a set that has
// neither whole elements nor whole edges.
class DeadLoads final : public Term {
 public:
  explicit DeadLoads(const model::Model& model) {
    const auto& mesh = model.mesh();
    for (const auto& f : model.all<model::ForceLoad>())
      loads_.push_back(spread(mesh, f.set, f.total, f.frame, true));
    for (const auto& t : model.all<model::TractionLoad>())
      loads_.push_back(spread(mesh, t.set, t.intensity, t.frame, false));
  }
  const char* name() const override { return "forces"; }
  void add_dead(double time, std::span<double> on_x) const override {
    for (const auto& load : loads_) {
      const Vec3 total = load.at(time);
      for (std::size_t i = 0; i < load.nodes.size(); ++i) at(on_x, load.nodes[i]) += load.weight[i] * total;
    }
  }
  bool constant() const override {
    return std::all_of(loads_.begin(), loads_.end(),
                       [](const DistributedLoad& s) { return is_constant(s.value); });
  }

 private:
  std::vector<DistributedLoad> loads_;
};

// --- pressure

// The directions in which a node may move, as far as supports leave them to it; empty: it is tied.
std::optional<std::vector<Vec3>> free_directions(const NodeFreedoms& node) {
  std::vector<Vec3> free;
  for (int c = 0; c < 3; ++c) {
    if (node.equation[c] == tied) return {};
    if (node.equation[c] >= 0) free.push_back(node.frame.row(c).transpose());
  }
  return free;
}

// Whether both ends are held along a direction across the edge, so that it stays in a plane.
bool stays_in_plane(const NodeFreedoms& a, const NodeFreedoms& b, const Vec3& edge) {
  constexpr double same = 1e-9;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const Vec3 n = a.frame.row(i).transpose(), m = b.frame.row(j).transpose();
      if (a.equation[i] == held && b.equation[j] == held && n.cross(m).norm() < same &&
          std::abs(n.dot(edge)) < same * edge.norm())
        return true;
    }
  return false;
}

// The work of pressure on a variation u of a surface's edge, the integral of (u x delta u) . dl, is that of
// no potential. It vanishes where both are parallel, or lie in a plane with the edge.
bool is_held(const NodeFreedoms& a, const NodeFreedoms& b, const Vec3& edge) {
  const auto u = free_directions(a), v = free_directions(b);
  if (!u || !v) return false;
  if (stays_in_plane(a, b, edge)) return true;
  if (u->size() > 1 || v->size() > 1) return false;
  return u->empty() || v->empty() || u->front().cross(v->front()).norm() < 1e-9;
}

// Edges that two elements share in opposite directions are inside. Joints of tearable zones may open
// anywhere.
bool edges_are_held(const model::Model& model, const Freedoms& freedoms,
                    const std::vector<std::array<Index, 4>>& elements) {
  if (model.mesh().whole) return false;
  std::set<std::pair<Index, Index>> open;
  for (const auto& nodes : elements)
    for (int k = 0, n = corners(nodes); k < n; ++k) {
      const std::pair<Index, Index> edge{nodes[k], nodes[(k + 1) % n]};
      if (open.erase({edge.second, edge.first}) == 0 && !open.insert(edge).second) return false;
    }
  return std::all_of(open.begin(), open.end(), [&](const auto& edge) {
    const auto& X = model.mesh().nodes;
    return is_held(freedoms.nodes[edge.first], freedoms.nodes[edge.second], X[edge.second] - X[edge.first]);
  });
}

// Pressure along the normal of the present surface: f_A = p sum_g N_A a1 x a2. It has a potential, p times
// the volume that the surface sweeps, and a symmetric stiffness, where its edges stay or move in planes.
// On triangles it also works on the volume under their arcs (terms/bulges.hpp).
class Pressure final : public Term, public FollowerLoad {
 public:
  Pressure(const model::Model& model, const RestShape& rest, const Freedoms& freedoms) {
    const auto& mesh = model.mesh();
    const bool touches = model.interactions().any();  // contact holds nodes against the pressure there
    for (const auto& p : model.all<model::PressureLoad>()) {
      Faces faces{{}, {}, p.value};
      for (const auto e : mesh.elements_in(mesh.set(p.set))) {
        faces.elements.push_back(mesh.elements[e]);
        if (touches) continue;
        if (const auto bulge = bulge_of(model, rest, e)) faces.bulges.push_back(*bulge);
      }
      bulges_ = bulges_ || !faces.bulges.empty();
      faces_.push_back(std::move(faces));
    }
    edges_are_held_ = std::all_of(faces_.begin(), faces_.end(), [&](const Faces& faces) {
      return edges_are_held(model, freedoms, faces.elements);
    });
    set_time(0);
  }

  const char* name() const override { return "pressure"; }
  void set_time(double time) override {
    at_trial_time_.clear();
    for (const auto& p : faces_) at_trial_time_.push_back(p.value.value(time));
  }
  bool follows_positions() const override { return true; }
  bool follows_directors() const override { return bulges_; }
  void add_follower(double time, const Trial& trial, std::span<double> on_x,
                    std::span<double> on_d) const override {
    for (const auto& faces : faces_) add(faces, faces.value.value(time), trial.configuration, on_x, on_d);
  }
  bool symmetric() const override { return edges_are_held_; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
    for (std::size_t k = 0; k < faces_.size(); ++k)
      add(faces_[k], -at_trial_time_[k], trial.configuration, forces.on_x, forces.on_d);
    return {};
  }
  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      add_pressure_tangent(faces_[k].elements, at_trial_time_[k], trial.configuration.x(), sink);
      add_pressure_tangent(faces_[k].bulges, at_trial_time_[k], trial.configuration, sink);
    }
  }

 private:
  struct Faces {
    std::vector<std::array<Index, 4>> elements;
    std::vector<Bulge> bulges;  // of the triangles
    model::History value;
  };
  static void add(const Faces& faces, double pressure, const Configuration& now, std::span<double> on_x,
                  std::span<double> on_d) {
    add_pressure(faces.elements, pressure, now.x(), on_x);
    add_pressure(faces.bulges, pressure, now, on_x, on_d);
  }
  std::vector<Faces> faces_;
  std::vector<double> at_trial_time_;  // Pa
  bool edges_are_held_ = false, bulges_ = false;
};

// --- moments

// Moments about axes fixed in space: the work M . (d x delta d) gives M x d on a director. Not symmetric.
class Moments final : public Term, public FollowerLoad {
 public:
  explicit Moments(const model::Model& model) : at_trial_time_(model.mesh().nodes.size(), Vec3::Zero()) {
    for (const auto& m : model.all<model::MomentLoad>())
      loads_.push_back(spread(model.mesh(), m.set, m.total, m.frame, true));
    set_time(0);
  }
  const char* name() const override { return "moments"; }
  void set_time(double time) override { at_trial_time_ = at_time(time); }
  bool follows_directors() const override { return true; }
  void add_follower(double time, const Trial& trial, std::span<double>,
                    std::span<double> on_d) const override {
    const auto d = trial.configuration.d();
    const auto moments = at_time(time);
    for (std::size_t i = 0; i < moments.size(); ++i)
      at(on_d, static_cast<Index>(i)) += moments[i].cross(at(d, static_cast<Index>(i)));
  }
  bool symmetric() const override { return false; }
  const std::vector<Vec3>* moments() const override { return &at_trial_time_; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
    const auto d = trial.configuration.d();
    for (std::size_t i = 0; i < at_trial_time_.size(); ++i)
      at(forces.on_d, static_cast<Index>(i)) -= at_trial_time_[i].cross(at(d, static_cast<Index>(i)));
    return {};
  }

  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    const auto d = trial.configuration.d(), b1 = trial.configuration.b1();
    for (std::size_t i = 0; i < at_trial_time_.size(); ++i) {
      const auto n = static_cast<Index>(i);
      const Vec3& M = at_trial_time_[i];
      const Vec3 dd = at(d, n), first = at(b1, n), second = dd.cross(first);
      Eigen::Matrix2d k = M.cross(dd).dot(dd) * Eigen::Matrix2d::Identity();  // second variation of d
      k(0, 0) -= M.cross(first).dot(first);
      k(0, 1) -= M.cross(second).dot(first);
      k(1, 0) -= M.cross(first).dot(second);
      k(1, 1) -= M.cross(second).dot(second);
      sink.on_director(n, k);
    }
  }

 private:
  std::vector<Vec3> at_time(double time) const {
    std::vector<Vec3> all(at_trial_time_.size(), Vec3::Zero());
    for (const auto& m : loads_) {
      const Vec3 total = m.at(time);
      for (std::size_t i = 0; i < m.nodes.size(); ++i) all[m.nodes[i]] += m.weight[i] * total;
    }
    return all;
  }
  std::vector<DistributedLoad> loads_;
  std::vector<Vec3> at_trial_time_;  // N m per node
};

// --- springs

// Linear springs to ground.
class Springs final : public Term {
 public:
  explicit Springs(const model::Model& model) {
    for (const auto& s : model.all<model::GroundSpring>()) {
      const auto& nodes = model.mesh().set(s.set);
      const Tributary t = tributary(model.mesh(), nodes);
      const Vec3 k(s.stiffness[0], s.stiffness[1], s.stiffness[2]);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        springs_.push_back(
            {nodes[i], t.measure[i] / t.total * s.frame.transpose() * k.asDiagonal() * s.frame});
    }
  }
  const char* name() const override { return "springs"; }
  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
    const auto x = trial.configuration.x();
    for (const auto& s : springs_) at(forces.on_x, s.node) += s.stiffness * (at(x, s.node) - trial.X[s.node]);
    return {};
  }
  void add_tangent(const Trial&, TangentSink& sink) const override {
    for (const auto& s : springs_) sink.on_positions(s.node, s.node, s.stiffness);
  }
  void add_energies(const Trial& trial, std::vector<Energy>& out) const override {
    const auto x = trial.configuration.x();
    double sum = 0;
    for (const auto& s : springs_) {
      const Vec3 u = at(x, s.node) - trial.X[s.node];
      sum += u.dot(s.stiffness * u) / 2;
    }
    out.push_back({"springs", Account::stored, sum});
  }

 private:
  struct Grounded {
    Index node;
    Mat3 stiffness;
  };
  std::vector<Grounded> springs_;
};

}  // namespace

#define X(name) std::unique_ptr<Term> name##_term(const LoadSite&);
FABRICSH_LOADS(X)
#undef X

std::vector<std::unique_ptr<Term>> loads_of(const LoadSite& site) {
  const model::Model& model = site.model;
  std::vector<std::unique_ptr<Term>> all;
  if (std::any_of(model.gravity().begin(), model.gravity().end(), [](const auto& g) { return bool(g); }))
    all.push_back(std::make_unique<Gravity>(model, site.cloth.mass(), site.cloth.mass_moment()));
  if (!model.all<model::ForceLoad>().empty() || !model.all<model::TractionLoad>().empty())
    all.push_back(std::make_unique<DeadLoads>(model));
  if (!model.all<model::PressureLoad>().empty())
    all.push_back(std::make_unique<Pressure>(model, site.cloth.rest(), site.freedoms));
  if (!model.all<model::MomentLoad>().empty()) all.push_back(std::make_unique<Moments>(model));
  if (!model.all<model::GroundSpring>().empty()) all.push_back(std::make_unique<Springs>(model));
    // Those in files of their own.
#define X(name) \
  if (auto load = name##_term(site)) all.push_back(std::move(load));
  FABRICSH_LOADS(X)
#undef X
  return all;
}

}  // namespace fabricsh::mechanics
