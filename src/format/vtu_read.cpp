// VTK's .vtu. VTK's own reader is not used because it trusts the
// counts and point ids in the file; only its decompression is used.
#include <vtkCallbackCommand.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "format/frame_file.hpp"
#include "format/mesh_file.hpp"
#include "format/source.hpp"
#include "format/vtk_cells.hpp"
#include "format/xml.hpp"

namespace fabricsh::format {

namespace {

// --- The arrays of a .vtu file: text, base64 or raw bytes, compressed or not.

struct VtuEncoding {
  bool big_endian = false;
  bool long_header = false;  // numbers in the headers of arrays take 8 bytes instead of 4
  std::string compressor;    // empty, or the name of VTK's compressor class
};

// The location and type of the values of one array.
struct VtuStored {
  enum class Encoding { ascii, base64, raw } form = Encoding::ascii;
  std::string_view bytes;
  std::string type;  // Int8 ... UInt64, Float32, Float64
};

// The largest possible compression ratio: deflate 1032, LZ4 255, LZMA some thousands for constant data.
std::uint64_t most_ratio(const std::string& compressor) {
  if (compressor == "vtkZLibDataCompressor") return 1040;
  if (compressor == "vtkLZ4DataCompressor") return 256;
  return compressor == "vtkLZMADataCompressor" ? 8000 : 1;
}

vtkSmartPointer<vtkDataCompressor> compressor_of(const std::string& name) {
  if (name == "vtkZLibDataCompressor") return vtkSmartPointer<vtkZLibDataCompressor>::New();
  if (name == "vtkLZ4DataCompressor") return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  if (name == "vtkLZMADataCompressor") return vtkSmartPointer<vtkLZMADataCompressor>::New();
  return nullptr;
}

// Whole numbers first.
constexpr std::pair<std::string_view, StoredNumber> vtu_types[] = {
    {"Int8", StoredNumber::i8},    {"UInt8", StoredNumber::u8},   {"Int16", StoredNumber::i16},
    {"UInt16", StoredNumber::u16}, {"Int32", StoredNumber::i32},  {"UInt32", StoredNumber::u32},
    {"Int64", StoredNumber::i64},  {"UInt64", StoredNumber::u64}, {"Float32", StoredNumber::f32},
    {"Float64", StoredNumber::f64}};

bool is_integer_type(std::string_view type) {
  const auto known = stored_number(vtu_types, type);
  return known && *known < StoredNumber::f32;
}

template <class T>
std::vector<T> words(const Source& source, std::string_view text) {
  Source list("", text);
  std::vector<T> values;
  for (auto word = list.word_or_none(); !word.empty(); word = list.word_or_none()) {
    values.emplace_back();
    if (!parse(word, values.back()))
      source.fail(std::string("expected ") + (std::is_same_v<T, double> ? "a number" : "a whole number") +
                  ", got " + in_quotes(word));
  }
  return values;
}

// VTK would print its error messages; the caller throws an Error instead.
std::size_t uncompress(vtkDataCompressor* compressor, std::string_view in, char* out, std::size_t size) {
  vtkNew<vtkCallbackCommand> quiet;
  compressor->AddObserver("ErrorEvent", quiet);
  compressor->AddObserver("WarningEvent", quiet);
  return compressor->Uncompress(reinterpret_cast<const unsigned char*>(in.data()), in.size(),
                                reinterpret_cast<unsigned char*>(out), size);
}

int sextet(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

// Decoding ends at the first character outside base64; padding may occur between parts encoded separately.
std::string decode_base64(std::string_view text) {
  std::string bytes;
  unsigned group = 0;
  int filled = 0;
  for (const char c : text) {
    if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
    if (c == '=') {  // the rest of the group of four is padding; more groups may follow
      group = 0;
      filled = 0;
      continue;
    }
    const int value = sextet(c);
    if (value < 0) break;
    group = group << 6 | static_cast<unsigned>(value);
    // The second, third and fourth character of a group each complete a byte.
    if (++filled >= 2) bytes += static_cast<char>(group >> (6 - 2 * (filled - 1)) & 0xFFu);
    if (filled == 4) group = 0, filled = 0;
  }
  return bytes;
}

class VtuDecoder {
 public:
  VtuDecoder(const Source& source, VtuEncoding encoding)
      : source_(source), encoding_(std::move(encoding)), ratio_(most_ratio(encoding_.compressor)) {
    if (!encoding_.compressor.empty() && compressor_of(encoding_.compressor) == nullptr)
      source_.fail("unknown compressor " + in_quotes(encoding_.compressor));
    budget_ = ratio_ * source.size();
  }
  // All values of the array. Error: text that is not a number, or sizes that do not match the bytes.
  std::vector<std::int64_t> integers(const VtuStored& stored) {
    if (!is_integer_type(stored.type))
      source_.fail("expected an array of integers, got " + in_quotes(stored.type));
    return values<std::int64_t>(stored);
  }
  std::vector<double> reals(const VtuStored& stored) {
    if (!stored_number(vtu_types, stored.type))
      source_.fail("expected an array of numbers, got " + in_quotes(stored.type));
    return values<double>(stored);
  }

 private:
  template <class T>
  std::vector<T> values(const VtuStored& stored) {
    if (stored.form == VtuStored::Encoding::ascii) return words<T>(source_, stored.bytes);
    const std::string bytes = stored.form == VtuStored::Encoding::raw ? payload(stored.bytes)
                                                                      : payload(decode_base64(stored.bytes));
    const StoredNumber type = *stored_number(vtu_types, stored.type);
    if (bytes.size() % bytes_of(type) != 0)
      source_.fail("an array of " + stored.type + " has " + std::to_string(bytes.size()) + " bytes");
    Source source("", bytes);
    source.swap_bytes(encoding_.big_endian);
    std::vector<T> values(bytes.size() / bytes_of(type));
    for (T& value : values) value = source.stored<T>(type, "a value");
    return values;
  }
  // The bytes of the numbers, from base64 or raw.
  // Layout: [number of bytes][bytes].
  std::string payload(std::string_view stored) {
    if (!encoding_.compressor.empty()) return inflated(stored);
    const std::uint64_t bytes = header(stored);
    if (bytes > stored.size())
      source_.fail("an array claims " + std::to_string(bytes) + " bytes, but only " +
                   std::to_string(stored.size()) + " follow");
    count_bytes(bytes);
    return std::string(stored.substr(0, bytes));
  }

  // The same of compressed blocks.
  // Layout: [blocks][size of a block][size of the last one, 0: full][compressed size of each block][blocks].
  std::string inflated(std::string_view stored) {
    const std::uint64_t blocks = header(stored), size = header(stored), last = header(stored);
    const std::size_t each = encoding_.long_header ? 8 : 4;
    if (blocks > stored.size() / each)
      source_.fail("an array claims " + std::to_string(blocks) + " compressed blocks");
    if (last > size) source_.fail("the last block of an array claims to be larger than the others");
    std::vector<std::uint64_t> sizes(blocks);
    for (auto& compressed : sizes) compressed = header(stored);
    const auto compressor = compressor_of(encoding_.compressor);
    std::string bytes;
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::uint64_t wanted = b + 1 == blocks && last != 0 ? last : size;
      if (sizes[b] > stored.size()) source_.fail("the file ends within a compressed block");
      if (wanted / ratio_ > sizes[b]) source_.fail("a compressed block claims more bytes than it can hold");
      count_bytes(wanted);
      const std::size_t before = bytes.size();
      bytes.resize(before + wanted);
      if (wanted > 0 &&
          uncompress(compressor, stored.substr(0, sizes[b]), bytes.data() + before, wanted) != wanted)
        source_.fail("a compressed block is damaged");
      stored.remove_prefix(sizes[b]);
    }
    return bytes;
  }

  // Takes the next number of a header off the front.
  std::uint64_t header(std::string_view& stored) const {
    const std::size_t size = encoding_.long_header ? 8 : 4;
    if (stored.size() < size) source_.fail("the file ends within the header of an array");
    Source number("", stored.substr(0, size));
    number.swap_bytes(encoding_.big_endian);
    stored.remove_prefix(size);
    return encoding_.long_header ? number.raw<std::uint64_t>("") : number.raw<std::uint32_t>("");
  }
  // Error: more than the budget.
  void count_bytes(std::uint64_t bytes) {
    if (bytes > budget_) source_.fail("the arrays claim more bytes than a file of this size can hold");
    budget_ -= bytes;
  }

  const Source& source_;
  VtuEncoding encoding_;
  std::uint64_t ratio_;   // the largest possible ratio of this compression
  std::uint64_t budget_;  // bytes of arrays that may still be decoded from this file
};

// --- The file.

constexpr std::int64_t kTriangle = 5, kQuadrilateral = 9;  // of VTK's types of cells

struct DataArray {
  std::string parent, name, type, format;
  std::vector<std::string> component_names;
  std::int64_t components = 1;
  std::size_t begin = 0, end = 0;      // range of the text between its tags
  std::optional<std::int64_t> offset;  // in the appended data
};

class VtuReader {
 public:
  VtuReader(const std::string& name, std::string_view bytes) : source_(name, bytes) {}

