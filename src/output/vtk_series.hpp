// A run as a VTK series for ParaView: one .vtu a frame, and the .pvd that names them.
#pragma once
#include <string>
#include <vector>

#include "analysis/run.hpp"
#include "files/pvd.hpp"

namespace fabricsh::output {

class VtkSeries {
 public:
  // fields: some of field_names(), empty for all. Errors: unknown field (with the list); a folder that can't
  // be written.
  VtkSeries(const std::string& stem, std::vector<std::string> fields);
  // The state that the analysis holds now. A frame of the step of the last one is not written again.
  void frame(const analysis::Run& run);
  void rewind(std::size_t step);  // takes off the frames later than a step
  const std::string& path() const { return series_.path(); }

 private:
  bool wants(const std::string& field) const;
  files::PvdSeries series_;
  std::vector<std::string> fields_;
  std::vector<std::size_t> steps_;  // of the frames
};

// At nodes: displacement (m), velocity (m/s; runs in motion) and director. In elements, averages over the
// reference volume in material axes: E, S (Pa; the order 11 22 23 13 12, tensor components), residual (E_r of
// warp and weft), slack, energy (stored and dissipated, J/m^3), and the yarns' directions warp and weft in
// the current configuration.
const std::vector<std::string>& field_names();

}  // namespace fabricsh::output
