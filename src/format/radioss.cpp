// OpenRadioss' starter decks: /NODE, /SHELL, /SH3N, /PART, groups of nodes and shells, and the stress-free
// shape of /XREF and /EREF, in fields of 10 and 20 characters. Lengths are in the units of /BEGIN, else in m.
// Statements of the problem, not of the mesh, are passed over; other elements, and statements that take lines
// from elsewhere or move nodes, are refused.
#include <algorithm>
#include <set>

#include "format/deck_mesh.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

using Of = DeckMesh::Of;

// The length of a unit in m: a number, or m with a prefix. 0: it is none.
double metres(std::string_view word) {
  double value = 0;
  if (parse_fortran(word, value)) return std::isfinite(value) && value > 0 ? value : 0;
  static const std::map<std::string_view, double> prefixes{
      {"", 1},     {"n", 1e-9}, {"mu", 1e-6}, {"m", 1e-3}, {"c", 1e-2},
      {"d", 1e-1}, {"da", 1e1}, {"h", 1e2},   {"k", 1e3},  {"M", 1e6}};
  if (!word.ends_with('m')) return 0;
  const auto found = prefixes.find(word.substr(0, word.size() - 1));
  return found == prefixes.end() ? 0 : found->second;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr auto blanks = " \t";
  std::vector<std::string_view> words;
  for (auto from = line.find_first_not_of(blanks); from != line.npos;) {
    const auto end = std::min(line.find_first_of(blanks, from), line.size());
    words.push_back(line.substr(from, end - from));
    from = line.find_first_not_of(blanks, end);
  }
  return words;
}

class RadiossReader : DeckReader {
 public:
  using DeckReader::DeckReader;

  mesh::Mesh read(bool at_rest) {
    std::string_view line;
    std::size_t last = 0;
    bool complete = false;
    while (!complete && next(line)) {
      last = place_;
      if (line.starts_with('/')) {
        open(split(trimmed(line)));
        complete = keyword_ == "/END";
      } else if (card_ != nullptr) {
        (this->*card_)(line);
      }
    }
    if (!complete && begun_)
      remark_end("/END");
    else if (!complete && source_.endless(last))
      remark(no_line_end);
    add_parts();
    add_groups();
    add_shape();
    return mesh_.finish(at_rest, remarks_);
  }

 private:
  using Card = void (RadiossReader::*)(std::string_view);
  using Words = std::vector<std::string>;

  // Blank lines count where a title may be one.
  bool next(std::string_view& line) {
    while (true) {
      place_ = source_.place();
      if (!source_.next_line(line)) return false;
      if (line.starts_with("#include"))
        source_.fail(
            "#include takes lines from another file, which is not read: expected one file with all of the "
            "mesh");
      if (line.starts_with('#') || line.starts_with('$')) continue;
      if (blank_counts_ || !trimmed(line).empty()) return true;
    }
  }

  // The words of a keyword between its slashes.
  static Words split(std::string_view keyword) {
    Words words;
    for (std::size_t from = 1; from <= keyword.size();) {
      const std::size_t end = std::min(keyword.find('/', from), keyword.size());
      words.push_back(upper(trimmed(keyword.substr(from, end - from))));
      from = end + 1;
    }
    return words;
  }

  std::vector<std::string_view> fields(std::string_view card, std::size_t first, std::size_t width) const {
    std::vector<std::string_view> out;
    for (std::size_t from = 0, size = first; from < card.size(); from += size, size = width)
      out.push_back(trimmed(card.substr(from, from == 0 ? first : width)));
    return out;
  }

  // The number that a keyword ends with; 0: none.
  std::int64_t number_of(const Words& words, std::size_t at, const char* what) const {
    return at < words.size() ? whole(words[at], what) : 0;
  }

  void expect(Card card, bool blank_counts = false) {
    card_ = card;
    blank_counts_ = blank_counts;
  }

