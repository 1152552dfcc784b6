#include <umfpack.h>

#include "solver/sparse.hpp"

extern "C" void openblas_set_num_threads(int);

namespace fabricsh::solver {

namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(Index),
              "SuiteSparse's long index is expected to have 64 bits");

const SuiteSparse_long* as_long(const std::vector<Index>& v) {
  return reinterpret_cast<const SuiteSparse_long*>(v.data());
}

class Umfpack final : public LinearSolver {
 public:
  Umfpack() {
    openblas_set_num_threads(
        1);  // two BLAS threads are slower than one here, and sums must not depend on them
    umfpack_dl_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_AMD;
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;
  ~Umfpack() override { clear(true); }

  bool analyse(const SparseMatrix& A) override {
    clear(true);
    return umfpack_dl_symbolic(A.size, A.size, as_long(A.column), as_long(A.row), nullptr, &symbolic_,
                               control_, info_) == UMFPACK_OK;
  }

  bool factorise(const SparseMatrix& A) override {
    clear(false);
    if (symbolic_ == nullptr) return false;
    const auto status = umfpack_dl_numeric(as_long(A.column), as_long(A.row), A.value.data(), symbolic_,
                                           &numeric_, control_, info_);
    report_.singular = status != UMFPACK_OK;
    report_.reciprocal_condition = info_[UMFPACK_RCOND];
    report_.fill = static_cast<Index>(info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ]);
    return status == UMFPACK_OK;
  }

  bool solve(const SparseMatrix& A, std::span<const double> b, std::span<double> x) override {
    if (numeric_ == nullptr) return false;
    return umfpack_dl_solve(UMFPACK_A, as_long(A.column), as_long(A.row), A.value.data(), x.data(), b.data(),
                            numeric_, control_, info_) == UMFPACK_OK;
  }

  LinearReport report() const override { return report_; }

 private:
  void clear(bool symbolic) {
    if (numeric_ != nullptr) umfpack_dl_free_numeric(&numeric_);
    if (symbolic && symbolic_ != nullptr) umfpack_dl_free_symbolic(&symbolic_);
  }
  double control_[UMFPACK_CONTROL], info_[UMFPACK_INFO];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  LinearReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_unsymmetric_solver() { return std::make_unique<Umfpack>(); }

}  // namespace fabricsh::solver
