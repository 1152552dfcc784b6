// Explicit steps through the barriers of contact with bodies whose motion is given, and between cloths.
//
// Central differences are stable where dt^2 K <= 4 M. The barrier's stiffness S, which rises without bound,
// is met by inertia along its normal: M + dt^2 S / 2 takes the place of M in M a = r, with the S of the same
// positions as r. That is a linearly implicit step of the barrier alone. Where r is zero, nothing changes:
// what is pressed between tools has the balance that it has in short steps. The rest of r, which the inertia
// holds back, does a work that comes back as the nodes leave the barrier; the account of the barrier has it.
//
// Of a body the inertia meets the acceleration a - a_b relative to it, and the body takes what is held back
// of each node: their work is that on the way relative to it. So what goes along with a tool has no part in
// it, whether the tool sets out or stops. Two cloths give it to each other: the pair's inertia S b b^T, where
// b has the weights of its corners along the normal, meets only how its sides part. The forces that it holds
// back are -lambda b of each pair, so that they have neither a sum nor a moment, whatever lambda is.
//
// A node that follows others, as on the edges of a seam that has closed, passes its part on to them, as it
// does with its forces and its mass.
#include <unordered_map>
#include <utility>

#include "mechanics/terms/contact_schemes.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kEased = 0.5;     // dt^2 S over the inertia that meets it
constexpr double kSolved = 1e-10;  // of the right-hand side, left by conjugate gradients
constexpr int kMostIterations = 300;

// A node that guards press: the inertia that bodies add, and the force that is left of the residual.
struct MetNode {
  Index node = 0;
  Mat3 inertia = Mat3::Zero();    // kg, global axes
  Vec3 carried = Vec3::Zero();    // N, that times the bodies' accelerations
  Vec3 force = Vec3::Zero();      // N, global axes
  Mat3 lightness = Mat3::Zero();  // 1/kg, of what may move
};

// The same in the node's frame, where what is held or driven has neither force nor added inertia.
struct InFrame {
  InFrame(const NodeFreedoms& freedoms, const Mat3& inertia, double of_node, std::span<const double> masses,
          std::span<const double> residual)
      : mass(Vec3::Constant(of_node)) {
    Mat3 added = freedoms.frame * inertia * freedoms.frame.transpose();
    for (int c = 0; c < 3; ++c) {
      if (const Index e = freedoms.equation[static_cast<std::size_t>(c)]; e >= 0) {
        force[c] = residual[static_cast<std::size_t>(e)];
        mass[c] = masses[static_cast<std::size_t>(e)];  // also that of followers
        continue;
      }
      free[c] = 0;
      added.row(c).setZero();
      added.col(c).setZero();
    }
    added.diagonal() += mass;
    whole = added;
  }
  Vec3 mass;                      // kg
  Mat3 whole;                     // kg
  Vec3 force = Vec3::Zero();      // N
  Vec3 free = Vec3::Constant(1);  // 0: held or driven
};

// A pressed node's part in how the two sides of a pair part: its motion along the normal by its weight.
struct Part {
  std::size_t place;
  Vec3 along;
};

// Two sides that part by the sum of their nodes' parts.
struct Parting {
  std::size_t first, end;  // of the parts
  double softness;         // 1/kg: the inverse of the inertia that meets it
};

// The forces lambda of all pairs, N: softness * lambda = b . L (f - sum of lambda b), with the lightness L of
// the nodes and the forces f on them. The system is symmetric and positive definite: conjugate gradients with
// its diagonal, always in the same order.
class Partings {
 public:
  Partings(std::span<const MetNode> nodes, std::span<const Parting> pairs, std::span<const Part> parts)
      : nodes_(nodes), pairs_(pairs), parts_(parts), moved_(nodes.size()) {}

  std::vector<double> solve() {
    const std::size_t n = pairs_.size();
    std::vector<double> lambda(n, 0.0), rest(n), scaled(n), along, image(n);
    for (std::size_t i = 0; i < nodes_.size(); ++i) moved_[i] = nodes_[i].lightness * nodes_[i].force;
    for (std::size_t p = 0; p < n; ++p) rest[p] = parted(pairs_[p]);
    const std::vector<double> inverse = diagonal();
    const auto product = [n](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0;
      for (std::size_t p = 0; p < n; ++p) sum += a[p] * b[p];
      return sum;
    };
    const auto scale = [&] {
      for (std::size_t p = 0; p < n; ++p) scaled[p] = inverse[p] * rest[p];
    };
    scale();
    along = scaled;
    double left = product(rest, scaled);
    const double enough = kSolved * kSolved * left;
    for (int i = 0; i < kMostIterations && left > enough; ++i) {
      apply(along, image);
      const double share = left / product(along, image);
      for (std::size_t p = 0; p < n; ++p) {
        lambda[p] += share * along[p];
        rest[p] -= share * image[p];
      }
      scale();
      const double next = product(rest, scaled);
      for (std::size_t p = 0; p < n; ++p) along[p] = scaled[p] + next / left * along[p];
      left = next;
    }
    return lambda;
  }

