#include "run/result_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/suggest.hpp"
#include "mechanics/terms/contact.hpp"
#include "mechanics/terms/hinges.hpp"
#include "mechanics/terms/tears.hpp"
#include "run/readings.hpp"
#include "run/recovery.hpp"

namespace fabricsh::run {

namespace {

using V = ElementValues;
using Names = std::vector<std::string>;
using Members = std::vector<double V::*>;

constexpr std::size_t kMostNumbers = 5;

// m, of a ply or (empty) of the whole sheet; NaN: the element has no such ply.
double thickness(const model::Model& model, mesh::Index e, const std::string& ply) {
  if (ply.empty()) return model.thickness_of(e);
  const int number = model.ply_of(e, ply);
  if (number < 0) return std::nan("");
  const auto& plies = model.regions()[static_cast<std::size_t>(model.region_of(e))].options.plies;
  return plies.empty() ? model.thickness_of(e) : plies[static_cast<std::size_t>(number)].thickness;
}

struct ResultFieldTable {
  std::vector<ResultField> rows;
  Members members;

  // A number for each node or element, which files have only on request.
  ResultField& number(std::string name, std::string unit, FieldPlace place, std::string sentence,
                      decltype(ResultField::values) values) {
    Names components = {name};
    rows.push_back({std::move(name), std::move(unit), FieldShape::scalar, place, std::move(sentence),
                    std::move(components), std::move(values)});
    rows.back().usual = false;
    return rows.back();
  }
  // read(run, node) gives the vector.
  template <class Read>
  void vectors(std::string name, std::string unit, std::string sentence, Names components, std::string letter,
               const Read& read) {
    const auto values = [read](const Readings& run, mesh::Index i, const std::string&, double* out) {
      const Vec3 v = read(run, i);
      std::copy_n(v.data(), 3, out);
    };
    rows.push_back({std::move(name),
                    std::move(unit),
                    FieldShape::vector,
                    FieldPlace::node,
                    std::move(sentence),
                    std::move(components),
                    values,
                    {},
                    std::move(letter)});
  }
  void nodal(std::string name, std::string unit, std::string sentence, Names components,
             Vec3 NodeValues::*what, std::string letter = "") {
    const auto read = [what](const Readings& run, mesh::Index i) -> Vec3 { return run.node(i).*what; };
    vectors(std::move(name), std::move(unit), std::move(sentence), std::move(components), std::move(letter),
            read);
  }
  void supports(const std::string& name, std::string unit, std::string sentence) {
    const auto read = [](const Readings& run, mesh::Index i) { return run.reaction_at(i); };
    vectors(name, std::move(unit), std::move(sentence), {name + "_x", name + "_y", name + "_z"}, "R", read);
  }
  void touched(const std::string& name, std::string unit, std::string sentence,
               double (mechanics::ContactReadings::*what)(mechanics::Index) const) {
    const auto values = [name, what](const Readings& run, mesh::Index i, const std::string&, double* out) {
      if (run.assembly().terms().find<mechanics::Contacts>() == nullptr)
        throw Error("field '" + name + "': nothing touches in this model (see model:contact)");
      *out = (run.contact().readings().*what)(i);
    };
    ResultField& row = number(name, std::move(unit), FieldPlace::node, std::move(sentence), values);
    row.usual = true;
    row.touching = true;
  }
  void joined() {
    const auto values = [](const Readings& run, mesh::Index i, const std::string&, double* out) {
      *out = run.assembly().dofs().joints().is_open(i) || run.assembly().dofs().has_parted(i) ? 1 : 0;
    };
    number("joint_open", "", FieldPlace::node,
           "1 where a joint of a tearable zone is open, or a seam has been opened or has burst; 0 elsewhere",
           values);
  }
  void creased() {
    const auto values = [](const Readings& run, mesh::Index i, const std::string&, double* out) {
      const auto* const hinges = run.assembly().terms().find<mechanics::Hinges>();
      *out = hinges != nullptr ? hinges->angle_at(i) : 0;
    };
    number("crease_angle", "degrees", FieldPlace::node,
           "angle at creases with a stiffness, the largest at the node; 0 elsewhere", values);
  }
  void average(std::string name, std::string unit, FieldShape shape, std::string sentence, Names components,
               const Members& what, Names labels) {
    members.insert(members.end(), what.begin(), what.end());
    const auto values = [what](const Readings& run, mesh::Index e, const std::string& ply, double* out) {
      const V& v = run.elements(ply)[e];
      for (const auto member : what) *out++ = v.*member;
    };
    rows.push_back({std::move(name), std::move(unit), shape, FieldPlace::element, std::move(sentence),
                    std::move(components), values, std::move(labels)});
    rows.back().by_ply = true;
  }
  // Parts of the dissipated energy, by the names that springs and elements of the law give.
  void dissipated(std::size_t i) {
    const std::string part(law::dissipation_names.name[i]);
    const auto values = [i](const Readings& run, mesh::Index e, const std::string& ply, double* out) {
      *out = run.elements(ply)[e].lost[i];
    };
    number("dissipated_" + part, "J/m^3", FieldPlace::element,
           "per reference volume: dissipated so far in " + part, values)
        .by_ply = true;
  }
  // Of yarns, which plies with different axes have each for itself.
  void of_yarns(std::string name, std::string sentence, Names components, const Members& what) {
    average(std::move(name), "", FieldShape::pair, std::move(sentence), std::move(components), what,
            {"warp", "weft"});
    rows.back().of_yarns = true;
  }
  void direction(std::string name, std::string sentence, Vec3 std::pair<Vec3, Vec3>::*which) {
    const auto values = [which](const Readings& run, mesh::Index e, const std::string& ply, double* out) {
      const int number = ply.empty() ? mechanics::ClothReadings::all_plies : run.model().ply_of(e, ply);
      Vec3 v = Vec3::Constant(std::nan(""));
      if (ply.empty() || number >= 0) v = run.assembly().cloth().readings().yarns(e, number).*which;
      std::copy_n(v.data(), 3, out);
    };
    rows.push_back(
        {std::move(name), "", FieldShape::vector, FieldPlace::element, std::move(sentence), {}, values});
    rows.back().by_ply = true;
  }
  // A scalar of elements, written to files only on request.
  void scalar(const std::string& name, std::string unit, std::string sentence,
              std::function<double(const Readings&, mesh::Index)> value) {
    const auto values = [value = std::move(value)](const Readings& run, mesh::Index e, const std::string&,
                                                   double* out) { *out = value(run, e); };
    number(name, std::move(unit), FieldPlace::element, std::move(sentence), values);
  }
  // Found for all elements together; there is no value of a single one.
  void together(const std::string& name, std::string unit, std::string sentence,
                std::function<std::vector<double>(const Readings&)> all) {
    rows.push_back(
        {name, std::move(unit), FieldShape::scalar, FieldPlace::element, std::move(sentence), {}, {}});
    rows.back().usual = false;
    rows.back().continuous = false;
    rows.back().all = std::move(all);
  }
  void torn(const std::string& name, int family) {
    scalar(name, "",
           std::string(family == 0 ? "warp" : "weft") +
               " force over strength at the joints of the element, the largest; 1 where it has broken",
           [family](const Readings& run, mesh::Index e) {
             const mechanics::Tears* tears = run.assembly().terms().find<mechanics::Tears>();
             return tears == nullptr ? 0.0 : tears->share(e, family);
           });
  }
  // The same computed from strains and stresses, value(values, thickness in m), of a ply or of all.
  void computed(const std::string& name, std::string unit, std::string sentence,
                double (*value)(const V&, double)) {
    const auto values = [value](const Readings& run, mesh::Index e, const std::string& ply, double* out) {
      const double t = thickness(run.model(), e, ply);
      *out = std::isnan(t) ? t : value(run.elements(ply)[e], t);
    };
    number(name, std::move(unit), FieldPlace::element, std::move(sentence), values).by_ply = true;
  }
};

double stretch(double E) { return std::sqrt(std::max(0.0, 1 + 2 * E)); }

// Cauchy stress 11, 22, 12 (Pa) in the frame whose first axis is the present warp direction: F S F^T / J with
// F upper triangular and F^T F = C = 1 + 2 E.
std::array<double, 3> cauchy(const V& v) {
  const double a = stretch(v.E11), b = a > 0 ? 2 * v.E12 / a : 0;
  const double d = std::sqrt(std::max(0.0, 1 + 2 * v.E22 - b * b)), J = a * d;
  if (!(J > 0)) return {};
  return {(a * a * v.S11 + 2 * a * b * v.S12 + b * b * v.S22) / J, d * d * v.S22 / J,
          (a * d * v.S12 + b * d * v.S22) / J};
}

// Force along a yarn over the reference area, Pa: S acts along the present direction of the yarn.
double nominal(double S, double E) { return S * stretch(E); }

double shear_angle(const V& v) {
  const double lengths = stretch(v.E11) * stretch(v.E22);
  const double sine = lengths > 0 ? std::clamp(2 * v.E12 / lengths, -1.0, 1.0) : 0;
  return std::asin(sine) * (180 / std::numbers::pi);
}

ResultFieldTable make_table() {
  ResultFieldTable t;
  t.nodal("displacement", "m", "from the reference position", {"ux", "uy", "uz"}, &NodeValues::u, "u");
  t.nodal("velocity", "m/s", "of a run in motion; zero in statics", {"vx", "vy", "vz"}, &NodeValues::v, "v");
  t.rows.back().moving = true;
  t.nodal("director", "", "unit vector across the sheet", {"nx", "ny", "nz"}, &NodeValues::n);
  t.nodal("position", "m", "where the node is now", {"x", "y", "z"}, &NodeValues::x, "x");
  t.rows.back().usual = false;
  t.nodal("reference", "m", "where the node was in the reference", {"X", "Y", "Z"}, &NodeValues::X, "X");
  t.rows.back().usual = false;
  t.supports("reaction", "N", "force of the supports on the node, which a:reaction sums over a set");
  t.touched("gap", "m",
            "distance to the nearest surface that it may touch, less the smallest distance that contact "
            "allows; at most the reach of contact",
            &mechanics::ContactReadings::gap);
  t.touched(
      "contact_pressure", "Pa",
      "normal pressure of contact, without friction; that on the front and that on the back of a sheet added",
      &mechanics::ContactReadings::pressure);
  t.creased();
  t.joined();
  t.torn("rupture_warp", 0);
  t.torn("rupture_weft", 1);
  t.average("E", "", FieldShape::tensor, "Green-Lagrange strain, tensor components",
            {"E11", "E22", "E23", "E13", "E12"}, {&V::E11, &V::E22, &V::E23, &V::E13, &V::E12},
            {"E11", "E22", "E23", "E13", "E12"});
  t.average("S", "Pa", FieldShape::tensor, "2nd Piola-Kirchhoff stress", {"S11", "S22", "S23", "S13", "S12"},
            {&V::S11, &V::S22, &V::S23, &V::S13, &V::S12}, {"S11", "S22", "S23", "S13", "S12"});
  t.of_yarns("residual", "strain that a yarn keeps when it is unloaded", {"residual1", "residual2"},
             {&V::residual1, &V::residual2});
  t.of_yarns("slack", "strain by which a slack yarn is below its residual strain", {"slack1", "slack2"},
             {&V::slack1, &V::slack2});
  t.average(
      "folded", "", FieldShape::scalar,
      "part of the compression that folds within the element have taken, 0 to 1; 0 in a model whose folds "
      "are resolved",
      {"folded"}, {&V::folded}, {});
  t.rows.back().usual = false;
  t.average("energy", "J/m^3", FieldShape::pair, "per reference volume: stored, and dissipated so far",
            {"stored", "dissipated"}, {&V::stored, &V::dissipated}, {"stored", "dissipated"});
  for (std::size_t i = 0; i < law::dissipations; ++i) t.dissipated(i);
  t.direction("warp", "unit vector along the deformed warp", &std::pair<Vec3, Vec3>::first);
  t.direction("weft", "unit vector along the deformed weft", &std::pair<Vec3, Vec3>::second);
  t.computed("shear_angle", "degrees", "90 degrees less the angle between warp and weft; has the sign of E12",
             [](const V& v, double) { return shear_angle(v); });
  t.computed("tension_warp", "N/m", "force along the warp yarns per reference width",
             [](const V& v, double thick) { return thick * v.S11 * stretch(v.E11); });
  t.computed("tension_weft", "N/m", "force along the weft yarns per reference width",
             [](const V& v, double thick) { return thick * v.S22 * stretch(v.E22); });
  t.computed("nominal_strain_warp", "", "change of length along the warp over the reference length",
             [](const V& v, double) { return stretch(v.E11) - 1; });
  t.computed("nominal_strain_weft", "", "change of length along the weft over the reference length",
             [](const V& v, double) { return stretch(v.E22) - 1; });
  t.computed("nominal_stress_warp", "Pa", "force along the warp yarns over the reference area",
             [](const V& v, double) { return nominal(v.S11, v.E11); });
  t.computed("nominal_stress_weft", "Pa", "force along the weft yarns over the reference area",
             [](const V& v, double) { return nominal(v.S22, v.E22); });
  t.computed("cauchy_11", "Pa", "Cauchy stress along the deformed warp (current width, reference thickness)",
             [](const V& v, double) { return cauchy(v)[0]; });
  t.computed("cauchy_22", "Pa", "Cauchy stress across the deformed warp, in the surface",
             [](const V& v, double) { return cauchy(v)[1]; });
  t.computed("cauchy_12", "Pa", "Cauchy shear stress, along and across the deformed warp",
             [](const V& v, double) { return cauchy(v)[2]; });
  t.scalar("beyond", "",
           "largest strain so far over the tested strain of the card: 1.2 is 20 % beyond; 0 where the card "
           "states none",
           [](const Readings& run, mesh::Index e) { return run.assembly().cloth().strains().ratio(e); });
  t.scalar("region", "", "number of the body or region that the element belongs to, in their order",
           [](const Readings& run, mesh::Index e) { return run.model().region_of(e) + 1.0; });
  t.rows.back().continuous = false;
  t.together(
      "error", "",
      "stress recovered at the nodes less that of the element, in the energy norm, over the mean of the "
      "sheet: where a finer mesh is needed",
      stress_errors);
  return t;
}

const ResultFieldTable& table() {
  static const ResultFieldTable t = make_table();
  return t;
}

std::size_t items(const Readings& run, FieldPlace place) {
  const auto& mesh = run.model().mesh();
  return place == FieldPlace::node ? mesh.nodes.size() : mesh.elements.size();
}

}  // namespace

const char* name(FieldPlace place) {
  static constexpr std::array words = {"node", "point", "element", "facet"};
  return words.at(static_cast<std::size_t>(place));
}

const char* name(FieldShape shape) {
  static constexpr std::array words = {"number", "pair", "vector", "symmetric tensor"};
  return words.at(static_cast<std::size_t>(shape));
}

std::size_t ResultField::size() const {
  static constexpr std::array<std::size_t, 4> sizes = {1, 2, 3, kMostNumbers};
  return sizes.at(static_cast<std::size_t>(shape));
}

namespace {

bool turned_plies(const Readings& run) {
  const auto& sections = run.model().sections();
  return std::any_of(sections.begin(), sections.end(), [](const auto& s) { return s.turned_plies(); });
}

}  // namespace

bool has(const Readings& run, const ResultField& field) {
  return (!field.moving || run.moves()) &&
         (!field.touching || run.assembly().terms().find<mechanics::Contacts>() != nullptr) &&
         (!field.of_yarns || !turned_plies(run));
}

const std::vector<ResultField>& result_fields() { return table().rows; }

const std::vector<double V::*>& element_members() { return table().members; }

std::vector<const ResultField*> fields_of(const Readings& run) {
  std::vector<const ResultField*> all;
  for (const ResultField& field : result_fields()) all.push_back(&field);
  for (const auto& field : run.shown()) all.push_back(field.get());
  return all;
}

ResultField field_of(const mechanics::TermField& shown) {
  const auto value = [value = shown.value](const Readings&, mesh::Index i, const std::string&, double* out) {
    *out = value(i);
  };
  return {shown.name,
          shown.unit,
          FieldShape::scalar,
          shown.of_elements ? FieldPlace::element : FieldPlace::node,
          shown.sentence,
          {shown.name},
          value};
}

namespace {

// The field is null if the name is not among those of this one.
FieldPart look_up(const ResultField& field, const std::string& name) {
  const auto found = std::find(field.components.begin(), field.components.end(), name);
  if (found != field.components.end()) return {&field, static_cast<int>(found - field.components.begin())};
  return {field.name == name ? &field : nullptr, -1};
}

FieldPart look_up(const std::string& name) {
  for (const ResultField& field : result_fields())
    if (const FieldPart part = look_up(field, name); part.field != nullptr) return part;
  return {nullptr, -1};
}

FieldPart look_up(const Readings& run, const std::string& name) {
  for (const auto& field : run.shown())
    if (field->name == name) return {field.get(), 0};
  return look_up(name);
}

std::string list(const Names& words) {
  std::string text;
  for (const std::string& word : words) text += " " + word;
  return text;
}

// Error unless the run has the ply of the part, or (without one) values of all plies together.
void check_ply(const Readings& run, const FieldPart& part, const std::string& name) {
  const Names plies = run.model().plies();
  if (part.ply.empty()) {
    if (part.field->of_yarns && turned_plies(run))
      throw Error("field '" + name +
                  "': the plies of this model have different axes, so each has yarns of its own: "
                  "expected the field of a ply, as in '" +
                  plies.front() + "." + name + "'");
    return;
  }
  if (std::find(plies.begin(), plies.end(), part.ply) == plies.end())
    throw Error("field '" + name + "': unknown ply '" + part.ply + "'" + did_you_mean(part.ply, plies) +
                " (known:" + list(plies) + ")");
}

}  // namespace

bool is_field(const Readings& run, const std::string& name) { return look_up(run, name).field != nullptr; }

FieldPart find_field(const Readings& run, const std::string& name) {
  const FieldPart found = look_up(run, name), part = found.field != nullptr ? found : find_field(name);
  check_ply(run, part, name);
  return part;
}

FieldPart find_field(const std::string& name) {
  if (const FieldPart part = look_up(name); part.field != nullptr) return part;
  if (const auto dot = name.rfind('.'); dot != name.npos && dot > 0) {
    FieldPart part = find_field(name.substr(dot + 1));
    if (!part.field->by_ply)
      throw Error("field '" + name + "': '" + name.substr(dot + 1) +
                  "' is not of single plies: expected it alone");
    part.ply = name.substr(0, dot);
    return part;
  }
  const std::string guess = did_you_mean(name, field_names());
  if (!guess.empty()) throw Error("unknown field '" + name + "'" + guess);
  throw Error("unknown field '" + name + "' (known:" + list(field_names()) + ")");
}

Names scalar_names() {
  Names names = scalar_names(FieldPlace::element);
  for (const std::string& name : scalar_names(FieldPlace::node)) names.push_back(name);
  return names;
}

Names scalar_names(FieldPlace place) {
  Names names;
  for (const ResultField& field : result_fields())
    if (field.place == place) names.insert(names.end(), field.components.begin(), field.components.end());
  return names;
}

Names field_names() {
  Names names = scalar_names();
  for (const ResultField& field : result_fields())
    if (field.shape != FieldShape::scalar || field.components.empty()) names.push_back(field.name);
  return names;
}

std::vector<double> values_of(const Readings& run, const FieldPart& part) {
  if (part.field->all) return part.field->all(run);
  const std::size_t size = part.field->size(), n = items(run, part.field->place);
  std::vector<double> out;
  out.reserve(part.component < 0 ? n * size : n);
  std::array<double, kMostNumbers> all{};
  for (std::size_t i = 0; i < n; ++i) {
    part.field->values(run, static_cast<mesh::Index>(i), part.ply, all.data());
    if (part.component < 0)
      out.insert(out.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(size));
    else
      out.push_back(all[static_cast<std::size_t>(part.component)]);
  }
  return out;
}

}  // namespace fabricsh::run
