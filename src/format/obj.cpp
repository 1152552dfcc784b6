// Wavefront .obj: v, f, l, p; groups (g) and objects (o) become sets.

#include "format/mesh_builder.hpp"
#include "format/mesh_file.hpp"
#include "format/table_line.hpp"

namespace fabricsh::format {

namespace {

class ObjReader {
 public:
  ObjReader(const std::string& name, std::string_view bytes)
      : source_(name, bytes), builder_(source_, 16 * bytes.size()) {}

  mesh::Mesh read(Remarks* remarks) {
    std::string_view line;
    for (std::size_t place = 0; source_.next_line(line); place = source_.place()) {
      statement(Source("", whole(line.substr(0, line.find('#')))));
      if (remarks != nullptr && source_.endless(place) && !trimmed(line).empty())
        remarks->push_back(source_.at_place(no_line_end));
    }
    add_remarks(remarks);
    return builder_.finish();
  }

 private:
  // A statement with the lines below on which it goes on, as a backslash at the end of a line says.
  std::string_view whole(std::string_view words) {
    if (!trimmed(words).ends_with('\\')) return words;
    continued_.clear();
    while (trimmed(words).ends_with('\\')) {
      continued_ += trimmed(words);
      continued_.back() = ' ';
      if (!source_.next_line(words)) words = {};
      words = words.substr(0, words.find('#'));
    }
    return continued_.append(words);
  }

  // Lines that were passed over and faces that were cut, a remark each.
  void add_remarks(Remarks* remarks) const {
    if (remarks == nullptr) return;
    if (!strange_.empty())
      remarks->push_back(strange_ +
                         (strange_lines_ > 1 ? " (" + std::to_string(strange_lines_) + " such lines)" : ""));
    if (cut_ > 0)
      remarks->push_back(source_.name() + ": " + std::to_string(cut_) + (cut_ == 1 ? " face" : " faces") +
                         " with more than four corners cut into triangles from the first corner");
  }

  void statement(Source line) {
    const auto keyword = line.word_or_none();
    if (keyword == "v") return node(line);
    if (keyword == "f") return element(line);
    if (keyword == "l" || keyword == "p") return add_to_sets(corners(line));
    if (keyword == "g") return groups(line);
    if (keyword == "o") {
      object_ = trimmed(line.rest());  // one name, blanks and all
      return;
    }
    for (const char* ignored : {"", "vt", "vn", "vp", "s", "usemtl", "mtllib"})
      if (keyword == ignored) return;
    if (strange_lines_++ == 0)
      strange_ = source_.at_place("statement " + in_quotes(keyword) + " is not known and is passed over");
  }

  void node(Source& line) {
    Vec3 x;
    for (int i = 0; i < 3; ++i) {
      const auto word = line.word_or_none();
      if (!parse(word, x[i])) source_.fail("expected three coordinates, got " + in_quotes(word));
    }
    builder_.add_node(static_cast<std::int64_t>(builder_.nodes()) + 1, x);
  }

  void element(Source& line) {
    const auto numbers = corners(line);
    if (numbers.size() < 3)
      source_.fail("expected a face of 3 corners or more, got " + std::to_string(numbers.size()));
    if (numbers.size() <= 4) {
      builder_.add_element(static_cast<std::int64_t>(builder_.elements()) + 1, numbers);
    } else {
      builder_.add_polygon(numbers);
      ++cut_;
    }
    add_to_sets(numbers);
  }

  // Vertex numbers of "3", "3/1", "3//2" or "3/1/2"; a negative number counts back from the last vertex.
  std::vector<std::int64_t> corners(Source& line) const {
    std::vector<std::int64_t> numbers;
    for (auto word = line.word_or_none(); !word.empty(); word = line.word_or_none()) {
      std::int64_t number = 0;
      if (!parse(word.substr(0, word.find('/')), number))
        source_.fail("expected the number of a vertex, got " + in_quotes(word));
      if (number < 0) number += static_cast<std::int64_t>(builder_.nodes()) + 1;
      if (!builder_.has_node(number)) source_.fail("vertex " + in_quotes(word) + " is not above this line");
      numbers.push_back(number);
    }
    return numbers;
  }

  void groups(Source& line) {
    groups_.clear();
    for (auto word = line.word_or_none(); !word.empty(); word = line.word_or_none())
      groups_.emplace_back(word);
  }

  void add_to_sets(const std::vector<std::int64_t>& numbers) {
    for (const std::string& group : groups_) builder_.add_to_set(group, numbers);
    if (!object_.empty()) builder_.add_to_set(object_, numbers);
  }

  Source source_;
  MeshBuilder builder_;
  std::vector<std::string> groups_;
  std::string object_;
  std::string continued_;
  std::string strange_;  // the first statement that is not known
  std::size_t strange_lines_ = 0, cut_ = 0;
};

}  // namespace

mesh::Mesh read_obj(const std::string& name, std::string_view bytes, Remarks* remarks) {
  return ObjReader(name, bytes).read(remarks);
}

}  // namespace fabricsh::format
