#include "format/deck_mesh.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "geometry/box.hpp"

namespace fabricsh::format {

void DeckMesh::fail_at(std::size_t place, const std::string& why) {
  source_.move_to(place);
  source_.fail(why);
}

void DeckMesh::add_element(std::int64_t number, std::size_t place, const std::vector<std::int64_t>& corners) {
  DeckElement element{{}, static_cast<int>(corners.size())};
  std::copy(corners.begin(), corners.end(), element.corners.begin());
  if (!elements_.emplace(number, element).second)
    source_.fail("element " + std::to_string(number) + " is defined twice");
  order_.emplace_back(number, place);
}

void DeckMesh::name_set(const std::string& key, Of of, const std::string& name) {
  sets(of).try_emplace(key, Set{name});
}

void DeckMesh::add(const std::string& set, Of of, std::size_t place, std::int64_t number) {
  const bool goes_on = !members_.empty() && members_.back().set == set && members_.back().of == of;
  if (!goes_on) members_.push_back({set, of, place});
  members_.back().numbers.push_back(number);
}

// The numbers from first to last that exist. A range that counts far beyond what the deck can
// hold is looked up the other way round.
DeckMesh::Numbers DeckMesh::of_range(const Members& members, const NumberRange& range) {
  const std::int64_t low = std::min(range.first, range.last), high = std::max(range.first, range.last);
  const auto step =
      range.step < 0 ? 0 - static_cast<std::uint64_t>(range.step) : static_cast<std::uint64_t>(range.step);
  if (step == 0) fail_at(members.place, "expected a step other than 0");
  const std::uint64_t width = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
  if (width / step > most_)
    fail_at(members.place, "a range from " + std::to_string(low) + " to " + std::to_string(high) +
                               " in steps of " + std::to_string(step) +
                               " counts further than a file of this size can go");
  Numbers found;
  for (std::uint64_t k = 0; k <= width / step; ++k) {
    const auto number = static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + k * step);
    const bool there =
        members.of == Of::nodes ? builder_.has_node(number) : elements_.find(number) != elements_.end();
    if (there) found.push_back(number);
  }
  most_ -= std::min<std::uint64_t>(most_, width / step);
  return found;
}

void DeckMesh::collect(const Members& members) {
  const bool of_nodes = members.of == Of::nodes;
  Numbers found;
  for (const std::int64_t number : members.numbers) {
    if (of_nodes ? !builder_.has_node(number) : elements_.find(number) == elements_.end())
      fail_at(members.place,
              std::string(of_nodes ? "node " : "element ") + std::to_string(number) + " is not in the file");
    found.push_back(number);
  }
  for (const NumberRange& range : members.ranges) {
    const Numbers there = of_range(members, range);
    found.insert(found.end(), there.begin(), there.end());
  }
  for (const std::string& key : members.sets) {
    const auto& among = members.of_elements ? element_sets_ : sets(members.of);
    const auto other = among.find(key);
    if (other == among.end())
      fail_at(members.place, "there is no set " + in_quotes(key) + " of " +
                                 (members.of_elements || !of_nodes ? "elements" : "nodes"));
    const Numbers& numbers = other->second.numbers;
    if (numbers.size() > most_)
      fail_at(members.place, "the sets have more members than a file of this size can name");
    most_ -= numbers.size();
    if (!members.of_elements) found.insert(found.end(), numbers.begin(), numbers.end());
    for (std::size_t i = 0; members.of_elements && i < numbers.size(); ++i) {
      const DeckElement& e = elements_.at(numbers[i]);
      found.insert(found.end(), e.corners.begin(), e.corners.begin() + e.size);
    }
  }
  Numbers& all = sets(members.of)[members.set].numbers;
  all.insert(all.end(), found.begin(), found.end());
}

