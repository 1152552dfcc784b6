// VTK's legacy .vtk: unstructured grids and polygonal data, text and binary (big-endian),
// versions 1 to 5. VTK's own reader is not used because it trusts the counts in the file.

#include "format/mesh_file.hpp"
#include "format/vtk_cells.hpp"

namespace fabricsh::format {

namespace {

struct Sets {
  std::string name;
  bool on_cells;
  std::vector<std::int64_t> values;
};

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return text;
}

// Packed bits have a byte of their own in text alone.
constexpr std::pair<std::string_view, StoredNumber> legacy_types[] = {
    {"char", StoredNumber::i8},           {"signed_char", StoredNumber::i8},
    {"unsigned_char", StoredNumber::u8},  {"bit", StoredNumber::u8},
    {"short", StoredNumber::i16},         {"unsigned_short", StoredNumber::u16},
    {"int", StoredNumber::i32},           {"unsigned_int", StoredNumber::u32},
    {"vtkidtype", StoredNumber::i32},     {"long", StoredNumber::i64},
    {"unsigned_long", StoredNumber::i64}, {"vtktypeint64", StoredNumber::i64},
    {"vtktypeuint64", StoredNumber::i64}, {"float", StoredNumber::f32},
    {"double", StoredNumber::f64}};

// In names %20 stands for a blank.
std::string plain_name(std::string_view word) {
  std::string text;
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool coded =
        word[i] == '%' && i + 2 < word.size() && digit(word[i + 1]) >= 0 && digit(word[i + 2]) >= 0;
    text += coded ? static_cast<char>(16 * digit(word[i + 1]) + digit(word[i + 2])) : word[i];
    if (coded) i += 2;
  }
  return text;
}

class LegacyReader {
 public:
  LegacyReader(const std::string& name, std::string_view bytes) : source_(name, bytes) {}

  mesh::Mesh read() {
    read_head();
    for (auto word = source_.word_or_none(); !word.empty(); word = source_.word_or_none())
      statement(lower(word));
    if (!has_points_) source_.fail("the file has no POINTS");
    VtkMesh mesh(source_, std::move(cells_));
    for (const Sets& set : sets_)
      if (set.values.size() == (set.on_cells ? mesh.cells() : mesh.points()))
        mesh.add_sets(set.name, set.on_cells, set.values);
    return mesh.finish();
  }

 private:
  void read_head() {
    constexpr std::string_view start = "# vtk DataFile Version ";
    const auto head = source_.line("# vtk DataFile Version");
    if (!head.starts_with(start))
      source_.fail("expected a .vtk file, which begins with # vtk DataFile Version");
    double version = 0;
    Source rest("", head.substr(start.size()));
    if (!parse(rest.word_or_none(), version) || version < 1 || version >= 6)
      source_.fail("expected version 1 to 5 of the format, got " + in_quotes(head.substr(start.size())));
    version_ = static_cast<int>(version);
    source_.line("a title");
    const auto mode = lower(source_.word("ASCII or BINARY"));
    if (mode != "ascii" && mode != "binary") source_.fail("expected ASCII or BINARY, got " + in_quotes(mode));
    binary_ = mode == "binary";
  }

  void statement(const std::string& word) {
    if (geometry(word)) return;
    if (word == "point_data" || word == "cell_data") return begin_data(word == "cell_data");
    if (word == "field") return read_field();
    if (word == "metadata") return skip_metadata();
    if (word == "lookup_table") return read_table();
    attributes(word);
  }

  bool geometry(const std::string& word) {
    if (word == "dataset")
      read_dataset();
    else if (word == "points")
      read_points();
    else if (word == "cells" || word == "polygons")
      read_cells(7);  // polygon
    else if (word == "vertices")
      read_cells(2);
    else if (word == "lines")
      read_cells(4);
    else if (word == "triangle_strips")
      source_.fail("triangle strips are not read: expected polygons");
    else if (word == "cell_types")
      read_types();
    else
      return false;
    return true;
  }

