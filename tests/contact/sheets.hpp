// Sheets for the tests of contact.
#pragma once
#include <numeric>

#include "contact/contact.hpp"
#include "contact/slope.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::test {

inline contact::ContactLaw blend_law() { return contact::ContactLaw({0.38e-3, 0.15e-3, 2e10, {}}); }

// Square sheets of n x n quadrilaterals, one node numbering.
struct Sheets {
  std::vector<Vec3> nodes;
  std::vector<std::vector<std::array<mesh::Index, 4>>> elements;
  void add(double side, int n, const Vec3& origin) {
    const mesh::Mesh m = mesh::rectangle(side, side, n, n, origin);
    const auto first = mesh::Index(nodes.size());
    nodes.insert(nodes.end(), m.nodes.begin(), m.nodes.end());
    elements.push_back(m.elements);
    for (auto& e : elements.back())
      for (auto& id : e)
        if (id >= 0) id += first;
  }
  contact::Scene scene() const {
    contact::Scene out(nodes);
    for (const auto& e : elements) out.add_cloth(e);
    return out;
  }
};

inline Vec3 sum(const std::vector<Vec3>& f, std::size_t from, std::size_t to) {
  return std::accumulate(f.begin() + std::ptrdiff_t(from), f.begin() + std::ptrdiff_t(to), Vec3(Vec3::Zero()),
                         [](const Vec3& a, const Vec3& b) -> Vec3 { return a + b; });
}

inline std::vector<Vec3> none(std::size_t n) { return std::vector<Vec3>(n, Vec3::Zero()); }

// The gap at which the law presses with p, Pa.
inline double gap_at(const contact::ContactLaw& law, double p) {
  double low = law.floor(), high = law.gap();
  for (int i = 0; i < 200; ++i) (law(0.5 * (low + high)).pressure > p ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

}  // namespace fabricsh::test
