// VTK's .vtu. VTK's own reader is not used because it trusts the
// counts and point ids in the file; only its decompression is used.
#include <algorithm>
#include <optional>

#include "format/frame_file.hpp"
#include "format/mesh_file.hpp"
#include "format/vtk_cells.hpp"
#include "format/vtu_data.hpp"
#include "format/xml.hpp"

namespace fabricsh::format {

namespace {

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
  mesh::Mesh read();
  FrameFile read_frame(const std::vector<std::string>& wanted);

 private:
  void scan();
  void open(const XmlTag& tag, const std::string& parent);
  void read_head(const XmlTag& tag);
  void read_piece(const XmlTag& tag);
  void read_array(const XmlTag& tag, const std::string& parent);
  void find_appended(const XmlTag& tag);
  std::string attribute(const XmlTag& tag, const char* name, const char* otherwise) const;
  std::int64_t number(const XmlTag& tag, const char* name, std::int64_t least) const;
  const DataArray& array(const char* parent, const char* name) const;
  VtuStored stored(const DataArray& array) const;
  std::vector<std::int64_t> integers(VtuDecoder& decoder, const char* parent, const char* name) const;
  VtkCells cells(VtuDecoder& decoder);
  void expect(const std::string& what, std::size_t wanted, std::size_t got) const;

  Source source_;
  VtuEncoding encoding_;
  std::vector<DataArray> arrays_;
  int pieces_ = 0;
  std::size_t points_ = 0, cells_ = 0, appended_ = 0;  // appended_: first byte of appended data, 0 if none
  bool head_ = false, appended_raw_ = false;
};

std::string VtuReader::attribute(const XmlTag& tag, const char* name, const char* otherwise) const {
  const auto found = tag.attributes.find(name);
  if (found != tag.attributes.end()) return found->second;
  if (otherwise == nullptr) source_.fail("<" + tag.name + "> has no " + name);
  return otherwise;
}

std::int64_t VtuReader::number(const XmlTag& tag, const char* name, std::int64_t least) const {
  const std::string text = attribute(tag, name, nullptr);
  std::int64_t value = 0;
  if (!parse(text, value) || value < least)
    source_.fail("<" + tag.name + ">: expected " + name + ", a whole number from " + std::to_string(least) +
                 ", got " + in_quotes(text));
  return value;
}

void VtuReader::scan() {
  XmlTags tags(source_);
  XmlTag tag;
  while (appended_ == 0 && tags.next(tag)) {
    const auto& names = tags.open();
    if (!tag.opens) continue;
    open(tag, names.size() < 2 ? "" : names[names.size() - 2]);
  }
}

void VtuReader::open(const XmlTag& tag, const std::string& parent) {
  if (!head_) return read_head(tag);
  if (tag.name == "Piece") return read_piece(tag);
  if (tag.name == "DataArray") return read_array(tag, parent);
  if (tag.name == "AppendedData") find_appended(tag);
}

void VtuReader::read_head(const XmlTag& tag) {
  if (tag.name != "VTKFile") source_.fail("expected <VTKFile>, got <" + tag.name + ">");
  const std::string type = attribute(tag, "type", nullptr);
  if (type != "UnstructuredGrid")
    source_.fail("expected a file of type UnstructuredGrid, got " + in_quotes(type));
  const std::string order = attribute(tag, "byte_order", "LittleEndian");
  const std::string header = attribute(tag, "header_type", "UInt32");
  if (order != "LittleEndian" && order != "BigEndian") source_.fail("unknown byte_order " + in_quotes(order));
  if (header != "UInt32" && header != "UInt64") source_.fail("unknown header_type " + in_quotes(header));
  encoding_ = {order == "BigEndian", header == "UInt64", attribute(tag, "compressor", "")};
  head_ = true;
}

void VtuReader::read_piece(const XmlTag& tag) {
  if (++pieces_ > 1) source_.fail("the grid is in several pieces: expected one");
  points_ = static_cast<std::size_t>(number(tag, "NumberOfPoints", 0));
  cells_ = static_cast<std::size_t>(number(tag, "NumberOfCells", 0));
}

void VtuReader::read_array(const XmlTag& tag, const std::string& parent) {
  DataArray array;
  array.parent = parent;
  array.name = attribute(tag, "Name", "");
  array.type = attribute(tag, "type", nullptr);
  array.format = attribute(tag, "format", "ascii");
  if (tag.attributes.contains("NumberOfComponents")) array.components = number(tag, "NumberOfComponents", 0);
  for (std::int64_t c = 0; c < std::min<std::int64_t>(array.components, 16); ++c)
    array.component_names.push_back(attribute(tag, ("ComponentName" + std::to_string(c)).c_str(), ""));
  if (array.format == "appended") array.offset = number(tag, "offset", 0);
  array.begin = tag.behind;
  array.end = tag.empty ? tag.behind : tag.behind + std::min(source_.rest().find('<'), source_.left());
  arrays_.push_back(std::move(array));
}

void VtuReader::find_appended(const XmlTag& tag) {
  const std::string encoding = attribute(tag, "encoding", "base64");
  if (encoding != "raw" && encoding != "base64") source_.fail("unknown encoding " + in_quotes(encoding));
  appended_raw_ = encoding == "raw";
  source_.skip_blanks();
  if (!source_.rest().starts_with('_')) source_.fail("expected _ before the appended data");
  appended_ = source_.place() + 1;
}

const DataArray& VtuReader::array(const char* parent, const char* name) const {
  for (const DataArray& array : arrays_)
    if (array.parent == parent && (*name == '\0' || array.name == name)) return array;
  source_.fail(std::string("no array ") + (*name == '\0' ? "" : in_quotes(name) + " ") + "in <" + parent +
               ">");
}

// Appended base64 ends where the next array begins, so that no array is decoded with those after it.
VtuStored VtuReader::stored(const DataArray& array) const {
  using Encoding = VtuStored::Encoding;
  if (array.format == "ascii") return {Encoding::ascii, source_.bytes(array.begin, array.end), array.type};
  if (array.format == "binary") return {Encoding::base64, source_.bytes(array.begin, array.end), array.type};
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

void VtuReader::expect(const std::string& what, std::size_t wanted, std::size_t got) const {
  if (wanted != got)
    source_.fail("expected " + std::to_string(wanted) + " " + what + ", got " + std::to_string(got));
}

std::vector<std::int64_t> VtuReader::integers(VtuDecoder& decoder, const char* parent,
                                              const char* name) const {
  return decoder.integers(stored(array(parent, name)));
}

VtkCells VtuReader::cells(VtuDecoder& decoder) {
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

mesh::Mesh VtuReader::read() {
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
FrameFile VtuReader::read_frame(const std::vector<std::string>& wanted) {
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
      source_.fail("cell " + std::to_string(i) + ": expected a triangle (5) or quadrilateral (9), got type " +
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
