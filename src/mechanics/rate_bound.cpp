// The bound of the frequencies of a whole model. The stiffness of each element is bounded by its share of the
// masses times its highest frequency squared, that of terms beside the cloth by a diagonal matrix, the sums
// of its blocks' norms over the roots of the nodes' masses. All of these are diagonal, so that no frequency
// is above the highest of a node: the mean of its elements and what the terms add. Held and tied degrees of
// freedom only lower the frequencies.
#include "mechanics/rate_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/shares.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

namespace {

// The largest stretch by a matrix.
template <class Matrix>
double norm(const Matrix& k) {
  Eigen::SelfAdjointEigenSolver<Matrix> of;
  of.computeDirect(k.transpose() * k, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, of.eigenvalues().maxCoeff()));
}

class RateSink final : public TangentSink {
 public:
  RateSink(const Freedoms& freedoms, const std::vector<double>& mass, const std::vector<double>& rotary)
      : freedoms_(freedoms), mass_(mass), rotary_(rotary), on_x_(mass.size(), 0), on_d_(mass.size(), 0) {}
  void on_positions(Index a, Index b, const Mat3& k) override {
    if (!moves(a, 0, 3) || !moves(b, 0, 3)) return;
    const double half = norm(k) / std::sqrt(mass_[a] * mass_[b]) / 2;
    on_x_[a] += half;
    on_x_[b] += half;
  }
  void on_director(Index a, const Eigen::Matrix2d& k) override {
    if (moves(a, 3, 5)) on_d_[a] += norm(k) / rotary_[a];
  }
  void on_nodes(Index a, Index b, const Eigen::Matrix<double, 5, 5>& k) override {
    if (k.isZero() || !moves(a, 0, 5) || !moves(b, 0, 5)) return;
    const Eigen::Matrix<double, 5, 5> scaled = scale(a).asDiagonal() * k * scale(b).asDiagonal();
    const double half = scaled.norm() / 2;  // Frobenius, an upper bound
    for (const Index n : {a, b}) {
      on_x_[n] += half;
      on_d_[n] += half;
    }
  }
  void on_lead(Index, const Vec3&) override {}
  // Empty if all are zero.
  std::vector<double> rates() const {
    std::vector<double> all(mass_.size());
    std::transform(on_x_.begin(), on_x_.end(), on_d_.begin(), all.begin(),
                   [](double x, double d) { return std::max(x, d); });
    const bool any = std::any_of(all.begin(), all.end(), [](double r) { return r > 0; });
    return any ? all : std::vector<double>();
  }

 private:
  bool moves(Index node, int from, int to) const {
    const auto& equation = freedoms_.nodes[node].equation;
    return mass_[node] > 0 && std::any_of(equation.begin() + from, equation.begin() + to,
                                          [](Index e) { return e >= 0 || e == tied; });
  }
  Eigen::Matrix<double, 5, 1> scale(Index node) const {
    const double x = 1 / std::sqrt(mass_[node]), d = 1 / std::sqrt(rotary_[node]);
    return {x, x, x, d, d};
  }
  const Freedoms& freedoms_;
  const std::vector<double>&mass_, &rotary_;
  std::vector<double> on_x_, on_d_;
};

// Of U C U^T by the sums of the rows of its absolute values, over the roots of the masses.
void add_ranks(const FewRankTerm& term, const Assembly& assembly, RateSink& sink) {
  NodalRanks ranks;
  term.add_ranks(assembly.trial(), ranks);
  const auto& mass = assembly.cloth().mass();
  const auto size = [&](std::size_t i, Index n) { return at(ranks.on_x[i], n).norm() / std::sqrt(mass[n]); };
  std::vector<double> whole;
  for (std::size_t i = 0; i < ranks.on_x.size(); ++i) {
    whole.push_back(ranks.beside.empty() ? 0 : ranks.beside[i]);
    for (std::size_t n = 0; n < mass.size(); ++n)
      if (mass[n] > 0) whole.back() += size(i, static_cast<Index>(n));
  }
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (std::size_t j = 0; j < whole.size(); ++j) {
      const double c = std::abs(ranks.core(static_cast<Index>(i), static_cast<Index>(j))) * whole[j];
      for (Index n = 0; c > 0 && n < static_cast<Index>(mass.size()); ++n)
        if (mass[n] > 0) sink.on_positions(n, n, c * size(i, n) * mass[n] * Mat3::Identity());
    }
}

}  // namespace

std::vector<double> added_rates(const Assembly& assembly, bool scaled) {
  RateSink sink(assembly.dofs().freedoms(), assembly.cloth().mass(), assembly.cloth().rotary_inertia(scaled));
  for (const auto& term : assembly.terms())
    if (dynamic_cast<const Contacts*>(term.get()) == nullptr) term->add_tangent(assembly.trial(), sink);
  for (const auto* const term : assembly.terms().all<FewRankTerm>()) add_ranks(*term, assembly, sink);
  return sink.rates();
}

namespace {

// 1/s^2: those of the elements, stretched as they are.
std::vector<double> rates_of(const Cloth& cloth, bool scaled, At at) {
  std::vector<double> rates = cloth.rates().highest(scaled);
  if (at == At::trial)
    for_each_index(rates.size(), rates.size() >= 4096,
                   [&](std::size_t e) { rates[e] *= cloth.readings().growth(static_cast<Index>(e)); });
  return rates;
}

// The node whose bound is the highest.
struct FastestNode {
  double rate = 0, added = 0;
  std::size_t node = 0;
};
FastestNode fastest_node(const std::vector<double>& means, std::span<const double> added) {
  FastestNode most;
  for (std::size_t n = 0; n < means.size(); ++n) {
    const double more = added.empty() ? 0 : added[n];
    if (means[n] + more > most.rate) most = {means[n] + more, more, n};
  }
  return most;
}

}  // namespace

double rate_bound(const Assembly& assembly, bool scaled, std::span<const double> added) {
  const Cloth& cloth = assembly.cloth();
  return fastest_node(cloth.rates().rates_at_nodes(rates_of(cloth, scaled, At::trial), scaled), added).rate;
}

FastestElement fastest_element(const Assembly& assembly, bool scaled, std::span<const double> added, At at) {
  const Cloth& cloth = assembly.cloth();
  const std::vector<double> rates = rates_of(cloth, scaled, at);
  const FastestNode node = fastest_node(cloth.rates().rates_at_nodes(rates, scaled), added);
  FastestElement most{node.rate, node.added};
  double highest = 0;
  for (std::size_t e = 0; e < rates.size(); ++e)
    for (const Index n : cloth.model().mesh().elements[e])
      if (n == static_cast<Index>(node.node) && rates[e] > highest) {
        highest = rates[e];
        most.element = static_cast<Index>(e);
      }
  return most;
}

}  // namespace fabricsh::mechanics
