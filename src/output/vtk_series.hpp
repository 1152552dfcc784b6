// A run as a VTK series for ParaView: one .vtu a frame, and the .pvd that names them.
#pragma once
#include <string>
#include <vector>

#include "files/pvd.hpp"
#include "output/series.hpp"

namespace fabricsh::output {

class VtkSeries final : public Series {
 public:
  // fields: some of field_names(), empty for all. Errors: unknown field (with the list); a folder that can't
  // be written.
  VtkSeries(const std::string& stem, std::vector<std::string> fields);
  // Goes on with the series that another program has left, from where it was kept.
  VtkSeries(const std::string& stem, std::vector<std::string> fields, Archive& from);
  void sync() override { series_.sync(); }
  std::vector<std::string> lost() const override { return series_.lost(); }

 private:
  void write(const analysis::Run& run) override;
  void cut(std::size_t frames) override { series_.keep(frames); }
  void keep_place(Archive& archive) override;
  void check_fields() const;
  bool wants(const std::string& field) const;
  files::PvdSeries series_;
  std::vector<std::string> fields_;
};

// At nodes: displacement (m), velocity (m/s; runs in motion) and director. In elements, averages over the
// reference volume in material axes: E, S (Pa; the order 11 22 23 13 12, tensor components), residual (E_r of
// warp and weft), slack, energy (stored and dissipated, J/m^3), and the yarns' directions warp and weft in
// the current configuration.
const std::vector<std::string>& field_names();

}  // namespace fabricsh::output
