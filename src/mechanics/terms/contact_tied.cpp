// Cloth that goes along with a rigid body. The body moves freely or as it is driven, and the nodes tied to it
// are held to their places on it by springs; they turn freely there.
#include "geometry/turning.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

void Contacts::find_tied() {
  for (const Bodies::TiedNode& tied : bodies_.tied())
    tied_.push_back({static_cast<std::size_t>(tied.node), nodes_ + tied.point,
                     cloth_.mass()[static_cast<std::size_t>(tied.node)] / (step_ * step_)});
}

// Adds the forces of the springs; returns their energy, J.
double Contacts::push_tied() {
  double energy = 0;
  for (const TiedTo& tied : tied_) {
    const Vec3 apart = x_[tied.point] - x_[tied.node], force = stiff_tie() * tied.carried * apart;
    force_[tied.node] += force;
    force_[tied.point] -= force;
    energy += force.dot(apart) / 2;
  }
  return energy;
}

void Contacts::add_tied_blocks() {
  for (const TiedTo& tied : tied_) {
    const double stiffness = stiff_tie() * tied.carried;
    Block block{{static_cast<std::int32_t>(tied.node), static_cast<std::int32_t>(tied.point), -1, -1},
                contact::Matrix12::Zero()};
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        block.k.block<3, 3>(3 * a, 3 * b) = (a == b ? stiffness : -stiffness) * Mat3::Identity();
    blocks_.push_back(block);
    const std::size_t vertex = tied.point - nodes_;
    if (bodies_.unknowns() == 0 || bodies_.free_of(vertex) < 0) continue;
    add_on_body(nullptr);
    const Vec3 force = stiffness * (x_[tied.node] - x_[tied.point]);
    on_bodies_.back().rubbed.bottomRightCorner<3, 3>() +=
        cross_matrix(force) * cross_matrix(bodies_.lever(vertex));
  }
}

}  // namespace fabricsh::mechanics
