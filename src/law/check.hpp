// What is wrong with a card, or worth knowing about it, before a run finds out.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "card/card.hpp"
#include "law/law.hpp"

namespace fabricsh::law {

enum class Severity { note, warning, error };
const char* name(Severity severity);

// One finding. Numbers are in SI and named, for the table form of the report.
struct CheckItem {
  std::string key;  // "guard.warp", "bending.weft", ...: stable, for programs
  Severity severity = Severity::note;
  std::string text;  // one or two sentences, for people
  std::vector<std::pair<std::string, double>> numbers;
};

struct CheckReport {
  std::string card;
  std::vector<CheckItem> items;

  bool ok() const;                                      // no error: a model may use the card
  const CheckItem* find(const std::string& key) const;  // null if absent
  std::string text() const;                             // the whole report, errors first
};

// element_size: m, the smallest in-plane size of an element, for the explicit step. Never throws for a bad
// card: what compile() refuses becomes an error item.
CheckReport check(const card::Card& card, double element_size = 0.1);

// Where the thesis' unsymmetric law loses positive definiteness, 4 D1 D2 < (nu21 D1 + nu12 D2)^2, along a
// path, by branch pair. Branches: virgin D(E), unloading Du, slack D(0).
struct CriterionRow {
  std::string path;   // "warp", "weft" (uniaxial stress), "biaxial" (E11 = E22)
  Branch warp, weft;  // the branch pair
  double first;       // strain along the pull at which it is violated first; NaN: nowhere in the tested range
  double last;        // end of the scan, the tested strain
};
std::vector<CriterionRow> criterion_table(const card::Woven& woven, const Law& law);
const char* name(Branch branch);

}  // namespace fabricsh::law
