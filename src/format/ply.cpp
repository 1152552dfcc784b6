// Stanford's .ply, text and binary: vertices with x, y, z and faces with a list of vertex_indices (or
// vertex_index). Other properties and elements are passed over.
#include <array>

#include "format/mesh_builder.hpp"
#include "format/mesh_file.hpp"
#include "format/table_line.hpp"

namespace fabricsh::format {

namespace {

constexpr std::array<std::pair<std::string_view, StoredNumber>, 16> types = {
    {{"char", StoredNumber::i8},
     {"uchar", StoredNumber::u8},
     {"short", StoredNumber::i16},
     {"ushort", StoredNumber::u16},
     {"int", StoredNumber::i32},
     {"uint", StoredNumber::u32},
     {"float", StoredNumber::f32},
     {"double", StoredNumber::f64},
     {"int8", StoredNumber::i8},
     {"uint8", StoredNumber::u8},
     {"int16", StoredNumber::i16},
     {"uint16", StoredNumber::u16},
     {"int32", StoredNumber::i32},
     {"uint32", StoredNumber::u32},
     {"float32", StoredNumber::f32},
     {"float64", StoredNumber::f64}}};

struct Property {
  std::string name;
  bool list = false;
  StoredNumber count = StoredNumber::u8, type = StoredNumber::f32;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties = {};
};

class PlyReader {
 public:
  PlyReader(const std::string& name, std::string_view bytes)
      : source_(name, bytes), builder_(source_, 16 * bytes.size()) {}  // the limit of members of sets

  mesh::Mesh read(Remarks* remarks) {
    read_header();
    for (const PlyElement& element : elements_) read_element(element);
    if (cut_ > 0 && remarks != nullptr)
      remarks->push_back(source_.name() + ": " + std::to_string(cut_) + (cut_ == 1 ? " face" : " faces") +
                         " with more than four corners cut into triangles from the first corner");
    return builder_.finish();
  }

 private:
  void read_header() {
    if (trimmed(source_.line("ply")) != "ply") source_.fail("expected a file that begins with 'ply'");
    for (;;) {
      Source line("", source_.line("end_header"));
      const auto keyword = line.word_or_none();
      if (keyword == "end_header") break;
      if (keyword == "format") read_format(line.word_or_none());
      if (keyword == "element")
        elements_.push_back({std::string(line.word_or_none()), whole(line.word_or_none())});
      if (keyword == "property") read_property(line);
    }
    source_.set_binary(binary_);
    source_.swap_bytes(swapped_);
  }

  void read_format(std::string_view format) {
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      source_.fail("expected the format ascii, binary_little_endian or binary_big_endian, got " +
                   in_quotes(format));
    binary_ = format != "ascii";
    swapped_ = binary_ && (format == "binary_big_endian") != (std::endian::native == std::endian::big);
  }

  std::int64_t whole(std::string_view word) const {
    std::int64_t value = 0;
    if (!parse(word, value) || value < 0)
      source_.fail("expected a number of elements, got " + in_quotes(word));
    return value;
  }

  StoredNumber type(std::string_view word) const {
    if (const auto number = stored_number(types, word)) return *number;
    source_.fail("expected a type of number (float, int, ...), got " + in_quotes(word));
  }

  void read_property(Source& line) {
    if (elements_.empty()) source_.fail("a property before the first element");
    Property property;
    auto word = line.word_or_none();
    property.list = word == "list";
    if (property.list) {
      property.count = type(line.word_or_none());
      word = line.word_or_none();
    }
    property.type = type(word);
    property.name = line.word_or_none();
    elements_.back().properties.push_back(std::move(property));
  }

  double stored(StoredNumber type) {
    return binary_ ? source_.stored<double>(type, "a number") : source_.real("a number");
  }

  // Each element takes a byte of the file at least.
  void read_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    source_.checked("a number of elements", element.count, 1);
    for (std::int64_t i = 0; i < element.count; ++i) {
      Vec3 x = Vec3::Zero();
      std::vector<std::int64_t> corners;
      for (const Property& property : element.properties) {
        if (property.list) {
          const bool ours = property.name == "vertex_indices" || property.name == "vertex_index";
          read_list(property, ours ? &corners : nullptr);
          continue;
        }
        const double value = stored(property.type);
        for (int k = 0; k < 3; ++k)
          if (property.name == std::string_view("xyz").substr(static_cast<std::size_t>(k), 1)) x[k] = value;
      }
      if (element.name == "vertex") builder_.add_node(static_cast<std::int64_t>(builder_.nodes()), x);
      if (element.name == "face") face(corners);
    }
  }

  void read_list(const Property& property, std::vector<std::int64_t>* kept) {
    const double count = stored(property.count);
    if (!(count >= 0 && count <= static_cast<double>(source_.left())))
      source_.fail("expected the length of a list, got " + std::to_string(count));
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const double value = stored(property.type);
      if (kept != nullptr) kept->push_back(static_cast<std::int64_t>(value));
    }
  }

  void face(const std::vector<std::int64_t>& corners) {
    if (corners.size() < 3)
      source_.fail("expected a face of 3 corners or more, got " + std::to_string(corners.size()));
    const auto number = [this] { return static_cast<std::int64_t>(builder_.elements()) + 1; };
    if (corners.size() <= 4) return builder_.add_element(number(), corners);
    builder_.add_polygon(corners);
    ++cut_;
  }

  Source source_;
  MeshBuilder builder_;
  std::vector<PlyElement> elements_;
  bool binary_ = false, swapped_ = false;
  std::size_t cut_ = 0;
};

}  // namespace

mesh::Mesh read_ply(const std::string& name, std::string_view bytes, Remarks* remarks) {
  return PlyReader(name, bytes).read(remarks);
}

}  // namespace fabricsh::format
