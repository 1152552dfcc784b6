// Overlaps at the start: pairs below their smallest distance, and cloth that starts inside a solid.
#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "contact/intersect.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

namespace {

constexpr double kNearest = 1e-3;  // smallest gap at the start that is opened, as a share of the whole
constexpr std::size_t kTold = 5;   // number of overlaps named in a message

}  // namespace

void Contacts::check_start() const {
  if (!state_.overlaps.empty()) throw Error(state_.overlaps);
}

// The first positions of the bodies stand beside the mesh, and not beside the cloth of the state.
void Contacts::begin_here() {
  surfaces_.bodies().settle();
  find_overlaps(state_.configuration.time());
  check_start();
  state_.begin();
}

void Contacts::find_overlaps(double time) {
  state_.overlaps = overlaps_at(time);
  if (state_.overlaps.empty()) state_.overlaps = inside();
}

std::string Contacts::overlaps_at(double time) {
  if (!surfaces_.any()) return {};
  state_.positions(state_.configuration.x(), 0, state_.x);
  settling_.open_to(time);
  const auto overlaps = state_.pairs.overlaps(state_.x);
  const auto& meetings = surfaces_.meetings();
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (meetings[i].near > 0 && meetings[i].nearest < kNearest * surfaces_.law(i).gap() && overlaps.empty())
      return "contact: field 'settle': " + meetings[i].names + ": expected at least " +
             number(kNearest * surfaces_.law(i).gap()) + " m between what is opened, got " +
             number(meetings[i].nearest) + " m";
  if (overlaps.empty()) return {};
  std::string text = "contact: " + std::to_string(overlaps.size()) +
                     (overlaps.size() == 1 ? " pair overlaps" : " pairs overlap") + " at the start:";
  for (std::size_t i = 0; i < std::min(kTold, overlaps.size()); ++i)
    text += (i > 0 ? "; " : " ") + surfaces_.words(overlaps[i].point) +
            (overlaps[i].gap > 0 ? ", " + number(overlaps[i].gap) + " m apart" : ", one through the other");
  if (overlaps.size() > kTold) text += "; ...";
  const auto tight = [](const auto& overlap) { return overlap.gap > 0; };
  return text + "; expected all of it apart" +
         (std::any_of(overlaps.begin(), overlaps.end(), tight)
              ? " (settle= of m:contact would open what is not one through the other)"
              : "");
}

// No edge of a sheet inside a solid need be near its surface, so that no pair tells. Empty: nothing is
// inside.
std::string Contacts::inside() const {
  for (const model::RigidPointer& given : model_.interactions().bodies()) {
    const model::Facets* facets = given->facets();
    const auto number = static_cast<std::size_t>(surfaces_.find_body(*given));
    if (facets == nullptr || !(facets->closed || given->free())) continue;
    const auto vertices = std::span(bodies().state().committed)
                              .subspan(bodies().vertices(number).first, facets->vertices.size());
    for (const auto& it : surfaces_.scene().interactions()) {
      if (it.second != bodies().state().bodies[number].surface) continue;
      for (const std::int32_t p : surfaces_.scene().surfaces()[static_cast<std::size_t>(it.first)].points)
        if ((it.rigid || surfaces_.scene().neighbours().sheet(p) == p) &&
            contact::encloses(vertices, facets->triangles, state_.x[static_cast<std::size_t>(p)]))
          return "contact: " + surfaces_.words({p, -1, -1, -1}) + " starts inside the " +
                 model_.interactions().name_of(*given) + ", which bounds a solid: expected " +
                 (it.rigid ? "it" : "the cloth") +
                 " outside of it (a hollow body has neither closed=true nor a mass)";
    }
  }
  return {};
}

}  // namespace fabricsh::mechanics
