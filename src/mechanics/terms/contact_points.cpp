// Contact points inside the elements: how many, and what an explicit step carries there.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number.hpp"
#include "mechanics/terms/contact_surfaces.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kOfSide =
    1.2 * (1 + 1e-9);  // of the root of an element's area: the largest radius with points
// Half of the width that is pressed, as the distance of the points: along a rod there are many of them.
constexpr double kOfPatch = 0.75, kOfRods = 1;
// Of the law's lengths: from there on others than nodes press a solid where these carry the law.
constexpr double kGuarded = 0.25;
// Of the range: how far apart nodes are there at most.
constexpr double kSparse = 2;

// m2, of the smallest element with points inside; 0 where there is none.
double smallest_element(const contact::Scene& scene, const contact::Interaction& it) {
  const auto first =
      static_cast<std::size_t>(scene.surfaces()[static_cast<std::size_t>(it.first)].first_triangle);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < it.parts.size(); ++t)
    if (it.parts[t] != 0) least = std::min(least, 2 * scene.triangles()[first + t].area);
  return std::isfinite(least) ? least : 0;
}

bool in_all_elements(const contact::Interaction& it) {
  return !it.parts.empty() && std::find(it.parts.begin(), it.parts.end(), 0) == it.parts.end();
}

// m2: what is pressed of a flat element, at most, if none of it is pressed farther than the range of contact.
double patch(const contact::Scene& scene, const contact::Interaction& it) {
  const auto& body = scene.surfaces()[static_cast<std::size_t>(it.second)];
  const double twice = 2 * body.radius * (it.law.gap() - it.law.floor());
  if (body.shape == contact::Shape::ball) return std::numbers::pi * twice;
  return 2 * std::sqrt(twice * smallest_element(scene, it));
}

// m: how near to each other points inside elements have to be.
double wanted_apart(const contact::Surface& body, const contact::ContactLaw& law) {
  return (body.shape == contact::Shape::rod ? kOfRods : kOfPatch) *
         std::sqrt((body.radius + law.gap()) * (law.gap() - law.floor()) / 4);
}

// m: what a depth of half of the range presses of flat cloth.
double half_pressed(const contact::Surface& body, const contact::ContactLaw& law) {
  return 2 * std::sqrt(body.radius * (law.gap() - law.floor()));
}

// Pa/m: with a larger stiffness the pressures of cloth use up a small part of the range.
double softest_constraint(const contact::ContactLaw& law) {
  return contact::dense_stiffness(law.gap(), law.floor());
}

// Of elements over the range of contact with a solid that gives way; 0: it does not, or is not a solid.
double sparseness(const contact::Scene& scene, const contact::Interaction& it, bool given) {
  const auto of = [&](std::int32_t s) -> const contact::Surface& {
    return scene.surfaces()[static_cast<std::size_t>(s)];
  };
  if (!given || it.rigid || of(it.second).shape != contact::Shape::solid) return 0;
  if (it.law.stiffest() > softest_constraint(it.law)) return 0;
  return std::sqrt(of(it.first).mean_area) / (it.law.gap() - it.law.floor());
}

}  // namespace

double eased(const contact::Scene& scene, const contact::Interaction& it) {
  constexpr double about_node = 0.75;  // of an element: the least area whose mass a node in a sheet has
  return in_all_elements(it) ? std::max(1.0, about_node * smallest_element(scene, it) / patch(scene, it)) : 1;
}

double area_as_flat(const contact::Scene& scene, const contact::Interaction& it) {
  const bool ball = scene.surfaces()[static_cast<std::size_t>(it.second)].shape == contact::Shape::ball;
  return (ball ? 1.0 / 3 : 8.0 / 15) * patch(scene, it);
}

// Factors as measured on held flat cloth of squares, see share/doc/contact.md: of a rod along a row of nodes,
// and of a ball on a node, against the law's integral.
double dependence(const contact::Scene& scene, const contact::Interaction& it) {
  constexpr double rod_on_nodes = 2.4, ball_on_node = 8;
  const auto& body = scene.surfaces()[static_cast<std::size_t>(it.second)];
  const bool ball = body.shape == contact::Shape::ball;
  if (it.rigid || (!ball && body.shape != contact::Shape::rod)) return 0;
  const auto& sheet = scene.surfaces()[static_cast<std::size_t>(it.first)];
  double sum = 0, count = 0;
  for (std::size_t t = 0; t < static_cast<std::size_t>(sheet.triangles); ++t) {
    if (!it.parts.empty() && it.parts[t] != 0) continue;
    sum += std::sqrt(2 * scene.triangles()[static_cast<std::size_t>(sheet.first_triangle) + t].area);
    ++count;
  }
  const double wide = count > 0 ? sum / count / half_pressed(body, it.law) : 0;
  return ball ? ball_on_node * wide * wide : rod_on_nodes * wide;
}

