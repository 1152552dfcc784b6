// Why a step could not be done: where, which yarn, what to try.
#include <algorithm>
#include <sstream>

#include "analysis/analysis.hpp"
#include "base/error.hpp"

namespace fabricsh::analysis {

using solver::NewtonStatus;

std::vector<fabric::Branch> Static::branches(mesh::Index element) const {
  std::vector<fabric::Branch> all;
  assembly_->visit(element, [&](double, const fabric::Law& law, const double* E, const double* state) {
    const auto in = fabric::internal(law, E, state);
    for (const auto branch : {in.warp, in.weft, in.shear}) all.push_back(branch);
  });
  return all;
}

// Compares the failed iterate with the committed state, to which it then goes back. Of the elements about the
// node with the largest residual, the first that switches is named.
Static::Blame Static::find_blame() const {
  Blame blame;
  std::vector<mesh::Index> about;
  if (last_.status == NewtonStatus::law_failed && assembly_->failed_element() >= 0) {
    about = {assembly_->failed_element()};
  } else if (last_.worst >= 0) {
    blame.node = assembly_->node_of_unknown(last_.worst);
    const auto& elements = model_->mesh().elements;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (std::find(elements[e].begin(), elements[e].end(), blame.node) != elements[e].end())
        about.push_back(static_cast<mesh::Index>(e));
  }
  std::vector<std::vector<fabric::Branch>> tried;
  for (const auto e : about) tried.push_back(branches(e));
  assembly_->state().rollback();
  static const char* const yarns[] = {"warp", "weft", "shear"};
  for (std::size_t i = 0; i < about.size() && blame.yarn.empty(); ++i) {
    const auto committed = branches(about[i]);
    for (std::size_t k = 0; k < committed.size() && blame.yarn.empty(); ++k)
      if (committed[k] != tried[i][k]) {
        blame.element = about[i];
        blame.yarn = yarns[k % 3];
      }
  }
  if (blame.element < 0 && !about.empty()) blame.element = about.front();
  return blame;
}

namespace {

std::string remedy(const solver::NewtonResult& last, const StaticOptions& options) {
  const bool arc = options.control == Control::arc;
  switch (last.status) {
    case NewtonStatus::law_failed:
      return "a smaller step; or a finer or better shaped mesh there: elements may have turned inside out";
    case NewtonStatus::singular:
      return "supports that leave no part free to move (a flat or slack sheet has no stiffness out of its "
             "plane: "
             "fix(\"all\", \"z\"), or stabilise=true, or method=\"relaxation\")";
    case NewtonStatus::turned_back:
      return "a history that begins below the lowest load of the path (table{ {0, -1}, {2, 1} }), or a "
             "smaller "
             "step, so that the path is not walked the way it came";
    case NewtonStatus::diverged:
    default:
      if (last.negative_pivots > 0 && !arc)
        return "control=\"arc\" (the tangent has negative pivots: a limit point), or stabilise=true for "
               "wrinkles and snaps";
      if (!last.residuals.empty() && last.residuals.back() < 1e-6)
        return "a larger tolerance (the residual is already small), or more max_iterations";
      return arc ? "a smaller step, or more max_cuts"
                 : "a smaller step, stabilise=true, or method=\"either\"";
  }
}

}  // namespace

void Static::give_up(const StepReport& report) const {
  const double now = assembly_->state().time();
  std::ostringstream text;
  text.precision(6);
  text << "static: no step beyond time " << now << " s: " << solver::describe(last_.status)
       << " in a step of " << report.step << " s after " << std::min(report.cuts, options_.max_cuts)
       << " halvings";
  if (blame_.node >= 0 && !last_.residuals.empty())
    text << "; the residual " << last_.residuals.back() << " (tolerance " << options_.tolerance
         << ") sits at node " << blame_.node + 1;
  if (blame_.element >= 0) text << ", element " << blame_.element + 1;
  if (!blame_.yarn.empty()) text << ", where the " << blame_.yarn << " is switching";
  text << ".\nTry: " << remedy(last_, options_) << ".";
  throw NumericalFailure(text.str(), now, blame_.element, blame_.yarn);
}

}  // namespace fabricsh::analysis