  void open(const Words& words) {
    expect(nullptr);
    const std::string& word = words[0];
    keyword_ = "/" + word;
    if (word == "BEGIN") {
      open_begin();
    } else if (word == "NODE") {
      refuse_units(words, 1);
      expect(&RadiossReader::node);
    } else if (word == "SHELL" || word == "SH3N") {
      corners_ = word == "SHELL" ? 4 : 3;
      part_ = number_of(words, 1, "the number of a part");
      expect(&RadiossReader::shell);
    } else if (word == "PART") {
      part_ = number_of(words, 1, "the number of a part");
      expect(&RadiossReader::part_title, true);
    } else if (word == "GRNOD" || word == "GRSHEL" || word == "GRSH3N") {
      open_group(words);
    } else if (word == "XREF") {
      refuse_units(words, 2);
      part_ = number_of(words, 1, "the number of a part");
      expect(&RadiossReader::shape_title, true);
    } else if (word == "EREF") {
      open_shape(words);
    } else {
      refuse(words);
      if (word != "TITLE" && word != "END" && word != "UNIT") mesh_.pass_over(keyword_, place_);
    }
  }

  void refuse(const Words& words) const {
    static const std::set<std::string> elements{"BRICK",  "BRIC20", "TETRA4", "TETRA10", "PENTA6",
                                                "SHEL16", "QUAD",   "TRIA",   "BEAM",    "TRUSS",
                                                "SPRING", "SPHCEL", "XELEM"};
    const std::string& word = words[0];
    if (elements.contains(word))
      source_.fail(keyword_ + ": expected /SHELL and /SH3N, and no other elements");
    if (word == "CNODE" || word == "TRANSFORM")
      source_.fail(keyword_ + " makes or moves nodes, which is not read: expected /NODE with all of them");
    if (word.empty() || word == "ENCRYPT")
      source_.fail((word.empty() ? "a submodel (//)" : keyword_) +
                   ", which is not read: expected one deck with all of the mesh");
    if (word == "REFSTA") leave_out("/REFSTA names another file with a stress-free shape");
  }

  void leave_out(const std::string& what) const {
    if (!source_.endless(place_))  // of a line that was cut something else is said
      remark(what + ", which is not read: it is left out");
  }

  void refuse_units(const Words& words, std::size_t at) const {
    if (number_of(words, at, "the number of units") != 0)
      source_.fail(keyword_ + " has units of its own (/UNIT/" + words[at] +
                   "), which are not read: expected lengths in the units of /BEGIN");
  }

  // --- /BEGIN: the name of the run, the version, the units of the deck, those of the computation.
  void open_begin() {
    if (begun_ || has_nodes_) source_.fail("expected /BEGIN once, before all nodes");
    begun_ = true;
    expect(&RadiossReader::run_name, true);
  }
  void run_name(std::string_view) { expect(&RadiossReader::version); }
  void version(std::string_view card) {
    constexpr std::int64_t oldest = 51;  // its fields are as wide as those of today
    const auto f = fields(card, 10, 10);
    const std::int64_t number = f.empty() ? 0 : whole(f[0], "the version of the format");
    if (number != 0 && number < oldest)
      source_.fail("expected a deck of version 51 of the format or later, got " + std::to_string(number));
    expect(&RadiossReader::units, true);
  }
  void units(std::string_view card) {
    const auto words = words_of(card);
    if (!words.empty() && words.size() != 3)
      source_.fail("expected units of mass, length and time, got " + in_quotes(card));
    if (!words.empty()) {
      length_ = metres(words[1]);
      if (!(length_ > 0))
        source_.fail("expected a unit of length, m with a prefix or a number of metres, got " +
                     in_quotes(words[1]));
    }
    expect(nullptr);
    if (words.empty()) expect(&RadiossReader::units_of_work, true);
  }
  void units_of_work(std::string_view card) {
    units(card);
    expect(nullptr);
  }

