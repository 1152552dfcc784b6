// A run as a VTK series for ParaView: one .vtu per frame, and the .pvd that lists them.
#pragma once
#include <string>
#include <vector>

#include "format/pvd.hpp"
#include "run/series.hpp"
#include "run/vtk_frame.hpp"

namespace fabricsh::run {

class VtkSeries final : public Series {
 public:
  // Error: a folder that cannot be written.
  VtkSeries(const std::string& stem, VtkContents contents);
  // Continues the series of an earlier program from its stored state.
  VtkSeries(const std::string& stem, VtkContents contents, Archive& from);
  void sync() override { series_.sync(); }
  std::vector<std::string> lost() const override { return series_.lost(); }

 private:
  void write(const run::Run& run) override;
  void cut(std::size_t frames) override { series_.keep(frames); }
  void keep_place(Archive& archive, std::size_t frames) override;
  static std::vector<format::PvdPart> bodies_of(const run::Run& run);
  format::PvdSeries series_;
  VtkContents contents_;
};

}  // namespace fabricsh::run
