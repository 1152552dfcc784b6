#include "lab/statistics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <string>
#include <unsupported/Eigen/SpecialFunctions>

#include "base/error.hpp"

namespace fabricsh::lab {

namespace {

// P(t <= x) by the incomplete beta function [abramowitz1964, 26.5.27].
double student(double x, double freedom) {
  const double half = Eigen::numext::betainc(0.5, freedom / 2, x * x / (freedom + x * x)) / 2;
  return x > 0 ? 0.5 + half : 0.5 - half;
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double student_quantile(double p, double freedom) {
  double low = -1, high = 1;
  while (student(low, freedom) > p) low *= 2;
  while (student(high, freedom) < p) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-15 * (1 + std::abs(low)); ++i)
    (student((low + high) / 2, freedom) < p ? low : high) = (low + high) / 2;
  return (low + high) / 2;
}

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

// A random number below n, the same on every machine (unlike std::uniform_int_distribution).
std::size_t below(std::mt19937_64& random, std::size_t n) { return random() % n; }

// Each column is the mean of n specimens drawn with replacement.
Matrix drawn_means(const Matrix& data, int draws, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto n = static_cast<std::size_t>(data.cols());
  Matrix means = Matrix::Zero(data.rows(), draws);
  for (int k = 0; k < draws; ++k) {
    for (std::size_t i = 0; i < n; ++i) means.col(k) += data.col(static_cast<Eigen::Index>(below(random, n)));
    means.col(k) /= static_cast<double>(n);
  }
  return means;
}

Matrix as_matrix(const std::vector<std::vector<double>>& specimens) {
  const auto rows = static_cast<Eigen::Index>(specimens.at(0).size());
  Matrix data(rows, static_cast<Eigen::Index>(specimens.size()));
  for (std::size_t j = 0; j < specimens.size(); ++j) {
    if (specimens[j].size() != specimens[0].size())
      throw Error("band: expected as many parameters from every specimen");
    data.col(static_cast<Eigen::Index>(j)) = Eigen::Map<const Vector>(specimens[j].data(), rows);
  }
  return data;
}

std::vector<double> as_list(const Vector& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

MeanWithBand band_of(const std::vector<std::vector<double>>& specimens, const BandOptions& options) {
  const Matrix data = as_matrix(specimens);
  const Vector mean = data.rowwise().mean();
  MeanWithBand out{as_list(mean), {}, {}, {}};
  const auto n = static_cast<double>(data.cols());
  if (n < 2) return out;
  Matrix means = drawn_means(data, options.draws, options.seed);
  means.colwise() -= Vector(means.rowwise().mean());
  Matrix covariance = means * means.transpose() / (options.draws - 1) * (n / (n - 1));
  if (!options.common.empty()) {
    const Vector shared = Eigen::Map<const Vector>(options.common.data(), mean.size()).cwiseProduct(mean);
    covariance += shared * shared.transpose();
  }
  const double t = student_quantile((1 + options.level) / 2, n - 1);
  const Vector half = t * covariance.diagonal().cwiseSqrt();
  out.low = as_list(mean - half);
  out.high = as_list(mean + half);
  out.covariance = as_list(covariance.reshaped());
  return out;
}

namespace {

// A draw z of the normal distribution, carried over to one in which `below` and `above` are the distances of
// the ends of the band from the value, in quantiles of the normal distribution: monotone in z, so that
// correlations stay.
double carried(double z, double below, double above) {
  const double apart = below + above;
  if (below < 0 || above < 0 || std::abs(above - below) <= 1e-9 * apart) return z * apart / 2;
  const double rank = std::erfc(-z / std::sqrt(2.0)) / 2, under = below / apart;
  const auto tail = [](double p) { return normal_quantile(std::clamp(p, 1e-300, 0.5)); };
  return rank < under ? below * tail(rank / under / 2) : -above * tail((1 - rank) / (1 - under) / 2);
}

}  // namespace

std::vector<double> draw_around(const std::vector<double>& value, const std::vector<double>& low,
                                const std::vector<double>& high, const std::vector<double>& covariance,
                                double level, std::mt19937_64& random) {
  const auto n = static_cast<Eigen::Index>(value.size());
  const Matrix C = Eigen::Map<const Matrix>(covariance.data(), n, n);
  const Vector deviation = C.diagonal().cwiseSqrt();
  const Vector scale = deviation.unaryExpr([](double d) { return d > 0 ? 1 / d : 0.0; });
  // The square root by eigenvalues also works for a singular covariance (few specimens, many parameters).
  const Eigen::SelfAdjointEigenSolver<Matrix> modes(scale.asDiagonal() * C * scale.asDiagonal());
  std::normal_distribution<double> normal;
  Vector z = Vector::NullaryExpr(n, [&] { return normal(random); });
  z = modes.eigenvectors() * modes.eigenvalues().cwiseMax(0).cwiseSqrt().cwiseProduct(z);
  const double quantile = normal_quantile((1 + level) / 2);
  std::vector<double> out(value);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += carried(z(static_cast<Eigen::Index>(i)), (value[i] - low[i]) / quantile,
                      (high[i] - value[i]) / quantile);
  return out;
}

std::vector<double> sobol_points(std::size_t count, std::size_t dimensions, std::uint64_t seed) {
  if (dimensions == 0 || dimensions > most_dimensions)
    throw Error("sobol: expected 1 to " + std::to_string(most_dimensions) + " names, got " +
                std::to_string(dimensions));
  boost::random::sobol_engine<std::uint64_t, 53> sequence(dimensions);
  std::mt19937_64 random(seed);
  std::vector<double> shift(dimensions, 0.0), points;
  if (seed != 0)
    for (double& s : shift) s = std::ldexp(static_cast<double>(random() >> 11), -53);
  points.reserve(count * dimensions);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < dimensions; ++k) {
      const bool origin = i == 0 && seed != 0;
      const double p = std::ldexp((origin ? 0.0 : static_cast<double>(sequence())) + 0.5, -53) + shift[k];
      points.push_back(p < 1 ? p : p - 1);
    }
  return points;
}

double normal_quantile(double p) { return boost::math::quantile(boost::math::normal(), p); }

}  // namespace fabricsh::lab