  // --- nodes and shells
  Vec3 coordinates(const std::vector<std::string_view>& f) const {
    return length_ * DeckReader::coordinates(f, 10, 20);
  }
  void node(std::string_view card) {
    const auto f = fields(card, 10, 20);
    has_nodes_ = true;
    mesh_.add_node(whole(f[0], "the number of a node"), coordinates(f));
  }
  // The number of an element, and its nodes; a shell of four may have the last one twice.
  std::pair<std::int64_t, std::vector<std::int64_t>> element(std::string_view card) const {
    const auto f = fields(card, 10, 10);
    if (f.size() < corners_ + 1)
      source_.fail("expected element and " + std::to_string(corners_) + " nodes, got " + in_quotes(card));
    std::vector<std::int64_t> nodes;
    for (std::size_t i = 1; i <= corners_; ++i) nodes.push_back(whole(f[i], "the number of a node"));
    if (corners_ == 4 && (nodes[3] == 0 || nodes[3] == nodes[2])) nodes.pop_back();
    return {whole(f[0], "the number of an element"), nodes};
  }
  void shell(std::string_view card) {
    const auto [number, nodes] = element(card);
    mesh_.add_element(number, place_, nodes);
    parts_[part_].push_back(number);
    nodes_of_[part_].insert(nodes_of_[part_].end(), nodes.begin(), nodes.end());
  }
  void part_title(std::string_view card) {
    titles_[part_] = std::string(trimmed(card));
    expect(nullptr);
  }

  // --- groups
  static std::string key(Of of, const std::string& kind, std::int64_t number) {
    return (of == Of::nodes ? "nodes " : kind + " ") + std::to_string(number);
  }

  void open_group(const Words& words) {
    const std::string kind = words.size() > 1 ? words[1] : "", &of = words[0];
    group_ = {};
    group_.of = of == "GRNOD" ? Of::nodes : Of::elements;
    group_.set = key(group_.of, of, number_of(words, 2, "the number of a group"));
    group_.place = place_;
    if (kind == (of == "GRNOD" ? "NODE" : of == "GRSHEL" ? "SHEL" : "SH3N") || kind == "NODENS")
      listed_ = Listed::members;
    else if (kind == "GENE")
      listed_ = Listed::ranges;
    else if (kind == "GEN_INCR")
      listed_ = Listed::steps;
    else if (kind == "PART" || kind == "GRSHEL" || kind == "GRSH3N" || kind == "GRNOD")
      listed_ = Listed::sets;
    else
      return leave_out("/" + of + "/" + kind + " makes a group");
    group_.of_elements = group_.of == Of::nodes && kind != "GRNOD" && listed_ == Listed::sets;
    named_ = kind;
    expect(&RadiossReader::group_title, true);
  }
  void group_title(std::string_view card) {
    const std::string title(trimmed(card));
    const std::string number = group_.set.substr(group_.set.find(' ') + 1);
    mesh_.name_set(group_.set, group_.of, title.empty() ? "group_" + number : title);
    expect(&RadiossReader::group);
  }
  std::int64_t member(std::string_view field) const {
    const std::int64_t number = whole(field, "the number of a member");
    if (number < 0)
      source_.fail("the group takes members away (" + std::to_string(number) +
                   "), which is not read: expected those that belong to it");
    return number;
  }
  void group(std::string_view card) {
    DeckMesh::Members line = group_;
    line.place = place_;
    const auto f = fields(card, 10, 10);
    if (listed_ == Listed::steps) {
      const std::int64_t step = f.size() > 2 ? member(f[2]) : 0;
      if (f.size() < 2) source_.fail("expected a first and a last number, got " + in_quotes(card));
      line.ranges.push_back({member(f[0]), member(f[1]), step == 0 ? 1 : step});
    }
    for (std::size_t i = 0; listed_ == Listed::ranges && i + 1 < f.size(); i += 2)
      if (const std::int64_t first = member(f[i]); first != 0)
        line.ranges.push_back({first, member(f[i + 1]), 1});
    for (const std::string_view field : f)
      if (const std::int64_t number = listed_ < Listed::ranges ? member(field) : 0; number != 0) {
        if (listed_ == Listed::members)
          line.numbers.push_back(number);
        else
          line.sets.push_back(named_ == "PART"    ? part_key(number)
                              : named_ == "GRNOD" ? key(Of::nodes, "", number)
                                                  : key(Of::elements, named_, number));
      }
    if (line.sets.empty()) return mesh_.add(std::move(line));
    for (const std::string& set : line.sets) used_.insert(set);
    composed_.push_back(std::move(line));
  }

