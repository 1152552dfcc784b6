#include "mechanics/terms/bands.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/node_view.hpp"
#include "model/rest_mesh.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kTaut = 1e-9;  // a strain above minus this is one of a taut band, for tangents

}  // namespace

EdgeBands::EdgeBands(const model::Model& model) : bands_(model.all<model::EdgeBand>()) {
  const mesh::Mesh rest = model::rest_mesh(model);
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    const model::EdgeChain chain = model::chain_of(rest, bands_[i].set);
    const std::size_t count = chain.nodes.size();
    for (std::size_t k = 0; k + (chain.ring ? 0 : 1) < count; ++k) {
      const bool last = k + 1 == count;
      const double end = last ? chain.length : chain.along[k + 1];
      pieces_.push_back({chain.nodes[k], chain.nodes[last ? 0 : k + 1], end - chain.along[k], i});
    }
  }
  pulling_.assign(pieces_.size(), 0);
  now_ = pulling_;
}

double EdgeBands::rest(const BandPiece& piece, double time) const {
  const model::EdgeBand& band = bands_[piece.band];
  const double s = band.over ? std::clamp(time / *band.over, 0.0, 1.0) : 1;
  return piece.length * (1 - band.ease * s * s * s * (10 - 15 * s + 6 * s * s));
}

double EdgeBands::strain(const BandPiece& piece, const Trial& trial) const {
  const auto x = trial.configuration.x();
  return (at(x, piece.b) - at(x, piece.a)).norm() / rest(piece, trial.time) - 1;
}

// Of S L e^2 / 2 with e = l/L - 1: S (1 - (l/L)^2) / 2.
double EdgeBands::pull_on_rest(const BandPiece& piece, double strain) const {
  return strain > 0 ? bands_[piece.band].stiffness * (1 - (1 + strain) * (1 + strain)) / 2 : 0;
}

Outcome EdgeBands::add_forces(const law::Step&, const Trial& trial, Forces& forces) {
  const auto x = trial.configuration.x();
  work_ = {};
  aimed_ = trial.time;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const BandPiece& piece = pieces_[i];
    const double e = strain(piece, trial);
    now_[i] = pull_on_rest(piece, e);
    const double way = rest(piece, trial.time) - rest(piece, time_);
    work_ += {(now_[i] + pulling_[i]) / 2 * way, std::abs((now_[i] - pulling_[i]) / 2 * way)};
    if (!(e > 0)) continue;
    const Vec3 force = bands_[piece.band].stiffness * e * (at(x, piece.b) - at(x, piece.a)).normalized();
    at(forces.on_x, piece.a) -= force;
    at(forces.on_x, piece.b) += force;
  }
  return {};
}

// In explicit motion, where it bounds the step, also of slack bands.
void EdgeBands::add_tangent(const Trial& trial, TangentSink& sink) const {
  const bool bounds = trial.motion != nullptr && trial.motion->moves() && trial.motion->damping_weight() == 0;
  const auto x = trial.configuration.x();
  for (const BandPiece& piece : pieces_) {
    const double e = strain(piece, trial), stiffness = bands_[piece.band].stiffness;
    if (!(e > -kTaut) && !bounds) continue;
    const Vec3 way = at(x, piece.b) - at(x, piece.a), n = way.normalized();
    const Mat3 along = n * n.transpose();
    const Mat3 k = stiffness / rest(piece, trial.time) * along +
                   stiffness * std::max(0.0, e) / way.norm() * (Mat3::Identity() - along);
    sink.on_positions(piece.a, piece.a, k);
    sink.on_positions(piece.b, piece.b, k);
    sink.on_positions(piece.a, piece.b, -k);
    sink.on_positions(piece.b, piece.a, -k);
  }
}

void EdgeBands::add_energies(const Trial& trial, std::vector<Energy>& out) const {
  double stored = 0;
  for (const BandPiece& piece : pieces_) {
    const double e = std::max(0.0, strain(piece, trial));
    stored += bands_[piece.band].stiffness * rest(piece, trial.time) * e * e / 2;
  }
  out.push_back({"bands", Account::stored, stored});
}

void EdgeBands::commit() {
  pulling_ = now_;
  time_ = aimed_;
}

}  // namespace fabricsh::mechanics
