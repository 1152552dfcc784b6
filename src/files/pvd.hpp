// A series of grids in time: <stem>.pvd, which ParaView opens, and <stem>_00000.vtu and on.
#pragma once
#include <string>
#include <vector>

#include "files/vtu.hpp"

namespace fabricsh::files {

class PvdSeries {
 public:
  // stem: "out/drape"; a trailing ".pvd" is taken off. Writes a series without frames at once, so that a
  // folder that cannot be written is known before the run begins.
  explicit PvdSeries(const std::string& stem);
  // The grid goes to the next .vtu, then the .pvd that names it is replaced: it is valid at any instant.
  void frame(double time, const Grid& grid);
  void keep(std::size_t n);  // takes off all frames but the first n
  const std::string& path() const { return path_; }
  std::size_t frames() const { return entries_.size(); }

 private:
  std::string frame_path(std::size_t i) const;
  void write_index() const;

  std::string stem_, path_;
  std::vector<std::string> entries_;  // one line of the .pvd each
};

}  // namespace fabricsh::files
