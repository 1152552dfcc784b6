// A time series of grids: <stem>.pvd, to be opened in ParaView, and <stem>_00000.vtu and so on.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "format/vtu.hpp"

namespace fabricsh::format {

// The state of a series, for a program that continues it after a restart.
struct PvdPlace {
  struct PvdFrame {
    std::string entry;  // its line in the .pvd; empty: the frame is lost, and the series continues without it
    FileSum file;
    void keep(Archive& archive) { archive(entry, file); }
  };
  std::vector<PvdFrame> frames;
  void keep(Archive& archive) { archive(frames); }
};

// An object shown together with the grid of a frame, in a file of its own: stem_name_00000.vtu.
struct PvdPart {
  std::string name;
  std::vector<Vec3> points;                 // m
  std::vector<std::array<Index, 4>> cells;  // as in a grid
  std::vector<Array> point_data = {};
};

class PvdSeries {
 public:
  // stem: "out/drape"; a trailing ".pvd" is removed. An empty series is written
  // at once, so that an unwritable folder is noticed before the run begins.
  explicit PvdSeries(const std::string& stem);
  // Continues the series of an earlier program: frames after `place` are removed,
  // deleted ones are skipped (see lost()). Error: the content of a frame has changed.
  PvdSeries(const std::string& stem, const PvdPlace& place);
  // Writes the grid to the next .vtu, then replaces the .pvd that names it, so that the series is valid
  // at any instant. Error: the folder is gone, another series was begun at this path, or a system error.
  void frame(double time, const VtuGrid& grid, const std::vector<PvdPart>& parts = {});
  void keep(std::size_t n);  // removes all frames but the first n
  void sync();               // forces the frames to the disk
  const PvdPlace& place() const { return place_; }
  PvdPlace place(std::size_t frames) const;  // as if there were only the first ones
  const std::string& path() const { return path_; }
  std::size_t frames() const { return place_.frames.size(); }
  const std::vector<std::string>& lost() const { return lost_; }  // missing when the series was continued

 private:
  void look_at_frame(std::size_t i);
  std::string frame_path(std::size_t i, const std::string& part = {}) const;
  void write_index(system::Folder folder);
  void check_place() const;
  void remove_frames(std::size_t from) const;

  std::string stem_, path_;
  PvdPlace place_;
  std::vector<std::string> lost_;
  std::vector<std::string> parts_;  // names of the parts in the frames written here
  std::size_t synced_ = 0;          // number of frames forced to the disk
  // Identifies the .pvd as last written: device, file number, size,
  // seconds and nanoseconds of its last change; empty: unknown.
  std::vector<std::int64_t> mark_;
};

}  // namespace fabricsh::format
