// Gmsh format 2: $Nodes and $Elements, text and binary.
// The counts of nodes and elements are text in both forms.
#include "format/gmsh.hpp"

namespace fabricsh::format {

void GmshReader::read_nodes_2() {
  source_.set_binary(false);
  const auto n = source_.count("a number of nodes", binary_ ? 28 : 8);
  if (binary_) source_.line("the nodes");
  source_.set_binary(binary_);
  for (std::int64_t i = 0; i < n; ++i) {
    const auto number = stored_integer("the number of a node");
    builder_.add_node(number, position());
  }
}

void GmshReader::read_elements_2() {
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

// The first tag is the physical group (0: none); here each group is treated as an entity of its own.
GmshReader::Tags* GmshReader::members_2(int dimension, const Tags& tags) {
  if (tags.empty() || tags[0] == 0) return nullptr;
  groups_[{dimension, tags[0]}] = {tags[0]};
  return &members_[{dimension, tags[0]}];
}

// Line format: number type tags... nodes...
void GmshReader::read_text_element_2() {
  const auto number = source_.integer("the number of an element");
  const ElementKind kind = this->kind(source_.integer("the type of an element"));
  Tags tags(static_cast<std::size_t>(source_.count("a number of tags", 2)));
  for (auto& tag : tags) tag = source_.integer("a tag");
  Tags corners(static_cast<std::size_t>(kind.nodes));
  for (auto& corner : corners) corner = source_.integer("the number of a node");
  add(number, kind, corners, members_2(kind.dimension, tags));
}

// A block begins with type, number of elements and number of tags; the elements follow.
std::int64_t GmshReader::read_block_2(std::int64_t most) {
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

}  // namespace fabricsh::format
