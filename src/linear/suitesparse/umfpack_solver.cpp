#include <umfpack.h>

#include <algorithm>
#include <functional>
#include <new>

#include "linear/linear_solver.hpp"
#include "linear/suitesparse/ordering.hpp"
#include "linear/vector.hpp"

extern "C" void openblas_set_num_threads(int);

namespace fabricsh::linear {

namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(Index),
              "SuiteSparse's long index is expected to have 64 bits");

const SuiteSparse_long* as_long(const std::vector<Index>& v) {
  return reinterpret_cast<const SuiteSparse_long*>(v.data());
}

constexpr double kRounding = 2e-14;  // of smallest to largest pivot: 100 times the unit roundoff

class Umfpack final : public LinearSolver {
 public:
  explicit Umfpack(Ordering ordering) : ordering_(ordering) {
    openblas_set_num_threads(
        1);  // two BLAS threads are slower than one here, and sums must not depend on them
    umfpack_dl_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    // Newton's iterations correct what rounding leaves; refining each solution took longer than the rest of
    // it.
    control_[UMFPACK_IRSTEP] = 0;
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;
  ~Umfpack() override { clear(true); }

  bool analyse(const Matrix& given) override {
    clear(true);
    const Matrix& A = whole(given);
    control_[UMFPACK_ORDERING] =
        use_metis(ordering_, A.size()) ? UMFPACK_ORDERING_METIS : UMFPACK_ORDERING_AMD;
    const auto status = umfpack_dl_symbolic(A.size(), A.size(), as_long(A.pattern->column),
                                            as_long(A.pattern->row), nullptr, &symbolic_, control_, info_);
    check_memory(status);
    return status == UMFPACK_OK;
  }

  bool factorise_numbers(const Matrix& given) override {
    clear(false);
    if (symbolic_ == nullptr) return false;
    const Matrix& A = whole(given);
    const auto status = umfpack_dl_numeric(as_long(A.pattern->column), as_long(A.pattern->row), entries_of(A),
                                           symbolic_, &numeric_, control_, info_);
    check_memory(status);
    // A pivot that is rounding error beside the largest one: a part can move freely; its sign means nothing.
    report_.singular = status != UMFPACK_OK || info_[UMFPACK_RCOND] < kRounding;
    report_.fill = static_cast<Index>(info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ]);
    report_.negative_pivots = status == UMFPACK_OK ? count_negative(A.size()) : 0;
    return !report_.singular;
  }

  bool solve(const Matrix& given, std::span<const double> b, std::span<double> x) override {
    if (numeric_ == nullptr) return false;
    const Matrix& A = given.pattern->upper ? both_ : given;
    const auto status = umfpack_dl_solve(UMFPACK_A, as_long(A.pattern->column), as_long(A.pattern->row),
                                         entries_of(A), x.data(), b.data(), numeric_, control_, info_);
    check_memory(status);
    return status == UMFPACK_OK;
  }

  LinearReport report() const override { return report_; }

 private:
  // A matrix that does not fit into memory is not a singular one.
  template <class Status>
  static void check_memory(Status status) {
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
  }

  // UMFPACK reads both triangles.
  const Matrix& whole(const Matrix& A) {
    if (!A.pattern->upper) return A;
    mirror(A, both_of_, both_);
    return both_;
  }
  const double* entries_of(const Matrix& A) {
    if (A.apart.empty()) return A.value.data();
    joined_.resize(A.value.size());
    std::transform(A.value.begin(), A.value.end(), A.apart.begin(), joined_.begin(), std::plus<>());
    return joined_.data();
  }
  void clear(bool symbolic) {
    if (numeric_ != nullptr) umfpack_dl_free_numeric(&numeric_);
    if (symbolic && symbolic_ != nullptr) umfpack_dl_free_symbolic(&symbolic_);
  }
  // Negative eigenvalues from the signs on the diagonal of U. Pivots off the
  // diagonal of the matrix form cycles of rows and columns; a cycle counts once if
  // its determinant is negative (a 2 x 2 pivot has one eigenvalue of each sign).
  Index count_negative(Index n) const {
    std::vector<SuiteSparse_long> P(n), Q(n), place(n);
    std::vector<double> D(n);
    SuiteSparse_long reciprocal = 0;
    if (umfpack_dl_get_numeric(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, P.data(), Q.data(),
                               D.data(), &reciprocal, nullptr, numeric_) != UMFPACK_OK)
      return 0;
    for (Index k = 0; k < n; ++k) place[P[k]] = k;
    std::vector<bool> seen(n, false);
    Index count = 0;
    for (Index k = 0; k < n; ++k) {
      bool negative = false;
      for (Index i = k; !seen[i]; i = place[Q[i]]) {
        seen[i] = true;
        if ((D[i] < 0) != (i != k)) negative = !negative;
      }
      if (negative) ++count;
    }
    return count;
  }

  Ordering ordering_;
  double control_[UMFPACK_CONTROL], info_[UMFPACK_INFO];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  LinearReport report_;
  Vector joined_;  // entries of a matrix of which some are apart
  Matrix both_;    // of a matrix that keeps its upper triangle
  std::uint64_t both_of_ = 0;
};

}  // namespace

std::unique_ptr<LinearSolver> make_unsymmetric_solver(Ordering ordering) {
  return std::make_unique<Umfpack>(ordering);
}

}  // namespace fabricsh::linear
