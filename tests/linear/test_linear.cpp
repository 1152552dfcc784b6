// The direct solvers on matrices whose solution and inertia are known.
#include <omp.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "catch.hpp"
#include "linear/linear_solver.hpp"
#include "linear/near_symmetric.hpp"

using namespace fabricsh::linear;

namespace {

// Five-point Laplacian on an n x n grid minus `shift` on the diagonal; its eigenvalues are
// 4 - 2 cos(i h) - 2 cos(j h) - shift, h = pi / (n + 1).
Matrix laplacian(Index n, double shift, double skew = 0) {
  std::vector<Index> column = {0}, rows;
  std::vector<double> values;
  const auto add = [&](Index row, double value) {
    rows.push_back(row);
    values.push_back(value);
  };
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index c = j * n + i;
      if (j > 0) add(c - n, -1 - skew);
      if (i > 0) add(c - 1, -1 - skew);
      add(c, 4 - shift);
      if (i + 1 < n) add(c + 1, -1 + skew);
      if (j + 1 < n) add(c + n, -1 + skew);
      column.push_back(static_cast<Index>(rows.size()));
    }
  Matrix A(std::make_shared<const Pattern>(std::move(column), std::move(rows)));
  A.value = values;
  return A;
}

Index negative_eigenvalues(Index n, double shift) {
  const double h = std::numbers::pi / static_cast<double>(n + 1);
  Index count = 0;
  for (Index i = 1; i <= n; ++i)
    for (Index j = 1; j <= n; ++j)
      if (4 - 2 * std::cos(i * h) - 2 * std::cos(j * h) < shift) ++count;
  return count;
}

// Largest error of the solution of A x = A x0.
double error(LinearSolver& solver, const Matrix& A) {
  std::vector<double> x0(A.size()), b(A.size(), 0), x(A.size());
  for (Index i = 0; i < A.size(); ++i) x0[i] = std::sin(1.0 + static_cast<double>(i));
  for (Index c = 0; c < A.size(); ++c)
    for (Index k = A.pattern->column[c]; k < A.pattern->column[c + 1]; ++k)
      b[A.pattern->row[k]] += A.entry(k) * x0[c];
  REQUIRE(solver.factorise(A));
  REQUIRE(solver.solve(A, b, x));
  double worst = 0;
  for (Index i = 0; i < A.size(); ++i) worst = std::max(worst, std::abs(x[i] - x0[i]));
  return worst;
}

}  // namespace

TEST_CASE("both solvers solve a definite matrix, in either ordering") {
  const auto A = laplacian(30, 0);
  for (const auto make : {make_symmetric_solver, make_unsymmetric_solver})
    for (const auto ordering : {Ordering::automatic, Ordering::amd, Ordering::metis}) {
      const auto solver = make(ordering);
      CHECK(error(*solver, A) < 1e-11);  // condition number 400
      CHECK(solver->report().negative_pivots == 0);
      CHECK(solver->report().fill > 0);
      CHECK_FALSE(solver->report().singular);
    }
}

TEST_CASE("an indefinite matrix is solved and its negative eigenvalues are counted") {
  const auto symmetric = make_symmetric_solver(), general = make_unsymmetric_solver();
  const Index n = 24;
  for (const double shift : {0.0, 0.5, 2.31, 0.02, 0.0, 1.07}) {
    const auto A = laplacian(n, shift);
    INFO("shift " << shift);
    CHECK(error(*symmetric, A) < 1e-10);
    CHECK(error(*general, A) < 1e-10);
    CHECK(symmetric->report().negative_pivots == negative_eigenvalues(n, shift));
    CHECK(general->report().negative_pivots == negative_eigenvalues(n, shift));
  }
}

TEST_CASE("the symmetric solver reads one triangle alone, the other one both") {
  const auto A = laplacian(12, 0, -0.3);
  const auto general = make_unsymmetric_solver(), symmetric = make_symmetric_solver();
  CHECK(error(*general, A) < 1e-11);
  CHECK(error(*symmetric, A) > 1e-3);
}

TEST_CASE("a singular matrix is refused by both") {
  auto A = laplacian(6, 0);
  for (Index k = A.pattern->column[7]; k < A.pattern->column[8]; ++k) A.value[k] = 0;
  for (Index c = 0; c < A.size(); ++c)
    for (Index k = A.pattern->column[c]; k < A.pattern->column[c + 1]; ++k)
      if (A.pattern->row[k] == 7) A.value[k] = 0;
  for (const auto make : {make_symmetric_solver, make_unsymmetric_solver}) {
    const auto solver = make(Ordering::automatic);
    CHECK_FALSE(solver->factorise(A));
    CHECK(solver->report().singular);
  }
}

