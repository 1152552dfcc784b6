// Elements that carry more compression than the cloth within them could without folding: a mesh cannot show
// folds shorter than some four elements, and is compressed in their place (share/doc/folds.md). A few of them
// beside a crease, or for a moment, change nothing; what counts is their share of the cloth's energy.
#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "mechanics/dofs.hpp"
#include "mechanics/mesh_tools.hpp"
#include "mechanics/terms/cloth.hpp"
#include "run/place_text.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

namespace {

// N/m: the resultants of an element, and the largest principal one.
struct Tensions {
  double along, across, shear;
  explicit Tensions(const ElementValues& v, double thickness)
      : along(v.S11 * thickness), across(v.S22 * thickness), shear(v.S12 * thickness) {}
  double largest() const { return (along + across) / 2 + std::hypot((along - across) / 2, shear); }
  // The share of the stored energy that is that of the compression, as if the law were linear.
  double compressed_share() const {
    const double pressed = std::min(0.0, least()), pulled = std::max(0.0, largest());
    const double sum = pressed * pressed + pulled * pulled;
    return sum > 0 ? pressed * pressed / sum : 0;
  }
  double least() const { return (along + across) / 2 - std::hypot((along - across) / 2, shear); }
  // The largest share of what folds, over all directions n: -n.N.n / (f1 n1^2 + f2 n2^2).
  double over(const std::array<double, 2>& folds) const {
    const double a = along / folds[0], b = across / folds[1], c = shear / std::sqrt(folds[0] * folds[1]);
    return std::hypot((a - b) / 2, c) - (a + b) / 2;
  }
};

// Whether supports hold all nodes of an element in its plane, which then cannot fold, nor is meant to.
bool is_held_flat(const mechanics::Dofs& dofs, const std::array<mesh::Index, 4>& nodes) {
  const auto& X = dofs.reference();
  const mesh::Index last = nodes[3] < 0 ? nodes[0] : nodes[3];
  const Vec3 normal = (X[nodes[2]] - X[nodes[0]]).cross(X[last] - X[nodes[1]]).normalized();
  constexpr double mostly = 0.8;
  return std::all_of(nodes.begin(), nodes.end(), [&](mesh::Index n) {
    if (n < 0) return true;
    const auto& node = dofs.freedoms().nodes[static_cast<std::size_t>(n)];
    double held = 0;
    for (int i = 0; i < 3; ++i) {
      const auto equation = node.equation[static_cast<std::size_t>(i)];
      const double along = node.frame.row(i).dot(normal);
      if (mechanics::is_prescribed(equation)) held += along * along;
    }
    return held > mostly;
  });
}

// J: the energy that an element stores.
double stored_in(const model::Model& model, mesh::Index e, const ElementValues& v) {
  const auto& mesh = model.mesh();
  return v.stored * model.thickness_of(e) *
         mechanics::area(mesh.elements[static_cast<std::size_t>(e)], mesh.nodes);
}

}  // namespace

void Run::watch_compression() {
  constexpr double far = 10, much = 0.1, matters = 0.2;
  if (warned("compressed") || model_->membrane()) return;
  const auto& values = elements();
  double tension = 0, most = far;
  double compressed = 0, held = 0;  // J: of compression, and of what is held flat
  mesh::Index worst = -1;
  for (mesh::Index e = 0; e < static_cast<mesh::Index>(values.size()); ++e)
    tension = std::max(tension, Tensions(values[e], model_->thickness_of(e)).largest());
  for (mesh::Index e = 0; e < static_cast<mesh::Index>(values.size()); ++e) {
    const Tensions now(values[e], model_->thickness_of(e));
    if (model_->folds_of(e) != card::Folds::resolved || !(now.least() < 0)) continue;
    const double over = now.over(assembly_->cloth().readings().fold_tensions(e));
    const auto& nodes = model_->mesh().elements[static_cast<std::size_t>(e)];
    if (!(over > far) || is_held_flat(assembly_->dofs(), nodes)) continue;
    compressed += stored_in(*model_, e, values[e]) * now.compressed_share();
    if (!(over > most && -now.least() > much * tension)) continue;
    most = over;
    worst = e;
  }
  if (worst < 0) return;
  for (mesh::Index e = 0; e < static_cast<mesh::Index>(values.size()); ++e)
    if (is_held_flat(assembly_->dofs(), model_->mesh().elements[static_cast<std::size_t>(e)]))
      held += stored_in(*model_, e, values[e]);
  const EnergyAccount all = energy();
  const double share = compressed / std::max(compressed, all.stored + all.kinetic - held);
  if (!(share > matters)) return;
  const double least = -Tensions(values[worst], model_->thickness_of(worst)).least();
  // Without a bending of its own a card bends like a solid, which another warning says: what folds is not
  // known.
  const auto region = static_cast<std::size_t>(model_->region_of(worst));
  const bool is_known = model_->sections()[region].bends_apart;
  const std::string text =
      "warning: " + std::string(kind()) + ": at time " + number(time()) + " s element " +
      model_->element_name(worst) + ", about " + place_text(assembly_->cloth().readings().centre(worst)) +
      ", is compressed by " + number(least, 3) + " N/m, " + number(most, 2) +
      " times what its cloth carries without folding within it, and " +
      (tension > 0 ? number(least / tension, 2) + " times the largest tension of the sheet"
                   : std::string("nothing is in tension")) +
      ". " + number(100 * share, 2) +
      " % of the energy is compression of such elements: real cloth folds there, and results are too stiff. "
      "Elements " +
      number(std::sqrt(most), 2) +
      " times as small would show it; a model with folds=\"within elements\" has it on any mesh" +
      (is_known ? "" : ", for a card with bending={warp=, weft=, twist=}");
  note("compressed", text, worst);
  warnings_->back().serious = is_known;
  notices_->say(text);
}

}  // namespace fabricsh::run
