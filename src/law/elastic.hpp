// Laws with a constant tangent: St. Venant-Kirchhoff (share/doc/theory.md, 4) and the linear orthotropic law
// [williams2010, eq. 4.2].
#pragma once
#include "law/response.hpp"

namespace fabricsh::law {
inline namespace FABRICSH_ISA {

template <class T>
Response<T> elastic_update(const ElasticData& law, const T E[5]) {
  Response<T> out;
  out.C11 = T(law.C11);
  out.C22 = T(law.C22);
  out.C12 = out.C21 = T(law.C12);
  out.C55 = T(law.G12);
  out.S[0] = out.C11 * E[0] + out.C12 * E[1];
  out.S[1] = out.C12 * E[0] + out.C22 * E[1];
  out.S[4] = out.C55 * E[4];
  transverse_elastic(T(law.G23), T(law.G13), E, out);
  return out;
}

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::law
