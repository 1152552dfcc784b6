#include "model/declarations.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/number.hpp"
#include "law/law.hpp"
#include "mesh/check.hpp"
#include "model/declaration_rows.hpp"
#include "model/model.hpp"

namespace fabricsh::model {

Mat3 frame_from(const Vec3& e1, const Vec3& e2) {
  const Vec3 third = e1.cross(e2);
  if (!(third.norm() > 1e-9 * e1.norm() * e2.norm()) || !std::isfinite(third.norm()))
    throw Error("frame: expected two directions {e1, e2} that are not parallel");
  Mat3 frame;
  frame.row(0) = e1.normalized().transpose();
  frame.row(2) = third.normalized().transpose();
  frame.row(1) = frame.row(2).cross(frame.row(0));
  return frame;
}

namespace {

std::string quoted_word(const std::string& s) { return "'" + s + "'"; }

void take_word(FixedFreedoms& f, const std::string& word, const std::string& call) {
  if (word == "rotation") {
    f.rotation = true;
    return;
  }
  for (std::size_t i = 0; i < freedom_names.size(); ++i)
    if (word == freedom_names.at(i)) {
      (i < 3 ? f.translation.at(i) : f.axis.at(i - 3)) = true;
      return;
    }
  throw Error(call + ": unknown freedom " + quoted_word(word) + ", expected some of x y z rx ry rz rotation");
}

}  // namespace

FixedFreedoms parse_freedoms(const std::string& words, const std::string& call) {
  FixedFreedoms f;
  std::string word;
  bool any = false;
  for (const char c : words + " ") {
    if (c != ' ' && c != ',' && c != '\t' && c != '\n') {
      word += c;
      continue;
    }
    if (word.empty()) continue;
    take_word(f, word, call);
    any = true;
    word.clear();
  }
  if (!any) throw Error(call + ": no freedom named, expected some of x y z rx ry rz rotation");
  return f;
}

std::vector<std::string> held_words(const FixedFreedoms& freedoms) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < freedom_names.size(); ++i)
    if (i < 3 ? freedoms.translation.at(i) : freedoms.axis.at(i - 3)) words.emplace_back(freedom_names.at(i));
  if (freedoms.rotation) words.emplace_back("rotation");
  return words;
}

Support symmetry(const std::string& set, int axis) {
  Support held{set, {}, global_frame(), axis};
  held.fixed.axis = {true, true, true};
  held.fixed.translation.at(static_cast<std::size_t>(axis)) = true;
  held.fixed.axis.at(static_cast<std::size_t>(axis)) = false;
  return held;
}

