#include "analysis/failure.hpp"

#include <algorithm>

#include "analysis/number.hpp"

namespace fabricsh::analysis {

namespace {

// Three per point: warp, weft, shear.
std::vector<fabric::Branch> branches(const assembly::Assembly& assembly, mesh::Index element) {
  std::vector<fabric::Branch> all;
  assembly.visit(element, [&](double, const fabric::Law& law, const double* E, const double* state) {
    const auto in = fabric::internal(law, E, state);
    for (const auto branch : {in.warp, in.weft, in.shear}) all.push_back(branch);
  });
  return all;
}

const char* const yarns[] = {"warp", "weft", "shear"};

std::string switching(const std::vector<fabric::Branch>& before, const std::vector<fabric::Branch>& now) {
  for (std::size_t k = 0; k < before.size(); ++k)
    if (before[k] != now[k]) return yarns[k % 3];
  return {};
}

}  // namespace

Blame find_blame(assembly::Assembly& assembly, const mesh::Mesh& mesh, const solver::NewtonResult& last) {
  Blame blame;
  std::vector<mesh::Index> about;
  if (last.status == solver::NewtonStatus::law_failed && assembly.failed_element() >= 0) {
    about = {assembly.failed_element()};
  } else if (last.worst >= 0) {
    blame.node = assembly.node_of_unknown(last.worst);
    const auto& elements = mesh.elements;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (std::find(elements[e].begin(), elements[e].end(), blame.node) != elements[e].end())
        about.push_back(static_cast<mesh::Index>(e));
  }
  std::vector<std::vector<fabric::Branch>> tried;
  for (const auto e : about) tried.push_back(branches(assembly, e));
  assembly.state().rollback();
  for (std::size_t i = 0; i < about.size() && blame.yarn.empty(); ++i) {
    blame.yarn = switching(branches(assembly, about[i]), tried[i]);
    if (!blame.yarn.empty()) blame.element = about[i];
  }
  if (blame.element < 0 && !about.empty()) blame.element = about.front();
  return blame;
}

std::string describe(const Blame& blame, const solver::NewtonResult& last, double tolerance) {
  std::string text;
  if (blame.node >= 0 && !last.residuals.empty())
    text += "; the residual " + number(last.residuals.back()) + " (tolerance " + number(tolerance) +
            ") sits at node " + std::to_string(blame.node + 1);
  if (blame.element >= 0) text += ", element " + std::to_string(blame.element + 1);
  if (!blame.yarn.empty()) text += ", where the " + blame.yarn + " is switching between branches";
  return text;
}

}  // namespace fabricsh::analysis
