// Abaqus' and CalculiX's .inp: *NODE, *ELEMENT, *NSET, *ELSET. Statements of the problem, not of the mesh
// (materials, steps, ...), are passed over; those that make nodes or elements in another way are refused.
#include <algorithm>

#include "format/deck_mesh.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

using Of = DeckMesh::Of;

constexpr const char* shells =
    "expected a shell or membrane of 3 or 4 nodes (S3, S4, S4R, M3D3, M3D4, CPS3, CPS4, R3D4, ...)";

// Nodes of an element by the name of its type; 0: none that is read.
int nodes_of(const std::string& type) {
  for (const char* one : {"MASS", "ROTARYI", "SPRING1", "DASHPOT1"})
    if (type == one) return 1;
  for (const char* two : {"T2D2", "T3D2", "B21", "B31", "B31R", "B33", "R2D2", "RB3D2", "SPRING2", "SPRINGA",
                          "DASHPOT2", "DASHPOTA", "CONN2D2", "CONN3D2"})
    if (type == two) return 2;
  for (const char* three :
       {"S3", "S3R", "S3RS", "STRI3", "M3D3", "CPS3", "CPE3", "R3D3", "SFM3D3", "DS3", "SC3", "US3"})
    if (type == three) return 3;
  for (const char* four : {"S4", "S4R", "S4RS", "S4RSW", "S4R5", "M3D4", "M3D4R", "CPS4", "CPS4R", "CPS4I",
                           "CPE4", "CPE4R", "CPE4I", "R3D4", "SFM3D4", "SFM3D4R", "DS4"})
    if (type == four) return 4;
  return 0;
}

// The parts of a line between commas, but for those within quotes.
std::vector<std::string_view> fields_of(std::string_view line) {
  if (line.find('"') == line.npos) return comma_fields(line);
  std::vector<std::string_view> fields;
  bool quoted = false;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != ',')) continue;
    fields.push_back(trimmed(line.substr(from, i - from)));
    from = i + 1;
  }
  return fields;
}

// Takes the quotes around a name away; false where there are none.
bool unquote(std::string_view& name) {
  if (name.size() < 2 || name.front() != '"' || name.back() != '"') return false;
  name = name.substr(1, name.size() - 2);
  return true;
}

struct Keyword {
  std::string name;                               // upper case, single blanks
  std::map<std::string, std::string> parameters;  // upper case names; "" for a flag
};

class AbaqusReader : DeckReader {
 public:
  using DeckReader::DeckReader;

  mesh::Mesh read(bool at_rest) {
    std::string_view line;
    while (next(line)) {
      closed_ = false;
      if (line.starts_with('*'))
        open(keyword(line));
      else if (data_ != nullptr)
        (this->*data_)(line);
    }
    if (!waiting_.empty()) source_.fail("the file ends within an element");
    // No keyword closes a file: only a part, an assembly, an instance and a step have one of their own.
    if (!within_.empty())
      remark_end("*END " + within_.back());
    else if (!closed_ && source_.endless(last_))
      remark(no_line_end);
    return mesh_.finish(at_rest, remarks_);
  }

 private:
  // The next line that is not empty and no comment. A file may have been cut within a comment, too.
  bool next(std::string_view& line) {
    while (true) {
      place_ = source_.place();
      if (!source_.next_line(line)) return false;
      line = trimmed(line);
      if (!line.empty()) last_ = place_;
      if (!line.empty() && !line.starts_with("**")) return true;
    }
  }

  // A keyword continues in the next line if its line ends with a comma.
  Keyword keyword(std::string_view line) {
    Keyword word;
    bool first = true;
    while (true) {
      for (const std::string_view field : fields_of(line)) {
        if (first) word.name = without_double_blanks(upper(field.substr(1)));
        if (!first && !field.empty()) parameter(word, field);
        first = false;
      }
      if (!line.ends_with(',')) return word;
      if (!next(line)) return word;
      if (line.starts_with('*'))
        source_.fail("expected the rest of *" + word.name + ", whose line ends with a comma");
    }
  }

  static std::string without_double_blanks(const std::string& text) {
    std::string out;
    for (const char c : text)
      if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
    return std::string(trimmed(out));
  }

  void parameter(Keyword& word, std::string_view field) {
    const std::size_t equals = std::min(field.find('='), field.size());
    std::string_view value = equals == field.size() ? "" : trimmed(field.substr(equals + 1));
    unquote(value);
    word.parameters[without_double_blanks(upper(field.substr(0, equals)))] = std::string(value);
  }

