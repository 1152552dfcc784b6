#include "law/by_direction.hpp"

#include <algorithm>

#include "law/data.hpp"

namespace fabricsh::law {

ByDirection by_direction(const Law& law) {
  if (law.kind == CompiledKind::elastic) return {{law.elastic.C11, law.elastic.C22}, law.elastic.G12};
  const WovenData& w = law.woven;
  ByDirection out;
  out.shear = backbone_modulus(law, 3, 0);
  for (int i = 0; i < 2; ++i)
    out.axis[i] =
        std::max(w.axis[i].unloading * w.loop[i].steepest + w.coupling * w.axis[i].poisson, w.axis[i].slack);
  return out;
}

}  // namespace fabricsh::law
