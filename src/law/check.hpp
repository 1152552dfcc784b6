// Defects of a card, and facts worth knowing about it, found before a run.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/severity.hpp"
#include "card/card.hpp"
#include "law/law.hpp"

namespace fabricsh::law {

// One finding. Its numbers are named and in SI units, for the table form of the report.
struct CheckItem {
  std::string key;  // "guard.warp", "bending.weft", ...: these words do not change between releases
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

// element_size: smallest in-plane size of an element (m), for the explicit step. Does
// not throw for a bad card: what compile() refuses becomes an error in the report.
CheckReport check(const card::Card& card, double element_size = 0.1);

// Where the unsymmetric law of the thesis loses positive definiteness along a path, 4 D1 D2 < (nu21 D1
// + nu12 D2)^2, for a pair of branches. Moduli of the branches: virgin D(E), unloading Du, slack D(0).
struct CriterionRow {
  std::string path;       // "warp", "weft" (uniaxial stress), "biaxial" (E11 = E22)
  LoadBranch warp, weft;  // the branch pair
  double first;           // strain along the pull at the first violation; NaN: none in the tested range
  double last;            // end of the scan, the tested strain
};
std::vector<CriterionRow> criterion_table(const card::Woven& woven, const Law& law);
const char* name(LoadBranch branch);

}  // namespace fabricsh::law
