#include "section/transverse.hpp"

#include <algorithm>

#include "law/data.hpp"
#include "law/transverse.hpp"

namespace fabricsh::section {

namespace {
constexpr double kHidden = 20;          // G_t t h^2 / B
constexpr double kOfMembrane = 1. / 3;  // of the stiffest modulus in the plane: no sheet is stiffer in shear
}  // namespace

void hide_transverse_shear(Section& section, const card::Card& card, double size) {
  if (!section.bends_apart || !(size > 0)) return;
  const double most = kOfMembrane * law::stiffest(*section.points.front().law);
  const auto least = [&](const law::BendingSpring& spring) {
    return std::min(most, kHidden * law::stiffest(spring) / (section.thickness * size * size));
  };
  const auto stiffer = law::compile_stiffer(card, {least(section.bending[0]), least(section.bending[1])});
  if (!stiffer) return;
  for (Point& point : section.points) point.law = stiffer;
  section.plain = section.points.front().law->is_plain ? &section.points.front().law->plain : nullptr;
}

}  // namespace fabricsh::section
