#include "files/pvd.hpp"

#include <cstdio>
#include <filesystem>

#include "base/error.hpp"
#include "files/gate.hpp"
#include "files/number.hpp"

namespace fabricsh::files {

namespace {

std::string without_extension(const std::string& stem) {
  return stem.ends_with(".pvd") ? stem.substr(0, stem.size() - 4) : stem;
}

std::string xml(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

}  // namespace

PvdSeries::PvdSeries(const std::string& stem) : stem_(without_extension(stem)), path_(stem_ + ".pvd") {
  if (file_name(stem_).empty()) throw Error("series '" + stem + "': expected a name such as out/drape");
  write_index();
}

std::string PvdSeries::frame_path(std::size_t i) const {
  char count[32];
  std::snprintf(count, sizeof count, "_%05zu.vtu", i);
  return stem_ + count;
}

void PvdSeries::frame(double time, const Grid& grid) {
  const std::string path = frame_path(entries_.size());
  write_vtu(path, grid, Sync::no);
  entries_.push_back("    <DataSet timestep=\"" + short_number(time) + "\" file=\"" + xml(file_name(path)) +
                     "\"/>\n");
  write_index();
}

void PvdSeries::keep(std::size_t n) {
  const std::size_t before = entries_.size();
  if (n >= before) return;
  entries_.resize(n);
  write_index();
  for (std::size_t i = n; i < before; ++i) Gate::of_process().discard(frame_path(i));
}

void PvdSeries::write_index() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"0.1\">\n"
      "  <Collection>\n";
  for (const std::string& entry : entries_) text += entry;
  write_file(path_, text + "  </Collection>\n</VTKFile>\n", Sync::no);
}

}  // namespace fabricsh::files
