// Gmsh .msh, formats 2 and 4.1, text and binary. Format: Gmsh reference manual, "MSH file format". Physical
// groups become sets.
#include <algorithm>
#include <map>
#include <set>

#include "format/mesh_builder.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

struct ElementKind {
  int nodes;      // 0: this kind of element is not supported
  int dimension;  // 2: becomes an element; 0 and 1: used for sets only
};

class GmshReader {
 public:
  GmshReader(const std::string& name, std::string_view bytes)
      : source_(name, bytes), builder_(source_, 16 * bytes.size()) {}

  mesh::Mesh read() {
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

 private:
  using Tags = std::vector<std::int64_t>;
  using Key = std::pair<std::int64_t, std::int64_t>;  // dimension and number of an entity or physical group

  void read_format() {
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
  void read_byte_order() {
    source_.line("the number 1");
    const auto one = source_.raw<std::uint32_t>("the number 1");
    if (one != 1 && one != 0x01000000)
      source_.fail("expected the number 1 in binary, got " + std::to_string(one));
    source_.swap_bytes(one != 1);
  }

  void section(std::string_view name) {
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

  void skip_section(std::string_view name) {
    const std::string end = "$End" + std::string(name);
    const auto found = source_.rest().find("\n" + end);
    if (found == std::string_view::npos) source_.fail("section " + in_quotes(name) + " has no end");
    source_.move_to(source_.place() + found + 1 + end.size());
  }
  void end_section(const std::string& name) {
    const auto word = source_.word(("$End" + name).c_str());
    if (word != "$End" + name) source_.fail("expected $End" + name + ", got " + in_quotes(word));
  }

  void read_names() {
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

  ElementKind kind(std::int64_t type) const {
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
  void add(std::int64_t number, const ElementKind& kind, const Tags& corners, Tags* members) {
    for (const std::int64_t node : corners)
      if (!builder_.has_node(node))
        source_.fail("element " + std::to_string(number) + ": node " + std::to_string(node) +
                     " is not in the file");
    if (kind.dimension == 2) builder_.add_element(number, corners);
    if (members != nullptr) members->insert(members->end(), corners.begin(), corners.end());
  }
  // The first tag is the physical group (0: none); here each group is treated as an entity of its own.
  Tags* members_2(int dimension, const Tags& tags) {
    if (tags.empty() || tags[0] == 0) return nullptr;
    groups_[{dimension, tags[0]}] = {tags[0]};
    return &members_[{dimension, tags[0]}];
  }
  void add_sets() {
    for (auto& [entity, nodes] : members_) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      for (const std::int64_t group : groups_[entity])
        builder_.add_to_set(group_name(entity.first, group < 0 ? -group : group), nodes);
    }
  }
  std::string group_name(std::int64_t dimension, std::int64_t group) const {
    const auto found = names_.find({dimension, group});
    if (found != names_.end()) return found->second;
    return std::array{"point_", "curve_", "surface_"}[static_cast<std::size_t>(dimension)] +
           std::to_string(group);
  }
  Vec3 position() {
    Vec3 x;
    for (int i = 0; i < 3; ++i) x[i] = stored_real("a coordinate");
    return x;
  }

  // Format 2.
  void read_nodes_2() {
    source_.set_binary(false);
    const auto n = source_.count("a number of nodes", binary_ ? 28 : 8);
    if (binary_) source_.line("the nodes");
    source_.set_binary(binary_);
    for (std::int64_t i = 0; i < n; ++i) {
      const auto number = stored_integer("the number of a node");
      builder_.add_node(number, position());
    }
  }

  void read_elements_2() {
    source_.set_binary(false);
    const auto n = source_.count("a number of elements", 8);
    if (binary_) source_.line("the elements");
    source_.set_binary(binary_);
    for (std::int64_t i = 0; i < n;)
      if (binary_) {
        i += read_block_2(n - i);
      } else {
        read_text_element_2();
        ++i;
      }
  }

  // Line format: number type tags... nodes...
  void read_text_element_2() {
    const auto number = source_.integer("the number of an element");
    const ElementKind kind = this->kind(source_.integer("the type of an element"));
    Tags tags(static_cast<std::size_t>(source_.count("a number of tags", 2)));
    for (auto& tag : tags) tag = source_.integer("a tag");
    Tags corners(static_cast<std::size_t>(kind.nodes));
    for (auto& corner : corners) corner = source_.integer("the number of a node");
    add(number, kind, corners, members_2(kind.dimension, tags));
  }

  // A block begins with type, number of elements and number of tags; the elements follow.
  std::int64_t read_block_2(std::int64_t most) {
    const ElementKind kind = this->kind(stored_integer("the type of an element"));
    const auto n = stored_integer("a number of elements");
    const auto tag_count = source_.checked("a number of tags", stored_integer("a number of tags"), 4);
    if (n < 1 || n > most)
      source_.fail("expected 1 to " + std::to_string(most) + " elements, got " + std::to_string(n));
    Tags tags(static_cast<std::size_t>(tag_count)), corners(static_cast<std::size_t>(kind.nodes));
    for (std::int64_t i = 0; i < n; ++i) {
      const auto number = stored_integer("the number of an element");
      for (auto& tag : tags) tag = stored_integer("a tag");
      for (auto& corner : corners) corner = stored_integer("the number of a node");
      add(number, kind, corners, members_2(kind.dimension, tags));
    }
    return n;
  }

  // Format 4.1.
  void read_entities_4() {
    std::int64_t counts[4];
    for (auto& count : counts) count = stored_count("a number of entities", 4, 20);
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[dimension]; ++i) read_entity_4(dimension);
  }

  // An entity: number, position or bounding box, physical groups, entities on its border.
  void read_entity_4(int dimension) {
    const auto number = stored_integer("the number of an entity");
    Tags groups = read_shape_4(dimension);
    if (dimension < 3) groups_[{dimension, number}] = std::move(groups);
  }

  // In a mesh cut into parts the elements belong to the parts of entities.
  void read_partitioned_4() {
    stored_size("a number of partitions");
    const auto ghosts = stored_count("a number of ghost entities", 4, 8);
    for (std::int64_t i = 0; i < 2 * ghosts; ++i) stored_integer("a ghost entity");
    std::int64_t counts[4];
    for (auto& count : counts) count = stored_count("a number of entities", 4, 32);
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[dimension]; ++i) read_part_4(dimension);
  }

  // The part of an entity: number, dimension and number of the entity, partitions, and the rest as of an
  // entity. Without groups of its own it has those of the entity.
  void read_part_4(int dimension) {
    const auto number = stored_integer("the number of an entity");
    const auto parent_dimension = stored_integer("a dimension"),
               parent = stored_integer("the number of an entity");
    const auto partitions = stored_count("a number of partitions", 2, 4);
    for (std::int64_t i = 0; i < partitions; ++i) stored_integer("a partition");
    Tags groups = read_shape_4(dimension);
    const auto whole = groups_.find({parent_dimension, parent});
    if (groups.empty() && parent_dimension == dimension && whole != groups_.end()) groups = whole->second;
    if (dimension < 3) groups_[{dimension, number}] = std::move(groups);
  }

  // Position or bounding box, physical groups, entities on its border.
  Tags read_shape_4(int dimension) {
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) stored_real("a coordinate");
    Tags groups(static_cast<std::size_t>(stored_count("a number of physical groups", 2, 4)));
    for (auto& group : groups) group = stored_integer("the number of a physical group");
    const auto n = dimension > 0 ? stored_count("a number of bordering entities", 2, 4) : 0;
    for (std::int64_t i = 0; i < n; ++i) stored_integer("the number of an entity");
    return groups;
  }
  void read_nodes_4() {
    const auto blocks = stored_count("a number of blocks", 8, 20);
    const auto n = stored_count("a number of nodes", 8, 28);
    stored_size("the smallest number of a node");
    stored_size("the largest number of a node");
    for (std::int64_t i = 0; i < blocks; ++i) read_node_block_4();
    if (static_cast<std::int64_t>(builder_.nodes()) != n)
      source_.fail("expected " + std::to_string(n) + " nodes in all, got " +
                   std::to_string(builder_.nodes()));
  }

  // All numbers, then all positions; a parametric block has more coordinates, one per dimension.
  void read_node_block_4() {
    const auto dimension = stored_integer("a dimension");
    stored_integer("the number of an entity");
    const auto parametric = stored_integer("0 or 1 for parametric");
    if (dimension < 0 || dimension > 3)
      source_.fail("expected a dimension from 0 to 3, got " + std::to_string(dimension));
    if (parametric != 0 && parametric != 1)
      source_.fail("expected 0 or 1 for parametric, got " + std::to_string(parametric));
    Tags numbers(static_cast<std::size_t>(stored_count("a number of nodes", 8, long_sizes_ ? 32 : 28)));
    for (auto& number : numbers) number = stored_size("the number of a node");
    for (const auto number : numbers) {
      const Vec3 x = position();
      for (std::int64_t i = 0; i < parametric * dimension; ++i) stored_real("a parametric coordinate");
      builder_.add_node(number, x);
    }
  }

  void read_elements_4() {
    const auto blocks = stored_count("a number of blocks", 8, 20);
    const auto n = stored_count("a number of elements", 4, 8);
    stored_size("the smallest number of an element");
    stored_size("the largest number of an element");
    std::int64_t sum = 0;
    for (std::int64_t i = 0; i < blocks; ++i) sum += read_element_block_4();
    if (sum != n)
      source_.fail("expected " + std::to_string(n) + " elements in all, got " + std::to_string(sum));
  }

  std::int64_t read_element_block_4() {
    const auto dimension = stored_integer("a dimension");
    const auto entity = stored_integer("the number of an entity");
    const ElementKind kind = this->kind(stored_integer("the type of an element"));
    if (dimension != kind.dimension)
      source_.fail("expected elements of dimension " + std::to_string(kind.dimension) + ", got " +
                   std::to_string(dimension));
    const auto n = stored_count("a number of elements", 4, 8);
    const auto found = groups_.find({dimension, entity});
    Tags* const members =
        found == groups_.end() || found->second.empty() ? nullptr : &members_[{dimension, entity}];
    Tags corners(static_cast<std::size_t>(kind.nodes));
    for (std::int64_t i = 0; i < n; ++i) {
      const auto number = stored_size("the number of an element");
      for (auto& corner : corners) corner = stored_size("the number of a node");
      add(number, kind, corners, members);
    }
    return n;
  }

  // Numbers as the file stores them: text, or 4 or 8 bytes.
  std::int64_t stored_integer(const char* what) {
    return binary_ ? source_.raw<std::int32_t>(what) : source_.integer(what);
  }
  std::int64_t stored_size(const char* what) {
    if (!binary_) return source_.integer(what);
    return long_sizes_ ? source_.raw<std::int64_t>(what) : source_.raw<std::uint32_t>(what);
  }
  std::int64_t stored_count(const char* what, std::size_t text_bytes, std::size_t binary_bytes) {
    return source_.checked(what, stored_size(what), binary_ ? binary_bytes : text_bytes);
  }
  double stored_real(const char* what) { return binary_ ? source_.raw<double>(what) : source_.real(what); }

  Source source_;
  MeshBuilder builder_;
  bool binary_ = false;
  bool long_sizes_ = true;  // in binary files a size takes 8 bytes
  int format_ = 0;          // 2 or 4
  std::set<std::string, std::less<>> seen_;
  std::map<Key, std::string> names_;  // of physical groups
  std::map<Key, Tags> groups_;        // physical groups of each entity
  std::map<Key, Tags> members_;       // nodes of each entity in a physical group
};

}  // namespace

mesh::Mesh read_gmsh(const std::string& name, std::string_view bytes) {
  return GmshReader(name, bytes).read();
}

}  // namespace fabricsh::format
