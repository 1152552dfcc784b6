#include "mesh/smoothing.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace fabricsh::mesh {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// One over x, and its tangent from there below a least value, so that elements turned inside out have a
// price.
double price(double x, double least) { return x > least ? 1 / x : (2 - x / least) / least; }

class Smoother {
 public:
  Smoother(std::vector<Vec2>& nodes, const std::vector<std::array<Index, 4>>& elements)
      : nodes_(nodes), elements_(elements), around_(nodes.size()) {
    double sum = 0;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      for (const Index id : elements[e]) around_[at(id)].push_back(e);
      sum += area(e);
    }
    mean_ = sum / static_cast<double>(elements.size());
  }

  // By trial in eight directions, over shares of the shortest distance that become smaller.
  void move(Index node) {
    Vec2& x = nodes_[at(node)];
    double now = cost(node), step = 0.2 * shortest(node);
    for (int k = 0; k < 5; ++k, step /= 2)
      for (const Vec2& way : ways) {
        const Vec2 was = x;
        x += step * way;
        const double then = cost(node);
        // The margin leaves a node where it is if rounding alone would tell.
        if (then < now * (1 - 1e-6))
          now = then;
        else
          x = was;
      }
  }

 private:
  static constexpr double diagonal = 0.70710678118654752;
  inline static const std::array<Vec2, 8> ways{Vec2{1, 0},
                                               Vec2{0, 1},
                                               Vec2{-1, 0},
                                               Vec2{0, -1},
                                               Vec2{diagonal, diagonal},
                                               Vec2{-diagonal, diagonal},
                                               Vec2{-diagonal, -diagonal},
                                               Vec2{diagonal, -diagonal}};

  const Vec2& corner(std::size_t e, std::size_t i) const { return nodes_[at(elements_[e][i % 4])]; }

  double area(std::size_t e) const {
    return cross(corner(e, 2) - corner(e, 0), corner(e, 3) - corner(e, 1)) / 2;
  }

  // By trial the share of the areas: from 0 to 16 the explicit step over some panels grows by an eighth, and
  // the mean of the smallest angles falls from 47 to 44 degrees.
  double cost(Index node) const {
    double sum = 0;
    for (const std::size_t e : around_[at(node)]) {
      sum += 4 * price(area(e) / mean_, 0.1);
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = corner(e, i + 1) - corner(e, i), b = corner(e, i + 3) - corner(e, i);
        sum += price(2 * cross(a, b) / (a.squaredNorm() + b.squaredNorm()), 0.05);
      }
    }
    return sum;
  }

  double shortest(Index node) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t e : around_[at(node)])
      for (const Index id : elements_[e])
        if (id != node) least = std::min(least, (nodes_[at(id)] - nodes_[at(node)]).norm());
    return least;
  }

  std::vector<Vec2>& nodes_;
  const std::vector<std::array<Index, 4>>& elements_;
  std::vector<std::vector<std::size_t>> around_;
  double mean_ = 0;  // area of an element
};

}  // namespace

void smooth(std::vector<Vec2>& nodes, const std::vector<std::array<Index, 4>>& elements,
            const std::vector<Index>& free) {
  constexpr int sweeps = 12;
  Smoother smoother(nodes, elements);
  for (int i = 0; i < sweeps; ++i)
    for (const Index node : free) smoother.move(node);
}

}  // namespace fabricsh::mesh