  void attributes(const std::string& word) {
    if (!in_data_) source_.fail("unknown word " + in_quotes(word));
    if (word == "scalars") return read_scalars();
    if (word == "color_scalars") return read_color_scalars();
    const auto name = source_.word("a name");
    if (word == "texture_coordinates") {
      const auto components = source_.integer("a number of components");
      const std::string type = type_word();
      return keep(name, type, components, items_);
    }
    const std::string type = type_word();
    if (word == "vectors" || word == "normals") return keep("", type, 3, items_);
    if (word == "tensors") return keep("", type, 9, items_);
    if (word == "tensors6") return keep("", type, 6, items_);
    if (word == "global_ids" || word == "pedigree_ids") return keep("", type, 1, items_);
    source_.fail("unknown word " + in_quotes(word));
  }

  void read_dataset() {
    const auto kind = lower(source_.word("a kind of dataset"));
    if (kind != "unstructured_grid" && kind != "polydata")
      source_.fail("expected the dataset UNSTRUCTURED_GRID or POLYDATA, got " + in_quotes(kind));
    grid_ = kind == "unstructured_grid";
  }
  void read_points() {
    if (has_points_) source_.fail("a second list of points");
    has_points_ = true;
    const auto n = source_.integer("a number of points");
    const std::string type = type_word();
    cells_.points = values<double>(type, product(n, 3));
  }

  // "CELLS rows size": up to version 4 rows "n id ... id", with `size`
  // numbers in all; from version 5 a list of offsets and one of ids.
  void read_cells(std::int64_t type) {
    const auto n = source_.count("a number of cells", 1);
    const auto size = source_.count("a size of cells", 1);
    const std::size_t before = cells_.count();
    if (version_ < 5)
      read_rows(n, size);
    else
      read_offsets(n, size);
    if (!grid_) cells_.types.insert(cells_.types.end(), cells_.count() - before, type);
  }

  void read_rows(std::int64_t rows, std::int64_t size) {
    const auto list = values<std::int64_t>("int", size);
    std::size_t at = 0;
    for (std::int64_t row = 0; row < rows; ++row) {
      if (at >= list.size()) source_.fail("the list of cells ends within cell " + std::to_string(row));
      const std::int64_t n = list[at++];
      if (n < 0 || static_cast<std::uint64_t>(n) > list.size() - at)
        source_.fail("cell " + std::to_string(row) + ": expected from 0 to " +
                     std::to_string(list.size() - at) + " corners, got " + std::to_string(n));
      const auto first = list.begin() + static_cast<std::ptrdiff_t>(at);
      cells_.connectivity.insert(cells_.connectivity.end(), first, first + static_cast<std::ptrdiff_t>(n));
      cells_.ends.push_back(static_cast<std::int64_t>(cells_.connectivity.size()));
      at += static_cast<std::size_t>(n);
    }
    if (at != list.size())
      source_.fail("the cells have " + std::to_string(at) + " numbers, expected " +
                   std::to_string(list.size()));
  }