  mesh::Mesh read() {
    scan();
    if (!head_) source_.fail("expected a .vtu file, which begins with <VTKFile>");
    if (pieces_ == 0) source_.fail("the file has no <Piece>");
    VtuDecoder decoder(source_, encoding_);
    VtkMesh mesh(source_, cells(decoder));
    for (const DataArray& array : arrays_) {
      const bool on_cells = array.parent == "CellData";
      if ((!on_cells && array.parent != "PointData") || array.components != 1 || !is_integer_type(array.type))
        continue;
      source_.move_to(array.begin);
      const auto values = decoder.integers(stored(array));
      expect("values of array " + in_quotes(array.name), on_cells ? mesh.cells() : mesh.points(),
             values.size());
      mesh.add_sets(array.name, on_cells, values);
    }
    return mesh.finish();
  }

  // The points and cells in the order of the file, which a mesh would number anew.
  FrameFile read_frame(const std::vector<std::string>& wanted) {
    scan();
    if (!head_) source_.fail("expected a .vtu file, which begins with <VTKFile>");
    if (pieces_ == 0) source_.fail("the file has no <Piece>");
    VtuDecoder decoder(source_, encoding_);
    const VtkCells all = cells(decoder);
    const VtkMesh checked(source_, all);
    FrameFile frame;
    for (std::size_t i = 0; i < points_; ++i)
      frame.points.emplace_back(all.points[3 * i], all.points[3 * i + 1], all.points[3 * i + 2]);
    for (std::size_t i = 0; i < all.count(); ++i) {
      const auto corners = all.corners(i);
      if (all.types[i] != kTriangle && all.types[i] != kQuadrilateral)
        source_.fail("cell " + std::to_string(i) +
                     ": expected a triangle (5) or quadrilateral (9), got type " +
                     std::to_string(all.types[i]));
      frame.cells.push_back({corners[0], corners[1], corners[2], corners.size() == 3 ? -1 : corners[3]});
    }
    for (const DataArray& array : arrays_) {
      const bool on_cells = array.parent == "CellData";
      if (!on_cells && array.parent != "PointData") continue;
      frame.names += " " + array.name;
      if (std::find(wanted.begin(), wanted.end(), array.name) == wanted.end()) continue;
      source_.move_to(array.begin);
      FrameArray out{array.name, on_cells, static_cast<std::size_t>(array.components), array.component_names,
                     decoder.reals(stored(array))};
      expect("values of array " + in_quotes(array.name), (on_cells ? cells_ : points_) * out.components,
             out.values.size());
      frame.arrays.push_back(std::move(out));
    }
    return frame;
  }

