// LS-DYNA's keyword files: *NODE, *ELEMENT_SHELL, *SET_NODE_..., *SET_SHELL_..., *PART, in fields of fixed
// width, long ones, or between commas. Statements of the problem, not of the mesh, are passed over; other
// elements, and statements that take lines from elsewhere, are refused.
#include "format/deck_mesh.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

using Of = DeckMesh::Of;

class DynaReader : DeckReader {
 public:
  using DeckReader::DeckReader;

  mesh::Mesh read(bool at_rest) {
    std::string_view line;
    bool complete = false;
    while (!complete && next(line)) {
      if (line.starts_with('*')) {
        const std::string word = upper(trimmed(line.substr(1, line.find('$') - 1)));  // before a comment
        complete = word == "END";
        open(word);
      } else if (card_ != nullptr) {
        (this->*card_)(line);
      }
    }
    if (!complete) remark_end("*END");
    if (parts_.size() > 1)
      for (const auto& [part, members] : parts_) add_part(part, members);
    return mesh_.finish(at_rest, remarks_);
  }

 private:
  using Card = void (DynaReader::*)(std::string_view);

  bool next(std::string_view& line) {
    while (true) {
      place_ = source_.place();
      if (!source_.next_line(line)) return false;
      if (!line.starts_with('$') && !trimmed(line).empty()) return true;
    }
  }

  // The parts of a card: widths in characters, or commas where the card has any.
  std::vector<std::string_view> fields(std::string_view card,
                                       std::initializer_list<std::size_t> widths) const {
    if (card.find(',') != card.npos) return comma_fields(card);
    std::vector<std::string_view> out;
    std::size_t from = 0;
    for (const std::size_t width : widths) {
      if (from >= card.size()) break;
      out.push_back(trimmed(card.substr(from, long_ ? 20 : width)));
      from += long_ ? 20 : width;
    }
    return out;
  }

  static bool begins(const std::string& word, const char* with) { return word.starts_with(with); }

  // A keyword may end with + for fields of 20 characters, or - for the usual ones.
  void open(std::string word) {
    card_ = nullptr;
    long_ = all_long_;
    if (word.ends_with('+') || word.ends_with('-')) {
      long_ = word.back() == '+';
      word = std::string(trimmed(std::string_view(word).substr(0, word.size() - 1)));
    }
    if (begins(word, "KEYWORD")) {
      all_long_ = word.find("LONG=Y") != word.npos || word.find("LONG=K") != word.npos;
    } else if (word == "NODE") {
      card_ = &DynaReader::node;
    } else if (begins(word, "ELEMENT_SHELL")) {
      open_shells(word);
    } else if (word == "PART") {
      card_ = &DynaReader::part_title;
    } else if (begins(word, "SET_NODE")) {
      open_set(word, Of::nodes, word.substr(8));
    } else if (begins(word, "SET_SHELL")) {
      open_set(word, Of::elements, word.substr(9));
    } else if (begins(word, "AIRBAG_SHELL_REFERENCE_GEOMETRY")) {
      open_rest(word);
      elementwise_ = true;
    } else if (begins(word, "AIRBAG_REFERENCE_GEOMETRY") || begins(word, "INITIAL_FOAM_REFERENCE_GEOMETRY")) {
      open_rest(word);
    } else {
      refuse(word);
      if (word != "TITLE" && word != "END") mesh_.pass_over("*" + word, place_);
    }
  }

  // Cards with the birth time or a curve come first, and one with scales.
  void open_rest(const std::string& word) {
    rest_ = "*" + word;
    elementwise_ = false;
    scaled_ = word.find("_ID") != word.npos;
    skip_ = word.find("_BIRTH") != word.npos || word.find("_RAMP") != word.npos ? 1 : 0;
    card_ = &DynaReader::rest;
  }
  void rest(std::string_view card) {
    if (scaled_) return rest_scales(card);
    if (skip_ > 0) {
      --skip_;
      return;
    }
    if (elementwise_) return rest_shell(card);
    const auto f = fields(card, {8, 16, 16, 16});
    mesh_.rest_node(rest_, place_, whole(f[0], "the number of a node"), coordinates(f));
  }
  // The element, its part and the nodes at whose places its own have no stress.
  void rest_shell(std::string_view card) {
    const auto f = fields(card, {8, 8, 8, 8, 8, 8});
    if (f.size() < 5) source_.fail("expected element, part and 3 or 4 nodes, got " + in_quotes(card));
    std::vector<std::int64_t> nodes;
    for (std::size_t i = 2; i < std::min<std::size_t>(f.size(), 6); ++i)
      nodes.push_back(whole(f[i], "the number of a node"));
    nodes.resize(nodes.size() < 4 || nodes[3] == 0 || nodes[3] == nodes[2] ? 3 : 4);
    mesh_.rest_element(rest_, place_, whole(f[0], "the number of an element"), nodes);
  }
  void rest_scales(std::string_view card) {
    scaled_ = false;
    const auto f = fields(card, {10, 10, 10, 10, 10});
    for (std::size_t i = 1; i < std::min<std::size_t>(f.size(), 4); ++i) {
      double scale = 1;
      if (f[i].empty() || (parse_fortran(f[i], scale) && (scale == 1 || scale == 0))) continue;
      leave_out(rest_.substr(1), "is scaled");
      card_ = nullptr;
      return;
    }
  }
  void leave_out(const std::string& word, const char* why) const {
    remark("*" + word + " " + why + ", which is not read: it is left out");
  }

