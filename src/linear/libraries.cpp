#include "linear/libraries.hpp"

#include <cblas.h>
#include <cholmod.h>
#include <umfpack.h>

#include <Eigen/Core>

namespace fabricsh::linear {

namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

// The version is the second word of "OpenBLAS 0.3.21 NO_AFFINITY USE64BITINT ...".
std::string openblas() {
  const std::string words = openblas_get_config();
  const auto first = words.find(' ') + 1;
  return words.substr(first, words.find(' ', first) - first) + " (" + blas_kernels() + ")";
}

}  // namespace

std::string blas_kernels() { return openblas_get_corename(); }

std::vector<Library> libraries() {
  int found[3] = {0, 0, 0};
  cholmod_version(found);
  return {{"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"UMFPACK", dotted(UMFPACK_MAIN_VERSION, UMFPACK_SUB_VERSION, UMFPACK_SUBSUB_VERSION)},
          {"CHOLMOD", dotted(found[0], found[1], found[2])},
          {"OpenBLAS", openblas()}};
}

}  // namespace fabricsh::linear
