// Beginning from the state of another assembly.
#include <string_view>

#include "base/error.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/terms/contact.hpp"

namespace fabricsh::mechanics {

// same_contact: whether both have the same pairs of surfaces with the same laws, so that slips and overlaps
// of the one are those of the other.
void Assembly::begin_from(const Assembly& other, bool same_contact) {
  auto& there = const_cast<Assembly&>(other);  // an archive that is written changes nothing
  const auto carry = [](auto& from, auto& to, const auto& keep) {
    Archive out;
    keep(from, out);
    Archive in(out.bytes());
    keep(to, in);
  };
  if (dofs_.joints().any()) {
    carry(there, *this, [](Assembly& a, Archive& archive) { a.keep_joints(archive); });
    renumbered();
  }
  if (!dofs_.seams().empty()) {
    carry(there, *this, [](Assembly& a, Archive& archive) { a.keep_seams(archive); });
    renumbered();
  }
  carry(there, *this, [](Assembly& a, Archive& archive) { a.configuration_.keep(archive); });
  auto* const contacts = terms_.find<Contacts>();
  if (const auto* const others = there.terms_.find<Contacts>(); contacts != nullptr && others != nullptr)
    contacts->take_stiffness(*others);
  for (const auto& term : terms_)
    for (const auto& twin : there.terms_) {
      if (std::string_view(twin->name()) != term->name()) continue;
      if (!same_contact && dynamic_cast<const Contacts*>(term.get()) != nullptr) continue;
      carry(*twin, *term, [](Term& one, Archive& archive) { one.keep(archive); });
    }
  dofs_.hold_here();
  configuration_.commit(configuration_.time());  // with the frames of directors that may turn less freely
  rollback();
  const double now = configuration_.time();
  set_time(now);
  if (contacts != nullptr && (!same_contact || contacts->bodies().jumps())) contacts->begin_here();
  if (!forces({now, 0})) throw Error("the law fails in the state from which it begins");
  commit(now);
}

}  // namespace fabricsh::mechanics