 private:
  void scan() {
    XmlTags tags(source_);
    XmlTag tag;
    while (appended_ == 0 && tags.next(tag)) {
      const auto& names = tags.open();
      if (!tag.opens) continue;
      open(tag, names.size() < 2 ? "" : names[names.size() - 2]);
    }
  }
  void open(const XmlTag& tag, const std::string& parent) {
    if (!head_) return read_head(tag);
    if (tag.name == "Piece") return read_piece(tag);
    if (tag.name == "DataArray") return read_array(tag, parent);
    if (tag.name == "AppendedData") find_appended(tag);
  }

  void read_head(const XmlTag& tag) {
    if (tag.name != "VTKFile") source_.fail("expected <VTKFile>, got <" + tag.name + ">");
    const std::string type = attribute(tag, "type", nullptr);
    if (type != "UnstructuredGrid")
      source_.fail("expected a file of type UnstructuredGrid, got " + in_quotes(type));
    const std::string order = attribute(tag, "byte_order", "LittleEndian");
    const std::string header = attribute(tag, "header_type", "UInt32");
    if (order != "LittleEndian" && order != "BigEndian")
      source_.fail("unknown byte_order " + in_quotes(order));
    if (header != "UInt32" && header != "UInt64") source_.fail("unknown header_type " + in_quotes(header));
    encoding_ = {order == "BigEndian", header == "UInt64", attribute(tag, "compressor", "")};
    head_ = true;
  }