  void refuse(const std::string& word) const {
    if (begins(word, "INCLUDE"))
      source_.fail(
          "*" + word +
          " takes lines from another file, which is not read: expected one file with all of the mesh");
    if (begins(word, "ELEMENT_"))
      source_.fail("*" + word + ": expected *ELEMENT_SHELL, with 3 or 4 nodes, and no other elements");
    if (begins(word, "NODE_"))
      source_.fail("*" + word + " makes or moves nodes, which is not read: expected *NODE with all of them");
  }

  void open_shells(const std::string& word) {
    std::string options = word.substr(13);
    more_ = 0;
    const auto take = [&options](const std::string& option) {
      const auto at = options.find(option);
      if (at != options.npos) options.erase(at, option.size());
      return at != std::string::npos;
    };
    if (static_cast<int>(take("_THICKNESS")) + static_cast<int>(take("_BETA")) +
            static_cast<int>(take("_MCID")) >
        0)
      ++more_;
    if (take("_OFFSET")) ++more_;
    if (!options.empty())
      source_.fail("*" + word + ": expected *ELEMENT_SHELL, alone or with _THICKNESS, _BETA, _MCID, _OFFSET");
    skip_ = 0;
    card_ = &DynaReader::shell;
  }

  void node(std::string_view card) {
    const auto f = fields(card, {8, 16, 16, 16, 8, 8});
    mesh_.add_node(whole(f[0], "the number of a node"), coordinates(f));
  }

  Vec3 coordinates(const std::vector<std::string_view>& f) const {
    return DeckReader::coordinates(f, long_ ? 20 : 8, long_ ? 20 : 16);
  }

  // A triangle has its last node twice, or no fourth.
  void shell(std::string_view card) {
    if (skip_ > 0) {
      --skip_;
      return;
    }
    skip_ = more_;
    const auto f = fields(card, {8, 8, 8, 8, 8, 8, 8, 8, 8, 8});
    if (f.size() < 5) source_.fail("expected element, part and 3 or 4 nodes, got " + in_quotes(card));
    const std::int64_t number = whole(f[0], "the number of an element"),
                       part = whole(f[1], "the number of a part");
    std::vector<std::int64_t> nodes;
    for (std::size_t i = 2; i < f.size(); ++i) nodes.push_back(whole(f[i], "the number of a node"));
    for (std::size_t i = 4; i < nodes.size(); ++i)
      if (nodes[i] != 0)
        source_.fail("element " + std::to_string(number) +
                     " has more than 4 nodes: expected shells of first order");
    nodes.resize(nodes.size() < 4 || nodes[3] == 0 || nodes[3] == nodes[2] ? 3 : 4);
    mesh_.add_element(number, place_, nodes);
    parts_[part].push_back(number);
  }

  void part_title(std::string_view card) {
    title_ = std::string(trimmed(card));
    card_ = &DynaReader::part_numbers;
  }
  void part_numbers(std::string_view card) {
    titles_[whole(fields(card, {10, 10})[0], "the number of a part")] = title_;
    card_ = &DynaReader::part_title;
  }

  void open_set(const std::string& word, Of of, std::string options) {
    of_ = of;
    titled_ = options.ends_with("_TITLE");
    if (titled_) options.resize(options.size() - 6);
    title_.clear();
    if (options.empty() || options == "_LIST")
      members_ = &DynaReader::list;
    else if (options == "_LIST_GENERATE")
      members_ = &DynaReader::ranges;
    else if (options == "_COLUMN")
      members_ = &DynaReader::column;
    else
      source_.fail("*" + word + ": expected *SET_NODE or *SET_SHELL with _LIST, _LIST_GENERATE or _COLUMN");
    card_ = titled_ ? &DynaReader::set_title : &DynaReader::set_number;
  }
  void set_title(std::string_view card) {
    title_ = std::string(trimmed(card));
    card_ = &DynaReader::set_number;
  }
  void set_number(std::string_view card) {
    const std::string number = std::to_string(whole(fields(card, {10})[0], "the number of a set"));
    set_ = "set " + number;
    mesh_.name_set(set_, of_, title_.empty() ? "set_" + number : title_);
    card_ = members_;
  }

  std::vector<std::string_view> eight(std::string_view card) const {
    return fields(card, {10, 10, 10, 10, 10, 10, 10, 10});
  }
  // Zeros fill up the last card.
  void list(std::string_view card) {
    DeckMesh::Members line{set_, of_, place_};
    for (const std::string_view field : eight(card))
      if (const std::int64_t number = whole(field, "the number of a member"); number != 0)
        line.numbers.push_back(number);
    mesh_.add(std::move(line));
  }
  void ranges(std::string_view card) {
    DeckMesh::Members line{set_, of_, place_};
    const auto f = eight(card);
    for (std::size_t i = 0; i + 1 < f.size(); i += 2) {
      const std::int64_t first = whole(f[i], "a first number"), last = whole(f[i + 1], "a last number");
      if (first != 0) line.ranges.push_back({first, last, 1});
    }
    mesh_.add(std::move(line));
  }
  void column(std::string_view card) {
    mesh_.add({set_, of_, place_, {whole(fields(card, {10})[0], "the number of a member")}});
  }

  Card card_ = nullptr, members_ = nullptr;  // what reads the next card
  bool all_long_ = false, long_ = false, titled_ = false;
  int more_ = 0, skip_ = 0;  // cards behind that of an element, which hold nothing of the mesh
  std::string set_, title_, rest_;
  bool elementwise_ = false;  // that shape is given by other nodes of the elements
  bool scaled_ = false;       // the next card has the scales of a stress-free shape
  Of of_ = Of::nodes;
  std::map<std::int64_t, std::vector<std::int64_t>> parts_;  // elements of each
};

}  // namespace

mesh::Mesh read_dyna(const std::string& name, std::string_view bytes, Remarks* remarks, bool at_rest) {
  return DynaReader(name, bytes, remarks).read(at_rest);
}

}  // namespace fabricsh::format
