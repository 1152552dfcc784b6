#include "fabric/check.hpp"

#include <cmath>

#include "base/error.hpp"
#include "fabric/check_parts.hpp"
#include "fabric/provenance.hpp"
#include "fabric/text.hpp"

namespace fabricsh::fabric {

const char* name(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

const char* name(Branch branch) {
  return branch == Branch::virgin ? "virgin" : branch == Branch::unloading ? "unloading" : "slack";
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

namespace {

struct Range {
  const char* key;
  const char* what;
  double value, low, high;
  const char* unit;
};

// A value far outside what cloth is: most often a wrong unit.
void ask_about(const Range& r, CheckReport& report) {
  if (!(r.value > 0) || (r.value >= r.low && r.value <= r.high)) return;
  report.items.push_back({std::string("units.") + r.key,
                          Severity::warning,
                          std::string(r.what) + " " + number(r.value) + " " + r.unit +
                              " is far outside cloth (" + number(r.low) + " to " + number(r.high) +
                              "): is it in SI units?",
                          {{"value", r.value}, {"low", r.low}, {"high", r.high}}});
}

double initial_modulus(const card::Curve& curve) {
  if (!curve.coefficients.empty()) return curve.coefficients.front();
  return curve.points.size() > 1 ? curve.points[1].second / curve.points[1].first : 0.0;
}

}  // namespace

void check_units(const card::Card& card, CheckReport& report) {
  ask_about({"density", "density", card.density, 30, 3000, "kg/m3"}, report);
  ask_about({"thickness", "thickness", card.thickness, 2e-5, 2e-2, "m"}, report);
  ask_about({"areal_mass", "mass per area", card.density * card.thickness, 5e-3, 3, "kg/m2"}, report);
  const auto* w = std::get_if<card::Woven>(&card.law);
  if (w == nullptr) {
    const auto* svk = std::get_if<card::Svk>(&card.law);
    if (svk != nullptr) ask_about({"warp", "warp modulus", svk->warp, 1e3, 1e11, "Pa"}, report);
    return;
  }
  ask_about({"warp.loading", "initial warp modulus", initial_modulus(w->warp.loading), 1e3, 1e11, "Pa"},
            report);
  ask_about({"weft.loading", "initial weft modulus", initial_modulus(w->weft.loading), 1e3, 1e11, "Pa"},
            report);
  ask_about({"shear.loading", "initial shear modulus", initial_modulus(w->shear.loading), 1e2, 1e10, "Pa"},
            report);
  ask_about({"warp.unloading", "warp unloading modulus", w->warp.unloading, 1e4, 1e12, "Pa"}, report);
  ask_about({"weft.unloading", "weft unloading modulus", w->weft.unloading, 1e4, 1e12, "Pa"}, report);
  ask_about({"shear.unloading", "shear unloading modulus", w->shear.unloading, 1e3, 1e11, "Pa"}, report);
  ask_about({"warp.poisson", "warp Poisson ratio", w->warp.poisson, 1e-3, 5, ""}, report);
  ask_about({"weft.poisson", "weft Poisson ratio", w->weft.poisson, 1e-3, 5, ""}, report);
  ask_about({"tested.warp", "tested warp strain", w->tested.warp, 1e-4, 1, ""}, report);
  ask_about({"tested.weft", "tested weft strain", w->tested.weft, 1e-4, 1, ""}, report);
  ask_about({"tested.shear", "tested shear strain", w->tested.shear, 1e-3, 1, ""}, report);
}

namespace {

// What nobody measured is said with every check.
void check_provenance(const card::Card& card, CheckReport& report) {
  for (const auto& [field, words] : provenance_of(card.source))
    if (words.starts_with("assumed"))
      report.items.push_back({"assumed." + field, Severity::note, field + " is " + words, {}});
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
  } catch (const Error& refusal) {
    report.items.push_back({"refused", Severity::error, refusal.what(), {}});
    return report;
  }
  const auto* woven = std::get_if<card::Woven>(&card.law);
  if (woven != nullptr) {
    check_curves(*woven, *law, report);
    check_continuity(*law, report);
  }
  check_definite(*law, report);
  if (woven != nullptr) check_criterion(*woven, *law, report);
  check_bending(card, *law, report);
  check_step(card, *law, element_size, report);
  return report;
}

}  // namespace fabricsh::fabric
