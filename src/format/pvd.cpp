#include "format/pvd.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/utf8.hpp"
#include "format/frame_file.hpp"
#include "format/source.hpp"
#include "format/xml.hpp"
#include "system/gate.hpp"

namespace fabricsh::format {

namespace {

std::string without_extension(const std::string& stem) {
  return stem.ends_with(".pvd") ? stem.substr(0, stem.size() - 4) : stem;
}

// Identifies a file, to notice when another one takes its place; empty if there is none or --safe hides it.
std::vector<std::int64_t> mark_of(const std::string& path) {
  struct stat file {};
  try {
    const system::Gate& gate = system::Gate::of_process();
    const system::PathInFolder place = gate.reading(path);
    if (fstatat(place.at(), place.name.c_str(), &file, gate.closed() ? AT_SYMLINK_NOFOLLOW : 0) != 0)
      return {};
  } catch (const Error&) {
    return {};
  }
  return {static_cast<std::int64_t>(file.st_dev), static_cast<std::int64_t>(file.st_ino), file.st_size,
          file.st_mtim.tv_sec, file.st_mtim.tv_nsec};
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

PvdSeries::PvdSeries(const std::string& stem) : stem_(without_extension(stem)), path_(stem_ + ".pvd") {
  if (file_name(stem_).empty()) throw Error("series '" + stem + "': expected a name such as out/drape");
  want_plain(file_name(stem_), "series");
  write_index(system::Folder::make);
  system::remove_leftovers(stem_);
}

PvdSeries::PvdSeries(const std::string& stem, const PvdPlace& place)
    : stem_(without_extension(stem)), path_(stem_ + ".pvd"), place_(place), synced_(frames()) {
  for (std::size_t i = 0; i < frames(); ++i) look_at_frame(i);
  write_index(system::Folder::expect);
  remove_frames(frames());
  system::remove_leftovers(stem_);
}

void PvdSeries::look_at_frame(std::size_t i) {
  PvdPlace::PvdFrame& frame = place_.frames[i];
  if (frame.entry.empty()) return;
  const std::string path = frame_path(i);
  if (!system::Gate::of_process().exists(path)) {
    frame.entry.clear();
    lost_.push_back(path);
    return;
  }
  const FileSum now = sum_of(read_file(path));
  if (now == frame.file) return;
  throw Error("cannot go on with '" + path_ + "': its frame '" + path + "' is not as it was written (" +
              std::to_string(now.size) + " bytes, " + std::to_string(frame.file.size) +
              " were written); where it is deleted, the series goes on without it");
}

std::string PvdSeries::frame_path(std::size_t i, const std::string& part) const {
  char count[32];
  std::snprintf(count, sizeof count, "_%05zu.vtu", i);
  return stem_ + (part.empty() ? "" : "_") + part + count;
}

void PvdSeries::frame(double time, const VtuGrid& grid, const std::vector<PvdPart>& parts) {
  check_place();
  const std::string path = frame_path(frames());
  const FileSum file = write_vtu(path, grid, system::Sync::no, system::Folder::expect);
  const std::string start = "    <DataSet timestep=\"" + exact_number(time) + "\"";
  std::string entry = start + " file=\"" + escaped(file_name(path)) + "\"/>\n";
  parts_.clear();
  for (const PvdPart& part : parts) {
    std::string name = part.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == '/'; }, '-');
    parts_.push_back(name);
    const std::string beside = frame_path(frames(), name);
    VtuGrid shape{part.points, part.cells};
    shape.point_data = part.point_data;
    shape.time = time;
    write_vtu(beside, shape, system::Sync::no, system::Folder::expect);
    entry += start + " part=\"" + std::to_string(parts_.size()) + "\" file=\"" + escaped(file_name(beside)) +
             "\"/>\n";
  }
  place_.frames.push_back({entry, file});
  try {
    write_index(system::Folder::expect);
  } catch (...) {
    place_.frames.pop_back();
    system::Gate::of_process().discard(path);
    throw;
  }
}

PvdPlace PvdSeries::place(std::size_t n) const {
  PvdPlace place = place_;
  place.frames.resize(std::min(n, frames()));
  return place;
}

void PvdSeries::keep(std::size_t n) {
  if (n >= frames()) return;
  check_place();
  place_.frames.resize(n);
  synced_ = std::min(synced_, n);
  write_index(system::Folder::expect);
  remove_frames(n);
}

void PvdSeries::sync() {
  for (; synced_ < frames(); ++synced_) system::sync_file(frame_path(synced_));
  system::sync_file(path_);
}

// Removes the frame with this number and those that follow it without a gap.
void PvdSeries::remove_frames(std::size_t from) const {
  for (bool gone = true; gone; ++from) {
    for (const std::string& part : parts_) system::Gate::of_process().discard(frame_path(from, part));
    gone = system::Gate::of_process().discard(frame_path(from));
  }
}

// Checks that the .pvd is still the one written by this series. If it was removed, it is written again.
void PvdSeries::check_place() const {
  const auto now = mark_of(path_);
  if (now.empty() || mark_.empty() || now == mark_) return;
  throw Error("cannot write '" + path_ + "': another file has taken its place");
}

void PvdSeries::write_index(system::Folder folder) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\">\n"
      "  <Collection>\n";
  for (const PvdPlace::PvdFrame& frame : place_.frames) text += frame.entry;
  system::write_file(path_, text + "  </Collection>\n</VTKFile>\n", system::Sync::no, folder);
  mark_ = mark_of(path_);
}

std::vector<SeriesEntry> read_pvd(const std::string& name, std::string_view bytes) {
  Source source(name, bytes);
  XmlTags tags(source);
  XmlTag tag;
  std::vector<SeriesEntry> entries;
  bool head = false;
  while (tags.next(tag)) {
    if (!tag.opens) continue;
    if (!head && (tag.name != "VTKFile" || tag.attributes["type"] != "Collection"))
      source.fail("expected a .pvd file, which begins with <VTKFile type=\"Collection\">");
    head = true;
    if (tag.name != "DataSet") continue;
    SeriesEntry entry;
    if (!parse(tag.attributes["timestep"], entry.time) || tag.attributes["file"].empty())
      source.fail("<DataSet>: expected timestep=\"a number\" and file=\"a name\"");
    const std::string part = tag.attributes["part"];
    if (!part.empty() && !parse(part, entry.part)) source.fail("<DataSet>: expected part=\"a whole number\"");
    entry.file = tag.attributes["file"];
    entries.push_back(std::move(entry));
  }
  if (!head) source.fail("expected a .pvd file, which begins with <VTKFile type=\"Collection\">");
  return entries;
}

}  // namespace fabricsh::format
