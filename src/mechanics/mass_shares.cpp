#include "mechanics/mass_shares.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
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

constexpr double kOfUsual = 0.95;      // of the step of usual nodes: what mass is moved for
constexpr double kWorthMoving = 0.85;  // of the bound: mass that gains less stays
constexpr double kLess = 0.05;         // of the bound: what the next attempt wants less
constexpr double kMostTimes = 3;       // its own mass at most has a node then
constexpr double kMostGiven = 0.1;     // of its mass a node gives at most
constexpr double kMostMoved = 5e-3;    // of the mass of the cloth is moved at most
constexpr int kRings = 3;              // of neighbours that give
constexpr int kAsked = 4;              // times that each ring is asked

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
        given_(rates),
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
    return last < kWorth * first ? SharedMasses{shares_, rates_, last} : SharedMasses{equal_, given_, first};
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
  const std::vector<double>& given_;  // rates, with these
  std::vector<CornerMasses> shares_, solved_,
      part_;                                  // solved: those of the rates; part: of the fastest motion
  std::vector<double> rates_, asks_, times_;  // times: its stiffness has the rate with equal shares
  std::vector<char> known_;                   // whether part_ is
  const std::function<PlaneMatrix(mesh::Index)>& stiffness_;
  const std::vector<double> mass_;
};

// Half of the mass is at nodes with a mean of no more.
double usual_of(const std::vector<double>& means, const std::vector<double>& mass) {
  const double whole = std::accumulate(mass.begin(), mass.end(), 0.0);
  std::vector<std::size_t> order(means.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return means[a] > means[b]; });
  double sum = 0;
  for (const std::size_t n : order)
    if ((sum += mass[n]) >= whole / 2) return means[n];
  return means[order.back()];
}

// All that want mass ask at once, and a node divides what it has in proportion, so that what is symmetric
// stays so up to rounding.
class Moving {
 public:
  Moving(const mesh::Mesh& mesh, const std::vector<double>& means, const std::vector<double>& mass)
      : mesh_(mesh),
        means_(means),
        mass_(mass),
        whole_(std::accumulate(mass.begin(), mass.end(), 0.0)),
        first_(mass.size() + 1, 0) {
    for (const auto& e : mesh.elements)
      for (const mesh::Index n : e)
        if (n >= 0) ++first_[static_cast<std::size_t>(n) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    of_.resize(first_.back());
    std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      for (const mesh::Index n : mesh.elements[e])
        if (n >= 0) of_[at[static_cast<std::size_t>(n)]++] = e;
  }
  // So that no mean is above `highest`. Empty: there is not enough, or it is too much.
  std::vector<double> to(double highest) const {
    std::vector<Wish> wishes;
    std::vector<double> spare(mass_.size());  // kg
    double sum = 0;
    for (std::size_t n = 0; n < mass_.size(); ++n) {
      spare[n] = std::max(0.0, mass_[n] * std::min(1 - means_[n] / highest, kMostGiven));
      const double wanted = mass_[n] * (means_[n] / highest - 1);
      if (!(wanted > 0)) continue;
      if ((sum += wanted) > kMostMoved * whole_) return {};
      wishes.push_back({n, wanted, {n}, {n}});
    }
    const std::vector<double> had = spare;
    for (int r = 0; r < kRings; ++r) {
      for (Wish& wish : wishes) wish.ring = next(wish.ring, wish.seen);
      for (int turn = 0; turn < kAsked; ++turn) take(wishes, spare);
    }
    for (const Wish& wish : wishes)
      if (wish.wanted > kRounding * mass_[wish.node]) return {};
    std::vector<double> times(mass_.size(), 1);
    for (std::size_t n = 0; n < times.size(); ++n)
      if (spare[n] != had[n]) times[n] -= (had[n] - spare[n]) / mass_[n];
    for (const Wish& wish : wishes)
      times[wish.node] = means_[wish.node] / highest - wish.wanted / mass_[wish.node];
    return times;
  }

 private:
  static constexpr double kRounding = 1e-9;
  struct Wish {
    std::size_t node;
    double wanted;                        // kg, still
    std::vector<std::size_t> ring, seen;  // the nodes that are asked, and all so far
  };
  void take(std::vector<Wish>& wishes, std::vector<double>& spare) const {
    std::vector<double> asked(mass_.size(), 0), part(wishes.size(), 0);
    for (std::size_t w = 0; w < wishes.size(); ++w) {
      double all = 0;
      for (const std::size_t b : wishes[w].ring) all += spare[b];
      if (!(wishes[w].wanted > 0) || !(all > 0)) continue;
      part[w] = std::min(1.0, wishes[w].wanted / all);
      for (const std::size_t b : wishes[w].ring) asked[b] += part[w] * spare[b];
    }
    std::vector<double> left = spare;
    for (std::size_t w = 0; w < wishes.size(); ++w)
      for (const std::size_t b : wishes[w].ring) {
        if (part[w] == 0 || spare[b] == 0) continue;
        const double given = part[w] * spare[b] * std::min(1.0, spare[b] / asked[b]);
        wishes[w].wanted -= given;
        left[b] = std::max(0.0, left[b] - given);
      }
    spare = std::move(left);
  }
  std::vector<std::size_t> next(const std::vector<std::size_t>& ring, std::vector<std::size_t>& seen) const {
    std::vector<std::size_t> out;
    for (const std::size_t a : ring)
      for (std::size_t i = first_[a]; i < first_[a + 1]; ++i)
        for (const mesh::Index n : mesh_.elements[of_[i]])
          if (const auto b = static_cast<std::size_t>(n);
              n >= 0 && std::find(seen.begin(), seen.end(), b) == seen.end()) {
            seen.push_back(b);
            out.push_back(b);
          }
    return out;
  }

  const mesh::Mesh& mesh_;
  const std::vector<double>&means_, &mass_;
  const double whole_;
  std::vector<std::size_t> first_, of_;  // the elements of each node
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
  if (*least > kWorth * *most) return {equal, rates, *most};  // squares
  return Sharing(mesh, equal, rates, stiffness).result();
}

MovedMass move_mass(const mesh::Mesh& mesh, const std::vector<double>& means,
                    const std::vector<double>& mass) {
  const double most = *std::max_element(means.begin(), means.end()), usual = usual_of(means, mass);
  const double goal = std::max(usual / (kOfUsual * kOfUsual), most / kMostTimes);
  if (!(goal < kWorthMoving * most)) return {{}, most};
  const Moving moving(mesh, means, mass);
  for (double highest = goal; highest < kWorthMoving * most; highest *= 1 + kLess)
    if (std::vector<double> times = moving.to(highest); !times.empty()) return {std::move(times), highest};
  return {{}, most};
}

}  // namespace fabricsh::mechanics
