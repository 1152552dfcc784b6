// The three numbers of one node, in an array with three numbers per node, as a vector to compute with.
#pragma once
#include <cstddef>
#include <type_traits>

#include "geometry/vec.hpp"

namespace fabricsh {

// values: a span or vector with 3 numbers per node, x0 y0 z0 x1 ...; the view is writable if the array is.
template <class Values>
requires requires(Values& values) { values.data(); }
auto at(Values&& values, std::ptrdiff_t node) {
  using Number = std::remove_pointer_t<decltype(values.data())>;
  using Vector = std::conditional_t<std::is_const_v<Number>, const Vec3, Vec3>;
  return Eigen::Map<Vector>(values.data() + 3 * node);
}

}  // namespace fabricsh
