// Shared by the readers of other solvers' decks: nodes and elements by the deck's numbers, and sets of them,
// which may be named before what is in them.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "format/mesh_builder.hpp"
#include "format/mesh_file.hpp"
#include "format/table_line.hpp"

namespace fabricsh::format {

class DeckMesh {
 public:
  // source: the deck, whose line errors name; it is moved about while sets are put together.
  DeckMesh(Source& source, std::size_t bytes)
      : source_(source), builder_(source, 16 * bytes), most_(16 * bytes) {}

  enum class Of { nodes, elements };
  struct NumberRange {
    std::int64_t first, last, step;
  };
  // A line of a set, at `place` of the deck. Only existing numbers of a range count; of numbers and names all
  // have to be.
  struct Members {
    std::string set;  // its key
    Of of;
    std::size_t place;
    std::vector<std::int64_t> numbers = {};
    std::vector<NumberRange> ranges = {};
    std::vector<std::string> sets = {};  // keys of other sets of the same kind, or `elements` below
    bool of_elements = false;            // nodes: those of the element sets named
  };

  void add_node(std::int64_t number, const Vec3& position) { builder_.add_node(number, position); }
  bool has_node(std::int64_t number) const { return builder_.has_node(number); }
  // The place of a node in the stress-free shape that the deck gives with a keyword ("/XREF"); by its number,
  // or as a corner of an element, from 0; or of all corners of an element by other nodes that are there.
  void rest_node(const std::string& keyword, std::size_t place, std::int64_t number, const Vec3& position);
  void rest_corner(const std::string& keyword, std::size_t place, std::int64_t element, std::size_t corner,
                   const Vec3& position);
  void rest_element(const std::string& keyword, std::size_t place, std::int64_t element,
                    const std::vector<std::int64_t>& nodes);
  // 1 to 4 nodes, which are looked up when all of the deck is read; fewer than 3 count for sets alone.
  void add_element(std::int64_t number, std::size_t place, const std::vector<std::int64_t>& corners);
  // The set as it will be called; the first spelling of a key stays. A set of elements without a name is for
  // other sets alone.
  void name_set(const std::string& key, Of of, const std::string& name);
  void add(Members members) { members_.push_back(std::move(members)); }
  void add(const std::string& set, Of of, std::size_t place, std::int64_t number);

  // A statement of the deck, at `place`, that has nothing of a mesh.
  void pass_over(const std::string& statement, std::size_t place);

  // at_rest: in the stress-free shape of the deck; Error: it has none. Otherwise a remark names one.
  mesh::Mesh finish(bool at_rest, std::vector<std::string>* remarks);

 private:
  struct DeckElement {
    std::array<std::int64_t, 4> corners;
    int size;
  };
  using Numbers = std::vector<std::int64_t>;
  struct Set {
    std::string name;
    Numbers numbers = {};
  };
  struct RestCorner {
    std::int64_t element;  // -1: the number of a node
    std::int64_t corner;
    Vec3 position;
    std::size_t place;
    std::int64_t like = -1;  // the node whose position it is
  };
  void take_rest();
  RestCorner& add_rest(const std::string& keyword, std::size_t place, const RestCorner& corner);
  [[noreturn]] void fail_at(std::size_t place, const std::string& why);
  Numbers of_range(const Members& members, const NumberRange& range);
  void collect(const Members& members);
  void add_sets();
  std::map<std::string, Set>& sets(Of of) { return of == Of::nodes ? node_sets_ : element_sets_; }

  Source& source_;
  MeshBuilder builder_;
  std::size_t most_;  // members that a deck of this size can name, and steps to look for them
  std::vector<std::pair<std::int64_t, std::size_t>> order_;  // numbers of elements, and where they are
  std::unordered_map<std::int64_t, DeckElement> elements_;
  std::vector<Members> members_;
  std::vector<mesh::Mesh::PassedOver> passed_over_;
  std::string rest_keyword_;
  std::size_t rest_place_ = 0;  // of its first line
  std::vector<RestCorner> rest_;
  std::map<std::string, Set> node_sets_, element_sets_;
};

// What the readers of the three solvers' decks share: the text, its mesh, and the line that is read.
class DeckReader {
 public:
  DeckReader(const std::string& name, std::string_view bytes, Remarks* remarks)
      : source_(name, bytes), mesh_(source_, bytes.size()), remarks_(remarks) {}

 protected:
  std::int64_t given_whole(std::string_view field, const char* what) const;
  // 0: the field is blank.
  std::int64_t whole(std::string_view field, const char* what) const {
    return field.empty() ? 0 : given_whole(field, what);
  }
  // Behind the number of a node. In an error the columns of a coordinate, unless the width is 0.
  Vec3 coordinates(const std::vector<std::string_view>& fields, std::size_t width_of_first = 0,
                   std::size_t width = 0) const;
  void remark(const std::string& text) const;
  void remark_end(const std::string& missing) const {
    remark("the file ends without " + missing + "; if it was cut short, part of the mesh is missing");
  }
  static std::string part_key(std::int64_t part) { return "part " + std::to_string(part); }
  // A set of elements, under its title where it is named.
  void add_part(std::int64_t part, std::vector<std::int64_t> members, bool named = true);

  Source source_;
  DeckMesh mesh_;
  Remarks* remarks_;
  std::size_t place_ = 0;                       // of the line
  std::map<std::int64_t, std::string> titles_;  // of parts
};

// The parts of a line between commas, without the blanks around them.
std::vector<std::string_view> comma_fields(std::string_view line);
std::string upper(std::string_view text);
// A number as Fortran writes it too: 1.5D-3.
bool parse_fortran(std::string_view word, double& value);

}  // namespace fabricsh::format
