// Contact points inside the elements, for balls and rods that are small against them.
#pragma once
#include <string>

#include "contact/scene.hpp"

namespace fabricsh::mechanics {

// How much stiffer than what presses whole elements such a contact may be in an explicit step: the area of
// the smallest element over the largest that a body presses of one. 1 without points in all elements.
double eased(const contact::Scene& scene, const contact::Interaction& it);

// m2: the area that would take the same energy if it were pressed flat through the range of contact as the
// patch that such a body presses of one element.
double area_as_flat(const contact::Scene& scene, const contact::Interaction& it);

// How many times the law's force that of a ball or a rod on a node of flat cloth is, roughly, where elements
// have no points inside; 0 where all have, and of other bodies.
double dependence(const contact::Scene& scene, const contact::Interaction& it);

// Words on that where it shows, and on points inside that are too few; or none.
std::string dependence_words(const contact::Scene& scene, const contact::Interaction& it);

}  // namespace fabricsh::mechanics