std::string dependence_words(const contact::Scene& scene, const contact::Interaction& it) {
  constexpr double least = 1.1;
  const auto& body = scene.surfaces()[static_cast<std::size_t>(it.second)];
  if (!it.parts.empty() &&
      std::find(it.parts.begin(), it.parts.end(), contact::Spots::most_parts) != it.parts.end())
    return "; more of them are not made, though " + number(wanted_apart(body, it.law), 2) +
           " m is wanted for its radius and range: its force on flat cloth depends on where they lie (finer "
           "elements)";
  const double factor = dependence(scene, it);
  if (!(factor > least)) return "";
  const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
  return "; its force on cloth that stays flat there depends on where the nodes lie, up to some " +
         number(unit * std::round(factor / unit)) +
         " times that of the law: half of the range presses a width of " +
         number(half_pressed(body, it.law), 2) +
         " m (cloth that lies around it is pressed by the law; elements of at least " +
         number(body.radius / kOfSide, 2) +
         " m have points inside, and so do those of any size where `stiffness` is given, of at most " +
         number(softest_constraint(it.law), 2) + " Pa/m)";
}

std::vector<std::string> ContactSurfaces::dependent() const {
  constexpr double told = 1.5;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    const auto& it = scene_.interactions()[i];
    if (dependence(scene_, it) > told) out.push_back(meetings_[i].names + dependence_words(scene_, it));
    const auto& body = scene_.surfaces()[static_cast<std::size_t>(it.second)];
    const bool flat = 2 * body.points.size() < static_cast<std::size_t>(body.vertices);  // nodes alone press
    if (const double sparse = sparseness(scene_, it, meetings_[i].given); sparse > kSparse && !flat)
      out.push_back(meetings_[i].names +
                    "; flat cloth is pressed with up to 1.6 times the force of the law: its elements are " +
                    number(sparse, 2) + " times as large as what gives way is deep, expected at most " +
                    number(kSparse));
  }
  return out;
}

// Balls and rods that press a width of few elements press between the nodes, or on one node more than on
// others. There the law is integrated over the surface, by points inside the elements: so near to each other
// that an eighth of the way from gap to floor presses several of them. That needs a law that is meant as one:
// a given stiffness, with which cloth is pressed through a good part of the range. A stiffer one is a
// constraint, and one that is assumed is chosen for the step; with these, only bodies that are small against
// the elements have points, and larger ones keep nodes, edges and facets. Into a solid with such a law nodes
// are pressed alone where they are no farther apart than twice the depth of it.
void ContactSurfaces::spread_points() {
  for (std::size_t i = 0; i < meetings_.size(); ++i) {
    auto& it = scene_.interaction(i);
    const auto& body = scene_.surfaces()[static_cast<std::size_t>(it.second)];
    if (const double sparse = sparseness(scene_, it, meetings_[i].given); sparse > 0 && sparse <= kSparse)
      it.guarded = kGuarded;
    if (it.rigid || (body.shape != contact::Shape::ball && body.shape != contact::Shape::rod)) continue;
    const double apart = wanted_apart(body, it.law);
    const bool any_radius = meetings_[i].given && it.law.stiffest() <= softest_constraint(it.law);
    const auto& sheet = scene_.surfaces()[static_cast<std::size_t>(it.first)];
    std::vector<std::int8_t> parts(static_cast<std::size_t>(sheet.triangles), 0);
    for (std::size_t t = 0; t < parts.size(); ++t) {
      const auto& row = scene_.triangles()[static_cast<std::size_t>(sheet.first_triangle) + t];
      if (!any_radius && body.radius > kOfSide * std::sqrt(2 * row.area)) continue;
      double longest = 0;
      for (const std::int32_t e : row.edge_row)
        longest = std::max(longest, scene_.edges()[static_cast<std::size_t>(e)].length);
      const double wanted = std::ceil(longest / (std::numbers::sqrt2 * apart)),
                   n = std::clamp(wanted, 1.0, static_cast<double>(contact::Spots::most_parts));
      parts[t] = static_cast<std::int8_t>(n);
      meetings_[i].spacing = std::max(meetings_[i].spacing, longest / (std::numbers::sqrt2 * n));
    }
    if (!(meetings_[i].spacing > 0)) continue;
    scene_.spread(i, std::move(parts));
    meetings_[i].carried *= eased(scene_, it);
  }
}

}  // namespace fabricsh::mechanics