  void open(const Keyword& word) {
    if (!waiting_.empty())
      source_.fail("expected the rest of the element above, got *" + in_quotes(word.name));
    data_ = nullptr;
    nest(word.name);
    if (word.name == "NODE") return open_nodes(word);
    if (word.name == "ELEMENT") return open_elements(word);
    if (word.name == "NSET") return open_set(word, Of::nodes, "NSET");
    if (word.name == "ELSET") return open_set(word, Of::elements, "ELSET");
    if (word.name == "INITIAL CONDITIONS") return open_conditions(word);
    if (word.name == "PART" && ++parts_ > 1)
      source_.fail("a second *PART: expected one part, with the numbers of nodes and elements of the whole");
    if (word.name == "INSTANCE") {
      instance_ = true;
      data_ = &AbaqusReader::moved;
    }
    if (word.name == "INCLUDE" || word.parameters.contains("INPUT"))
      source_.fail(
          "*" + word.name +
          " takes lines from another file, which is not read: expected one file with all of the mesh");
    for (const char* maker :
         {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "TRANSFORM NODES"})
      if (word.name == maker)
        source_.fail("*" + word.name +
                     " makes or moves nodes or elements, which is not read: expected *NODE and *ELEMENT with "
                     "all of them");
    if (!is_frame(word.name)) mesh_.pass_over("*" + word.name, place_);
  }

  // Statements that hold others together, or words for the reader.
  static bool is_frame(const std::string& word) {
    constexpr const char* frames[] = {"HEADING", "PREPRINT", "PART", "ASSEMBLY", "INSTANCE"};
    return word.starts_with("END") ||
           std::any_of(std::begin(frames), std::end(frames), [&](const char* f) { return word == f; });
  }

  // Blanks do not count in a keyword: *ENDSTEP ends a step.
  void nest(std::string word) {
    std::erase(word, ' ');
    for (const std::string block : {"PART", "ASSEMBLY", "INSTANCE", "STEP"}) {
      if (word == block) within_.push_back(block);
      if (word != "END" + block) continue;
      closed_ = true;
      if (const auto found = std::find(within_.rbegin(), within_.rend(), block); found != within_.rend())
        within_.erase(found.base() - 1, within_.end());
    }
  }

  static std::string value(const Keyword& word, const char* name) {
    const auto found = word.parameters.find(name);
    return found == word.parameters.end() ? "" : found->second;
  }

  // The places of an element's nodes where it is free of stress, two nodes to a line.
  void open_conditions(const Keyword& word) {
    if (!upper(value(word, "TYPE")).starts_with("REF COORDINATE") &&
        !upper(value(word, "TYPE")).starts_with("REFERENCE COORDINATE"))
      return;
    rest_element_ = -1;
    data_ = &AbaqusReader::rest;
  }
  void rest(std::string_view line) {
    auto fields = comma_fields(line);
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    const bool begins = fields.size() % 3 == 1;
    if (fields.size() > 7 || fields.empty() || (!begins && (fields.size() % 3 != 0 || rest_element_ < 0)))
      source_.fail("expected an element and two places, or two more places, got " + in_quotes(line));
    if (begins) rest_element_ = given_whole(fields[0], "the number of an element"), rest_corner_ = 0;
    for (std::size_t i = begins ? 1 : 0; i + 2 < fields.size(); i += 3) {
      Vec3 x;
      for (std::size_t k = 0; k < 3; ++k)
        if (!parse_fortran(fields[i + k], x[static_cast<Eigen::Index>(k)]))
          source_.fail("element " + std::to_string(rest_element_) + ": expected a coordinate, got " +
                       in_quotes(fields[i + k]));
      mesh_.rest_corner("*INITIAL CONDITIONS, TYPE=REF COORDINATE", place_, rest_element_, rest_corner_++, x);
    }
  }

  void open_nodes(const Keyword& word) {
    const std::string system = upper(value(word, "SYSTEM"));
    if (!system.empty() && system != "R")
      source_.fail("*NODE, SYSTEM=" + system + ": expected rectangular coordinates");
    set_ = begin_set(value(word, "NSET"), Of::nodes);
    data_ = &AbaqusReader::node;
  }

  void open_elements(const Keyword& word) {
    const std::string type = upper(value(word, "TYPE"));
    if (type.empty()) source_.fail("*ELEMENT: expected TYPE=...");
    wanted_ = nodes_of(type);
    if (wanted_ == 0) source_.fail("*ELEMENT, TYPE=" + in_quotes(type) + ": " + shells);
    set_ = begin_set(value(word, "ELSET"), Of::elements);
    data_ = &AbaqusReader::element;
  }

