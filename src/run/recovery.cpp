#include "run/recovery.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "mechanics/terms/cloth.hpp"
#include "run/readings.hpp"

namespace fabricsh::run {

using mesh::Index;

struct PatchShare {
  Index element;
  double weight;
};

struct ElementShape {
  Vec3 centre, normal;  // of area; unit
  double area = 0;
};

namespace {

constexpr int kRows = 3;               // of elements, that a patch on a border reaches inwards
constexpr std::size_t kQuadratic = 8;  // elements that determine the six coefficients with some to spare
constexpr double kConditioned =
    0.02;                        // least over largest diagonal of R: below, a polynomial is not determined
constexpr double kFacing = 0.5;  // cosine with the node's normal, below which an element lies too steeply

ElementShape shape_of(const std::array<Index, 4>& nodes, const std::vector<Vec3>& X) {
  const auto part = [&](int a, int b, int c) {
    const Vec3 across = (X[nodes[b]] - X[nodes[a]]).cross(X[nodes[c]] - X[nodes[a]]) / 2;
    return std::pair(across, Vec3((X[nodes[a]] + X[nodes[b]] + X[nodes[c]]) / 3));
  };
  ElementShape s;
  const auto [first, middle] = part(0, 1, 2);
  Vec3 normal = first, moment = first.norm() * middle;
  s.area = first.norm();
  if (nodes[3] >= 0) {
    const auto [second, other] = part(0, 2, 3);
    // A corner that points inwards makes one of the two negative.
    const double area = first.dot(second) < 0 ? -second.norm() : second.norm();
    normal += second;
    moment += area * other;
    s.area += area;
  }
  s.centre = moment / s.area;
  s.area = std::abs(s.area);
  s.normal = normal.normalized();
  return s;
}

}  // namespace

// A patch stands for a node and a region. Nodes that lead a joint have those of all of its nodes.
struct Recovery::Patches {
  struct Patch {
    int region;
    double area;  // m^2, of the elements that meet at the node
    std::vector<PatchShare> shares;
  };
  std::vector<std::vector<Patch>> of_node;  // by leading nodes
  std::vector<Index> leader;
  const Readings& run;