namespace {

// What is shared among the nodes of a set goes by the area of its whole elements, and if it has none by the
// length of its whole edges. Error: then a line beside the elements, or a node beside the edges, has no
// share. Single nodes about elements are those of a border that cuts through others.
void check_shares(const mesh::Mesh& mesh, const mesh::NodeSet& nodes, const std::string& call,
                  const std::string& set) {
  const auto in = [](const mesh::NodeSet& list, Index n) {
    return std::binary_search(list.begin(), list.end(), n);
  };
  const auto ordered = [](mesh::NodeSet& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  mesh::NodeSet inside, on_edges, without;
  for (const Index e : mesh.elements_in(nodes))
    for (const Index n : mesh.elements[static_cast<std::size_t>(e)])
      if (n >= 0) inside.push_back(n);
  ordered(inside);
  for (const auto& ids : mesh.elements)
    for (std::size_t k = 0, count = ids[3] < 0 ? 3 : 4; k < count; ++k)
      if (const Index a = ids[k], b = ids[(k + 1) % count];
          in(nodes, a) && in(nodes, b) && !in(inside, a) && !in(inside, b))
        on_edges.insert(on_edges.end(), {a, b});
  ordered(on_edges);
  const bool by_area = !inside.empty();
  if (by_area)
    without = on_edges;
  else if (!on_edges.empty())
    std::set_difference(nodes.begin(), nodes.end(), on_edges.begin(), on_edges.end(),
                        std::back_inserter(without));
  if (without.empty()) return;
  throw Error(call + ": set '" + set + "' is shared by " +
              (by_area ? "the area of its elements, and beside them it has edges"
                       : "the length of its edges, and beside them it has single nodes") +
              ", which would get nothing (" + mesh::listed("node", without) +
              "): expected a call of their own");
}

}  // namespace

void DeclarationCheck::set(const std::string& name, const char*) {
  const auto& nodes = mesh_.set(name);
  if (shared_) check_shares(mesh_.uncut(), mesh_.uncut().set(name), call_, name);
  if (on_elements_ && mesh_.elements_in(nodes).empty())
    throw Error(call_ + ": set '" + name + "' holds no whole element");
}

void DeclarationCheck::components(const Components& value, const char*, const char*) {
  if (!value[0] && !value[1] && !value[2])
    throw Error(call_ + ": expected at least one of x, y, z, got none");
}

void DeclarationCheck::stiffness(const std::array<double, 3>& value, const char* unit) {
  for (const double k : value)
    if (!(k >= 0) || !std::isfinite(k))
      throw Error(call_ + ": expected stiffnesses of 0 or more in " + unit + ", got " + fabricsh::number(k));
}

void DeclarationCheck::number(const char* name, const std::optional<double>& value, const char*, double,
                              const NumberRow& row) {
  if (!value || *row.sentence == 0 || (row.range.holds(*value) && std::isfinite(*value))) return;
  throw Error(call_ + ": field '" + name + "': expected " + number_words(row.range, row.unit) + ", got " +
              fabricsh::number(*value));
}

void DeclarationCheck::vector(const char* name, const std::optional<Vec3>& value, const char*,
                              const NumberRow& row) {
  if (!value || *row.sentence == 0 || (row.range.holds(value->norm()) && value->allFinite())) return;
  throw Error(call_ + ": field '" + name + "': expected " +
              (row.range.is_positive() ? "a direction" : "finite numbers") + " {x, y, z}");
}

void check(const Model&, const InitialVelocity& velocity) {
  if (!velocity.linear.allFinite() || !velocity.spin.allFinite() || !velocity.centre.allFinite())
    throw Error("velocity: expected finite numbers in m/s, degrees/s and m");
}

void check(const Model&, PrescribedTurn& turn) {
  if (!(turn.axis.norm() > 0) || !turn.axis.allFinite())
    throw Error("turn: field 'axis': expected a direction {x, y, z}");
  turn.axis.normalize();
}

void check(const Model& model, const Tie& tie) {
  const FixedFreedoms& f = tie.freedoms;
  if (tie.kind == TieKind::rigid) {
    if (model.mesh().set(tie.set).size() < 2)
      throw Error("tie: rigid set " + quoted_word(tie.set) + " needs two nodes or more");
  } else if (!f.translation[0] && !f.translation[1] && !f.translation[2] && !f.rotation) {
    throw Error("tie: no freedom named, expected some of x y z");
  }
  if (tie.kind == TieKind::periodic) model.mesh().set(tie.partner);
  if (f.axis[0] || f.axis[1] || f.axis[2] || (f.rotation && tie.kind != TieKind::periodic))
    throw Error(tie.kind == TieKind::periodic ? "tie: expected some of x y z rotation"
                                              : "tie: expected some of x y z");
}

void check(const Model& model, const Zone& zone) {
  if (!zone.path.empty()) model.mesh().set(zone.path);
}

void check(const Model& model, const StrengthGiven& strength) {
  field::require("strength", strength_rows(), strength);
  const auto elements = model.mesh().elements_in(model.mesh().set(strength.set));
  const auto softens = [&model](Index e) {
    const auto& points = model.sections()[static_cast<std::size_t>(model.region_of(e))].points;
    return std::any_of(points.begin(), points.end(), [](const auto& p) { return law::softens(*p.law); });
  };
  if (std::none_of(elements.begin(), elements.end(), softens))
    throw Error("strength: set " + quoted_word(strength.set) +
                ": expected elements of a card whose yarns soften (its field 'damage'), got none");
}

void check(const Model& model, const Seam& seam) {
  for (const std::string& edge : {seam.first, seam.second}) model.mesh().set(edge);
  field::require("seam", seam_rows(), seam);
  if (seam.strength.has_value() != seam.energy.has_value())
    throw Error("seam: field '" + std::string(seam.strength ? "energy" : "strength") +
                "': expected strength (N/m) and energy (J/m) together, got one alone");
  if (seam.stiffness && seam.strength) {
    const double least = *seam.strength * *seam.strength / (2 * *seam.stiffness);
    if (!(*seam.energy > least))
      throw Error("seam: field 'energy': expected more than " + number(least) +
                  " J/m, which a seam of this stiffness stores at its strength, got " + number(*seam.energy));
  }
}

void check(const Model& model, const CreaseGiven& crease) {
  field::require("crease", crease_rows(), crease);
  edges_of(model, crease);
}

}  // namespace fabricsh::model
