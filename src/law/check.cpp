#include "law/check.hpp"

#include "base/error.hpp"
#include "card/fields.hpp"
#include "law/bending_spring.hpp"
#include "law/check_parts.hpp"
#include "law/provenance.hpp"
#include "law/text.hpp"

namespace fabricsh::law {

const char* name(LoadBranch branch) {
  return branch == LoadBranch::virgin ? "virgin" : branch == LoadBranch::unloading ? "unloading" : "slack";
}

bool CheckReport::ok() const {
  for (const auto& item : items)
    if (item.severity == Severity::error) return false;
  return true;
}

const CheckItem* CheckReport::find(const std::string& key) const {
  for (const auto& item : items)
    if (item.key == key) return &item;
  return nullptr;
}

std::string CheckReport::text() const {
  std::string out = "card '" + card + "': " + (ok() ? "usable" : "refused") + "\n";
  for (const Severity wanted : {Severity::error, Severity::warning, Severity::note})
    for (const auto& item : items)
      if (item.severity == wanted) {
        std::string key = item.key;
        key.resize(std::max<std::size_t>(key.size(), 18), ' ');
        out += std::string("  ") + (wanted == Severity::note ? "       " : name(wanted)) +
               (wanted == Severity::error     ? "   "
                : wanted == Severity::warning ? " "
                                              : " ") +
               key + " " + item.text + "\n";
      }
  return out;
}

void check_units(const card::Card& card, CheckReport& report) {
  auto doubts = card::doubts(card);
  const double mass = card.density * card.thickness;
  const Range cloth{5e-3, 3};
  if (mass > 0 && !cloth.holds(mass))
    doubts.push_back({"areal_mass", "kg/m^2", "are density and thickness in kg/m^3 and m?", mass, cloth});
  for (const auto& d : doubts)
    report.items.push_back({"units." + d.field,
                            Severity::warning,
                            d.field + ": " + number(d.value) + (d.unit.empty() ? "" : " " + d.unit) +
                                " is far from what cloth is (" + number(d.cloth.low) + " to " +
                                number(d.cloth.high) + "): " + d.question,
                            {{"value", d.value}, {"low", d.cloth.low}, {"high", d.cloth.high}}});
}

namespace {

// Parameters that were assumed instead of measured are listed by every check.
void check_provenance(const card::Card& card, CheckReport& report) {
  for (const auto& [field, words] : card.provenance)
    if (words.starts_with("assumed"))
      report.items.push_back(
          {"assumed." + field, Severity::note, field + " is " + words + range_text(card, field), {}});
  if (const std::string line = line_of_origin(card.source); card.provenance.empty() && !line.empty())
    report.items.push_back({"source",
                            Severity::warning,
                            "the source has the line '" + line +
                                "', which is words alone: where numbers come from is stated by "
                                "provenance={ ['field']='origin' }",
                            {}});
}

// Samples lie about the card's own values, so that a band which does not hold its value is of another one.
void check_bands(const card::Card& card, const card::Woven& woven, CheckReport& report) {
  if (!woven.bands) return;
  for (const auto& [part, place] : card::banded_parts) {
    const card::ParameterBand& band = *woven.bands.*place;
    if (band.low.empty()) continue;
    const auto values = card::parameters(*card::find_field(card::fields(card), part), card);
    for (std::size_t i = 0; i < std::min(values.size(), band.low.size()); ++i) {
      if (values[i] >= band.low[i] && values[i] <= band.high[i]) continue;
      report.items.push_back({std::string("band.") + part,
                              Severity::warning,
                              "the band of " + std::string(part) +
                                  " does not hold the card's own value of number " + std::to_string(i + 1) +
                                  ": " + number(band.low[i]) + " to " + number(band.high[i]) + ", got " +
                                  number(values[i]),
                              {{"value", values[i]}, {"low", band.low[i]}, {"high", band.high[i]}}});
      break;
    }
  }
}

// Parts of the card that its law does not use.
void check_unused(const card::Woven& woven, CheckReport& report) {
  if (woven.law == card::LawKind::potential) return;
  const auto unused = [&](const char* field) {
    report.items.push_back({std::string("unused.") + field,
                            Severity::warning,
                            std::string(field) + " is not used: only law = \"potential\" has it",
                            {}});
  };
  if (woven.biaxial) unused("biaxial");
  if (woven.shear.memory == card::ShearMemory::fading) unused("shear.memory");
}

}  // namespace

CheckReport check(const card::Card& card, double element_size) {
  CheckReport report;
  report.card = card.name;
  check_units(card, report);
  check_provenance(card, report);
  std::shared_ptr<const Law> law;
  try {
    law = compile(card);
    if (card.bending) bending_springs(card);
  } catch (const Error& refusal) {
    report.items.push_back({"refused", Severity::error, refusal.what(), {}});
    return report;
  }
  const auto* woven = std::get_if<card::Woven>(&card.law);
  if (woven != nullptr) {
    check_unused(*woven, report);
    check_bands(card, *woven, report);
    check_curves(*woven, *law, report);
    check_continuity(*law, report);
  }
  check_definite(*law, report);
  if (softens(*law))
    report.items.push_back(
        {"softens",
         Severity::note,
         "beyond their strength yarns soften: there the tangent is not positive definite, and "
         "a static run may jump",
         {}});
  if (woven != nullptr) check_criterion(*woven, *law, report);
  check_bending(card, *law, report);
  check_step(card, *law, element_size, report);
  return report;
}

}  // namespace fabricsh::law