  explicit Patches(const Readings& of) : run(of) {
    const auto& mesh = run.model().mesh();
    const auto& joints = run.assembly().dofs().joints();
    const auto& X = run.assembly().dofs().reference();
    leader.resize(mesh.nodes.size());
    for (std::size_t n = 0; n < leader.size(); ++n) leader[n] = joints.leader(static_cast<Index>(n));
    around_.resize(mesh.nodes.size());
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      shapes_.push_back(shape_of(mesh.elements[e], X));
      for (const Index n : mesh.elements[e])
        if (n >= 0) around_[static_cast<std::size_t>(leader_of(n))].push_back(static_cast<Index>(e));
    }
    of_node.resize(mesh.nodes.size());
#pragma omp parallel for schedule(dynamic, 64) if (mesh.nodes.size() >= 1024)
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) add_patches(static_cast<Index>(n));
  }

  const Patch* find(Index node, int region) const {
    for (const Patch& patch : of_node[static_cast<std::size_t>(leader_of(node))])
      if (patch.region == region) return &patch;
    return nullptr;
  }

 private:
  Index leader_of(Index node) const { return leader[static_cast<std::size_t>(node)]; }
  const std::array<Index, 4>& nodes_of(Index e) const {
    return run.model().mesh().elements[static_cast<std::size_t>(e)];
  }
  const ElementShape& shape(Index e) const { return shapes_[static_cast<std::size_t>(e)]; }

  void add_patches(Index node) {
    std::map<int, std::vector<Index>> by_region;
    for (const Index e : around_[static_cast<std::size_t>(node)])
      by_region[run.model().region_of(e)].push_back(e);
    for (const auto& [region, elements] : by_region) {
      Patch patch{region, 0, {}};
      for (const Index e : elements) patch.area += shape(e).area;
      patch.shares = shares_of(node, region, elements);
      of_node[static_cast<std::size_t>(node)].push_back(std::move(patch));
    }
  }

  // Whether the elements surround the node: each of their edges there belongs to two of them.
  bool surrounded(Index node, const std::vector<Index>& elements) const {
    std::map<Index, int> ends;
    for (const Index e : elements) {
      const auto& nodes = nodes_of(e);
      const int corners = nodes[3] < 0 ? 3 : 4;
      for (int a = 0; a < corners; ++a)
        if (leader_of(nodes[a]) == node)
          for (const int b : {(a + 1) % corners, (a + corners - 1) % corners}) ++ends[leader_of(nodes[b])];
    }
    return std::all_of(ends.begin(), ends.end(), [](const auto& end) { return end.second == 2; });
  }

  // Adds the elements of the region that share a node with one of the patch and face the same way.
  void grow(std::vector<Index>& elements, int region, const Vec3& normal) const {
    std::set<Index> all(elements.begin(), elements.end());
    for (const Index e : std::vector<Index>(elements))
      for (const Index n : nodes_of(e))
        if (n >= 0)
          for (const Index other : around_[static_cast<std::size_t>(leader_of(n))])
            if (run.model().region_of(other) == region && shape(other).normal.dot(normal) > kFacing &&
                all.insert(other).second)
              elements.push_back(other);
  }

  std::vector<PatchShare> shares_of(Index node, int region, std::vector<Index> elements) const {
    Vec3 normal = Vec3::Zero();
    for (const Index e : elements) normal += shape(e).area * shape(e).normal;
    normal = normal.norm() > 0 ? Vec3(normal.normalized()) : shape(elements.front()).normal;
    const std::vector<Index> own = elements;
    std::vector<PatchShare> shares;
    if (surrounded(node, elements) && fit(node, normal, elements, 3, shares)) return shares;
    for (int row = 1; row < kRows; ++row) grow(elements, region, normal);
    if (elements.size() >= kQuadratic && fit(node, normal, elements, 6, shares)) return shares;
    elements = own;
    for (int row = 0; row < kRows; ++row, grow(elements, region, normal))
      if (fit(node, normal, elements, 3, shares)) return shares;
    double area = 0;
    for (const Index e : own) area += shape(e).area;
    for (const Index e : own) shares.push_back({e, shape(e).area / area});
    return shares;
  }

  // The weights of the elements in the value at the node of a polynomial of three or six coefficients, fitted
  // by least squares. A border's elements count the less the farther they are.
  bool fit(Index node, const Vec3& normal, const std::vector<Index>& elements, int terms,
           std::vector<PatchShare>& shares) const {
    const auto count = static_cast<Eigen::Index>(elements.size());
    if (count < terms) return false;
    const Vec3& at = run.assembly().dofs().reference()[static_cast<std::size_t>(node)];
    const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
    double reach = 0;
    for (const Index e : elements) reach = std::max(reach, (shape(e).centre - at).norm());
    Eigen::MatrixXd P(count, terms);
    Eigen::VectorXd weight(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Vec3 to = (shape(elements[static_cast<std::size_t>(i)]).centre - at) / reach;
      const double x = to.dot(first), y = to.dot(second);
      P.row(i).head(3) << 1, x, y;
      if (terms == 6) P.row(i).tail(3) << x * x, x * y, y * y;
      weight[i] = terms == 6 ? std::exp(-2 * to.squaredNorm()) : 1;
    }
    const Eigen::MatrixXd scaled = weight.asDiagonal() * P;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
    const auto diagonal = qr.matrixR().diagonal().cwiseAbs();
    if (!(diagonal.minCoeff() > kConditioned * diagonal.maxCoeff())) return false;
    // The value at the node is the first coefficient, e1^T (WP)^+ W.
    const Eigen::MatrixXd inverse = qr.solve(Eigen::MatrixXd::Identity(count, count));
    shares.clear();
    for (Eigen::Index i = 0; i < count; ++i)
      shares.push_back({elements[static_cast<std::size_t>(i)], inverse(0, i) * weight[i]});
    return true;
  }

  std::vector<std::vector<Index>> around_;  // by leading nodes
  std::vector<ElementShape> shapes_;
};

namespace {

void add_shares(const std::vector<PatchShare>& shares, double factor, std::span<const double> of_elements,
                std::size_t width, double* value) {
  for (const PatchShare& share : shares)
    for (std::size_t i = 0; i < width; ++i)
      value[i] += factor * share.weight * of_elements[static_cast<std::size_t>(share.element) * width + i];
}

}  // namespace

Recovery::Recovery(const Readings& run) : patches_(std::make_unique<Patches>(run)) {}
Recovery::~Recovery() = default;

std::vector<double> Recovery::at_nodes(std::span<const double> of_elements, std::size_t width,
                                       int region) const {
  const std::size_t nodes = patches_->leader.size();
  std::vector<double> values(nodes * width, 0.0);
  for (std::size_t n = 0; n < nodes; ++n) {
    double area = 0;
    const auto& patches = patches_->of_node[static_cast<std::size_t>(patches_->leader[n])];
    for (const auto& patch : patches)
      if (region < 0 || patch.region == region) area += patch.area;
    for (const auto& patch : patches)
      if (region < 0 || patch.region == region)
        add_shares(patch.shares, patch.area / area, of_elements, width, &values[n * width]);
    if (!(area > 0)) std::fill_n(&values[n * width], width, std::nan(""));
  }
  return values;
}

void Recovery::at_corners(Index element, std::span<const double> of_elements, std::size_t width,
                          double* value) const {
  const auto& nodes = patches_->run.model().mesh().elements[static_cast<std::size_t>(element)];
  const int region = patches_->run.model().region_of(element);
  for (std::size_t a = 0; a < 4 && nodes[a] >= 0; ++a) {
    std::fill_n(value + a * width, width, 0.0);
    add_shares(patches_->find(nodes[a], region)->shares, 1, of_elements, width, value + a * width);
  }
}