// A set of elements is that of their nodes.
void DeckMesh::add_sets() {
  for (const auto& [key, set] : node_sets_) builder_.add_to_set(set.name, set.numbers);
  for (const auto& [key, set] : element_sets_) {
    if (set.name.empty()) continue;
    Numbers nodes;
    for (const std::int64_t number : set.numbers) {
      const DeckElement& e = elements_.at(number);
      nodes.insert(nodes.end(), e.corners.begin(), e.corners.begin() + e.size);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    builder_.add_to_set(set.name, nodes);
  }
}

void DeckMesh::pass_over(const std::string& statement, std::size_t place) {
  const auto known = std::find_if(passed_over_.begin(), passed_over_.end(),
                                  [&](const auto& p) { return p.statement == statement; });
  if (known != passed_over_.end()) {
    ++known->count;
    return;
  }
  const auto before = source_.bytes(0, place);
  passed_over_.push_back({statement, std::count(before.begin(), before.end(), '\n') + 1, 1});
}

void DeckMesh::rest_node(const std::string& keyword, std::size_t place, std::int64_t number,
                         const Vec3& position) {
  add_rest(keyword, place, {-1, number, position, place});
}

DeckMesh::RestCorner& DeckMesh::add_rest(const std::string& keyword, std::size_t place,
                                         const RestCorner& corner) {
  if (rest_.empty()) rest_keyword_ = keyword, rest_place_ = place;
  return rest_.emplace_back(corner);
}

void DeckMesh::rest_element(const std::string& keyword, std::size_t place, std::int64_t element,
                            const std::vector<std::int64_t>& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    add_rest(keyword, place, {element, static_cast<std::int64_t>(i), Vec3::Zero(), place}).like = nodes[i];
}

void DeckMesh::rest_corner(const std::string& keyword, std::size_t place, std::int64_t element,
                           std::size_t corner, const Vec3& position) {
  add_rest(keyword, place, {element, static_cast<std::int64_t>(corner), position, place});
}

// Nodes that it does not name stay where they are. Where it is given element by element, or part by part,
// these have to agree about the nodes that they share.
void DeckMesh::take_rest() {
  constexpr double same = 1e-6;  // of the size of the shape
  std::vector<Vec3> all;
  for (RestCorner& one : rest_) {
    if (one.like < 0) continue;
    if (!builder_.has_node(one.like))
      fail_at(one.place, "node " + std::to_string(one.like) + " is not in the file");
    one.position = builder_.position(one.like);
  }
  for (const RestCorner& one : rest_) all.push_back(one.position);
  const double near = same * box_of(all).size().norm();
  std::unordered_map<std::int64_t, Vec3> at;
  for (const RestCorner& one : rest_) {
    std::int64_t node = one.corner;
    if (one.element >= 0) {
      const auto found = elements_.find(one.element);
      if (found == elements_.end())
        fail_at(one.place, "element " + std::to_string(one.element) + " is not in the file");
      if (one.corner >= found->second.size) continue;
      node = found->second.corners[static_cast<std::size_t>(one.corner)];
    }
    if (!builder_.has_node(node)) fail_at(one.place, "node " + std::to_string(node) + " is not in the file");
    const auto [place, is_new] = at.emplace(node, one.position);
    if (!is_new && (place->second - one.position).norm() > near)
      fail_at(one.place,
              rest_keyword_ + ": " +
                  (one.element >= 0 ? "element " + std::to_string(one.element) + " has node " +
                                          std::to_string(node) + " at another place than an element before"
                                    : "node " + std::to_string(node) + " has another place before") +
                  ": expected one shape of all elements");
    builder_.move_node(node, one.position);
  }
}

mesh::Mesh DeckMesh::finish(bool at_rest, std::vector<std::string>* remarks) {
  if (at_rest && rest_.empty())
    throw Error(
        source_.name() +
        ": field 'reference': the file has no stress-free shape that is read "
        "(*AIRBAG_REFERENCE_GEOMETRY, *AIRBAG_SHELL_REFERENCE_GEOMETRY, *INITIAL_FOAM_REFERENCE_GEOMETRY; "
        "*INITIAL CONDITIONS, TYPE=REF COORDINATE; /XREF, /EREF)");
  if (at_rest) take_rest();
  if (!at_rest && !rest_.empty() && remarks != nullptr) {
    source_.move_to(rest_place_);
    remarks->push_back(source_.at_place(rest_keyword_ +
                                        " gives a stress-free shape, which this mesh leaves out: "
                                        "fabric.mesh.read{ file=..., reference=true } reads it, for "
                                        "reference= of a model"));
  }
  for (const auto& [number, place] : order_) {
    const DeckElement& e = elements_.at(number);
    source_.move_to(place);
    const std::span<const std::int64_t> corners(e.corners.data(), static_cast<std::size_t>(e.size));
    for (const std::int64_t node : corners)
      if (!builder_.has_node(node))
        source_.fail("element " + std::to_string(number) + ": node " + std::to_string(node) +
                     " is not in the file");
    if (e.size >= 3) builder_.add_element(number, corners);
  }
  for (const Members& members : members_) collect(members);
  add_sets();
  mesh::Mesh mesh = builder_.finish();
  mesh.passed_over = std::move(passed_over_);
  return mesh;
}

std::int64_t DeckReader::given_whole(std::string_view field, const char* what) const {
  std::int64_t number = 0;
  if (!parse(field, number))
    source_.fail(std::string("expected ") + what + ", a whole number, got " + in_quotes(field));
  return number;
}

Vec3 DeckReader::coordinates(const std::vector<std::string_view>& fields, std::size_t width_of_first,
                             std::size_t width) const {
  Vec3 x = Vec3::Zero();
  for (std::size_t i = 1; i < std::min<std::size_t>(fields.size(), 4); ++i) {
    if (fields[i].empty() || parse_fortran(fields[i], x[static_cast<Eigen::Index>(i) - 1])) continue;
    const std::size_t before = width_of_first + (i - 1) * width;
    source_.fail(
        "node " + std::string(fields[0]) + ": expected a coordinate, got " + in_quotes(fields[i]) +
        (width == 0 ? ""
                    : " in columns " + std::to_string(before + 1) + " to " + std::to_string(before + width)));
  }
  return x;
}

void DeckReader::remark(const std::string& text) const {
  if (remarks_ != nullptr) remarks_->push_back(source_.at_place(text));
}

void DeckReader::add_part(std::int64_t part, std::vector<std::int64_t> members, bool named) {
  const auto title = titles_.find(part);
  const bool titled = title != titles_.end() && !title->second.empty();
  mesh_.name_set(part_key(part), DeckMesh::Of::elements,
                 !named   ? ""
                 : titled ? title->second
                          : "part_" + std::to_string(part));
  mesh_.add({part_key(part), DeckMesh::Of::elements, place_, std::move(members)});
}

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
  return out;
}

std::vector<std::string_view> comma_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t end = std::min(line.find(',', from), line.size());
    fields.push_back(trimmed(line.substr(from, end - from)));
    from = end + 1;
  }
  return fields;
}

bool parse_fortran(std::string_view word, double& value) {
  std::string plain(word);
  for (char& c : plain)
    if (c == 'D' || c == 'd') c = 'e';
  return parse(plain, value);
}

}  // namespace fabricsh::format
