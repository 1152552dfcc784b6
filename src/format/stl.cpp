// Stereolithography's .stl, text and binary: facets without a common list of points. Vertices of equal
// coordinates are one node.
#include <array>
#include <unordered_map>

#include "format/mesh_builder.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

constexpr double kFlattest = 1e-6;  // height over longest edge of a facet, up to which it has no area

struct SameBits {
  std::size_t operator()(const std::array<double, 3>& x) const {
    std::uint64_t sum = 1469598103934665603u;
    for (const double c : x) sum = (sum ^ std::bit_cast<std::uint64_t>(c)) * 1099511628211u + (sum >> 29);
    return static_cast<std::size_t>(sum);
  }
};

class StlReader {
 public:
  StlReader(const std::string& name, std::string_view bytes)
      : source_(name, bytes), builder_(source_, 16 * bytes.size()), bytes_(bytes) {}

  mesh::Mesh read(Remarks* remarks) {
    if (is_binary())
      read_binary();
    else
      read_text();
    if (solids_.size() > 1)
      for (const auto& [name, nodes] : solids_) builder_.add_to_set(name, nodes);
    if (left_out_ > 0 && remarks != nullptr)
      remarks->push_back(source_.name() + ": " + std::to_string(left_out_) +
                         (left_out_ == 1 ? " facet" : " facets") +
                         " without area left out (corners at one place or on one line), the first is facet " +
                         std::to_string(first_));
    return builder_.finish();
  }

 private:
  // 80 bytes of anything, a count, 50 bytes a facet. Some that are binary begin with "solid" as well.
  bool is_binary() const {
    if (bytes_.size() < 84) return false;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes_.data() + 80, sizeof count);
    const bool fits = bytes_.size() == 84 + 50 * static_cast<std::uint64_t>(count);
    return fits || !bytes_.starts_with("solid");
  }

  void read_binary() {
    source_.set_binary(true);
    source_.swap_bytes(std::endian::native == std::endian::big);
    source_.take(80, "the header");
    const auto count =
        source_.checked("the number of facets", source_.raw<std::uint32_t>("the number of facets"), 50);
    for (std::int64_t i = 0; i < count; ++i) {
      source_.take(12, "a normal");
      std::array<std::int64_t, 3> corners{};
      for (auto& corner : corners) {
        Vec3 x;
        for (int k = 0; k < 3; ++k) x[k] = static_cast<double>(source_.raw<float>("a vertex"));
        corner = node(x);
      }
      source_.take(2, "a facet");
      add(corners);
    }
  }

  void expect(const char* wanted) {
    const auto word = source_.word(wanted);
    if (word != wanted) source_.fail(std::string("expected ") + wanted + ", got " + in_quotes(word));
  }

  // solid NAME ... endsolid NAME, each name to the end of its line.
  void read_text() {
    if (!bytes_.starts_with("solid"))
      source_.fail("expected a file that begins with 'solid', or a binary one of at least 84 bytes");
    for (auto word = source_.word_or_none(); !word.empty(); word = source_.word_or_none()) {
      if (word != "solid") source_.fail("expected solid, got " + in_quotes(word));
      solid_ = rest_of_line();
      for (word = source_.word("facet or endsolid"); word == "facet";
           word = source_.word("facet or endsolid"))
        read_facet();
      if (word != "endsolid") source_.fail("expected facet or endsolid, got " + in_quotes(word));
      rest_of_line();
    }
  }

  std::string rest_of_line() {
    std::string_view line;
    source_.next_line(line);
    const auto from = std::min(line.find_first_not_of(" \t"), line.size());
    const auto to = line.find_last_not_of(" \t");
    return from == line.size() ? "" : std::string(line.substr(from, to - from + 1));
  }

  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) source_.word("a normal");
    expect("outer");
    expect("loop");
    std::array<std::int64_t, 3> corners{};
    for (auto& corner : corners) {
      expect("vertex");
      Vec3 x;
      for (int i = 0; i < 3; ++i) x[i] = source_.real("a coordinate");
      corner = node(x);
    }
    add(corners);
    expect("endloop");
    expect("endfacet");
  }

  // -0 is 0.
  std::int64_t node(const Vec3& x) {
    const std::array<double, 3> key = {x.x() + 0.0, x.y() + 0.0, x.z() + 0.0};
    const auto number = static_cast<std::int64_t>(builder_.nodes()) + 1;
    const auto [found, fresh] = places_.emplace(key, number);
    if (fresh) builder_.add_node(number, positions_.emplace_back(key[0], key[1], key[2]));
    return found->second;
  }

  // Coordinates of single precision put three corners on one line only to that precision.
  bool is_flat(const std::array<std::int64_t, 3>& corners) const {
    const auto edge = [&](std::size_t i) {
      return Vec3(positions_[static_cast<std::size_t>(corners[(i + 1) % 3] - 1)] -
                  positions_[static_cast<std::size_t>(corners[i] - 1)]);
    };
    const double longest = std::max({edge(0).squaredNorm(), edge(1).squaredNorm(), edge(2).squaredNorm()});
    return edge(0).cross(edge(1)).norm() <= kFlattest * longest;
  }

  void add(const std::array<std::int64_t, 3>& corners) {
    ++facets_;
    if (is_flat(corners)) {
      if (left_out_++ == 0) first_ = facets_;
      return;
    }
    builder_.add_element(static_cast<std::int64_t>(builder_.elements()) + 1, corners);
    if (!solid_.empty()) solids_[solid_].insert(solids_[solid_].end(), corners.begin(), corners.end());
  }

  Source source_;
  MeshBuilder builder_;
  std::string_view bytes_;
  std::string solid_;
  std::size_t facets_ = 0, left_out_ = 0, first_ = 0;  // first_: the first facet that was left out, from 1
  std::map<std::string, std::vector<std::int64_t>> solids_;  // nodes, as often as they are named
  std::unordered_map<std::array<double, 3>, std::int64_t, SameBits> places_;
  std::vector<Vec3> positions_;
};

}  // namespace

mesh::Mesh read_stl(const std::string& name, std::string_view bytes, Remarks* remarks) {
  return StlReader(name, bytes).read(remarks);
}

}  // namespace fabricsh::format
