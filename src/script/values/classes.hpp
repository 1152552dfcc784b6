// The classes of the core's objects in Lua.
#pragma once
#include "card/card.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"
#include "model/model.hpp"
#include "script/call/object.hpp"

namespace fabricsh::script {

template <>
struct ClassName<mesh::Mesh> {
  static constexpr const char* name = "mesh";
};
template <>
struct ClassName<card::Card> {
  static constexpr const char* name = "card";
};
template <>
struct ClassName<history::History> {
  static constexpr const char* name = "history";
};
template <>
struct ClassName<model::Model> {
  static constexpr const char* name = "model";
};
template <>
struct ClassName<const model::GasGiven> {
  static constexpr const char* name = "gas";
};
template <>
struct ClassName<const model::Rigid> {
  static constexpr const char* name = "body";
};

}  // namespace fabricsh::script
