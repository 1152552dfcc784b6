#include "model/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number.hpp"
#include "contact/law.hpp"
#include "law/law.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

namespace {

// Where yarns lock, forces are too large by 5 % at a stiffness over that of shear of some six times the
// elements across: measured in strips pulled off the yarns with clamped ends.
constexpr double kLocks = 6;
// Share of the area of locking elements from which they are warned of. A rim of triangles about a panel along
// the grain, 5 to 18 % of its area, makes such a strip 1.04 to 18 times too strong.
constexpr double kMuch = 0.05;
constexpr double kGravity = 9.81, kWell = 8;  // elements to a fold

// Corners, sides and directions of the yarns of an element.
struct Flat {
  std::vector<Vec3> corner;
  Vec3 normal, yarn[2];
  double area = 0;
};

Flat flat_of(const Model& model, Index e) {
  const auto& mesh = model.mesh();
  Flat f;
  Vec3 middle = Vec3::Zero();
  for (int a = 0; a < (mesh.elements[static_cast<std::size_t>(e)][3] < 0 ? 3 : 4); ++a)
    f.corner.push_back(model.rest_corner(e, a));
  for (const Vec3& x : f.corner) middle += x / static_cast<double>(f.corner.size());
  const Vec3 cross = f.corner.size() == 3 ? (f.corner[1] - f.corner[0]).cross(f.corner[2] - f.corner[0])
                                          : (f.corner[2] - f.corner[0]).cross(f.corner[3] - f.corner[1]);
  f.area = cross.norm() / 2;
  f.normal = cross.normalized();
  const Vec3 w = model.warp_at(e, middle, f.normal);
  const double turn = model.sections()[static_cast<std::size_t>(model.region_of(e))].points.front().angle;
  const Vec3 along = (w - w.dot(f.normal) * f.normal).normalized();
  f.yarn[0] = std::cos(turn) * along + std::sin(turn) * f.normal.cross(along);
  f.yarn[1] = f.normal.cross(f.yarn[0]);
  return f;
}

// Degrees between a yarn and the nearest side.
double to_side(const Flat& f, const Vec3& yarn) {
  double least = 90;
  for (std::size_t i = 0; i < f.corner.size(); ++i) {
    const Vec3 side = (f.corner[(i + 1) % f.corner.size()] - f.corner[i]).normalized();
    least = std::min(least,
                     std::atan2(side.cross(yarn).norm(), std::abs(side.dot(yarn))) * 180 / std::numbers::pi);
  }
  return least;
}

// sin^2 of a multiple of the yarn's angle to a side in an element that is mapped to a square (2) or to an
// equilateral triangle (3): 0 along a side, 1 where it is farthest from all.
double obliqueness(const Flat& f, const Vec3& yarn) {
  const bool three = f.corner.size() == 3;
  const auto& x = f.corner;
  const Vec3 a = three ? Vec3(x[1] - x[0]) : Vec3(x[1] + x[2] - x[0] - x[3]);
  const Vec3 b = three ? Vec3(x[2] - x[0]) : Vec3(x[2] + x[3] - x[0] - x[1]);
  const double on_a = yarn.cross(b).dot(f.normal), on_b = a.cross(yarn).dot(f.normal);
  const double angle =
      three ? std::atan2(std::numbers::sqrt3 / 2 * on_b, on_a + on_b / 2) : std::atan2(on_b, on_a);
  return std::pow(std::sin((three ? 3 : 2) * angle), 2);
}

// N m: the rigidity of the softer direction.
double rigidity(const section::Section& section) {
  if (section.bends_apart) return std::min(section.bending[0].rigidity, section.bending[1].rigidity);
  double B[2] = {0, 0};
  for (const section::Point& p : section.points) {
    const double z = section.thickness / 2 * (p.zeta - section.offset);
    for (int i = 0; i < 2; ++i)
      B[i] += p.weight / 2 * section.thickness * z * z * law::backbone_modulus(*p.law, i + 1, 0);
  }
  return std::min(B[0], B[1]);
}

// Of both yarns over shear, also where elements do not ease them.
std::array<double, 2> stiffness_of(const section::Section& section) {
  if (section.yarns_over_shear[0] > 0 || section.points.empty()) return section.yarns_over_shear;
  const law::ByDirection of = law::by_direction(*section.points.front().law);
  return {of.axis[0] / of.shear, of.axis[1] / of.shear};
}

// Pa/m: of the softest body whose contact has a stiffness of its own.
std::optional<double> softest_body(const Model& model) {
  std::optional<double> softest;
  for (const ContactGiven& contact : model.all<ContactGiven>())
    for (const Party& side : contact.between)
      if (side.body && contact.stiffness)
        softest = std::min(softest.value_or(*contact.stiffness), *contact.stiffness);
  return softest;
}

// Whether supports hold every node across a plane.
bool stays_flat(const Model& model) {
  std::vector<bool> held(model.mesh().nodes.size());
  const Flat first = flat_of(model, 0);
  for (const Support& support : model.all<Support>())
    for (int i = 0; i < 3; ++i)
      if (support.fixed.translation[static_cast<std::size_t>(i)] &&
          std::abs(support.frame.row(i).dot(first.normal)) > 1 - 1e-9)
        for (const Index n : model.mesh().set(support.set)) held[static_cast<std::size_t>(n)] = true;
  return std::all_of(held.begin(), held.end(), [](bool h) { return h; });
}

Test test_of(const Model& model, bool on_flesh) {
  const auto& gravity = model.gravity();
  if (on_flesh) return Test::pressed;
  if (stays_flat(model)) return Test::flat;
  if (std::any_of(gravity.begin(), gravity.end(), [](const auto& g) { return bool(g); })) return Test::falls;
  return model.all<Support>().empty() ? Test::unknown : Test::pulled;
}

Outlook outlook_of(const Model& model, std::size_t region, const std::optional<double>& flesh) {
  const section::Section& section = model.sections()[region];
  const auto ratio = stiffness_of(section);
  const bool eased = section.yarns_over_shear[0] > 0;
  Outlook out;
  out.region = model.regions()[region].name;
  out.yarns.stiffness = std::max(ratio[0], ratio[1]);
  double area = 0, worst = 0;
  std::vector<std::pair<double, double>> locking;  // the stiffness that counts, and the area
  Index count = 0;
  for (Index e = 0; e < static_cast<Index>(model.mesh().elements.size()); ++e) {
    if (static_cast<std::size_t>(model.region_of(e)) != region) continue;
    const Flat f = flat_of(model, e);
    const bool three = f.corner.size() == 3;
    area += f.area;
    ++count;
    if (three) out.yarns.triangles += f.area;
    double held = 0, angle = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      angle = std::max(angle, to_side(f, f.yarn[i]));
      if (three || !eased) held = std::max(held, ratio[i] * obliqueness(f, f.yarn[i]));
    }
    out.yarns.degrees += angle * f.area;
    out.yarns.most = std::max(out.yarns.most, angle);
    locking.emplace_back(held, f.area);
    if (held > worst) {
      worst = held;
      out.yarns.worst = e;
    }
  }
  if (count == 0 || !(area > 0)) return out;
  out.yarns.across = std::sqrt(static_cast<double>(count) / (out.yarns.triangles > area / 2 ? 2 : 1));
  for (const auto& [held, of] : locking)
    if (held > kLocks * out.yarns.across) out.yarns.locking += of / area;
  out.yarns.degrees /= area;
  out.yarns.triangles /= area;
  out.folds.element = std::sqrt(area) / out.yarns.across;
  const double B = rigidity(section);
  out.folds.length = 2 * std::numbers::pi * std::cbrt(B / (section.areal_mass * kGravity));
  if (flesh) out.folds.flesh = 2 * std::numbers::pi * std::pow(B / *flesh, 0.25);
  out.test = test_of(model, flesh.has_value());
  return out;
}