TEST_CASE(
    "a matrix that is symmetric but for some entries is solved with the factors of its symmetric part") {
  const auto solver = make_near_symmetric_solver();
  const Index n = 24;
  for (const double shift : {0.0, 0.5, 0.02}) {
    auto A = laplacian(n, shift);
    CHECK(error(*solver, A) < 1e-10);
    for (Index c = 100; c < 115; ++c) A.add(c + 1, c, 0.3);
    CHECK(error(*solver, A) < 1e-4);  // a relative residual of 1e-6, condition number 250
    CHECK(solver->report().negative_pivots == negative_eigenvalues(n, shift));
  }
  CHECK(error(*solver, laplacian(n, 0, -0.9)) < 1e-4);  // by the factors of the whole where that is slow
  CHECK(solver->analyses() == 4);
}

TEST_CASE("what a matrix keeps apart may be large: the factors are those of the rest") {
  const Index n = 24;
  auto A = laplacian(n, 0);
  A.apart.assign(A.value.size(), 0.0);
  for (Index c = 20; c < 500; c += 40) A.apart[A.pattern->slot(c + 1, c)] = -30;
  std::vector<double> ones(A.size(), 1), y(A.size()), sums;
  Matrix S;
  absolute_sums(A, sums);
  CHECK(sums[20] == 4 + 2 + 31);
  multiply(A, ones, y);
  CHECK(y[21] == -29);
  CHECK(symmetric_part(A, ones, S) == 30);
  CHECK((S.apart.empty() && S.value[S.pattern->slot(20, 21)] == -16));
  const auto near = make_near_symmetric_solver(), general = make_unsymmetric_solver(),
             symmetric = make_symmetric_solver();
  REQUIRE(symmetric->factorise(S));
  CHECK(symmetric->report().negative_pivots > 0);
  CHECK(error(*near, A) < 1e-4);
  CHECK(near->report().negative_pivots == 0);
  CHECK(error(*general, A) < 1e-10);
  A.scale(2);
  CHECK(A.entry(A.pattern->slot(21, 20)) == -62);
  A.change_pattern(std::make_shared<const Pattern>(
      A.pattern->with(std::vector<std::vector<Index>>(static_cast<std::size_t>(A.size()), {0}))));
  CHECK(A.entry(A.pattern->slot(21, 20)) == -62);
  A.clear();
  CHECK(A.apart.empty());
}

TEST_CASE("the symmetric solver solves matrices that are indefinite and counts their negative eigenvalues") {
  const auto solver = make_symmetric_solver();
  for (const Index n : {1, 7, 24, 61})
    for (const double shift : {0.0, 0.5, 2.31}) {
      INFO(n << " x " << n << ", shift " << shift);
      const auto A = laplacian(n, shift);
      CHECK(error(*solver, A) < 1e-9);
      CHECK(solver->report().negative_pivots == negative_eigenvalues(n, shift));
      CHECK(solver->report().fill > 0);
    }
  CHECK(solver->analyses() == 12);
  // A zero that no elimination fills is left to pivots that are looked for.
  Matrix swap(std::make_shared<const Pattern>(std::vector<std::vector<Index>>{{0, 1}, {0, 1}}));
  swap.add(0, 1, 1);
  swap.add(1, 0, 1);
  CHECK(error(*solver, swap) < 1e-15);
  CHECK(solver->report().negative_pivots == 1);
  // A pivot that is nearly none costs digits, which a second solution brings back.
  swap.add(0, 0, 1e-10);
  swap.add(1, 1, 1);
  CHECK(error(*solver, swap) < 1e-11);
  swap.clear();
  CHECK_FALSE(solver->factorise(swap));
}