  void read_piece(const XmlTag& tag) {
    if (++pieces_ > 1) source_.fail("the grid is in several pieces: expected one");
    points_ = static_cast<std::size_t>(number(tag, "NumberOfPoints", 0));
    cells_ = static_cast<std::size_t>(number(tag, "NumberOfCells", 0));
  }

  void read_array(const XmlTag& tag, const std::string& parent) {
    DataArray array;
    array.parent = parent;
    array.name = attribute(tag, "Name", "");
    array.type = attribute(tag, "type", nullptr);
    array.format = attribute(tag, "format", "ascii");
    if (tag.attributes.contains("NumberOfComponents"))
      array.components = number(tag, "NumberOfComponents", 0);
    for (std::int64_t c = 0; c < std::min<std::int64_t>(array.components, 16); ++c)
      array.component_names.push_back(attribute(tag, ("ComponentName" + std::to_string(c)).c_str(), ""));
    if (array.format == "appended") array.offset = number(tag, "offset", 0);
    array.begin = tag.behind;
    array.end = tag.empty ? tag.behind : tag.behind + std::min(source_.rest().find('<'), source_.left());
    arrays_.push_back(std::move(array));
  }

  void find_appended(const XmlTag& tag) {
    const std::string encoding = attribute(tag, "encoding", "base64");
    if (encoding != "raw" && encoding != "base64") source_.fail("unknown encoding " + in_quotes(encoding));
    appended_raw_ = encoding == "raw";
    source_.skip_blanks();
    if (!source_.rest().starts_with('_')) source_.fail("expected _ before the appended data");
    appended_ = source_.place() + 1;
  }
  std::string attribute(const XmlTag& tag, const char* name, const char* otherwise) const {
    const auto found = tag.attributes.find(name);
    if (found != tag.attributes.end()) return found->second;
    if (otherwise == nullptr) source_.fail("<" + tag.name + "> has no " + name);
    return otherwise;
  }
  std::int64_t number(const XmlTag& tag, const char* name, std::int64_t least) const {
    const std::string text = attribute(tag, name, nullptr);
    std::int64_t value = 0;
    if (!parse(text, value) || value < least)
      source_.fail("<" + tag.name + ">: expected " + name + ", a whole number from " + std::to_string(least) +
                   ", got " + in_quotes(text));
    return value;
  }
  const DataArray& array(const char* parent, const char* name) const {
    for (const DataArray& array : arrays_)
      if (array.parent == parent && (*name == '\0' || array.name == name)) return array;
    source_.fail(std::string("no array ") + (*name == '\0' ? "" : in_quotes(name) + " ") + "in <" + parent +
                 ">");
  }