  // The key of the set, by which upper and lower case are the same; empty for no name.
  std::string begin_set(const std::string& name, Of of) {
    const std::string key = upper(name);
    if (!key.empty()) mesh_.name_set(key, of, name);
    return key;
  }

  void open_set(const Keyword& word, Of of, const char* parameter) {
    set_ = begin_set(value(word, parameter), of);
    if (set_.empty()) source_.fail("*" + word.name + ": expected " + parameter + "=a name");
    of_ = of;
    data_ = word.parameters.contains("GENERATE") ? &AbaqusReader::range : &AbaqusReader::members;
    if (const std::string from = upper(value(word, "ELSET")); of == Of::nodes && !from.empty()) {
      DeckMesh::Members line{set_, of, place_};
      line.sets = {from};
      line.of_elements = true;
      mesh_.add(std::move(line));
    }
  }

  void node(std::string_view line) {
    const auto fields = comma_fields(line);
    const std::int64_t number = given_whole(fields[0], "the number of a node");
    const Vec3 x = coordinates(fields);
    if (fields.size() < 3)
      source_.fail("node " + std::to_string(number) +
                   ": expected its number and coordinates with commas between them");
    mesh_.add_node(number, x);
    take_in(Of::nodes, number);
  }

  void take_in(Of of, std::int64_t number) {
    if (!set_.empty()) mesh_.add(set_, of, place_, number);
  }

  // An element may take more than one line: the line before ends with a comma then.
  void element(std::string_view line) {
    for (const std::string_view field : comma_fields(line))
      if (!field.empty())
        waiting_.push_back(
            given_whole(field, waiting_.empty() ? "the number of an element" : "the number of a node"));
    const auto size = static_cast<std::size_t>(wanted_) + 1;
    if (waiting_.size() < size && line.ends_with(',')) return;
    if (waiting_.size() != size)
      source_.fail("expected the number of an element and " + std::to_string(wanted_) + " nodes, got " +
                   std::to_string(waiting_.size()) + (waiting_.size() == 1 ? " number" : " numbers"));
    mesh_.add_element(waiting_[0], place_, {waiting_.begin() + 1, waiting_.end()});
    take_in(Of::elements, waiting_[0]);
    waiting_.clear();
  }

  // Numbers, and names of other sets; of an assembly's instance, of which there is one, behind its name.
  void members(std::string_view line) {
    DeckMesh::Members out{set_, of_, place_};
    for (std::string_view field : fields_of(line)) {
      std::int64_t number = 0;
      if (unquote(field)) {
        out.sets.push_back(upper(field));
        continue;
      }
      if (const auto dot = field.rfind('.'); instance_ && dot != field.npos) field.remove_prefix(dot + 1);
      if (field.empty()) continue;
      if (parse(field, number))
        out.numbers.push_back(number);
      else
        out.sets.push_back(upper(field));
    }
    mesh_.add(std::move(out));
  }

  void range(std::string_view line) {
    auto fields = comma_fields(line);
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    if (fields.size() < 2 || fields.size() > 3)
      source_.fail("expected first, last and step, got " + in_quotes(line));
    DeckMesh::Members out{set_, of_, place_};
    out.ranges.push_back({given_whole(fields[0], "the first number"),
                          given_whole(fields[1], "the last number"),
                          fields.size() == 3 ? given_whole(fields[2], "a step") : 1});
    mesh_.add(std::move(out));
  }

  void moved(std::string_view line) {
    for (const std::string_view field : comma_fields(line)) {
      double value = 0;
      if (!field.empty() && (!parse_fortran(field, value) || value != 0))
        source_.fail("*INSTANCE moves its part, which is not read: expected the nodes where they are");
    }
  }

  void (AbaqusReader::*data_)(std::string_view) = nullptr;  // what reads the lines below the keyword
  std::size_t last_ = 0;                                    // place of the last line that is not empty
  bool closed_ = false;                                     // by the last line, *END ...
  std::vector<std::string> within_;                         // blocks that are open, innermost last
  std::string set_;                                         // key of the set that is read
  Of of_ = Of::nodes;
  bool instance_ = false;
  std::int64_t rest_element_ = -1;  // whose places are read
  std::size_t rest_corner_ = 0;
  int wanted_ = 0, parts_ = 0;         // nodes of an element; parts so far
  std::vector<std::int64_t> waiting_;  // of an element that goes on in the next line
};

}  // namespace

mesh::Mesh read_abaqus(const std::string& name, std::string_view bytes, Remarks* remarks, bool at_rest) {
  return AbaqusReader(name, bytes, remarks).read(at_rest);
}

}  // namespace fabricsh::format
