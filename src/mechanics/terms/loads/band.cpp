#include <algorithm>
#include <cmath>

#include "geometry/node_view.hpp"
#include "mechanics/terms/loads.hpp"
#include "model/rest_mesh.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kTaut = 1e-9;  // a strain above minus this is one of a taut band, for tangents

// Bands along edges (model/declarations.hpp): between neighbouring nodes of an edge a spring that pulls and
// never pushes, whose length without force is that of the edge, less the ease.
class EdgeBands final : public Term {
 public:
  explicit EdgeBands(const model::Model& model) : bands_(model.all<model::EdgeBand>()) {
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

  const char* name() const override { return "bands"; }

  Outcome add_forces(const law::Step&, const Trial& trial, Forces& forces) override {
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
  void add_tangent(const Trial& trial, TangentSink& sink) const override {
    const bool bounds =
        trial.motion != nullptr && trial.motion->moves() && trial.motion->damping_weight() == 0;
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

  void add_energies(const Trial& trial, std::vector<Energy>& out) const override {
    double stored = 0;
    for (const BandPiece& piece : pieces_) {
      const double e = std::max(0.0, strain(piece, trial));
      stored += bands_[piece.band].stiffness * rest(piece, trial.time) * e * e / 2;
    }
    out.push_back({"bands", Account::stored, stored});
  }
  StepWork step_work() const override { return work_; }
  void commit() override {
    pulling_ = now_;
    time_ = aimed_;
  }
  void keep(Archive& archive) override { archive(time_, pulling_); }

 private:
  struct BandPiece {
    Index a, b;
    double length;  // m, of the edge
    std::size_t band;
  };
  // m, without force at that time.
  double rest(const BandPiece& piece, double time) const {
    const model::EdgeBand& band = bands_[piece.band];
    const double s = band.over ? std::clamp(time / *band.over, 0.0, 1.0) : 1;
    return piece.length * (1 - band.ease * s * s * s * (10 - 15 * s + 6 * s * s));
  }
  double strain(const BandPiece& piece, const Trial& trial) const {
    const auto x = trial.configuration.x();
    return (at(x, piece.b) - at(x, piece.a)).norm() / rest(piece, trial.time) - 1;
  }
  // N, d(energy) / d(rest length)
  // Of S L e^2 / 2 with e = l/L - 1: S (1 - (l/L)^2) / 2.
  double pull_on_rest(const BandPiece& piece, double strain) const {
    return strain > 0 ? bands_[piece.band].stiffness * (1 - (1 + strain) * (1 + strain)) / 2 : 0;
  }

  const std::vector<model::EdgeBand> bands_;
  std::vector<BandPiece> pieces_;
  std::vector<double> pulling_, now_;  // N: the last of these at the committed and the trial state
  double time_ = 0, aimed_ = 0;        // s: committed, of the trial state
  StepWork work_;                      // of shortening the bands in the step
};

}  // namespace

std::unique_ptr<Term> band_term(const LoadSite& site) {
  if (site.model.all<model::EdgeBand>().empty()) return {};
  return std::make_unique<EdgeBands>(site.model);
}

}  // namespace fabricsh::mechanics
