#include "lab/averaged.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lab/backbone.hpp"

namespace fabricsh::lab {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_points = 160;       // of a specimen; more are averaged in groups
constexpr int first_places = 24, places = 32;  // of contact: over its range, and where it is likely
constexpr double resolved = 0.2,
                 shared = 0.2;  // least deviation of contact, of the way from there to where the stress
                                // leaves its noise; the part of its variance that is alike in all
constexpr double likely = 9;    // logarithm of the probability that is left out
constexpr double falling = 0.02,
                 noisy = 3;  // of the secant, of its deviation: a tangent that falls by less is noise

// A law's functions of x = strain over the largest, zero at zero: x, x^2, ... and (x - knot)^3 beyond each
// knot.
struct Law {
  int degree, knots;
  std::string name() const {
    return knots > 0 ? "spline " + std::to_string(knots) : "degree " + std::to_string(degree);
  }
  Index size() const { return degree + knots; }
  double beyond(double x, int knot) const {
    return std::max(0.0, x - static_cast<double>(knot) / (knots + 1));
  }
  void values(double x, Vector& row) const {
    double power = 1;
    for (int k = 0; k < degree; ++k) row(k) = power *= x;
    for (int k = 1; k <= knots; ++k) row(degree + k - 1) = beyond(x, k) * beyond(x, k) * beyond(x, k);
  }
  void slopes(double x, Vector& row) const {
    double power = 1;
    for (int k = 0; k < degree; ++k, power *= x) row(k) = (k + 1) * power;
    for (int k = 1; k <= knots; ++k) row(degree + k - 1) = 3 * beyond(x, k) * beyond(x, k);
  }
};

std::vector<Law> laws_of(const AveragingOptions& options) {
  std::vector<Law> out;
  if (!options.degrees.empty()) {
    for (const int degree : options.degrees) out.push_back({degree, 0});
    return out;
  }
  for (int degree = 2; degree <= 6; ++degree) out.push_back({degree, 0});
  for (const int knots : {2, 4, 8, 12}) out.push_back({3, knots});
  return out;
}

// Groups of neighbouring points by their means.
Tension thinned(const Tension& t) {
  const std::size_t group = (t.E.size() + most_points - 1) / most_points;
  if (group <= 1) return t;
  Tension out;
  for (std::size_t first = 0; first < t.E.size(); first += group) {
    const std::size_t n = std::min(group, t.E.size() - first);
    double E = 0, S = 0;
    for (std::size_t i = first; i < first + n; ++i) E += t.E[i], S += t.S[i];
    out.E.push_back(E / static_cast<double>(n));
    out.S.push_back(S / static_cast<double>(n));
  }
  return out;
}

struct Record {
  Tension t;
  Vector weight;  // relative
  double scale;   // largest strain as recorded
};

// Prior knowledge of a law: its tangents at as many places as it has coefficients are of the size of the
// mean tangent there, give or take as much. It decides nothing that the points decide, but a law with as good
// as no stiffness at contact is so less probable than contact that begins later.
struct Known {
  Matrix slopes;     // of the functions, over the tangent
  double noise = 0;  // deviation of a weighted point; 0: nothing is known
};

// One law with one place of contact.
struct Solution {
  double slack = 0, squares = infinity, evidence = -infinity;
  Vector coefficients;
  Matrix root;       // R^-1 of the weighted functions
  double reach = 0;  // largest strain from contact
  bool rising = false;
};

Solution solved(const Record& p, const Law& law, double slack, const Known& known = {}) {
  const Index n = static_cast<Index>(p.t.E.size()), m = law.size();
  Matrix A(n + m, m);
  Vector b(n + m), row(m);
  Index rows = 0;
  Solution out;
  out.slack = slack;
  double before = 0;
  for (Index i = 0; i < n; ++i) {
    const auto [E, S] =
        from_contact(p.t.E[static_cast<std::size_t>(i)], p.t.S[static_cast<std::size_t>(i)], slack);
    if (E <= 0) {
      before += p.weight(i) * S * S;
      continue;
    }
    out.reach = std::max(out.reach, E);
    law.values(E / p.scale, row);
    const double root = std::sqrt(p.weight(i));
    A.row(rows) = root * row.transpose();
    b(rows++) = root * S;
  }
  if (rows < m + 1) return out;
  const Index measured = rows;
  if (known.noise > 0) {
    A.middleRows(rows, m) = known.noise * known.slopes;
    b.segment(rows, m).setConstant(known.noise);
    rows += m;
  }
  const Eigen::HouseholderQR<Matrix> qr(A.topRows(rows));
  const Matrix R = qr.matrixQR().topRows(m).triangularView<Eigen::Upper>();
  Vector q = qr.householderQ().transpose() * b.head(rows);
  if (R.diagonal().cwiseAbs().minCoeff() < 1e-9 * R.diagonal().cwiseAbs().maxCoeff()) return out;
  out.coefficients = R.triangularView<Eigen::Upper>().solve(q.head(m));
  out.squares = before + (b.head(measured) - A.topRows(measured) * out.coefficients).squaredNorm();
  if (known.noise > 0)
    out.evidence = -(before + q.tail(rows - m).squaredNorm()) / (2 * known.noise * known.noise) -
                   R.diagonal().cwiseAbs().array().log().sum();
  out.root = R.triangularView<Eigen::Upper>().solve(Matrix::Identity(m, m));
  const double top = out.reach / p.scale;
  law.values(top, row);
  const double secant = row.dot(out.coefficients) / top;
  out.rising = secant > 0;
  const double deviation = std::sqrt(out.squares / std::max<double>(1, static_cast<double>(n - m)));
  for (int k = 0; k <= 40 && out.rising; ++k) {
    law.slopes(top * k / 40, row);
    const double allowed =
        std::max(falling * secant, noisy * deviation * (out.root.transpose() * row).norm());
    out.rising = row.dot(out.coefficients) > -allowed;
  }
  return out;
}

// The range in which contact may have begun: up to where the stress stays above its noise.
struct Range {
  double low = 0, high = 0;
  bool preloaded = false;
  double none = 0;  // probability of zero
  double variance() const {
    const double mean = (1 - none) * (low + high) / 2;
    return (1 - none) * (low * low + low * high + high * high) / 3 - mean * mean;
  }
};

Range contact_range(const Record& p, double noise, double earliest) {
  const auto& [E, S] = p.t;
  const std::size_t n = E.size();
  std::size_t i = 0;
  const auto mean = [&](std::size_t from) {
    const std::size_t to = std::min(n, from + 3);
    return std::accumulate(S.begin() + static_cast<std::ptrdiff_t>(from),
                           S.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
           static_cast<double>(to - from);
  };
  while (i + 1 < n && (S[i] <= 3 * noise || mean(i) <= 3 * noise)) ++i;
  Range out;
  out.high = std::sqrt(1 + 2 * std::max(0.0, E[i])) - 1;
  out.low = std::max(earliest, std::sqrt(1 + 2 * std::min(0.0, E[0])) - 1);
  if (i ==
      0) {  // it bore force from its first row: contact was before, at the tangent of the toe or a softer one
    std::size_t k = 1;
    while (k + 1 < n && E[k] - E[0] < 0.1 * (p.scale - E[0])) ++k;
    const double tangent = (S[k] - S[0]) / (E[k] - E[0]);
    out.preloaded = true;
    out.high = std::max(0.0, E[0]);
    out.low = std::min(earliest, tangent > 0 ? -3 * S[0] / tangent : 0.0);
  }
  return out;
}

// A law with all places of contact, weighted.
struct Averaged {
  std::vector<Solution> at;
  std::vector<double> weight;  // sum 1
  double least = infinity;     // of the squares
  double correlation = 0;
  const Solution* best = nullptr;
  bool found() const { return best != nullptr; }
};

Known known_of(const Record& p, const Law& law, const Solution& s) {
  Known out;
  const Index m = law.size();
  const double top = s.reach / p.scale;
  Vector row(m);
  const auto stress = [&](double x) {
    law.values(x, row);
    return row.dot(s.coefficients);
  };
  out.slopes = Matrix::Zero(m, m);
  const double least = 0.02 * stress(top) / top;
  for (Index j = 0; j < m; ++j) {
    const double x = top * static_cast<double>(j) / static_cast<double>(m - 1),
                 from = std::max(0.0, x - 0.1 * top), to = std::min(top, x + 0.1 * top);
    const double tangent = std::max(least, (stress(to) - stress(from)) / (to - from));
    law.slopes(x, row);
    out.slopes.row(j) = row.transpose() / tangent;
  }
  out.noise = std::sqrt(s.squares /
                        std::max<double>(1, static_cast<double>(p.t.E.size()) - static_cast<double>(m) - 1));
  return out;
}

double neighbours(const Record& p, const Law& law, const Solution& s) {
  Vector row(law.size());
  double last = 0, together = 0, squares = 0;
  int n = 0;
  for (std::size_t i = 0; i < p.t.E.size(); ++i) {
    const auto [E, S] = from_contact(p.t.E[i], p.t.S[i], s.slack);
    if (E <= 0) continue;
    law.values(E / p.scale, row);
    const double rest = std::sqrt(p.weight(static_cast<Index>(i))) * (S - row.dot(s.coefficients));
    if (n++ > 0) together += rest * last;
    squares += rest * rest;
    last = rest;
  }
  return squares > 0 ? std::clamp(together / squares, 0.0, 0.95) : 0;
}

Averaged average(const Record& p, const Law& law, const Range& range) {
  const double none = range.none;
  std::vector<Solution> coarse;
  const bool open = range.high > range.low;
  const int count = open && none < 1 ? first_places : 0;
  for (int k = 0; k <= count; ++k)
    coarse.push_back(solved(p, law, count > 0 ? range.low + (range.high - range.low) * k / count : 0));
  Averaged out;
  double temper = 1;
  const auto probability = [&](const Solution& s) { return temper * s.evidence; };
  const auto likeliest = [&](const std::vector<Solution>& list) {
    const Solution* best = nullptr;
    for (const Solution& s : list)
      if (s.rising && (best == nullptr || s.squares < best->squares)) best = &s;
    return best;
  };
  const Solution* best = likeliest(coarse);
  if (best == nullptr) return out;
  out.correlation = neighbours(p, law, *best);
  const Known known = known_of(p, law, *best);
  for (Solution& s : coarse) s = solved(p, law, s.slack, known);
  temper = (1 - out.correlation) / (1 + out.correlation);
  double from = range.high, to = range.low, top = -infinity;
  for (const Solution& s : coarse)
    if (s.rising) top = std::max(top, probability(s));
  for (const Solution& s : coarse)
    if (s.rising && probability(s) > top - likely) from = std::min(from, s.slack), to = std::max(to, s.slack);
  const double step = count > 0 ? (range.high - range.low) / count : 0;
  from = std::max(range.low, from - step), to = std::min(range.high, to + step);
  std::vector<double> prior;
  if (none > 0 && range.low <= 0 && range.high >= 0) {
    out.at.push_back(solved(p, law, 0, known));
    prior.push_back(count > 0 ? none : 1);
  }
  for (int k = 0; k <= places && count > 0; ++k) {
    out.at.push_back(solved(p, law, from + (to - from) * k / places, known));
    prior.push_back((1 - none) * (to - from) / (range.high - range.low) / (places + 1));
  }
  best = likeliest(out.at);
  if (best == nullptr) return out;
  out.best = best;
  out.least = best->squares;
  top = -infinity;
  for (const Solution& s : out.at)
    if (s.rising) top = std::max(top, probability(s));
  double sum = 0;
  for (std::size_t k = 0; k < out.at.size(); ++k)
    sum += out.weight.emplace_back(out.at[k].rising ? prior[k] * std::exp(probability(out.at[k]) - top) : 0);
  for (double& w : out.weight) w /= sum;
  return out;
}

// Mean of a law's curve at the strains over all places of contact, and its covariances by noise and by these
// places.
void moments(const Law& law, const Record& p, const Averaged& a, const std::vector<double>& strains,
             Vector& mean, Matrix& noise, Matrix& contact) {
  const auto G = static_cast<Index>(strains.size());
  Matrix B(G, law.size());
  Vector row(law.size()), slope(law.size());
  // Beyond the largest strain from this place of contact the curve goes straight on.
  const auto functions = [&](double reach) {
    for (Index g = 0; g < G; ++g) {
      const double E = strains[static_cast<std::size_t>(g)], last = std::min(E, reach);
      law.values(last / p.scale, row);
      law.slopes(last / p.scale, slope);
      B.row(g) = (row + (E - last) / p.scale * slope).transpose();
    }
  };
  const double n = static_cast<double>(p.t.E.size());
  const double variance = a.least / std::max(1.0, n - static_cast<double>(law.size()) - 1) *
                          (1 + a.correlation) / (1 - a.correlation);
  mean = Vector::Zero(G);
  noise = contact = Matrix::Zero(G, G);
  for (std::size_t k = 0; k < a.at.size(); ++k) {
    if (a.weight[k] < 1e-5) continue;
    functions(a.at[k].reach);
    const Vector y = B * a.at[k].coefficients;
    const Matrix L = B * a.at[k].root;
    mean += a.weight[k] * y;
    noise += a.weight[k] * variance * L * L.transpose();
    contact += a.weight[k] * y * y.transpose();
  }
  contact -= mean * mean.transpose();
}

// Relative weights of the points, from the scatter about a spline where contact fits best.
Record weighted(const Tension& t, const AveragingOptions& options) {
  Record p{thinned(t), {}, 0};
  const auto n = p.t.E.size();
  p.weight = Vector::Ones(static_cast<Index>(n));
  p.scale = std::max(1e-12, *std::max_element(p.t.E.begin(), p.t.E.end()));
  const Law law = n > 40 ? Law{3, 8} : Law{3, n > 16 ? 2 : 0};
  for (int turn = 0; turn < 3; ++turn) {
    const Range range{options.earliest, 0.1 * p.scale};
    Solution best;
    for (int k = 0; k <= first_places; ++k) {
      Solution s = solved(p, law, range.low + (range.high - range.low) * k / first_places);
      if (s.coefficients.size() > 0 && s.squares < best.squares) best = std::move(s);
    }
    if (best.coefficients.size() == 0) return p;
    std::vector<double> squares, tangents;
    Vector row(law.size());
    for (std::size_t i = 0; i < n; ++i) {
      const auto [E, S] = from_contact(p.t.E[i], p.t.S[i], best.slack);
      double rest = S, tangent = 0;
      if (E > 0) {
        law.values(E / p.scale, row);
        rest -= row.dot(best.coefficients);
        law.slopes(E / p.scale, row);
        tangent = row.dot(best.coefficients) / p.scale;
      }
      squares.push_back(rest * rest);
      tangents.push_back(tangent * tangent);
    }
    const std::vector<double> weights = effective_weights(squares, tangents);
    p.weight = Eigen::Map<const Vector>(weights.data(), static_cast<Index>(n));
  }
  return p;
}

// alike: the correlation of neighbouring residuals that no law avoids.
double criterion(const Record& p, const Law& law, const Averaged& a, double alike) {
  const double likeness = (1 - alike) / (1 + alike);
  const double n = static_cast<double>(p.t.E.size());
  const double k = static_cast<double>(law.size()) + 2;
  return likeness * n * std::log(a.least / n) + 2 * k + 2 * k * (k + 1) / std::max(1.0, n - k - 1);
}

// Mean, and the ends of 95 %, of the place of contact over all laws.
void describe_contact(AveragedSpecimen& out, std::vector<std::pair<double, double>> places_and_weights) {
  std::sort(places_and_weights.begin(), places_and_weights.end());
  double sum = 0, second = 0;
  out.slack_low = places_and_weights.front().first;
  out.slack_high = places_and_weights.back().first;
  bool low = false, high = false;
  for (const auto& [slack, w] : places_and_weights) {
    out.slack += slack * w;
    second += slack * slack * w;
    if (slack == 0) out.none += w;
    sum += w;
    if (!low && sum >= 0.025) out.slack_low = slack, low = true;
    if (!high && sum >= 0.975) out.slack_high = slack, high = true;
  }
  out.variance = std::max(0.0, second - out.slack * out.slack);
}

// Tangents of a curve through zero by the stretch of contact: its strains become less by 1 + 2 E.
Vector tangents(const Vector& S, const std::vector<double>& E) {
  Vector out(S.size());
  for (Index g = 0; g < S.size(); ++g) {
    const Index to = std::min<Index>(g + 1, S.size() - 1);
    const auto at = [&](Index k) {
      return k < 0 ? std::pair{0.0, 0.0} : std::pair{E[static_cast<std::size_t>(k)], S(k)};
    };
    const auto [E1, S1] = at(g - 1);
    const auto [E2, S2] = at(to);
    out(g) = (S2 - S1) / (E2 - E1) * (1 + 2 * E[static_cast<std::size_t>(g)]);
  }
  return out;
}

}  // namespace

AveragedCurves average_curves(const std::vector<Tension>& loading, const AveragingOptions& options) {
  std::vector<Law> laws = laws_of(options);
  std::size_t fewest = most_points;
  for (const Tension& t : loading) fewest = std::min(fewest, t.E.size());
  std::erase_if(
      laws, [&](const Law& law) { return laws.size() > 1 && law.size() + 4 > static_cast<Index>(fewest); });
  std::vector<Record> points;
  std::vector<Range> ranges;
  std::vector<std::vector<Averaged>> averaged(laws.size());
  for (const Tension& t : loading) {
    points.push_back(weighted(t, options));
    const double noise = 1 / std::sqrt(points.back().weight.maxCoeff());
    Range range = contact_range(points.back(), noise, options.earliest);
    range.none = range.preloaded ? 0 : options.probability_none;
    ranges.push_back(range);
    for (std::size_t m = 0; m < laws.size(); ++m)
      averaged[m].push_back(average(points.back(), laws[m], range));
  }
  // Akaike weights of the laws with which every specimen rises.
  std::vector<double> weight(laws.size(), 0.0), score(laws.size(), infinity), alike(points.size(), 1.0);
  for (const auto& law : averaged)
    for (std::size_t i = 0; i < points.size(); ++i)
      if (law[i].found()) alike[i] = std::min(alike[i], law[i].correlation);
  for (std::size_t m = 0; m < laws.size(); ++m) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += averaged[m][i].found() ? criterion(points[i], laws[m], averaged[m][i], alike[i]) : infinity;
    score[m] = sum;
  }
  const double least = *std::min_element(score.begin(), score.end());
  AveragedCurves out;
  if (least == infinity) return out;
  double sum = 0;
  for (std::size_t m = 0; m < laws.size(); ++m) sum += weight[m] = std::exp(-(score[m] - least) / 2);
  double reach = infinity;
  std::size_t likeliest = 0;
  for (std::size_t m = 0; m < laws.size(); ++m) {
    weight[m] /= sum;
    if (weight[m] > weight[likeliest]) likeliest = m;
    if (weight[m] < 1e-4) continue;
    for (const Averaged& a : averaged[m]) reach = std::min(reach, a.best->reach);
    out.laws.push_back({laws[m].name(), weight[m]});
  }
  std::sort(out.laws.begin(), out.laws.end(),
            [](const auto& a, const auto& b) { return a.weight > b.weight; });
  for (int g = 1; g <= options.strains; ++g) out.E.push_back(reach * g / options.strains);
  const auto G = static_cast<Index>(out.E.size());
  Matrix within = Matrix::Zero(G, G), common = within;
  Matrix whole = Matrix::Zero(G, static_cast<Index>(points.size()));
  std::vector<Matrix> of_law(laws.size(), whole);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto column = static_cast<Index>(i);
    Vector mean;
    Matrix noise, contact, noises = Matrix::Zero(G, G), contacts = noises;
    std::vector<std::pair<double, double>> slacks;
    AveragedSpecimen one;
    for (std::size_t m = 0; m < laws.size(); ++m) {
      if (weight[m] < 1e-4) continue;
      const Averaged& a = averaged[m][i];
      moments(laws[m], points[i], a, out.E, mean, noise, contact);
      of_law[m].col(column) = mean;
      whole.col(column) += weight[m] * mean;
      noises += weight[m] * noise;
      contacts += weight[m] * contact;
      for (std::size_t k = 0; k < a.at.size(); ++k)
        slacks.emplace_back(a.at[k].slack, weight[m] * a.weight[k]);
    }
    describe_contact(one, std::move(slacks));
    const double prior = ranges[i].variance(), share = prior > 0 ? std::min(1.0, one.variance / prior) : 0;
    // Where the records do not tell, the range and its even weights are a choice, and as uncertain again. And
    // they never tell contact better than the noise lets the first stress be seen.
    const double floor = resolved * std::max(0.0, ranges[i].high - one.slack);
    const Vector moved =
        tangents(whole.col(column), out.E) * std::sqrt(std::max(0.0, floor * floor - one.variance));
    within +=
        (noises + (1 + share) * contacts + moved * moved.transpose()) / static_cast<double>(points.size());
    common += (share * (1 + share) * contacts + shared * moved * moved.transpose()) /
              static_cast<double>(points.size());
    const Averaged& best = averaged[likeliest][i];
    one.S.assign(whole.col(column).data(), whole.col(column).data() + G);
    one.reach = best.best->reach;
    one.residual = std::sqrt(best.least / points[i].weight.sum());
    out.correlation = std::max(out.correlation, best.correlation);
    out.specimens.push_back(std::move(one));
  }
  for (std::size_t m = 0; m < laws.size(); ++m) {
    if (weight[m] < 1e-4) continue;
    const Vector apart = (of_law[m] - whole).rowwise().mean();
    within += weight[m] * apart * apart.transpose();
    common += weight[m] * apart * apart.transpose();
  }
  out.common.assign(common.data(), common.data() + G * G);
  out.within.assign(within.data(), within.data() + G * G);
  return out;
}

}  // namespace fabricsh::lab