std::string percent(double share) { return number(std::round(100 * share), 3) + " %"; }
std::string degrees(double angle) { return number(std::round(angle), 3); }
std::string mm(double length) { return number(1e3 * length, 3) + " mm"; }

// "about 120 mm from one to the next, 6 elements"
std::string spacing(double length, double element) {
  return "about " + mm(length) + " from one to the next, " + number(element > 0 ? length / element : 0, 2) +
         " elements";
}

}  // namespace

std::vector<Outlook> outlook(const Model& model, std::optional<double> flesh) {
  if (!flesh) flesh = softest_body(model);
  std::vector<Outlook> all;
  for (std::size_t r = 0; r < model.regions().size(); ++r) all.push_back(outlook_of(model, r, flesh));
  return all;
}

std::array<std::string, 2> words(const Outlook& o) {
  const YarnsAcross& y = o.yarns;
  const std::string of = o.region.empty() ? "" : o.region + ": ";
  std::string yarns = of + "yarns are " + degrees(y.degrees) +
                      " degrees from the sides of elements in the mean, " + degrees(y.most) +
                      " at most, and " + number(y.stiffness, 3) + " times as stiff as shear: ";
  if (y.locking > 0)
    yarns += percent(y.locking) + " of the cloth, such as element " + std::to_string(y.worst + 1) +
             ", locks where yarns are pulled or sheared unevenly (5 % too stiff at " +
             number(kLocks * y.across, 2) + " times)";
  else
    yarns += "no element locks";
  const OwnFolds& f = o.folds;
  std::string folds = of + "folds by its own weight are " + spacing(f.length, f.element);
  if (f.flesh > 0) folds += ", folds on what gives way under it " + spacing(f.flesh, f.element);
  const double shortest = f.flesh > 0 ? std::min(f.length, f.flesh) : f.length;
  folds += ": ";
  if (o.test == Test::flat)
    folds += "the cloth is held in its plane, where none can form";
  else if (shortest >= kWell * f.element)
    folds += "the mesh shows them";
  else if (f.flesh > 0)
    folds += "pressures where it folds need elements of " + mm(shortest / kWell) +
             " or folds=\"within elements\"; the work and the pressure of taut cloth do not";
  else if (o.test == Test::pulled)
    folds += "a pull does not need them; where it is pressed together, elements of " + mm(shortest / kWell) +
             " or folds=\"within elements\" do";
  else
    folds += "for draping and crumpling elements of " + mm(shortest / kWell) +
             " show them, coarser ones hang too straight" +
             (o.test == Test::falls ? "" : "; pulls in the plane do not need that");
  return {yarns, folds};
}

std::string warning_of(const Outlook& o) {
  if (o.yarns.locking < kMuch) return {};
  std::string text = words(o)[0];
  if (o.yarns.triangles > 0.5)
    text +=
        "; quadrilaterals lock far less: mesh:pair() joins triangles to them (unstructured ones, 6 elements "
        "across, at 45 degrees: from 22 times too strong to 1.4)";
  else if (o.yarns.triangles > 0)
    text +=
        "; quadrilaterals lock far less: a panel is of them with quadrilaterals=true, and mesh:refine() "
        "makes "
        "them of all elements of any mesh, so that one may begin with elements of twice the size";
  return text;
}

Loose loose(const card::Card& card) {
  const section::Section s = section::integrated(card, card.thickness, 1, 0);
  if (s.compression.empty()) return {card.thickness, s.solid_thickness};
  contact::LawData data;
  data.floor = s.compression.front().first / 2;  // where contact begins does not depend on it
  data.curve = s.compression;
  return {contact::ContactLaw(data).gap(), s.solid_thickness};
}

}  // namespace fabricsh::model
