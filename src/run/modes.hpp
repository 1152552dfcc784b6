// Small vibrations about a state, and factors of loads at which a state becomes unstable: the eigenvalues of
// its tangent beside the mass, or beside what the loads have added to the tangent of the unloaded cloth.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace fabricsh::run {

class Run;

// A motion of all nodes from the positions of a state; the largest displacement is 1, m.
struct Shape {
  std::shared_ptr<const mesh::Mesh> mesh;  // of the model
  std::vector<Vec3> from;                  // m, positions of the state
  std::vector<Vec3> way;                   // m
};

struct VibrationMode {
  double frequency = 0;      // Hz; 0: a motion without stiffness, or one that grows
  double growth = 0;         // 1/s; above 0: the state is unstable, and leaves it at this rate
  Vec3 mass = Vec3::Zero();  // kg, effective in x, y, z
  // Of the shape: how much of it a motion of the supports by 1 in x, y, z has, and its own mass, kg.
  Vec3 participation = Vec3::Zero();
  double own_mass = 0;
  std::shared_ptr<const Shape> shape;
};

struct BucklingMode {
  double factor = 0;  // of the loads
  std::shared_ptr<const Shape> shape;
};

// Modes, and remarks on the result beside its numbers, one line each.
template <class M>
struct Modes {
  std::vector<M> modes;
  std::vector<std::string> words = {};
  Vec3 mass = Vec3::Zero();  // kg, all that can move in x, y, z
};

struct ModesWanted {
  int count = 10;
  std::optional<double> below = {};  // Hz
  bool all_below = false;            // however many they are
};

// In the state of a run, or of a model at rest at time 0, with the lumped masses of motion and directors
// without inertia. Rigid bodies with a mass swing along. Errors: one
// without, that moves freely; nothing can move; more modes than can be found.
Modes<VibrationMode> vibration_modes(const Run& run, const ModesWanted& wanted);
Modes<VibrationMode> vibration_modes(const std::shared_ptr<model::Model>& model, const ModesWanted& wanted);

// The factors, above zero and ascending, of the stresses of the run's state and of its loads, in its shape,
// at which its tangent would have no stiffness against some motion. Errors: as above; a state without stress;
// joints or seams that are not as they were at the start.
Modes<BucklingMode> buckling_modes(const Run& run, int count);
// The same of what the loads and motions of another model of the cloth, at the time of the state, are beyond
// those of the run: the stresses and loads of the state stay as they are. Errors: other cloth, contacts or
// supports; nothing beyond; a state that is unstable already.
Modes<BucklingMode> buckling_modes(const Run& run, const std::shared_ptr<model::Model>& load, int count);

}  // namespace fabricsh::run
