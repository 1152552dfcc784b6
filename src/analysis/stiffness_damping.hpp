// Rayleigh's second part: forces b K_M v, K_M the law's part of the tangent when the step begins
// [williams2010, eq. 5.71, Box 5-2]. On the unknowns.
#pragma once
#include <span>
#include <vector>

#include "mechanics/assembly.hpp"

namespace fabricsh::analysis {

class StiffnessDamping {
 public:
  StiffnessDamping(mechanics::Assembly& assembly, double b);  // b: s, 0: none
  bool on() const { return b_ > 0; }
  // K_M of the trial configuration, which is the committed one; driven: rates of the driven freedoms. False:
  // the law failed.
  bool start(std::span<const double> driven);
  // f = b K_M v, N and N m, of rates v.
  void force(std::span<const double> v, std::vector<double>& f) const;
  // K += c b K_M.
  void add(double c, linear::Matrix& K) const;

 private:
  mechanics::Assembly& assembly_;
  double b_;
  linear::Matrix K_;
  std::vector<double> product_;  // K_M on the driven freedoms' rates
};

}  // namespace fabricsh::analysis
