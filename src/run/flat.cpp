#include "run/flat.hpp"

#include <algorithm>
#include <limits>

#include "geometry/box.hpp"
#include "geometry/node_view.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/seams.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/place_text.hpp"
#include "run/problem.hpp"

namespace fabricsh::run {

solver::Judge judge_of(const model::Model& model, const mechanics::Assembly& assembly) {
  if (!model.all<model::MomentLoad>().empty()) return solver::Judge::never;
  const auto& terms = assembly.terms();  // the cloth is the first
  const bool loads_have_energy =
      std::all_of(terms.begin() + 1, terms.end(), [](const auto& t) { return t->symmetric(); });
  return loads_have_energy ? solver::Judge::work : solver::Judge::energy;
}

namespace {

// Of the first element, in the present shape.
Vec3 normal_of(const mechanics::Assembly& assembly) {
  const auto& nodes = assembly.cloth().model().mesh().elements.front();
  const auto x = assembly.state().x();
  const auto last = nodes[3] < 0 ? nodes[0] : nodes[3];
  return (at(x, nodes[2]) - at(x, nodes[0])).cross(at(x, last) - at(x, nodes[1])).normalized();
}

bool is_held(const mechanics::Assembly& assembly) {
  const auto& nodes = assembly.dofs().freedoms().nodes;
  return std::any_of(nodes.begin(), nodes.end(), [](const auto& node) {
    return std::any_of(node.equation.begin(), node.equation.begin() + 3, mechanics::is_prescribed);
  });
}

// The node that a mode moves most, if it leads out of the plane; -1: it does not.
mesh::Index leaves_by(const mechanics::Assembly& assembly, const linear::Vector& shape, const Vec3& normal) {
  if (shape.empty()) return -1;
  constexpr double mostly = 0.99;
  mechanics::NodalRates way;
  assembly.dofs().spread_rates(shape, std::vector<double>(assembly.dofs().targets(0).size()), way);
  double across = 0, all = 0, most = 0;
  mesh::Index where = -1;
  for (mesh::Index n = 0; n < static_cast<mesh::Index>(way.x.size() / 3); ++n) {
    const double out = at(way.x, n).dot(normal);
    across += out * out;
    all += at(way.x, n).squaredNorm();
    if (out * out <= most) continue;
    most = out * out;
    where = n;
  }
  return across > mostly * all ? where : -1;
}

}  // namespace

// Coordinates are rounded, and with them the first element's normal, which the whole sheet is held against.
bool is_flat(const mechanics::Assembly& assembly) {
  constexpr double rounding = 1e-12;
  const auto x = assembly.state().x();
  const auto& first = assembly.cloth().model().mesh().elements.front();
  const Vec3 normal = normal_of(assembly), from = at(x, 0);
  const double size = box_of(assembly.dofs().reference()).size().norm();
  const double side = (at(x, first[1]) - at(x, first[0])).norm(),
               width = (at(x, first[2]) - at(x, first[1])).norm();
  const double far =
      *std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double coarse = 8 * std::numeric_limits<double>::epsilon() * std::abs(far) / std::min(side, width);
  for (std::ptrdiff_t n = 0; n < static_cast<std::ptrdiff_t>(x.size() / 3); ++n)
    if (!(std::abs((at(x, n) - from).dot(normal)) <= (rounding + coarse) * size)) return false;
  return true;
}

std::optional<std::string> leaves_its_plane(const model::Model& model, const mechanics::Assembly& assembly) {
  const auto& terms = assembly.terms();
  if (!is_held(assembly) || terms.find<mechanics::Contacts>() != nullptr ||
      terms.find<mechanics::Seams>() != nullptr || terms.find<mechanics::Tears>() != nullptr)
    return {};
  mechanics::Assembly alone(model);
  const EquilibriumProblem::Poll poll;
  EquilibriumProblem problem(alone, 1e-9, poll);
  problem.set_time(assembly.state().time());
  const auto shape = assembly.state().kinematics();
  std::copy(shape.begin(), shape.end(), alone.state().kinematics().begin());
  alone.state().touch();
  linear::Matrix K;
  linear::Vector D;
  if (problem.tangent(K) != Answer::ok) return {};
  linear::absolute_sums(K, D);
  const bool symmetric = alone.terms().symmetric();
  const auto linear = symmetric ? linear::make_symmetric_solver() : linear::make_unsymmetric_solver();
  solver::StabilityCheck check(*linear, symmetric, judge_of(model, alone));
  if (check.of(K, D) != solver::Stability::unstable) return {};
  const mesh::Index node = leaves_by(assembly, check.mode().shape, normal_of(assembly));
  if (node < 0) return {};
  return "node " + std::to_string(model.mesh().place_of(node) + 1) + ", about " +
         place_text(at(assembly.state().x(), node));
}

}  // namespace fabricsh::run
