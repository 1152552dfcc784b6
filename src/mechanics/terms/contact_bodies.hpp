// The tangent of contact, and the places of free bodies as unknowns of implicit and static steps.
#pragma once
#include <functional>
#include <vector>

#include "mechanics/facets.hpp"
#include "mechanics/terms/contact_gas.hpp"

namespace fabricsh::mechanics {

// Of a pair that touches: what the motion of the point `by` does to the force on a node, N/m.
struct PairBlock {
  std::int32_t node, by;
  Mat3 k;
  Mat3 apart;  // the part of it that is not symmetric, see contact::FrictionTangent
};

// Six unknowns for each free body, the force on it at the step's end; in static steps its place and turn.
class BodyUnknowns final : public OwnUnknowns {
 public:
  BodyUnknowns(ContactState& state, const GasOnBodies& gas) : state_(state), gas_(gas) {}

  // Newton's iterations move all bodies by shares of the remaining way, driven ones too.
  void begin_iterate() override;
  void move(double scale) override;
  bool at_target() const override { return state_.share >= 1 || !state_.surfaces.moves(); }
  // Free bodies go by a share of a way whose end changes in the same iteration, and turn.
  bool parts_leave_way() const override { return own_unknowns() > 0; }
  void save() override;
  void restore() override;
  std::size_t own_unknowns() const override { return equations().unknowns(); }
  bool own_push(std::size_t j, std::span<double> on_x) const override;
  Eigen::VectorXd own_answer(std::span<const double> move) const override;
  Eigen::MatrixXd own_response() const override;
  Eigen::VectorXd own_residual() const override;
  void direct(std::span<const double> way) override { equations().direct(way); }
  double largest_own_force() const override;  // where bodies meet each other; else 0
  double largest_own_residual() const override { return equations().largest_residual(); }
  Eigen::MatrixXd own_stiffness() const override;
  void add_places(Places which, std::vector<double>& x) const override;

  // By the places (m) and turns (rad) of all free bodies, 6 numbers each: derivatives of the internal forces
  // on the nodes, N; of the forces and torques on the bodies with the other sign; and of the volumes of gas,
  // m3, whose changes of pressure both are without.
  struct AtRest {
    std::vector<std::vector<double>> on_nodes, of_volumes;  // by number
    Eigen::MatrixXd stiffness;
  };
  AtRest at_rest() const;  // of the last tangent
  // The places at rest are unknowns from here on.
  void go_static(double rise);  // s, see Bodies

  // The tangent; of each pair the coupling with the free bodies that it has: one, or two that meet.
  const std::vector<PairBlock>& blocks() const { return blocks_; }
  bool leads() const { return state_.share < 1 && state_.surfaces.moves(); }  // driven bodies have a way left
  void clear();
  void add(const std::array<std::int32_t, 4>& points, const contact::Matrix12& k,
           const contact::FrictionTangent* friction);
  void add_ties();

 private:
  // How a pair's forces and torque change with the place and the turn of a free body. Two bodies that meet
  // have one each of the same pair.
  struct OnBody {
    std::size_t pair;
    std::array<std::int32_t, 4> point;
    int body;                             // of the free ones
    Eigen::Matrix<double, 12, 6> by;      // its corners, by the body's place and turn
    Eigen::Matrix<double, 12, 6> force;   // on its corners, by the body's place and turn, with the other sign
    Eigen::Matrix<double, 6, 12> answer;  // on the body, by its corners
    Eigen::Matrix<double, 6, 6> rubbed;   // on the body, by its own place and turn, through friction alone
  };
  Bodies& bodies() const { return state_.surfaces.bodies(); }
  BodyEquations& equations() const { return bodies().equations(); }
  std::size_t nodes() const { return state_.surfaces.nodes(); }
  // Adds what a pair does to the nodes of the cloth when its body moves.
  void add_to_nodes(const OnBody& part, const BodyEquations::Vector6& moved, double weight,
                    std::span<double> on_x) const;
  Eigen::MatrixXd answers(bool with_volumes) const;
  Eigen::MatrixXd responses() const;  // of free bodies to the changes of their unknowns

  ContactState& state_;
  const GasOnBodies& gas_;
  bool static_ = false;
  double saved_share_ = 0;
  std::size_t pairs_ = 0;
  std::vector<PairBlock> blocks_;
  std::vector<OnBody> on_bodies_;
};

class ContactTangent {
 public:
  ContactTangent(ContactState& state, BodyUnknowns& bodies, const GasOnBodies& gas)
      : state_(state), bodies_(bodies), gas_(gas) {}
  // Computes the stiffness of the touching pairs, and adds the pairs of nodes that are coupled.
  void couple(const contact::Way& way, std::vector<NodePair>& pairs);
  void add(TangentSink& sink) const;
  void commit();
  void rollback();
  void keep(Archive& archive);

 private:
  ContactState& state_;
  BodyUnknowns& bodies_;
  const GasOnBodies& gas_;
  // Pairs of nodes coupled at any time: a * nodes + b, a < b, ascending. They only become more, and a
  // rollback takes back those since the last commit.
  std::vector<std::int64_t> pairs_, committed_pairs_;
  std::vector<char> cloth_;  // by point: whether it is a node
};

}  // namespace fabricsh::mechanics
