// A run as a VTK series for ParaView: one .vtu per frame, and the .pvd that lists them.
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
  // fields: names for run::find_field(); empty: the usual ones. The name of one
  // value of a tensor or pair ("E12") writes only that value, in the array of its
  // field. Errors: unknown field (with the list); a folder that cannot be
  // written.
  VtkSeries(const std::string& stem, std::vector<std::string> fields);
  // Continues the series of an earlier program from its stored state.
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

// A field of a run as an array for a file.
format::Array array_of(const run::Run& run, const run::ResultField& field);

}  // namespace fabricsh::run
