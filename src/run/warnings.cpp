#include "run/warnings.hpp"

#include <algorithm>
#include <cassert>

namespace fabricsh::run {

namespace {

constexpr bool serious = true;
constexpr WarningKind kinds[] = {
    {"ledger", "energy appears or is lost beyond what the steps explain", serious},
    {"inverted", "an element is turned inside out", serious},
    {"director", "a director has turned over to the other side of the sheet", serious},
    {"beyond", "the strain is beyond what the card was tested to; serious with limit=\"stop\""},
    {"path", "steps of a static run are long for laws that remember their path", serious},
    {"unstable", "a step has ended in a shape that is not stable", serious},
    {"compressed", "elements carry compression under which the cloth within them would fold", serious},
    {"pivots", "a static run has passed a limit or bifurcation point, or left an unstable shape"},
    {"branches", "a static run has left an unstable shape more than once, and its steps decide for which"},
    {"relaxed", "relaxation took a noticeable part of a static run's work, or its first step"},
    {"stabilise", "stabilisation has taken a noticeable part of the work"},
    {"jump", "a load or motion is at full value at once, not ramped"},
    {"step",
     "the explicit step is near the stable one, or is split because stretch has shortened that; or an "
     "implicit one is shortened, since the cloth turns far in it"},
    {"inertia", "much of the kinetic energy is in rotary inertia that is scaled up for the step"},
    {"guard", "contact is pressed so far that a barrier keeps the surfaces apart"},
    {"nip",
     "held or driven bodies press cloth between them from the start; serious if it cannot fit between them"},
    {"crossing", "surfaces that may touch pass through each other at the end", serious},
    {"pressed", "contact of an assumed stiffness has a noticeable part of the stored energy"},
    {"rim", "the rim of a volume of gas has left the rigid body that closes it", serious},
    {"nodes", "the force of a ball or a rod on flat cloth depends on where the nodes lie"},
    {"facets", "facets of a rigid surface lie so near to each other that places of it press more than once"},
    {"fold", "cloth turns sharply between two elements where contact presses on it"},
    {"seam",
     "edges that are sewn had not met when their time was over, or are drawn against a body faster than "
     "contact stops them"},
    {"damped", "the time scheme has taken much of the energy that went through a run in motion"},
    {"rest", "a run that was to end at rest has not come to rest in its time"},
    {"held",
     "the cloth pulls on yarns beyond their strength where a support holds them, and none breaks there"},
    {"dropped", "an initial velocity is dropped along supports"},
    {"oblique", "yarns cross elements so obliquely, and are so stiff, that these lock"},
    {"shear", "transverse shear that is derived from other numbers of the card shows in bending"},
    {"lean", "the guard of the directors has a noticeable part of the stored energy"},
    {"splay", "elements are so long across stiff fibres that they lose stability where cloth does not"},
    {"idle", "supports take up the whole of a load, or nothing loads or moves the cloth at all"},
    {"bending", "the bending rigidity of the card is far from that of cloth"},
    {"card", "the check of the card has a warning"},
    {"units", "a value of the deck is far outside the usual"},
    {"mesh",
     "the file of a mesh was cut short or holds what is left out, or a sheet is in parts that are not "
     "connected"},
    {"restart", "the run was continued from the checkpoint of another deck"},
    {"lost", "an output of the restarted run is gone"},
    {"retired", "an argument of an earlier release has no effect any more"},
    {"deck", "the deck or a virtual test has said it with fabric.warn"},
};

}  // namespace

std::span<const WarningKind> warning_kinds() { return kinds; }

const WarningKind& warning_kind(std::string_view code) {
  const auto* found =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const auto& kind) { return code == kind.code; });
  assert(found != std::end(kinds));
  return *found;
}

}  // namespace fabricsh::run
