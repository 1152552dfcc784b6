// Gmsh .msh: the sections and physical groups, which both versions of the format have.
#include "format/gmsh.hpp"

#include <algorithm>

#include "format/mesh_file.hpp"

namespace fabricsh::format {

mesh::Mesh GmshReader::read() {
  if (source_.word("$MeshFormat") != "$MeshFormat")
    source_.fail("expected a Gmsh file, which begins with $MeshFormat");
  read_format();
  for (auto word = source_.word_or_none(); !word.empty(); word = source_.word_or_none()) {
    if (word.front() != '$' || word.size() < 2)
      source_.fail("expected a section ($Nodes, $Elements, ...), got " + in_quotes(word));
    section(word.substr(1));
  }
  if (!seen_.contains("Nodes")) source_.fail("the file has no section $Nodes");
  if (!seen_.contains("Elements")) source_.fail("the file has no section $Elements");
  add_sets();
  return builder_.finish();
}

void GmshReader::read_format() {
  const auto version = source_.word("the version of the format");
  if (version == "4.1")
    format_ = 4;
  else if (version == "2" || version.starts_with("2."))
    format_ = 2;
  else
    source_.fail("expected format 2.2 or 4.1 (in Gmsh: Mesh.MshFileVersion), got " + in_quotes(version));
  const auto mode = source_.integer("the file type, 0 or 1");
  if (mode != 0 && mode != 1)
    source_.fail("expected the file type 0 (text) or 1 (binary), got " + std::to_string(mode));
  binary_ = mode == 1;
  const auto size = source_.integer("the size of a number, 8");
  if (size != 8 && !(size == 4 && format_ == 4))
    source_.fail("expected numbers of 8 bytes, got " + std::to_string(size));
  long_sizes_ = size == 8;
  if (binary_) read_byte_order();
  end_section("MeshFormat");
}

// A binary file contains the integer 1 in its own byte order.
void GmshReader::read_byte_order() {
  source_.line("the number 1");
  const auto one = source_.raw<std::uint32_t>("the number 1");
  if (one != 1 && one != 0x01000000)
    source_.fail("expected the number 1 in binary, got " + std::to_string(one));
  source_.swap_bytes(one != 1);
}

void GmshReader::section(std::string_view name) {
  const bool ours = name == "PhysicalNames" || name == "Nodes" || name == "Elements" ||
                    ((name == "Entities" || name == "PartitionedEntities") && format_ == 4);
  if (!ours) return skip_section(name);
  if (!seen_.emplace(name).second) source_.fail("a second section $" + std::string(name));
  if (name == "PhysicalNames") {
    read_names();
  } else {
    source_.line("a section");
    source_.set_binary(binary_);
    if (name == "Entities") read_entities_4();
    if (name == "PartitionedEntities") read_partitioned_4();
    if (name == "Nodes") format_ == 4 ? read_nodes_4() : read_nodes_2();
    if (name == "Elements") format_ == 4 ? read_elements_4() : read_elements_2();
    source_.set_binary(false);
  }
  end_section(std::string(name));
}

void GmshReader::skip_section(std::string_view name) {
  const std::string end = "$End" + std::string(name);
  const auto found = source_.rest().find("\n" + end);
  if (found == std::string_view::npos) source_.fail("section " + in_quotes(name) + " has no end");
  source_.move_to(source_.place() + found + 1 + end.size());
}

void GmshReader::end_section(const std::string& name) {
  const auto word = source_.word(("$End" + name).c_str());
  if (word != "$End" + name) source_.fail("expected $End" + name + ", got " + in_quotes(word));
}

void GmshReader::read_names() {
  const auto n = source_.count("a number of physical names", 6);
  for (std::int64_t i = 0; i < n; ++i) {
    const auto dimension = source_.integer("a dimension");
    const auto group = source_.integer("the number of a physical group");
    auto name = source_.line("a name in quotes");
    while (name.starts_with(' ') || name.starts_with('\t')) name.remove_prefix(1);
    const auto end = name.rfind('"');
    if (!name.starts_with('"') || end < 2 || end == std::string_view::npos)
      source_.fail("expected a name in quotes, got " + in_quotes(name));
    names_[{dimension, group}] = std::string(name.substr(1, end - 1));
  }
}

std::string GmshReader::group_name(std::int64_t dimension, std::int64_t group) const {
  const auto found = names_.find({dimension, group});
  if (found != names_.end()) return found->second;
  return std::array{"point_", "curve_", "surface_"}[static_cast<std::size_t>(dimension)] +
         std::to_string(group);
}

ElementKind GmshReader::kind(std::int64_t type) const {
  switch (type) {
    case 1:
      return {2, 1};
    case 2:
      return {3, 2};
    case 3:
      return {4, 2};
    case 15:
      return {1, 0};
    case 4:
    case 5:
    case 6:
    case 7:
      source_.fail("element type " + std::to_string(type) + " is a volume: expected a mesh of a surface");
    case 8:
    case 9:
    case 10:
    case 16:
      source_.fail(
          "element type " + std::to_string(type) +
          " is of second order: expected lines, triangles and quadrilaterals of first order (in Gmsh: "
          "Mesh.ElementOrder = 1)");
    default:
      source_.fail("unknown element type " + std::to_string(type) +
                   ": expected 1 (line), 2 (triangle), 3 (quadrilateral) or 15 (point)");
  }
}

// Nodes are looked up here, so that the error for an unknown one names its line.
void GmshReader::add(std::int64_t number, const ElementKind& kind, const Tags& corners, Tags* members) {
  for (const std::int64_t node : corners)
    if (!builder_.has_node(node))
      source_.fail("element " + std::to_string(number) + ": node " + std::to_string(node) +
                   " is not in the file");
  if (kind.dimension == 2) builder_.add_element(number, corners);
  if (members != nullptr) members->insert(members->end(), corners.begin(), corners.end());
}

void GmshReader::add_sets() {
  for (auto& [entity, nodes] : members_) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const std::int64_t group : groups_[entity])
      builder_.add_to_set(group_name(entity.first, group < 0 ? -group : group), nodes);
  }
}

std::int64_t GmshReader::stored_integer(const char* what) {
  return binary_ ? source_.raw<std::int32_t>(what) : source_.integer(what);
}

std::int64_t GmshReader::stored_size(const char* what) {
  if (!binary_) return source_.integer(what);
  return long_sizes_ ? source_.raw<std::int64_t>(what) : source_.raw<std::uint32_t>(what);
}

std::int64_t GmshReader::stored_count(const char* what, std::size_t text_bytes, std::size_t binary_bytes) {
  return source_.checked(what, stored_size(what), binary_ ? binary_bytes : text_bytes);
}

double GmshReader::stored_real(const char* what) {
  return binary_ ? source_.raw<double>(what) : source_.real(what);
}

Vec3 GmshReader::position() {
  Vec3 x;
  for (int i = 0; i < 3; ++i) x[i] = stored_real("a coordinate");
  return x;
}

mesh::Mesh read_gmsh(const std::string& name, std::string_view bytes) {
  return GmshReader(name, bytes).read();
}

}  // namespace fabricsh::format
