#include "law/point.hpp"

#include "base/error.hpp"
#include "law/load_frame.hpp"

namespace fabricsh::law {

namespace {

std::array<double, 5> voigt(const std::array<double, 3>& e) { return {e[0], e[1], 0, 0, 2 * e[2]}; }

}  // namespace

PointDriver::PointDriver(std::shared_ptr<const law::Law> law, const law::Site& site)
    : law_(std::move(law)), site_(site) {
  reset();
}

void PointDriver::reset() {
  committed_.resize(law::state_size(*law_));
  law::set_initial(*law_, site_, committed_.data());
  trial_ = committed_;
  strain_ = {};
  sample_ = {};
  step_ = {};
}

void PointDriver::begin(double over) { step_ = {sample_.time, over}; }

law::Internal PointDriver::internal() const {
  return law::internal(*law_, strain_.data(), committed_.data());
}

bool PointDriver::update(const std::array<double, 3>& e) {
  const auto E = voigt(e);
  return law::evaluate(*law_, step_, E.data(), committed_.data(), trial_.data(), stress_.data(),
                       tangent_.data()) == law::Evaluation::ok;
}

void PointDriver::commit(const std::array<double, 3>& e) {
  committed_.swap(trial_);
  strain_ = voigt(e);
  const auto energy = law::energy(*law_, strain_.data(), committed_.data());
  sample_ = {};
  sample_.time = step_.t0 + step_.dt;
  sample_.S11 = stress_[0];
  sample_.S22 = stress_[1];
  sample_.S12 = stress_[4];
  sample_.E11 = e[0];
  sample_.E22 = e[1];
  sample_.E12 = e[2];
  sample_.stored = energy.stored;
  sample_.dissipated = energy.dissipated();
  sample_.lost = energy.lost;
  sample_.created = energy.created;
}

StressPoint PointDriver::strain(std::optional<double> E11, std::optional<double> E22,
                                std::optional<double> E12, double over) {
  begin(over);
  const std::array<double, 3> e{E11.value_or(strain_[0]), E22.value_or(strain_[1]),
                                E12.value_or(0.5 * strain_[4])};
  if (!update(e)) throw NumericalFailure("the law failed: strain or stress is not a finite number", 0);
  commit(e);
  return sample_;
}

StressPoint PointDriver::uniaxial(double angle, double E, double over) {
  begin(over);
  const auto e = solve_uniaxial(angle, E);
  commit(e);
  const LoadFrame frame(angle);
  sample_.E = E;
  sample_.S = frame.stress({stress_[0], stress_[1], stress_[4]})[0];
  sample_.E_lateral = frame.strain_in(e)[1];
  return sample_;
}

std::vector<StressPoint> PointDriver::path(const std::vector<std::array<double, 4>>& rows) {
  std::vector<StressPoint> out;
  out.reserve(rows.size());
  for (const auto& e : rows) out.push_back(strain(e[0], e[1], e[2], e[3]));
  return out;
}

std::vector<StressPoint> PointDriver::biaxial(double ratio, const std::vector<double>& strains) {
  std::vector<StressPoint> out;
  out.reserve(strains.size());
  for (const double E : strains) out.push_back(strain(E, ratio * E, {}));
  return out;
}

std::vector<StressPoint> PointDriver::uniaxial(double angle, const std::vector<double>& strains,
                                               double over) {
  std::vector<StressPoint> out;
  out.reserve(strains.size());
  for (const double E : strains) out.push_back(uniaxial(angle, E, over));
  return out;
}

}  // namespace fabricsh::law
