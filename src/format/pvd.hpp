// A series of grids in time: <stem>.pvd, which ParaView opens, and <stem>_00000.vtu and on.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "format/vtu.hpp"

namespace fabricsh::format {

// How far a series has come, for a program that continues it.
struct PvdPlace {
  struct Frame {
    std::string entry;  // its line of the .pvd; empty: the frame is lost, and the series goes on without it
    FileSum file;
    void keep(Archive& archive) { archive(entry, file); }
  };
  std::vector<Frame> frames;
  void keep(Archive& archive) { archive(frames); }
};

// What stands beside the grid of a frame: shown with it, in a file of its own, stem_name_00000.vtu.
struct PvdPart {
  std::string name;
  std::vector<Vec3> points;                 // m
  std::vector<std::array<Index, 4>> cells;  // as those of a grid
};

class PvdSeries {
 public:
  // stem: "out/drape"; a trailing ".pvd" is taken off. Writes a series without frames at once, so that a
  // folder that cannot be written is known before the run begins.
  explicit PvdSeries(const std::string& stem);
  // Goes on with the series that another program has left: frames behind the place are taken off, one that
  // was deleted is passed over (see lost()). Error: a frame is not as it was written.
  PvdSeries(const std::string& stem, const PvdPlace& place);
  // The grid goes to the next .vtu, then the .pvd that names it is replaced: it is valid at any instant.
  // Error: the folder is gone, another series has been begun on the same path, and what the system says.
  void frame(double time, const Grid& grid, const std::vector<PvdPart>& parts = {});
  void keep(std::size_t n);  // takes off all frames but the first n
  void sync();               // to the disk
  const PvdPlace& place() const { return place_; }
  const std::string& path() const { return path_; }
  std::size_t frames() const { return place_.frames.size(); }
  const std::vector<std::string>& lost() const { return lost_; }  // frames that were gone when it went on

 private:
  void look_at_frame(std::size_t i);
  std::string frame_path(std::size_t i, const std::string& part = {}) const;
  void write_index(system::Folder folder);
  void check_place() const;
  void remove_frames(std::size_t from) const;

  std::string stem_, path_;
  PvdPlace place_;
  std::vector<std::string> lost_;
  std::vector<std::string> parts_;  // names, of the frames that were written here
  std::size_t synced_ = 0;          // frames
  // The .pvd as it was last written: device, number, size, seconds and nanoseconds of its change; empty: not
  // known.
  std::vector<std::int64_t> mark_;
};

}  // namespace fabricsh::format