TEST_CASE("factors of a matrix that threads share have the same bits for any number of them") {
  const int usual = omp_get_max_threads();
  const Index n = 180;
  for (const double shift : {0.0, 0.01}) {
    const auto A = laplacian(n, shift);
    std::vector<double> b(A.size()), first, x(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(1.0 + static_cast<double>(i));
    for (const int threads : {1, 2, 5}) {
      omp_set_num_threads(threads);
      const auto solver = make_symmetric_solver();
      CHECK(error(*solver, A) < 1e-9);
      CHECK(solver->report().negative_pivots == negative_eigenvalues(n, shift));
      REQUIRE(solver->solve(A, b, x));
      if (first.empty()) first = x;
      CHECK(x == first);
    }
    // One pivot means nothing: all threads stop, and pivots are looked for.
    Matrix singular = A;
    const Index middle = n * n / 2 + n / 2;
    for (Index k = A.pattern->column[middle]; k < A.pattern->column[middle + 1]; ++k) {
      singular.value[k] = 0;
      singular.value[A.pattern->slot(middle, A.pattern->row[k])] = 0;
    }
    CHECK_FALSE(make_symmetric_solver()->factorise(singular));
  }
  omp_set_num_threads(usual);
}

TEST_CASE("a pattern is analysed once, and another one anew") {
  for (const auto make : {make_symmetric_solver, make_unsymmetric_solver}) {
    const auto solver = make(Ordering::automatic);
    auto A = laplacian(8, 0);
    CHECK(error(*solver, A) < 1e-12);
    for (double& v : A.value) v *= 2;
    CHECK(error(*solver, A) < 1e-12);
    CHECK(solver->analyses() == 1);
    CHECK(error(*solver, laplacian(11, 0)) < 1e-12);
    CHECK(solver->analyses() == 2);
  }
}

TEST_CASE("a matrix follows a pattern that has grown, and an entry outside its pattern is an error") {
  Matrix A(std::make_shared<const Pattern>(std::vector<std::vector<Index>>{{0, 0}, {1}}));
  CHECK(A.pattern->entries() == 2);  // repeated rows count once
  A.add(1, 1, 3);
  A.add(1, 1, 4);
  CHECK(A.value == std::vector<double>{0, 7});
#ifdef NDEBUG
  CHECK_THROWS_AS(A.add(0, 1, 1), std::logic_error);
#endif
  CHECK(A.value == std::vector<double>{0, 7});  // no neighbour's entry has changed
  const auto grown = std::make_shared<const Pattern>(std::vector<std::vector<Index>>{{1, 0}, {0, 1}});
  CHECK(grown->version != A.pattern->version);
  A.follow(grown);
  CHECK(A.value == std::vector<double>(4, 0.0));
  A.add(0, 1, 1);
  A.follow(grown);
  CHECK(A.value == std::vector<double>{0, 0, 1, 0});
}

namespace {

// The upper triangle of A, with some entries below the diagonal that mean nothing.
Matrix upper_of(const Matrix& A) {
  std::vector<Index> column{0}, row;
  std::vector<double> value;
  for (Index c = 0; c < A.size(); ++c) {
    for (Index k = A.pattern->column[c]; k < A.pattern->column[c + 1]; ++k) {
      const Index r = A.pattern->row[k];
      if (r > c + 1) continue;
      row.push_back(r);
      value.push_back(r <= c ? A.value[k] : 1e6);
    }
    column.push_back(static_cast<Index>(row.size()));
  }
  Pattern pattern(std::move(column), std::move(row));
  pattern.upper = true;
  Matrix upper(std::make_shared<const Pattern>(std::move(pattern)));
  upper.value = std::move(value);
  return upper;
}

}  // namespace

TEST_CASE("a matrix without its zeros is the same, in a pattern of its own") {
  Matrix A = laplacian(3, 0);
  const Index entries = A.pattern->entries();
  for (const Index c : {0, 4}) A.value[static_cast<std::size_t>(A.pattern->slot(c + 1, c))] = 0;
  const Matrix few = without_zeros(A);
  CHECK(few.pattern->entries() == entries - 2);
  CHECK(few.pattern->version != A.pattern->version);
  const std::vector<double> x{3, 1, 4, 1, 5, 9, 2, 6, 5};
  std::vector<double> y(x.size()), wanted(x.size());
  multiply(few, x, y);
  multiply(A, x, wanted);
  CHECK(y == wanted);
}

TEST_CASE("a matrix that keeps its upper triangle is solved as the whole one, to the bit") {
  for (const double shift : {0.0, 1.07}) {  // definite and not
    const auto A = laplacian(20, shift), upper = upper_of(A);
    std::vector<double> b(A.size()), of_whole(b.size()), of_upper(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::sin(1.0 + static_cast<double>(i));
    for (const auto make : {make_symmetric_solver, make_unsymmetric_solver}) {
      const auto one = make(Ordering::amd), two = make(Ordering::amd);
      REQUIRE(one->factorise(A));
      REQUIRE(two->factorise(upper));
      REQUIRE(one->solve(A, b, of_whole));
      REQUIRE(two->solve(upper, b, of_upper));
      CHECK(of_whole == of_upper);
      CHECK(two->report().negative_pivots == negative_eigenvalues(20, shift));
    }
  }
}

TEST_CASE("a matrix that keeps its upper triangle takes no entry below the diagonal") {
  Pattern pattern(std::vector<std::vector<Index>>{{0}, {0, 1}});
  pattern.upper = true;
  Matrix A(std::make_shared<const Pattern>(std::move(pattern)));
  A.add(0, 1, 3);
  A.add(1, 0, 3);
  CHECK(A.value == std::vector<double>{0, 3, 0});
  CHECK(A.pattern->with({{0, 1}, {0, 1}}).upper);
}

TEST_CASE("the sums of columns are those of the whole matrix where the upper triangle is kept") {
  const auto A = laplacian(9, 0.3);
  std::vector<double> whole, upper;
  absolute_sums(A, whole);
  absolute_sums(upper_of(A), upper);
  CHECK(whole == upper);
  CHECK(whole[10] == 4 - 0.3 + 4);
}
