// A run as a VTK series for ParaView: one .vtu a frame, and the .pvd that names them.
#pragma once
#include <string>
#include <vector>

#include "format/pvd.hpp"
#include "format/vtu.hpp"
#include "run/result_fields.hpp"
#include "run/series.hpp"

namespace fabricsh::run {

class VtkSeries final : public Series {
 public:
  // fields: names of run::find_field(), empty for the usual ones. A name of one number of a tensor or
  // pair
  // ("E12") writes that number alone into the array of its field. Errors: unknown field (with the list); a
  // folder that can't be written.
  VtkSeries(const std::string& stem, std::vector<std::string> fields);
  // Goes on with the series that another program has left, from where it was kept.
  VtkSeries(const std::string& stem, std::vector<std::string> fields, Archive& from);
  void sync() override { series_.sync(); }
  std::vector<std::string> lost() const override { return series_.lost(); }

 private:
  void write(const run::Run& run) override;
  void cut(std::size_t frames) override { series_.keep(frames); }
  void keep_place(Archive& archive) override;
  void check_fields() const;
  static std::vector<format::PvdPart> bodies_of(const run::Run& run);
  format::Array chosen(const run::Run& run, const run::ResultField& field) const;
  format::PvdSeries series_;
  std::vector<std::string> fields_;
};

// A field of a run as an array of a file.
format::Array array_of(const run::Run& run, const run::ResultField& field);

}  // namespace fabricsh::run