  std::span<const Part> parts_of(const Parting& pair) const {
    return parts_.subspan(pair.first, pair.end - pair.first);
  }

 private:
  double parted(const Parting& pair) const {
    double sum = 0;
    for (const Part& part : parts_of(pair)) sum += part.along.dot(moved_[part.place]);
    return sum;
  }
  std::vector<double> diagonal() const {
    std::vector<double> inverse;
    for (const Parting& pair : pairs_) {
      double sum = pair.softness;
      for (const Part& part : parts_of(pair))
        sum += part.along.dot(nodes_[part.place].lightness * part.along);
      inverse.push_back(1 / sum);
    }
    return inverse;
  }

  void apply(const std::vector<double>& lambda, std::vector<double>& image) {
    std::fill(moved_.begin(), moved_.end(), Vec3::Zero());
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      for (const Part& part : parts_of(pairs_[p])) moved_[part.place] += lambda[p] * part.along;
    for (std::size_t i = 0; i < nodes_.size(); ++i) moved_[i] = nodes_[i].lightness * moved_[i];
    for (std::size_t p = 0; p < pairs_.size(); ++p)
      image[p] = pairs_[p].softness * lambda[p] + parted(pairs_[p]);
  }

  std::span<const MetNode> nodes_;
  std::span<const Parting> pairs_;
  std::span<const Part> parts_;
  std::vector<Vec3> moved_;  // of the nodes
};

}  // namespace

// A body that forces or its mass move would have a share of the inertia, too. The parts of a joint that opens
// would have to share what it held back.
void BarrierInertia::allow() {
  ContactSurfaces& surfaces = state_.surfaces;
  if (dofs_.joints().any()) return;
  for (std::size_t i = 0; i < surfaces.meetings().size(); ++i) {
    const int body = surfaces.body_of(surfaces.scene().interactions()[i].second);
    if (surfaces.meetings()[i].bodies ||
        (body >= 0 && surfaces.bodies().readings().inverse_mass_pressed(static_cast<std::size_t>(body)) > 0))
      continue;
    surfaces.scene().interaction(i).eased = true;
  }
}

Vec3 BarrierInertia::acceleration(const contact::Contact::BodySide& side) {
  const Bodies& bodies = state_.surfaces.bodies();
  const double dt = state_.dt();
  later_.resize(bodies.count());
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    if (side.share[k] == 0) continue;
    const auto point = static_cast<std::size_t>(side.point[k]);
    for (std::size_t b = 0; b < bodies.count(); ++b) {
      const auto [first, last] = bodies.vertices(b);
      const std::size_t vertex = point - state_.surfaces.nodes();
      if (vertex < first || vertex >= last || !bodies.is_driven(b)) continue;
      if (later_[b].empty()) later_[b] = bodies.places(b, state_.time + dt);
      sum += side.share[k] *
             ((later_[b][vertex - first] - state_.x[point]) - (state_.x[point] - state_.start[point]));
    }
  }
  return sum / (dt * dt);
}

