// Contacts and rigid bodies of a model, and the surfaces that meet.
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "model/declarations.hpp"

namespace fabricsh::model {

// Declarations of rigid bodies and contacts, as they concern each body: a view of a model's declarations.
class Interactions {
 public:
  explicit Interactions(const Declarations& declared) : declared_(declared) {}
  // Errors: a body that is moved or has a velocity but is in no contact; a history that is not finite at time
  // 0; sets that share nodes without being equal; two sides that meet twice.
  void validate(const mesh::Mesh& mesh) const;

  bool any() const;
  const std::vector<ContactGiven>& contacts() const { return declared_.all<ContactGiven>(); }
  // Each once, in the order in which the contacts name them; then those that close volumes of gas, which need
  // not touch anything.
  std::vector<RigidPointer> bodies() const;
  std::string name_of(const Rigid& body) const;  // its own; else "sphere", or "sphere 2" if there are several
  const BodyMotion* motion_of(const Rigid& body) const {
    return first<BodyMotion>(body);
  }  // null: free, rests
  const BodyVelocity* velocity_of(const Rigid& body) const { return first<BodyVelocity>(body); }
  // Whether forces decide where the body is: it has a mass, or is loaded, on springs, or held in part.
  bool floats(const Rigid& body) const;
  BodySupport held(const Rigid& body) const;  // all of its supports together
  // The first declaration of a kind about the body; null: there is none.
  template <class D>
  const D* first(const Rigid& body) const {
    for (const D& one : declared_.all<D>())
      if (one.body.get() == &body) return &one;
    return nullptr;
  }
  template <class D>
  const std::vector<D>& all() const {
    return declared_.all<D>();
  }

 private:
  const Declarations& declared_;
};

// The surfaces of the cloth. No two share a node; each consists of the elements that the same contacts name.
struct SurfacePair {
  int first, second;    // numbers of surfaces; those of bodies follow, in the order of bodies()
  std::size_t contact;  // index in contacts()
};
struct Surfaces {
  std::vector<std::vector<mesh::Index>> elements;  // of each surface, ascending
  std::vector<SurfacePair> meetings;
};
// Errors: those of Interactions::validate().
Surfaces work_out_surfaces(const Interactions& interactions, const mesh::Mesh& mesh);

}  // namespace fabricsh::model
