// Closed paths of whole elements: what is put into them is what they store and dissipate, and never less than
// nothing.
#include "catch.hpp"
#include "one_batch.hpp"
#include "test_cards.hpp"

using namespace fabricsh;

namespace {

// N and N m: forces on the corners, and on the directors across them.
template <class Batch>
struct Loads {
  std::array<std::array<Vec3, Batch::corners>, lanes> x, d;
  explicit Loads(Batch& batch) {
    const Eigen::MatrixXd f = batch.force();
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < Batch::corners; ++a) {
        x[l][a] = f.col(l).template segment<3>(5 * a);
        const Vec3 b = batch.b1[l][a];
        d[l][a] = f(5 * a + 3, l) * b + f(5 * a + 4, l) * batch.d[l][a].cross(b);
      }
  }
};

// Goes through two random places and back, and again, with all eight elements; each has its own path.
template <class Element>
void go_round(const card::Card& card, unsigned seed, double& least, double& largest_gap) {
  using Batch = test::RandomBatch<Element>;
  constexpr int steps = 240;
  Batch batch(card, 3);
  batch.random.seed(seed);
  std::vector<Batch> places(3, batch);
  for (int p = 1; p < 3; ++p)
    for (int l = 0; l < lanes; ++l)
      for (int a = 0; a < Batch::corners; ++a) {
        places[p].x[l][a] += 0.01 * 0.12 * batch.vector();
        places[p].d[l][a] = (batch.d[l][a] + 0.3 * batch.vector()).normalized();
      }
  std::array<double, lanes> work{}, moved{};
  Loads<Batch> before(batch);
  for (int leg = 0; leg < 6; ++leg)
    for (int i = 1; i <= steps; ++i) {
      const Batch &from = places[leg % 3], &to = places[(leg + 1) % 3];
      const double share = static_cast<double>(i) / steps;
      const auto x = batch.x, d = batch.d;
      for (int l = 0; l < lanes; ++l)
        for (int a = 0; a < Batch::corners; ++a) {
          batch.x[l][a] = from.x[l][a] + share * (to.x[l][a] - from.x[l][a]);
          batch.d[l][a] = (from.d[l][a] + share * (to.d[l][a] - from.d[l][a])).normalized();
        }
      batch.basis();
      const Loads<Batch> now(batch);
      for (int l = 0; l < lanes; ++l)
        for (int a = 0; a < Batch::corners; ++a) {
          const double dW = (before.x[l][a] + now.x[l][a]).dot(batch.x[l][a] - x[l][a]) / 2 +
                            (before.d[l][a] + now.d[l][a]).dot(batch.d[l][a] - d[l][a]) / 2;
          work[l] += dW;
          moved[l] += std::abs(dW);
        }
      before = now;
      batch.s0 = batch.s1;
    }
  for (int l = 0; l < lanes; ++l) {
    least = std::min(least, work[l] / moved[l]);
    largest_gap = std::max(largest_gap, std::abs(batch.energy(l) - work[l]) / moved[l]);
  }
}

template <class Element>
void check_paths() {
  for (const auto& card : {test::blend(), test::muslin()}) {
    double least = 1, gap = 0;
    for (unsigned seed = 1; seed <= 38; ++seed) go_round<Element>(card, seed, least, gap);  // 304 paths
    INFO(card.name << ": least work " << least << ", work less energy " << gap);
    CHECK(least > 0);
    CHECK(gap < 2e-3);  // the trapezoidal rule over the kinks of the law
  }
}

}  // namespace

TEST_CASE("300 random closed paths make no energy: quadrilaterals whose yarns are eased") {
  check_paths<test::Quadrilateral>();
}

TEST_CASE("300 random closed paths make no energy: triangles") { check_paths<test::Triangle>(); }
