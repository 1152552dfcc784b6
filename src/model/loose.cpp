#include "model/loose.hpp"

#include "contact/law.hpp"
#include "section/section.hpp"

namespace fabricsh::model {

Loose loose(const card::Card& card) {
  const section::Section s = section::integrated(card, card.thickness, 1, 0);
  if (s.compression.empty()) return {card.thickness, s.solid_thickness};
  contact::LawData data;
  data.floor = s.compression.front().first / 2;  // where contact begins does not depend on it
  data.curve = s.compression;
  return {contact::ContactLaw(data).gap(), s.solid_thickness};
}

}  // namespace fabricsh::model