  void read_offsets(std::int64_t offsets, std::int64_t size) {
    const auto base = static_cast<std::int64_t>(cells_.connectivity.size());
    if (lower(source_.word("OFFSETS")) != "offsets") source_.fail("expected OFFSETS");
    const std::string offset_type = type_word();
    const auto ends = values<std::int64_t>(offset_type, offsets);
    if (lower(source_.word("CONNECTIVITY")) != "connectivity") source_.fail("expected CONNECTIVITY");
    const std::string id_type = type_word();
    const auto ids = values<std::int64_t>(id_type, size);
    cells_.connectivity.insert(cells_.connectivity.end(), ids.begin(), ids.end());
    if (!ends.empty() && ends.front() != 0) source_.fail("expected the first offset to be 0");
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i] < 0 || ends[i] > size)
        source_.fail("expected an offset from 0 to " + std::to_string(size) + ", got " +
                     std::to_string(ends[i]));
      cells_.ends.push_back(base + ends[i]);
    }
  }

  void read_types() {
    const auto n = source_.count("a number of cell types", 1);
    cells_.types = values<std::int64_t>("int", n);
  }

  void begin_data(bool on_cells) {
    const auto n = source_.integer("a number of items");
    const auto wanted = static_cast<std::int64_t>(on_cells ? cells_.count() : cells_.points.size() / 3);
    if (n != wanted)
      source_.fail("expected data of " + std::to_string(wanted) + (on_cells ? " cells" : " points") +
                   ", got " + std::to_string(n));
    in_data_ = true;
    on_cells_ = on_cells;
    items_ = n;
  }

  // Format: "SCALARS name type [components]", then "LOOKUP_TABLE name".
  void read_scalars() {
    const auto name = source_.word("a name");
    const std::string type = type_word();
    std::int64_t components = 1;
    auto word = source_.word("LOOKUP_TABLE");
    if (parse(word, components)) word = source_.word("LOOKUP_TABLE");
    if (lower(word) != "lookup_table") source_.fail("expected LOOKUP_TABLE, got " + in_quotes(word));
    source_.word("the name of a table");
    keep(name, type, components, items_);
  }

  void read_table() {
    source_.word("the name of a table");
    const auto n = source_.integer("a size of the table");
    values<double>(binary_ ? "unsigned_char" : "float", product(n, 4));
  }
  void read_color_scalars() {
    source_.word("a name");
    const auto n = source_.integer("a number of components");
    values<double>(binary_ ? "unsigned_char" : "float", product(n, items_));
  }

  // Format: "FIELD name arrays", then for each array "name components items type".
  void read_field() {
    source_.word("a name");
    const auto n = source_.count("a number of arrays", 1);
    for (std::int64_t i = 0; i < n; ++i) {
      auto name = source_.word("a name");
      if (lower(name) == "metadata") {
        skip_metadata();
        name = source_.word("a name");
      }
      const auto components = source_.integer("a number of components");
      const auto items = source_.integer("a number of items");
      const std::string type = type_word();
      keep(name, type, components, items);
    }
  }

  // Metadata end with the next empty line.
  void skip_metadata() {
    source_.line("metadata");
    std::string_view line;
    while (source_.next_line(line) && !line.empty()) {
    }
  }
  // Reads an array, and keeps it if it has one integer for each point or cell.
  void keep(std::string_view name, const std::string& type, std::int64_t components, std::int64_t items) {
    const bool kept = in_data_ && components == 1 && items == items_ && type != "float" && type != "double";
    if (kept)
      sets_.push_back({plain_name(name), on_cells_, values<std::int64_t>(type, items)});
    else
      values<double>(type, product(components, items));
  }
  std::string type_word() {
    const std::string type = lower(source_.word("a type"));
    if (!stored_number(legacy_types, type))
      source_.fail("expected a type of numbers (int, float, double, ...), got " + in_quotes(type));
    return type;
  }
  // Counts are bounded by the size of the file, so that only the product of false counts can overflow.
  std::int64_t product(std::int64_t a, std::int64_t b) const {
    const auto most = static_cast<std::int64_t>(source_.size());
    if (a < 0 || b < 0 || (b > 0 && a > most / b))
      source_.fail("expected no more values than fit into the file, got " + std::to_string(a) + " x " +
                   std::to_string(b));
    return a * b;
  }
  template <class T>
  // Reads n values from here; in a binary file from the next line.
  std::vector<T> values(const std::string& type, std::int64_t n) {
    if (std::is_same_v<T, std::int64_t> && (type == "float" || type == "double"))
      source_.fail("expected a type of integers, got " + in_quotes(type));
    if (binary_) {
      source_.line("an array");
      source_.set_binary(true);
      source_.swap_bytes(std::endian::native == std::endian::little);
    }
    const bool packed = binary_ && type == "bit";
    const StoredNumber stored_as = *stored_number(legacy_types, type);
    if (!packed) source_.checked("a number of values", n, binary_ ? bytes_of(stored_as) : 2);
    if (packed) source_.checked("a number of values", (n + 7) / 8, 1);
    std::vector<T> list(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (packed) {
        const auto byte = static_cast<unsigned char>(source_.rest()[i / 8]);
        list[i] = static_cast<T>(byte >> (7 - i % 8) & 1);
      } else if (binary_) {
        list[i] = source_.stored<T>(stored_as, "an array");
      } else if constexpr (std::is_same_v<T, double>) {
        list[i] = source_.real("a value");
      } else {
        list[i] = source_.integer("a value");
      }
    }
    if (packed) source_.take(static_cast<std::size_t>((n + 7) / 8), "an array");
    source_.set_binary(false);
    return list;
  }

  Source source_;
  bool binary_ = false, grid_ = false, has_points_ = false, in_data_ = false, on_cells_ = false;
  int version_ = 0;
  std::int64_t items_ = 0;  // number of points or cells of the data being read
  VtkCells cells_;
  std::vector<Sets> sets_;
};

}  // namespace

mesh::Mesh read_legacy_vtk(const std::string& name, std::string_view bytes) {
  return LegacyReader(name, bytes).read();
}

}  // namespace fabricsh::format
