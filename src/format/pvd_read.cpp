// ParaView's .pvd: times and names of files.
#include "format/frame_file.hpp"
#include "format/xml.hpp"

namespace fabricsh::format {

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