  // Appended base64 ends where the next array begins, so that no array is decoded with those after it.
  VtuStored stored(const DataArray& array) const {
    using Encoding = VtuStored::Encoding;
    if (array.format == "ascii") return {Encoding::ascii, source_.bytes(array.begin, array.end), array.type};
    if (array.format == "binary")
      return {Encoding::base64, source_.bytes(array.begin, array.end), array.type};
    if (array.format != "appended")
      source_.fail("array " + in_quotes(array.name) + ": unknown format " + in_quotes(array.format));
    const std::size_t room = appended_ == 0 ? 0 : source_.size() - appended_;
    const auto offset = static_cast<std::size_t>(*array.offset);
    if (offset >= room)
      source_.fail("array " + in_quotes(array.name) + ": expected an offset below " + std::to_string(room) +
                   ", got " + std::to_string(offset));
    std::size_t end = room;
    for (const DataArray& other : arrays_)
      if (other.offset && *other.offset > *array.offset)
        end = std::min(end, static_cast<std::size_t>(*other.offset));
    if (appended_raw_) end = room;
    return {appended_raw_ ? Encoding::raw : Encoding::base64,
            source_.bytes(appended_ + offset, appended_ + end), array.type};
  }

  std::vector<std::int64_t> integers(VtuDecoder& decoder, const char* parent, const char* name) const {
    return decoder.integers(stored(array(parent, name)));
  }

  VtkCells cells(VtuDecoder& decoder) {
    VtkCells cells;
    const DataArray& points = array("Points", "");
    source_.move_to(points.begin);
    if (points.components != 3)
      source_.fail("expected points of 3 components, got " + std::to_string(points.components));
    cells.points = decoder.reals(stored(points));
    if (cells.points.size() % 3 != 0 || cells.points.size() / 3 != points_)
      source_.fail("expected three coordinates for each of " + std::to_string(points_) + " points, got " +
                   std::to_string(cells.points.size()) + " numbers");
    source_.move_to(array("Cells", "connectivity").begin);
    cells.connectivity = integers(decoder, "Cells", "connectivity");
    source_.move_to(array("Cells", "offsets").begin);
    cells.ends = integers(decoder, "Cells", "offsets");
    expect("offsets of cells", cells_, cells.ends.size());
    source_.move_to(array("Cells", "types").begin);
    cells.types = integers(decoder, "Cells", "types");
    return cells;
  }

  void expect(const std::string& what, std::size_t wanted, std::size_t got) const {
    if (wanted != got)
      source_.fail("expected " + std::to_string(wanted) + " " + what + ", got " + std::to_string(got));
  }

  Source source_;
  VtuEncoding encoding_;
  std::vector<DataArray> arrays_;
  int pieces_ = 0;
  std::size_t points_ = 0, cells_ = 0, appended_ = 0;  // appended_: first byte of appended data, 0 if none
  bool head_ = false, appended_raw_ = false;
};

}  // namespace

const FrameArray* FrameFile::find(std::string_view name) const {
  const FrameArray* found = nullptr;
  for (const FrameArray& array : arrays)
    if (array.name == name && (found == nullptr || !array.on_cells)) found = &array;
  return found;
}

FrameFile read_vtu_frame(const std::string& name, std::string_view bytes,
                         const std::vector<std::string>& wanted) {
  return VtuReader(name, bytes).read_frame(wanted);
}

mesh::Mesh read_vtu(const std::string& name, std::string_view bytes) { return VtuReader(name, bytes).read(); }

}  // namespace fabricsh::format
