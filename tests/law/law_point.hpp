// One point of a law with its committed state, for tests; and plain random numbers.
#pragma once
#include <array>
#include <memory>
#include <random>

#include "law/law.hpp"

namespace fabricsh::test {

using Strain = std::array<double, 5>;  // E11 E22 2E23 2E13 2E12

struct LawPoint {
  std::shared_ptr<const law::Law> law;
  std::array<double, 32> s{}, trial{};
  Strain E{}, S{};
  std::array<double, 25> C{};
  double over = 0;  // s that a leg of a loop takes

  // The point stands for a millimetre of cloth, where the law asks for that.
  explicit LawPoint(const card::Card& card) : law(law::compile(card)) {
    law::set_initial(*law, {{1e-3, 1e-3}}, s.data());
  }
  bool evaluate(const Strain& e, const law::Step& step = {}) {
    return law::evaluate(*law, step, e.data(), s.data(), trial.data(), S.data(), C.data()) ==
           law::Evaluation::ok;
  }
  bool go(const Strain& e, const law::Step& step = {}) {
    const bool fine = evaluate(e, step);
    E = e;
    s = trial;
    return fine;
  }
  law::EnergyDensity energy() const { return law::energy(*law, E.data(), s.data()); }
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0.0, 1.0)(engine_);
  }
  int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 engine_;
};

}  // namespace fabricsh::test
