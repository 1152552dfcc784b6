#include "run/diagnosis.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/node_view.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mechanics/terms/directors.hpp"

namespace fabricsh::run {

namespace {

// The state of the law at one point.
struct PointLook {
  law::Internal internal;
  double E[5];
  double ratio = 0;  // the in-plane tangent's largest over its smallest eigenvalue
};

double stiffness_ratio(const law::Law& law, const double* E, const double* state) {
  std::vector<double> next(static_cast<std::size_t>(law::state_size(law)));
  double S[5], C[25];
  if (law::evaluate(law, law::Step{}, E, state, next.data(), S, C) != law::Evaluation::ok) return 0;
  Mat3 K;
  const int in_plane[] = {0, 1, 4};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      K(i, j) = (C[5 * in_plane[i] + in_plane[j]] + C[5 * in_plane[j] + in_plane[i]]) / 2;
  if (!K.allFinite()) return 0;
  const Vec3 values = Eigen::SelfAdjointEigenSolver<Mat3>(K, Eigen::EigenvaluesOnly).eigenvalues();
  return values[0] > 0 ? values[2] / values[0] : 0;
}

std::vector<PointLook> look(const mechanics::Assembly& assembly, mesh::Index element, bool with_ratio) {
  std::vector<PointLook> all;
  assembly.cloth().readings().visit(element,
                                    [&](double, const law::Law& law, const double* E, const double* state) {
                                      PointLook p;
                                      p.internal = law::internal(law, E, state);
                                      std::copy(E, E + 5, p.E);
                                      if (with_ratio) p.ratio = stiffness_ratio(law, E, state);
                                      all.push_back(p);
                                    });
  return all;
}

const char* switching(const law::Internal& before, const law::Internal& now) {
  if (before.warp != now.warp) return "warp";
  if (before.weft != now.weft) return "weft";
  return before.shear != now.shear ? "shear" : "";
}

double largest_strain(const PointLook& p) {
  return std::max({std::abs(p.E[0]), std::abs(p.E[1]), std::abs(p.E[4])});
}

// Degrees, without sign: 90 less the angle between the yarns.
double shear_angle(const PointLook& p) {
  const double stretch = (1 + 2 * p.E[0]) * (1 + 2 * p.E[1]);
  return stretch > 0
             ? std::asin(std::min(1.0, std::abs(p.E[4]) / std::sqrt(stretch))) * 180 / std::numbers::pi
             : 0;
}

bool all_slack(const std::vector<PointLook>& points) {
  return std::all_of(points.begin(), points.end(), [](const PointLook& p) {
    return p.internal.warp == law::LoadBranch::slack && p.internal.weft == law::LoadBranch::slack;
  });
}

// For all elements, in the failed iterate.
using Looks = std::vector<std::vector<PointLook>>;

std::vector<mesh::Index> elements_about(const mesh::Mesh& mesh, mesh::Index node) {
  std::vector<mesh::Index> about;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (std::find(mesh.elements[e].begin(), mesh.elements[e].end(), node) != mesh.elements[e].end())
      about.push_back(static_cast<mesh::Index>(e));
  return about;
}

// Names the first element with a switching yarn, and the point; otherwise the point of the first element with
// the largest strain.
void name_element(const std::vector<mesh::Index>& about, const Looks& before, const Looks& now,
                  ResidualSite& site) {
  std::size_t point = 0;
  for (const auto e : about) {
    for (std::size_t p = 0; p < now[e].size() && site.yarn.empty(); ++p) {
      site.yarn = switching(before[e][p].internal, now[e][p].internal);
      point = p;
    }
    if (site.yarn.empty()) continue;
    site.element = e;
    break;
  }
  if (site.element < 0) {
    if (about.empty()) return;
    site.element = about.front();
    const auto& points = now[site.element];
    point = static_cast<std::size_t>(
        std::max_element(points.begin(), points.end(),
                         [](const auto& a, const auto& b) { return largest_strain(a) < largest_strain(b); }) -
        points.begin());
  }
  const PointLook& p = now[site.element][point];
  site.E11 = p.E[0];
  site.E22 = p.E[1];
  site.E12 = p.E[4] / 2;
  site.after = p.internal;
  site.before = before[site.element][point].internal;
}

Looks look_at_all(const mechanics::Assembly& assembly) {
  Looks all;
  for (mesh::Index e = 0; e < assembly.cloth().elements(); ++e) all.push_back(look(assembly, e, false));
  return all;
}

void find_sheared(const Looks& before, ResidualSite& site) {
  for (std::size_t e = 0; e < before.size(); ++e)
    for (const PointLook& p : before[e])
      if (const double angle = shear_angle(p); angle > site.shear_angle) {
        site.sheared = static_cast<mesh::Index>(e);
        site.shear_angle = angle;
      }
}

void count(const Looks& before, const Looks& now, ResidualSite& site) {
  site.elements = static_cast<std::int64_t>(now.size());
  for (std::size_t e = 0; e < now.size(); ++e) {
    bool switches = false;
    for (std::size_t p = 0; p < now[e].size(); ++p)
      switches = switches || *switching(before[e][p].internal, now[e][p].internal) != '\0';
    site.switching += switches ? 1 : 0;
    site.slack += all_slack(now[e]) ? 1 : 0;
  }
}

}  // namespace

namespace {

ResidualSite find_residual_site(mechanics::Assembly& assembly, const mesh::Mesh& mesh,
                                const solver::NewtonResult& last) {
  ResidualSite site;
  std::vector<mesh::Index> about;
  const auto x = std::as_const(assembly).state().x();
  const bool no_forces = last.status == solver::NewtonStatus::law_failed ||
                         last.status == solver::NewtonStatus::broken ||
                         last.status == solver::NewtonStatus::blocked;
  if (no_forces) site.reason = assembly.outcome().why;
  if (no_forces && assembly.outcome().element >= 0) {
    about = {assembly.outcome().element};
  } else if (last.worst >= 0) {
    site.node = assembly.dofs().node_of(last.worst);
    site.rotation = assembly.dofs().turns(last.worst);
    site.x = at(x, site.node);
    about = elements_about(mesh, site.node);
  }
  const auto shape =
      assembly.terms().find<mechanics::Directors>()->overturned(std::as_const(assembly).state());
  site.inverted = shape.inverted;
  site.turned = shape.turned;
  const Looks now = look_at_all(assembly);
  assembly.rollback();
  const Looks before = look_at_all(assembly);
  name_element(about, before, now, site);
  count(before, now, site);
  if (site.inverted >= 0) find_sheared(before, site);
  if (site.element >= 0) {
    site.centre = assembly.cloth().readings().centre(site.element);
    for (const auto& p : look(assembly, site.element, true))
      site.stiffness_ratio = std::max(site.stiffness_ratio, p.ratio);
  }
  return site;
}

double farthest_move(const mechanics::Assembly& assembly, double from, double to) {
  double farthest = 0;
  const auto& motions = assembly.dofs().freedoms().motions;
  const auto before = assembly.dofs().targets(from), after = assembly.dofs().targets(to);
  for (std::size_t i = 0; i < motions.size(); ++i)
    if (motions[i].component < 3) farthest = std::max(farthest, std::abs(after[i] - before[i]));
  return farthest;
}

double aspect_of(const std::array<mesh::Index, 4>& e, const std::vector<Vec3>& X) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  const int n = e[3] < 0 ? 3 : 4;
  for (int a = 0; a < n; ++a) {
    const double side = (X[e[(a + 1) % n]] - X[e[a]]).norm();
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  return n == 4 ? longest / shortest : 1;
}

}  // namespace

bool Diagnosis::take(const solver::NewtonResult& result, double step, mechanics::Assembly& assembly,
                     const mesh::Mesh& mesh) {
  last = result;
  if (last.status == solver::NewtonStatus::converged) return true;
  site = find_residual_site(assembly, mesh, last);
  tries.push_back({step, last.status, last.residuals, site.reason});
  return false;
}

void Diagnosis::complete(const model::Model& model, const mechanics::Assembly& assembly, double committed) {
  time = committed;
  moved = farthest_move(assembly, time, time + (tries.empty() ? 0 : tries.front().step));
  size = assembly.cloth().rates().smallest_size();
  if (const auto* woven = std::get_if<card::Woven>(&model.card_of(site.element).law)) tested = woven->tested;
  if (site.sheared >= 0 && !std::holds_alternative<card::Woven>(model.card_of(site.sheared).law))
    site.shear_angle = 0;  // it has no yarns
  if (const auto* contact = assembly.terms().find<mechanics::Contacts>()) {
    if (contact->readings().touching() > 0)
      nearest = contact->surfaces().words(contact->readings().nearest().point);
    const auto rubs = contact->readings().held_friction();
    constexpr double most = 0.8;  // of all friction
    if (rubs.sliding > 0 && rubs.of_sliding >= most * rubs.force) {
      sliding = rubs.of_sliding;
      slides = contact->surfaces().words(rubs.most);
    }
  }
  if (site.element >= 0) aspect = aspect_of(model.mesh().elements[site.element], assembly.dofs().reference());
}

}  // namespace fabricsh::run
