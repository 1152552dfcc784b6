#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <new>

#include "linear/linear_solver.hpp"
#include "linear/suitesparse/ordering.hpp"

extern "C" void openblas_set_num_threads(int);

namespace fabricsh::linear {

namespace {

// CHOLMOD's description of our arrays, which it only reads.
template <class T>
T* writable(const std::vector<T>& v) {
  return const_cast<T*>(v.data());
}

// While an object of this class exists, parallel regions run on one thread. CHOLMOD asks for four
// threads around loops of microseconds, and waking them takes longer than the factorisation.
class OneThread {
 public:
  OneThread() { omp_set_max_active_levels(0); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
  ~OneThread() { omp_set_max_active_levels(levels_); }

 private:
  int levels_ = omp_get_max_active_levels();
};

class Cholmod final : public LinearSolver {
 public:
  explicit Cholmod(Ordering ordering) : ordering_(ordering) {
    openblas_set_num_threads(1);  // as for UMFPACK: sums must not depend on the number of threads
    cholmod_l_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.final_ll = 1;
    common_.nmethods = 1;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() override {
    if (L_ != nullptr) cholmod_l_free_factor(&L_, &common_);
    for (cholmod_dense** v : {&X_, &Y_, &E_})
      if (*v != nullptr) cholmod_l_free_dense(v, &common_);
    cholmod_l_finish(&common_);
  }

  bool analyse(const Matrix& A) override {
    if (L_ != nullptr) cholmod_l_free_factor(&L_, &common_);
    general_.reset();
    common_.method[0].ordering = use_metis(ordering_, A.size()) ? CHOLMOD_METIS : CHOLMOD_AMD;
    cholmod_sparse view = upper(A);
    L_ = cholmod_l_analyze(&view, &common_);
    check_memory();
    return L_ != nullptr;
  }

  bool factorise_numbers(const Matrix& A) override {
    if (L_ == nullptr) return false;
    const bool refused = !doubtful_ && !cholesky(A);
    by_general_ = doubtful_ || refused;
    doubtful_ = false;
    if (!by_general_) return true;
    if (!general_) general_ = make_unsymmetric_solver(ordering_);
    const bool done = general_->factorise(A);
    report_ = general_->report();
    // The signs of pivots off the diagonal can mislead; that a matrix has no Cholesky factors cannot.
    if (report_.negative_pivots == 0 && !report_.singular) {
      const LinearReport general = report_;
      const bool definite = !refused && cholesky(A);
      report_ = general;
      if (!definite) report_.negative_pivots = 1;
    }
    doubtful_ = report_.negative_pivots != 0;
    return done;
  }

  bool solve(const Matrix& A, std::span<const double> b, std::span<double> x) override {
    if (by_general_) return general_->solve(A, b, x);
    const OneThread one;
    cholmod_dense rhs{};
    rhs.nrow = rhs.d = rhs.nzmax = b.size();
    rhs.ncol = 1;
    rhs.x = const_cast<double*>(b.data());
    rhs.xtype = CHOLMOD_REAL;
    rhs.dtype = CHOLMOD_DOUBLE;
    const bool done = cholmod_l_solve2(CHOLMOD_A, L_, &rhs, nullptr, &X_, nullptr, &Y_, &E_, &common_) != 0;
    check_memory();
    if (!done) return false;
    const double* result = static_cast<const double*>(X_->x);
    std::copy(result, result + b.size(), x.begin());
    return true;
  }

  LinearReport report() const override { return report_; }
  bool doubtful() const override { return doubtful_; }
  void set_doubtful(bool doubtful) override { doubtful_ = doubtful; }

 private:
  static cholmod_sparse upper(const Matrix& A) {
    cholmod_sparse view{};
    view.nrow = view.ncol = A.size();
    view.nzmax = A.pattern->row.size();
    view.p = writable(A.pattern->column);
    view.i = writable(A.pattern->row);
    view.x = writable(A.value);
    view.stype = 1;  // symmetric, upper triangle: this avoids one permuted copy that the lower one needs
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    return view;
  }

  // A matrix that does not fit into memory is not a singular one.
  void check_memory() const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  bool cholesky(const Matrix& A) {
    const OneThread one;
    cholmod_sparse view = upper(A);
    const bool done = cholmod_l_factorize(&view, L_, &common_) && common_.status == CHOLMOD_OK;
    check_memory();
    if (!done) return false;
    report_ = {};
    report_.reciprocal_condition = cholmod_l_rcond(L_, &common_);
    report_.fill = static_cast<Index>(L_->xsize);
    return true;
  }

  Ordering ordering_;
  cholmod_common common_;
  cholmod_factor* L_ = nullptr;
  cholmod_dense *X_ = nullptr, *Y_ = nullptr, *E_ = nullptr;  // solve's workspace
  std::unique_ptr<LinearSolver> general_;                     // created for the first indefinite matrix
  bool by_general_ = false;                                   // the last matrix was factorised by general_
  bool doubtful_ = false;                                     // and was indefinite; the next may be too
  LinearReport report_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_symmetric_solver(Ordering ordering) {
  return std::make_unique<Cholmod>(ordering);
}

}  // namespace fabricsh::linear
