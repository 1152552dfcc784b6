// Gmsh format 4.1: $Entities (with the physical groups), and $Nodes and $Elements in blocks of one entity.
#include "format/gmsh.hpp"

namespace fabricsh::format {

void GmshReader::read_entities_4() {
  std::int64_t counts[4];
  for (auto& count : counts) count = stored_count("a number of entities", 4, 20);
  for (int dimension = 0; dimension < 4; ++dimension)
    for (std::int64_t i = 0; i < counts[dimension]; ++i) read_entity_4(dimension);
}

// An entity: number, position or bounding box, physical groups, entities on its border.
void GmshReader::read_entity_4(int dimension) {
  const auto number = stored_integer("the number of an entity");
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) stored_real("a coordinate");
  Tags groups = read_groups_4();
  if (dimension > 0) {
    const auto n = stored_count("a number of bordering entities", 2, 4);
    for (std::int64_t i = 0; i < n; ++i) stored_integer("the number of an entity");
  }
  if (dimension < 3) groups_[{dimension, number}] = std::move(groups);
}

GmshReader::Tags GmshReader::read_groups_4() {
  Tags groups(static_cast<std::size_t>(stored_count("a number of physical groups", 2, 4)));
  for (auto& group : groups) group = stored_integer("the number of a physical group");
  return groups;
}

// In a mesh cut into parts the elements belong to the parts of entities.
void GmshReader::read_partitioned_4() {
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
void GmshReader::read_part_4(int dimension) {
  const auto number = stored_integer("the number of an entity");
  const auto parent_dimension = stored_integer("a dimension"),
             parent = stored_integer("the number of an entity");
  const auto partitions = stored_count("a number of partitions", 2, 4);
  for (std::int64_t i = 0; i < partitions; ++i) stored_integer("a partition");
  for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) stored_real("a coordinate");
  Tags groups = read_groups_4();
  if (dimension > 0) {
    const auto n = stored_count("a number of bordering entities", 2, 4);
    for (std::int64_t i = 0; i < n; ++i) stored_integer("the number of an entity");
  }
  const auto whole = groups_.find({parent_dimension, parent});
  if (groups.empty() && parent_dimension == dimension && whole != groups_.end()) groups = whole->second;
  if (dimension < 3) groups_[{dimension, number}] = std::move(groups);
}

void GmshReader::read_nodes_4() {
  const auto blocks = stored_count("a number of blocks", 8, 20);
  const auto n = stored_count("a number of nodes", 8, 28);
  stored_size("the smallest number of a node");
  stored_size("the largest number of a node");
  for (std::int64_t i = 0; i < blocks; ++i) read_node_block_4();
  if (static_cast<std::int64_t>(builder_.nodes()) != n)
    source_.fail("expected " + std::to_string(n) + " nodes in all, got " + std::to_string(builder_.nodes()));
}

// All numbers, then all positions; a parametric block has more coordinates, one per dimension.
void GmshReader::read_node_block_4() {
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

void GmshReader::read_elements_4() {
  const auto blocks = stored_count("a number of blocks", 8, 20);
  const auto n = stored_count("a number of elements", 4, 8);
  stored_size("the smallest number of an element");
  stored_size("the largest number of an element");
  std::int64_t sum = 0;
  for (std::int64_t i = 0; i < blocks; ++i) sum += read_element_block_4();
  if (sum != n)
    source_.fail("expected " + std::to_string(n) + " elements in all, got " + std::to_string(sum));
}

std::int64_t GmshReader::read_element_block_4() {
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

}  // namespace fabricsh::format
