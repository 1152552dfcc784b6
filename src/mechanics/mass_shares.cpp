#include "mechanics/mass_shares.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mechanics/mesh_tools.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr int kTurns = 32;
constexpr int kLook = 8;          // turns after which to go on must be worth it
constexpr double kFalls = 0.997;  // of the bound that many turns ago
constexpr double kGoal = 0.95;    // of the lowest bound so far: elements above it ask for all they can
constexpr double kSmall = 2e-3;   // an element that asks for less, or a share that changed by less, waits
constexpr double kWorth = 0.99;   // of the bound with equal shares: others that gain less are not worth it

// How strongly an element asks for more: the 32nd power, which is the same on all processors.
double strength(double ratio) {
  double power = std::min(ratio, 1.0);
  for (int i = 0; i < 5; ++i) power *= power;
  return power;
}

class Sharing {
 public:
  Sharing(const mesh::Mesh& mesh, const std::vector<CornerMasses>& equal, const std::vector<double>& rates,
          const std::function<PlaneMatrix(mesh::Index)>& stiffness)
      : mesh_(mesh),
        equal_(equal),
        shares_(equal_),
        solved_(equal_),
        part_(equal_.size(), CornerMasses{}),
        rates_(rates),
        asks_(equal_.size(), 0),
        times_(equal_.size(), 1),
        known_(equal_.size(), 0),
        stiffness_(stiffness),
        mass_(summed([this](std::size_t e, std::size_t c) { return shares_[e][c]; })) {}

  SharedMasses result() {
    const double first = highest();
    double lowest = first, before = first;
    for (int turn = 0; turn < kTurns; ++turn) {
      if (turn > 0 && turn % kLook == 0 && lowest > kFalls * std::exchange(before, lowest)) break;
      ask(kGoal * lowest);
      give(1 - 0.9 * turn / kTurns);
      solve([this](std::size_t e) { return changed(e, kSmall); });
      lowest = std::min(lowest, highest());
    }
    solve([this](std::size_t e) { return shares_[e] != solved_[e]; });
    const double last = highest();
    return last < kWorth * first ? SharedMasses{shares_, last} : SharedMasses{equal_, first};
  }

 private:
  double highest() const {
    const std::vector<double> means =
        means_at_nodes(mesh_, rates_, [this](std::size_t e, std::size_t c) { return shares_[e][c]; });
    return *std::max_element(means.begin(), means.end());
  }
  template <class Of>
  std::vector<double> summed(Of of) const {
    std::vector<double> sum(mesh_.nodes.size(), 0);
    for (std::size_t e = 0; e < equal_.size(); ++e)
      for (std::size_t c = 0; c < 4; ++c)
        if (const auto n = mesh_.elements[e][c]; n >= 0) sum[static_cast<std::size_t>(n)] += of(e, c);
    return sum;
  }
  bool changed(std::size_t e, double by) const {
    for (std::size_t c = 0; c < 4; ++c)
      if (std::abs(shares_[e][c] - solved_[e][c]) > by * solved_[e][c]) return true;
    return false;
  }
  template <class Which>
  void solve(Which which) {
#pragma omp parallel for schedule(dynamic, 64) if (equal_.size() >= 4096)
    for (std::size_t e = 0; e < equal_.size(); ++e)
      if (which(e)) solve_one(e);
  }
  // The rate, and how much of the fastest motion each corner has.
  void solve_one(std::size_t e) {
    const auto index = static_cast<mesh::Index>(e);
    const int n = corners(mesh_.elements[e]);
    Eigen::Matrix<double, 8, 1> scale = Eigen::Matrix<double, 8, 1>::Zero();
    for (int i = 0; i < 2 * n; ++i)
      scale[i] = std::sqrt(equal_[e][0] / shares_[e][static_cast<std::size_t>(i / 2)]);
    const PlaneMatrix K = stiffness_(index);
    if (known_[e] == 0) times_[e] = rates_[e] / largest_eigenvalue(K);
    const Eigen::SelfAdjointEigenSolver<PlaneMatrix> of(
        PlaneMatrix(times_[e] * (scale.asDiagonal() * K * scale.asDiagonal())));
    rates_[e] = of.eigenvalues()[7];
    for (int c = 0; c < n; ++c)
      part_[e][static_cast<std::size_t>(c)] = of.eigenvectors().col(7).segment<2>(2 * c).squaredNorm();
    solved_[e] = shares_[e];
    known_[e] = 1;
  }
  void ask(double reference) {
    for (std::size_t e = 0; e < equal_.size(); ++e)
      if ((asks_[e] = strength(rates_[e] / reference)) < kSmall) asks_[e] = 0;
    solve([this](std::size_t e) { return asks_[e] > 0 && known_[e] == 0; });
  }
  // Shares grow where an element asks for more than its neighbours do, as a whole the mass of the node.
  void give(double pace) {
    const std::vector<double> asked =
        summed([this](std::size_t e, std::size_t c) { return asks_[e] * part_[e][c]; });
    for (std::size_t e = 0; e < equal_.size(); ++e)
      for (std::size_t c = 0; c < 4; ++c) {
        const auto n = mesh_.elements[e][c];
        if (n < 0 || !(asked[static_cast<std::size_t>(n)] > 0)) continue;
        double& share = shares_[e][c];
        const double more = pace * (asks_[e] * part_[e][c] - share / mass_[static_cast<std::size_t>(n)] *
                                                                 asked[static_cast<std::size_t>(n)]);
        share *= more > 0 ? 1 + more : 1 / (1 - more);
      }
    const std::vector<double> sum = summed([this](std::size_t e, std::size_t c) { return shares_[e][c]; });
    for (std::size_t e = 0; e < equal_.size(); ++e)
      for (std::size_t c = 0; c < 4; ++c) {
        const auto n = mesh_.elements[e][c];
        if (n >= 0 && asked[static_cast<std::size_t>(n)] > 0)
          shares_[e][c] *= mass_[static_cast<std::size_t>(n)] / sum[static_cast<std::size_t>(n)];
      }
  }

  const mesh::Mesh& mesh_;
  const std::vector<CornerMasses>& equal_;
  std::vector<CornerMasses> shares_, solved_,
      part_;                                  // solved: those of the rates; part: of the fastest motion
  std::vector<double> rates_, asks_, times_;  // times: its stiffness has the rate with equal shares
  std::vector<char> known_;                   // whether part_ is
  const std::function<PlaneMatrix(mesh::Index)>& stiffness_;
  const std::vector<double> mass_;
};

}  // namespace

double largest_eigenvalue(const PlaneMatrix& symmetric) {
  return Eigen::SelfAdjointEigenSolver<PlaneMatrix>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[7];
}

SharedMasses share_masses(const mesh::Mesh& mesh, const std::vector<CornerMasses>& equal,
                          const std::vector<double>& rates,
                          const std::function<PlaneMatrix(mesh::Index)>& stiffness) {
  const std::vector<double> means =
      means_at_nodes(mesh, rates, [&](std::size_t e, std::size_t c) { return equal[e][c]; });
  const auto [least, most] = std::minmax_element(means.begin(), means.end());
  if (*least > kWorth * *most) return {equal, *most};  // squares
  return Sharing(mesh, equal, rates, stiffness).result();
}

}  // namespace fabricsh::mechanics
