// Shared by the readers of both Gmsh formats. Format: Gmsh reference manual, "MSH file format".
#pragma once
#include <map>
#include <set>

#include "format/mesh_builder.hpp"

namespace fabricsh::format {

struct ElementKind {
  int nodes;      // 0: this kind of element is not supported
  int dimension;  // 2: becomes an element; 0 and 1: used for sets only
};

class GmshReader {
 public:
  GmshReader(const std::string& name, std::string_view bytes)
      : source_(name, bytes), builder_(source_, 16 * bytes.size()) {}
  mesh::Mesh read();

 private:
  using Tags = std::vector<std::int64_t>;
  using Key = std::pair<std::int64_t, std::int64_t>;  // dimension and number of an entity or physical group

  void read_format();
  void read_byte_order();
  void section(std::string_view name);
  void skip_section(std::string_view name);
  void end_section(const std::string& name);
  void read_names();
  ElementKind kind(std::int64_t type) const;
  void add(std::int64_t number, const ElementKind& kind, const Tags& corners, Tags* members);
  Tags* members_2(int dimension, const Tags& tags);
  void add_sets();
  std::string group_name(std::int64_t dimension, std::int64_t group) const;
  Vec3 position();

  // Format 2.
  void read_nodes_2();
  void read_elements_2();
  void read_text_element_2();
  std::int64_t read_block_2(std::int64_t most);

  // Format 4.1.
  void read_entities_4();
  void read_entity_4(int dimension);
  void read_partitioned_4();
  void read_part_4(int dimension);
  Tags read_groups_4();
  void read_nodes_4();
  void read_node_block_4();
  void read_elements_4();
  std::int64_t read_element_block_4();

  // Numbers as the file stores them: text, or 4 or 8 bytes.
  std::int64_t stored_integer(const char* what);
  std::int64_t stored_size(const char* what);
  std::int64_t stored_count(const char* what, std::size_t text_bytes, std::size_t binary_bytes);
  double stored_real(const char* what);

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

}  // namespace fabricsh::format
