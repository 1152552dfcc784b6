// Seams of a run: their edges meet when their time is over, and they burst where they reach their strength.
#include "mechanics/terms/seams.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/number.hpp"
#include "run/place_text.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

// Mean edges: how far apart edges may be when their time is over; and from where on that is said.
constexpr double kMeet = 0.1, kTell = 0.01;

// m, the largest gap of the stitches that are to close.
double widest(const mechanics::Dofs& dofs, const mechanics::Sewn& next, std::span<const double> x) {
  double most = 0;
  for (std::size_t i = 0; i < next.closed.size(); ++i)
    if (next.closed[i] != 0 && dofs.sewn().closed[i] == 0)
      most = std::max(most, mechanics::Dofs::gap(dofs.stitches()[i], x).norm());
  return most;
}

}  // namespace

void Run::resew(mechanics::Sewn next, double within) {
  change([&] { return assembly_->sew(std::move(next), within); });
}

void Run::sew() {
  if (seams_ == nullptr) return;
  if (const auto stuck = seams_->stuck())
    warn("seam", "warning: " + std::string(kind()) + ": the time of the seam " + seam_name(stuck->stitch) +
                     " is over, and at " + number(time()) + " s it does not close: it is " +
                     number(stuck->gap, 3) + " m apart about " + place_text(stuck->at) +
                     ", and comes no nearer: a body, folds or friction hold its edges; a longer 'over' of "
                     "m:seam, pieces that start nearer or larger, or more 'thickness' of m:contact would do");
  try {
    mechanics::Sewn next = seams_->due(time());
    if (next == assembly_->dofs().sewn()) return;
    const double apart = widest(assembly_->dofs(), next, std::as_const(*assembly_).state().x()),
                 edge = assembly_->dofs().length();
    if (apart > kTell * edge)
      warn("seam", "warning: " + std::string(kind()) + ": edges that are sewn were still " + number(apart) +
                       " m apart when their time was over, at " + number(time()) +
                       " s: they were moved together; a longer 'over' leaves less");
    resew(std::move(next), kMeet * edge);
  } catch (const Error& error) {
    const std::string text = std::string("at time ") + number(time()) + " s " + error.what();
    fail(NumericalFailure(std::string(kind()) + ": " + text +
                              ".\nTry: a longer field 'over' of m:seam, or pieces that lie nearer.",
                          time()),
         text);
  }
}

std::string Run::seam_name(std::size_t stitch) const {
  const auto& dofs = assembly_->dofs();
  return dofs.seams()[dofs.stitches()[stitch].seam].name();
}

// Message on a seam that should be closer by now; empty: none is behind.
std::string Run::caught_text() const {
  if (seams_ == nullptr) return {};
  const auto lagging = seams_->lagging();
  if (!lagging || lagging->gap - lagging->wanted < kMeet * assembly_->dofs().length()) return {};
  return "the seam " + seam_name(lagging->stitch) + " is caught: it is " + number(lagging->gap, 3) +
         " m apart about " + place_text(lagging->at) + ", where " + number(lagging->wanted, 3) +
         " m are planned by now";
}

// In steps that iterate whatever bursts with a stitch does so in the same state, as in tears.
void Run::burst() {
  if (seams_ == nullptr) return;
  const double step = tear_step();
  while (seams_->worst().share >= 1) {
    resew(seams_->let_go(step), 0);
    if (step > 0) return;
  }
}

// The stitches whose node, or all of what it is sewn to, is in the set.
std::vector<std::size_t> Run::stitches_along(const Along& along) const {
  std::vector<std::size_t> found;
  if (along.set.empty()) return found;
  const auto& set = model_->mesh().set(along.set);
  const auto has = [&](mesh::Index n) { return std::binary_search(set.begin(), set.end(), n); };
  const auto& stitches = assembly_->dofs().stitches();
  for (std::size_t i = 0; i < stitches.size(); ++i)
    if (has(stitches[i].node) || std::all_of(stitches[i].leads.begin(), stitches[i].leads.end(),
                                             [&](const auto& lead) { return has(lead.node); }))
      found.push_back(i);
  return found;
}

}  // namespace fabricsh::run