  void add_parts() {
    for (auto& [part, members] : parts_)
      if (parts_.size() > 1 || used_.contains(part_key(part)))
        add_part(part, std::move(members), parts_.size() > 1);
  }
  // Those of other groups, which must be there before they are named.
  void add_groups() {
    std::set<std::string> later;
    for (const auto& group : composed_) later.insert(group.set);
    std::string set;
    for (auto& group : composed_) {
      if (!set.empty() && set != group.set) later.erase(set);
      set = group.set;
      for (const std::string& named : group.sets)
        if (later.contains(named)) {
          source_.move_to(group.place);
          source_.fail(
              "group " + in_quotes(named) +
              " is made of others further down: expected groups in the order in which they are used");
        }
      mesh_.add(std::move(group));
    }
  }

  // --- the stress-free shape
  void shape_title(std::string_view) { expect(&RadiossReader::shape_steps, true); }
  // How many steps lead from the shape to the start; a line that is longer is a node already.
  void shape_steps(std::string_view card) {
    expect(&RadiossReader::shape_node);
    if (trimmed(card).size() > 10) shape_node(card);
  }
  void shape_node(std::string_view card) {
    const auto f = fields(card, 10, 20);
    shape_.push_back({part_, whole(f[0], "the number of a node"), coordinates(f), place_});
  }
  // Nodes that are not of the part do not count.
  void add_shape() {
    for (auto& [part, nodes] : nodes_of_) std::sort(nodes.begin(), nodes.end());
    for (const ShapeNode& node : shape_) {
      const auto of = nodes_of_.find(node.part);
      if (node.part != 0 &&
          (of == nodes_of_.end() || !std::binary_search(of->second.begin(), of->second.end(), node.number)))
        continue;
      mesh_.rest_node("/XREF", node.place, node.number, node.x);
    }
  }
  void open_shape(const Words& words) {
    const std::string kind = words.size() > 1 ? words[1] : "";
    if (kind != "SHELL" && kind != "SH3N") return leave_out("/EREF/" + kind + " gives a stress-free shape");
    corners_ = kind == "SHELL" ? 4 : 3;
    expect(&RadiossReader::shape_of_shells, true);
  }
  void shape_of_shells(std::string_view) { expect(&RadiossReader::shape_shell); }
  void shape_shell(std::string_view card) {
    const auto [number, nodes] = element(card);
    mesh_.rest_element("/EREF", place_, number, nodes);
  }

  struct ShapeNode {
    std::int64_t part, number;
    Vec3 x;
    std::size_t place;
  };

  Card card_ = nullptr;        // what reads the next line
  bool blank_counts_ = false;  // whether that line may be blank
  std::string keyword_;
  bool begun_ = false, has_nodes_ = false;
  double length_ = 1;  // m, the deck's unit
  std::size_t corners_ = 4;
  std::int64_t part_ = 0;
  std::map<std::int64_t, std::vector<std::int64_t>> parts_, nodes_of_;  // elements and nodes of each
  enum class Listed { members, sets, ranges, steps } listed_ = Listed::members;
  DeckMesh::Members group_{};
  std::string named_;                        // of what kind the members of the group are
  std::vector<DeckMesh::Members> composed_;  // lines of groups that are made of groups or parts
  std::set<std::string> used_;               // keys of these
  std::vector<ShapeNode> shape_;
};

}  // namespace

mesh::Mesh read_radioss(const std::string& name, std::string_view bytes, Remarks* remarks, bool at_rest) {
  return RadiossReader(name, bytes, remarks).read(at_rest);
}

}  // namespace fabricsh::format
