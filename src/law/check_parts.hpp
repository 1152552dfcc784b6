// The parts of the check of a card; each adds its findings to the report.
#pragma once
#include "law/check.hpp"
#include "law/data.hpp"

namespace fabricsh::law {

void check_units(const card::Card& card, CheckReport& report);
void check_curves(const card::Woven& woven, const Law& law, CheckReport& report);
void check_continuity(const Law& law, CheckReport& report);
void check_definite(const Law& law, CheckReport& report);
void check_criterion(const card::Woven& woven, const Law& law, CheckReport& report);
void check_bending(const card::Card& card, const Law& law, CheckReport& report);
void check_step(const card::Card& card, const Law& law, double element_size, CheckReport& report);

}  // namespace fabricsh::law
