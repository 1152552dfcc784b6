// The declared problem: a mesh, a card, supports, motions, loads. Nothing is computed here; validate() checks
// the whole once, and an analysis compiles it.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/notice.hpp"
#include "model/declarations.hpp"
#include "model/interaction.hpp"
#include "model/sheets.hpp"
#include "model/ties.hpp"

namespace fabricsh::model {

class Model : public Sheets {
 public:
  // Errors: those of Sheets.
  Model(std::shared_ptr<mesh::Mesh> mesh, card::Card card, Options options);
  // Several bodies, or one with regions.
  explicit Model(std::vector<BodyGiven> bodies);

  // Declares one of the kinds of Declarations. Errors: those of check_values() and check(); the model is
  // compiled already.
  template <class D>
  void add(D declaration) {
    check_open(plain(declaration).call());
    if constexpr (requires { declaration.set; }) check_values(*mesh_, declaration);
    if constexpr (requires { check(*this, declaration); }) check(*this, declaration);
    auto& all = declarations_.all<D>();
    if constexpr (std::is_same_v<D, Gravity>) all.clear();
    all.push_back(std::move(declaration));
  }
  // The calls made most often.
  void fix(const std::string& set, const FixedFreedoms& fixed, const Mat3& frame = global_frame()) {
    add(Support{set, fixed, frame});
  }
  void move(const std::string& set, Components displacement, const Mat3& frame = global_frame()) {
    add(PrescribedMotion{set, std::move(displacement), frame});
  }
  void force(const std::string& set, Components total, const Mat3& frame = global_frame()) {
    add(ForceLoad{set, std::move(total), frame});
  }
  void pressure(const std::string& set, History value) { add(PressureLoad{set, std::move(value)}); }
  void gravity(Components acceleration) { add(Gravity{std::move(acceleration)}); }
  // Takes back the i-th of a kind, from 0. Error: it does not exist.
  template <class D>
  void remove(std::size_t i) {
    check_open("remove");
    auto& all = declarations_.all<D>();
    if (i >= all.size()) throw Error("remove: there is no such support or load");
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
  }
  const Declarations& declarations() const { return declarations_; }
  template <class D>
  const std::vector<D>& all() const {
    return declarations_.all<D>();
  }
  const Components& gravity() const;
  Interactions interactions() const { return Interactions(declarations_); }

  // Error: a degree of freedom that is both fixed and moved, or moved twice (naming node and calls); a node
  // held in two frames; nodes of a periodic tie in a tearable zone; the errors of work_out_ties,
  // work_out_seams, chain_of and enclosure_of.
  void validate() const;
  // Called by the analysis that compiles the model, after validate(): from here on mesh() has the nodes of
  // the tearable zones.
  void divide_zones();
  // Called by the analysis that compiles the model: later changes of the model or its mesh are Errors.
  void seal();
  // The same declarations over the same mesh, to be changed and compiled anew.
  std::shared_ptr<Model> copy() const;

  // Times at which a step must end: the kinks of all histories.
  std::vector<double> kinks() const;
  // Whether the cloth is free of stress in another shape than that of the mesh.
  bool has_rest() const;
  std::string describe() const;  // a few lines: mesh, card, warp, thickness, points, supports

 private:
  void check_open(const char* call) const;
  std::vector<Index> elements_of_zones() const;  // ascending
  void check_zones() const;
  Declarations declarations_;
  bool sealed_ = false;
};

// A plane of symmetry: x, y or z (axis 0, 1, 2) = at.
struct SymmetryPlane {
  int axis = 0;
  double at = 0;              // m
  std::string set;            // that lies in it, the first of several
  std::string words() const;  // "the plane of symmetry x = 0 m of set 'left'"
};
// Each once. Errors: a set that lies in no plane normal to the axis; cloth that is not symmetric about it
// where it meets it, because its yarns run neither along nor across it (symmetry.cpp).
std::vector<SymmetryPlane> symmetry_planes(const Model& model);
void check_symmetry(const Model& model);

}  // namespace fabricsh::model