std::vector<double> recovered(const Readings& run, const FieldPart& part, int region) {
  const ResultField& field = *part.field;
  if (field.place != FieldPlace::element)
    throw Error("field '" + field.name + "': has its values at the nodes: expected it without 'at'");
  if (!field.continuous)
    throw Error("field '" + field.name + "': jumps from element to element, and has no values at the nodes");
  const std::size_t regions = run.model().regions().size();
  if (region >= static_cast<int>(regions))
    throw Error("field '" + field.name + "': expected a region from 1 to " + std::to_string(regions) +
                ", got " + std::to_string(region + 1));
  const std::size_t width = part.component < 0 ? field.size() : 1;
  return Recovery(run).at_nodes(values_of(run, part), width, region);
}

namespace {

constexpr std::size_t kTensor = 6;  // S11 S22 S12 E11 E22 E12

// The volume (m^3) that an in-plane point stands for, and its mean over the thickness.
struct PointMean {
  double volume = 0;
  std::array<double, kTensor> value{};
};

// Of a symmetric tensor 11 22 12, whose axes are turned back by an angle.
void turn_tensor(double angle, double* v) {
  const double c = std::cos(angle), s = std::sin(angle), a = v[0], b = v[1], d = v[2];
  v[0] = c * c * a + s * s * b - 2 * c * s * d;
  v[1] = s * s * a + c * c * b + 2 * c * s * d;
  v[2] = c * s * (a - b) + (c * c - s * s) * d;
}

std::vector<PointMean> means_of(const Readings& run, Index e) {
  const auto& section = run.model().sections()[static_cast<std::size_t>(run.model().region_of(e))];
  const double common = section.common_angle();
  const std::size_t points = section.points.size();
  std::vector<PointMean> all;
  std::size_t visited = 0;
  run.assembly().cloth().readings().visit(
      e, [&](double w, const law::Law& law, const double* E, const double* state) {
        const std::size_t k = visited++ % points;
        if (k == 0) all.emplace_back();
        double S[5];
        law::stress(law, E, state, S);
        std::array<double, kTensor> v{S[0], S[1], S[4], E[0], E[1], E[4] / 2};
        if (const double angle = section.points[k].angle - common; angle != 0) {
          turn_tensor(angle, v.data());
          turn_tensor(angle, v.data() + 3);
        }
        PointMean& mean = all.back();
        mean.volume += w;
        for (std::size_t i = 0; i < kTensor; ++i) mean.value[i] += w * v[i];
      });
  for (PointMean& mean : all)
    for (double& v : mean.value) v /= mean.volume;
  return all;
}

double strain_work(const std::array<double, kTensor>& v) {
  return v[0] * v[3] + v[1] * v[4] + 2 * v[2] * v[5];
}

// The corners' weights at an in-plane point, in the order of the elements' kernels.
std::array<double, 4> weights_at(std::size_t point, bool triangle) {
  if (triangle) {
    std::array<double, 4> w{1.0 / 6, 1.0 / 6, 1.0 / 6, 0};
    w[point] = 2.0 / 3;
    return w;
  }
  static const double near = (1 + 1 / std::sqrt(3.0)) / 2, far = 1 - near;
  std::array<double, 4> w{};
  w[point] = near * near;
  w[(point + 1) % 4] = w[(point + 3) % 4] = near * far;
  w[(point + 2) % 4] = far * far;
  return w;
}

}  // namespace

std::vector<double> stress_errors(const Readings& run) {
  const auto& elements = run.model().mesh().elements;
  std::vector<std::vector<PointMean>> points(elements.size());
  std::vector<double> means(elements.size() * kTensor, 0.0), volume(elements.size(), 0.0);
  double energy = 0, whole = 0;
#pragma omp parallel for schedule(static) if (elements.size() >= 256)
  for (std::size_t e = 0; e < elements.size(); ++e) {
    points[e] = means_of(run, static_cast<Index>(e));
    for (const PointMean& p : points[e]) {
      volume[e] += p.volume;
      for (std::size_t i = 0; i < kTensor; ++i) means[e * kTensor + i] += p.volume * p.value[i];
    }
    for (std::size_t i = 0; i < kTensor; ++i) means[e * kTensor + i] /= volume[e];
  }
  for (std::size_t e = 0; e < elements.size(); ++e) {
    whole += volume[e];
    for (const PointMean& p : points[e]) energy += p.volume * std::abs(strain_work(p.value));
  }
  std::vector<double> error(elements.size(), 0.0);
  if (!(energy > 0)) return error;
  const Recovery recovery(run);
#pragma omp parallel for schedule(static) if (elements.size() >= 256)
  for (std::size_t e = 0; e < elements.size(); ++e) {
    double corner[4 * kTensor], sum = 0;
    recovery.at_corners(static_cast<Index>(e), means, kTensor, corner);
    for (std::size_t g = 0; g < points[e].size(); ++g) {
      const auto weight = weights_at(g, elements[e][3] < 0);
      std::array<double, kTensor> less = points[e][g].value;
      for (std::size_t a = 0; a < (elements[e][3] < 0 ? 3U : 4U); ++a)
        for (std::size_t i = 0; i < kTensor; ++i) less[i] -= weight[a] * corner[a * kTensor + i];
      sum += points[e][g].volume * std::max(0.0, strain_work(less));
    }
    error[e] = std::sqrt(sum / volume[e] * whole / energy);
  }
  return error;
}

}  // namespace fabricsh::run
