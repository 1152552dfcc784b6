// The loads of sets of nodes, one struct each. A struct has the name of its call in decks and tells its
// members to a visitor; from that come its checks, m:list(), m:declared(), removal, the printed model, the
// times of kinks, the fingerprint in checkpoints and the notice of a load that begins with a jump. A new load
// is a struct here, in Loads, and a term.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "geometry/vec.hpp"
#include "history/history.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::model {

using history::History;

// Orthonormal frame of an oblique support or load: rows e1 e2 e3 in global components. The x y z of the call
// are components along them.
Mat3 frame_from(const Vec3& e1,
                const Vec3& e2);  // Error unless they span a plane; e2 is made orthogonal to e1
inline Mat3 global_frame() { return Mat3::Identity(); }

using Components = std::array<std::optional<History>, 3>;
// The same vector at all times.
inline Components steady(const Vec3& v) {
  return {History::constant(v.x()), History::constant(v.y()), History::constant(v.z())};
}

// A visitor has components(value, unit), history(name, value, unit), stiffness(value, unit) along three axes,
// and frame(value). The order in which members are told is that of the fingerprint.
struct ForceLoad {
  static constexpr const char* call = "force";
  std::string set;
  Components total;  // N, distributed by tributary length (edges) or area; a single node gets all of it
  Mat3 frame = global_frame();
  template <class Visitor>
  void tell(Visitor& v) const {
    v.components(total, "N");
    v.frame(frame);
  }
};
struct MomentLoad {
  static constexpr const char* call = "moment";
  std::string set;
  Components total;  // N m about the axes of the frame, which stay fixed in space; distributed like a force
  Mat3 frame = global_frame();
  template <class Visitor>
  void tell(Visitor& v) const {
    v.components(total, "N m");
    v.frame(frame);
  }
};
struct TractionLoad {
  static constexpr const char* call = "traction";
  std::string set;
  Components intensity;  // dead load: N/m^2 of reference area if the set has whole elements, else N/m of edge
  Mat3 frame = global_frame();
  template <class Visitor>
  void tell(Visitor& v) const {
    v.components(intensity, "N/m^2 or N/m");
    v.frame(frame);
  }
};
struct PressureLoad {
  static constexpr const char* call = "pressure";
  static constexpr bool on_elements = true;  // the set has to have whole ones
  std::string set;
  History value;  // Pa, along the shell normal, which follows the surface
  template <class Visitor>
  void tell(Visitor& v) const {
    v.history("value", value, "Pa");
  }
};
struct GroundSpring {
  static constexpr const char* call = "spring";
  static constexpr bool resists = true;  // listed with what holds the cloth
  std::string set;
  std::array<double, 3>
      stiffness{};  // N/m along the frame, to ground, total of the set, distributed like a force
  Mat3 frame = global_frame();
  template <class Visitor>
  void tell(Visitor& v) const {
    v.frame(frame);
    v.stiffness(stiffness, "N/m");
  }
};

// Their order is that of the fingerprint and of lists: a new kind comes last.
using Loads = std::tuple<std::vector<ForceLoad>, std::vector<MomentLoad>, std::vector<TractionLoad>,
                         std::vector<PressureLoad>, std::vector<GroundSpring>>;

template <class Load>
constexpr bool resists = requires {
  Load::resists;
};

// look(all) for the list of each kind.
template <class Look>
void each_kind(const Loads& loads, Look look) {
  std::apply([&look](const auto&... all) { (look(all), ...); }, loads);
}
// Tells the visitor each of them; it is told before whose members follow, by about(load).
template <class Visitor>
void tell_each(const Loads& loads, Visitor& visitor) {
  each_kind(loads, [&visitor](const auto& all) {
    for (const auto& load : all) {
      visitor.about(load);
      load.tell(visitor);
    }
  });
}

// Throws what is wrong with the values of a load.
class LoadCheck {
 public:
  explicit LoadCheck(std::string call) : call_(std::move(call)) {}
  void components(const Components& value, const char* unit) const;
  void history(const char*, const History&, const char*) const {}
  void stiffness(const std::array<double, 3>& value, const char* unit) const;
  void frame(const Mat3&) const {}
  void elements(const mesh::Mesh& mesh, const std::string& set) const;

 private:
  std::string call_;
};
// Errors: an unknown set, or one without a whole element for a load of elements; no component given; a
// stiffness below 0.
template <class Load>
void check_load(const mesh::Mesh& mesh, const Load& load) {
  const LoadCheck check(Load::call);
  mesh.set(load.set);
  if constexpr (requires { Load::on_elements; }) check.elements(mesh, load.set);
  load.tell(check);
}

}  // namespace fabricsh::model