void BarrierInertia::hold_back(std::span<const double> masses, std::span<double> residual) {
  held_.clear();
  later_.clear();
  const double dt = state_.dt();
  if (!(state_.trial.guard > 0) || !(dt > 0)) return;
  std::vector<MetNode> met;                       // in the order of the pairs
  std::unordered_map<Index, std::size_t> places;  // in it
  const auto place_of = [&](std::int32_t node) {
    const auto [place, added] = places.try_emplace(node, met.size());
    if (added) met.push_back({node});
    return place->second;
  };
  struct Meeting {
    std::size_t place;
    double inertia, carried;  // kg, m/s^2 along the normal
    Vec3 normal;
    contact::Contact::BodySide body;
  };
  std::vector<Meeting> meetings;
  std::vector<Dofs::AxisLead> leads;
  state_.pairs.barriers(
      [&](std::int32_t node, double stiffness, const Vec3& n, const contact::Contact::BodySide& body) {
        dofs_.leads(node, leads);
        double sum = 0;
        for (const Dofs::AxisLead& lead : leads) sum += lead.weight.cwiseAbs().maxCoeff();
        const Vec3 of_body = acceleration(body);
        for (const Dofs::AxisLead& lead : leads) {
          const double share = lead.weight.cwiseAbs().maxCoeff() / sum;
          const Vec3 along = lead.weight.cwiseProduct(n) / share;
          const std::size_t place = place_of(lead.node);
          const double inertia = kEased * dt * dt * stiffness * share;
          met[place].inertia += inertia * along * along.transpose();
          const double carried = along.dot(of_body);
          met[place].carried += inertia * carried * along;
          meetings.push_back({place, inertia, carried, along, body});
        }
      });
  std::vector<Parting> partings;
  std::vector<Part> parts;
  state_.pairs.barriers_between([&](const std::array<std::int32_t, 4>& points,
                                    const contact::Force::Barrier& barrier) {
    const std::size_t first = parts.size();
    for (std::size_t k = 0; k < 4; ++k) {
      if (barrier.weight[k] == 0) continue;
      dofs_.leads(points[k], leads);
      for (const Dofs::AxisLead& lead : leads)
        parts.push_back({place_of(lead.node), barrier.weight[k] * lead.weight.cwiseProduct(barrier.normal)});
    }
    partings.push_back({first, parts.size(), 1 / (kEased * dt * dt * barrier.stiffness)});
  });
  std::vector<InFrame> in_frame;
  for (MetNode& node : met) {
    const auto& freedoms = dofs_.freedoms().nodes[static_cast<std::size_t>(node.node)];
    InFrame& at = in_frame.emplace_back(freedoms, node.inertia,
                                        cloth_.mass()[static_cast<std::size_t>(node.node)], masses, residual);
    at.force += at.free.asDiagonal() * (freedoms.frame * node.carried);
    if (partings.empty()) continue;
    const Mat3& frame = freedoms.frame;
    node.force = frame.transpose() * at.force;
    node.lightness = frame.transpose() * (at.whole.inverse() * at.free.asDiagonal()) * frame;
  }
  std::vector<Vec3> by_pairs(met.size(), Vec3::Zero());  // N, held back
  Partings pairs(met, partings, parts);
  const std::vector<double> lambda = pairs.solve();
  for (std::size_t p = 0; p < partings.size(); ++p)
    for (const Part& part : pairs.parts_of(partings[p])) by_pairs[part.place] += lambda[p] * part.along;
  std::vector<Vec3> acceleration_of(met.size());  // m/s^2
  for (std::size_t i = 0; i < met.size(); ++i) {
    const InFrame& at = in_frame[i];
    const NodeFreedoms& freedoms = dofs_.freedoms().nodes[static_cast<std::size_t>(met[i].node)];
    const Vec3 left = at.force - at.free.asDiagonal() * (freedoms.frame * by_pairs[i]);
    const Vec3 moving = at.mass.cwiseProduct(at.whole.llt().solve(left));
    for (int c = 0; c < 3; ++c)
      if (const Index e = freedoms.equation[static_cast<std::size_t>(c)]; e >= 0)
        residual[static_cast<std::size_t>(e)] = moving[c];
    acceleration_of[i] = freedoms.frame.transpose() * moving.cwiseQuotient(at.mass);
    if (partings.empty()) continue;
    held_.push_back(
        {met[i].node, freedoms.frame.transpose() * (at.free.asDiagonal() * (freedoms.frame * by_pairs[i]))});
  }
  for (const Meeting& meeting : meetings) {
    const NodeFreedoms& freedoms = dofs_.freedoms().nodes[static_cast<std::size_t>(met[meeting.place].node)];
    const Vec3 along = freedoms.frame.transpose() *
                       (in_frame[meeting.place].free.asDiagonal() * (freedoms.frame * meeting.normal));
    const Vec3 force =
        meeting.inertia * (along.dot(acceleration_of[meeting.place]) - meeting.carried) * along;
    held_.push_back({met[meeting.place].node, force, meeting.body});
    for (std::size_t k = 0; k < 4; ++k)
      if (meeting.body.share[k] != 0)
        state_.surfaces.bodies().add(
            static_cast<std::size_t>(meeting.body.point[k]) - state_.surfaces.nodes(),
            meeting.body.share[k] * force);
  }
}

// J, in the trial step, by the trapezoidal rule as that of the kinetic energy.
double BarrierInertia::work() const {
  double work = 0;
  for (const auto* all : {&held_, &before_})
    for (const HeldBack& held : *all) {
      const auto n = static_cast<std::size_t>(held.node);
      Vec3 way = state_.x[n] - state_.start[n];
      for (std::size_t k = 0; k < 4; ++k)
        if (held.body.share[k] != 0) {
          const auto point = static_cast<std::size_t>(held.body.point[k]);
          way -= held.body.share[k] * (state_.x[point] - state_.start[point]);
        }
      work += held.force.dot(way) / 2;
    }
  return work;
}

void BarrierInertia::commit() {
  energy_ += work();
  std::swap(before_, held_);
  held_.clear();
}

}  // namespace fabricsh::mechanics
