// Format: Khronos, glTF 2.0 specification, 2021, sections 3.7.2.2 (morph targets) and 4 (GLB).
#include "format/gltf.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "format/json.hpp"
#include "mesh/edges.hpp"

namespace fabricsh::format {

namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertices = 34962, kIndices = 34963;
using Triples = std::vector<std::array<float, 3>>;

std::string little(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}

// The binary part, and what the JSON says of it: a view and an accessor for each list of numbers.
class Store {
 public:
  std::int64_t add(const Triples& list, bool of_vertices, bool bounds) {
    const std::size_t from = data_.size();
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-low[0]);
    for (const auto& item : list)
      for (std::size_t k = 0; k < 3; ++k) {
        put(item[k]);
        low[k] = std::min(low[k], item[k]), high[k] = std::max(high[k], item[k]);
      }
    Json accessor = begin(from, of_vertices ? kVertices : 0, kFloat, list.size(), "VEC3");
    if (bounds) accessor.set("min", list_of(low)).set("max", list_of(high));
    return finish(std::move(accessor));
  }
  std::int64_t add(const std::vector<float>& list, bool bounds) {
    const std::size_t from = data_.size();
    for (const float value : list) put(value);
    Json accessor = begin(from, 0, kFloat, list.size(), "SCALAR");
    if (bounds) {
      accessor.set("min", list_of(std::array{list.front()}));
      accessor.set("max", list_of(std::array{list.back()}));
    }
    return finish(std::move(accessor));
  }
  std::int64_t add(const std::vector<std::uint32_t>& list) {
    const std::size_t from = data_.size();
    for (const std::uint32_t value : list) data_ += little(value);
    return finish(begin(from, kIndices, kUnsignedInt, list.size(), "SCALAR"));
  }

  const std::string& data() const { return data_; }
  Json views() const { return views_; }
  Json accessors() const { return accessors_; }

 private:
  void put(float value) { data_ += little(std::bit_cast<std::uint32_t>(value)); }

  template <class List>
  static Json list_of(const List& values) {
    Json out = Json::array();
    for (const float value : values) out.push(static_cast<double>(value));
    return out;
  }

  Json begin(std::size_t from, int target, int type, std::size_t count, const char* shape) {
    Json view = Json::object();
    view.set("buffer", 0).set("byteOffset", from).set("byteLength", data_.size() - from);
    if (target != 0) view.set("target", target);
    views_.push(std::move(view));
    Json accessor = Json::object();
    accessor.set("bufferView", count_).set("componentType", type).set("count", count).set("type", shape);
    return accessor;
  }
  std::int64_t finish(Json accessor) {
    accessors_.push(std::move(accessor));
    return count_++;
  }

  std::string data_;
  Json views_ = Json::array(), accessors_ = Json::array();
  std::int64_t count_ = 0;
};

std::vector<std::uint32_t> triangles(const GltfSurface& surface) {
  std::vector<std::uint32_t> ids;
  for (const auto& cell : surface.cells)
    for (std::size_t k = 2; k < mesh::corner_count(cell); ++k)
      for (const std::size_t corner : {std::size_t{0}, k - 1, k})
        ids.push_back(static_cast<std::uint32_t>(cell[corner]));
  return ids;
}

Triples rounded(const std::vector<Vec3>& list) {
  Triples out;
  for (const Vec3& x : list)
    out.push_back({static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z())});
  return out;
}

// Means over the cells that meet in a point, by area.
std::vector<Vec3> normals(const GltfSurface& surface, const std::vector<Vec3>& points) {
  std::vector<Vec3> sums(points.size(), Vec3::Zero());
  const auto at = [&points](mesh::Index id) -> const Vec3& { return points[static_cast<std::size_t>(id)]; };
  for (const auto& cell : surface.cells) {
    const Vec3 across = mesh::corner_count(cell) == 3
                            ? Vec3((at(cell[1]) - at(cell[0])).cross(at(cell[2]) - at(cell[0])))
                            : Vec3((at(cell[2]) - at(cell[0])).cross(at(cell[3]) - at(cell[1])));
    for (std::size_t k = 0; k < mesh::corner_count(cell); ++k)
      sums[static_cast<std::size_t>(cell[k])] += across;
  }
  for (Vec3& n : sums) n = n.norm() > 0 ? Vec3(n / n.norm()) : Vec3(Vec3::UnitZ());
  return sums;
}

// Of the numbers as they are stored, so that the first frame and the difference make the frame.
Triples less(const Triples& now, const Triples& first) {
  Triples out(now.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) out[i][k] = now[i][k] - first[i][k];
  return out;
}

void check(const GltfScene& scene) {
  const std::size_t frames = scene.times.size();
  if (frames == 0 || scene.surfaces.empty()) throw Error("glTF: expected at least one frame of a surface");
  for (const GltfSurface& s : scene.surfaces) {
    if (s.cells.empty()) throw Error("glTF: surface '" + s.name + "' has no cell");
    bool good = s.frames.size() == frames && (s.colours.empty() || s.colours.size() == frames);
    for (const auto& points : s.frames) good = good && points.size() == s.frames[0].size();
    for (const auto& colours : s.colours) good = good && colours.size() == s.frames[0].size();
    if (!good)
      throw Error("glTF: surface '" + s.name + "': expected as many points, and colours, in each of " +
                  std::to_string(frames) + " frames");
  }
}

Json primitive(const GltfSurface& s, std::int64_t material, Store& store) {
  const Triples places = rounded(s.frames[0]), across = rounded(normals(s, s.frames[0]));
  Json attributes = Json::object();
  attributes.set("POSITION", store.add(places, true, true)).set("NORMAL", store.add(across, true, false));
  if (!s.colours.empty()) attributes.set("COLOR_0", store.add(s.colours[0], true, false));
  Json targets = Json::array();
  for (std::size_t f = 1; f < s.frames.size(); ++f) {
    Json target = Json::object();
    target.set("POSITION", store.add(less(rounded(s.frames[f]), places), true, true));
    target.set("NORMAL", store.add(less(rounded(normals(s, s.frames[f])), across), true, false));
    if (!s.colours.empty()) target.set("COLOR_0", store.add(less(s.colours[f], s.colours[0]), true, false));
    targets.push(std::move(target));
  }
  Json out = Json::object();
  out.set("attributes", std::move(attributes))
      .set("indices", store.add(triangles(s)))
      .set("material", material);
  if (s.frames.size() > 1) out.set("targets", std::move(targets));
  return out;
}

Json mesh_of(const GltfSurface& s, std::int64_t material, Store& store) {
  Json out = Json::object(), primitives = Json::array();
  primitives.push(primitive(s, material, store));
  out.set("name", s.name).set("primitives", std::move(primitives));
  if (s.frames.size() > 1) out.set("weights", std::vector<int>(s.frames.size() - 1, 0));
  return out;
}

Json material_of(const GltfSurface& s) {
  Json colour = Json::array(), look = Json::object(), out = Json::object();
  for (const float c : s.plain) colour.push(s.colours.empty() ? static_cast<double>(c) : 1.0);
  colour.push(1.0);
  look.set("baseColorFactor", std::move(colour)).set("metallicFactor", 0.0).set("roughnessFactor", 0.8);
  return out.set("name", s.name).set("doubleSided", true).set("pbrMetallicRoughness", std::move(look));
}

// Of the surface in one frame.
GltfSurface still(const GltfSurface& s, std::size_t frame) {
  GltfSurface out{s.name, s.cells, {s.frames[frame]}, {}, s.plain};
  if (!s.colours.empty()) out.colours = {s.colours[frame]};
  if (s.frames.size() > 1) out.name += " " + std::to_string(frame + 1);
  return out;
}

// Node 1 + surface + surfaces * frame is as large as it is while its frame is on, and else a point.
Json show_by_turns(const GltfScene& scene, Store& store) {
  const std::size_t frames = scene.times.size(), surfaces = scene.surfaces.size();
  std::vector<float> times;
  for (const double t : scene.times) times.push_back(static_cast<float>(t));
  const std::int64_t input = store.add(times, true);
  Json samplers = Json::array(), channels = Json::array(), out = Json::object();
  for (std::size_t f = 0; f < frames; ++f) {
    Triples scale(frames, {0, 0, 0});
    scale[f] = {1, 1, 1};
    Json sampler = Json::object();
    sampler.set("input", input).set("interpolation", "STEP").set("output", store.add(scale, false, false));
    samplers.push(std::move(sampler));
    for (std::size_t i = 0; i < surfaces; ++i) {
      Json target = Json::object(), channel = Json::object();
      target.set("node", 1 + i + surfaces * f).set("path", "scale");
      channels.push(channel.set("sampler", f).set("target", std::move(target)));
    }
  }
  return out.set("name", "run").set("samplers", std::move(samplers)).set("channels", std::move(channels));
}

// At the time of a frame its own weight is 1 and all others are 0.
Json animation(const GltfScene& scene, Store& store) {
  const std::size_t frames = scene.times.size();
  std::vector<float> times, weights(frames * (frames - 1), 0.0f);
  for (const double t : scene.times) times.push_back(static_cast<float>(t));
  for (std::size_t f = 1; f < frames; ++f) weights[f * (frames - 1) + f - 1] = 1;
  Json sampler = Json::object(), samplers = Json::array(), channels = Json::array(), out = Json::object();
  sampler.set("input", store.add(times, true))
      .set("interpolation", "LINEAR")
      .set("output", store.add(weights, false));
  samplers.push(std::move(sampler));
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    Json target = Json::object(), channel = Json::object();
    target.set("node", i + 1).set("path", "weights");
    channels.push(channel.set("sampler", 0).set("target", std::move(target)));
  }
  return out.set("name", "run").set("samplers", std::move(samplers)).set("channels", std::move(channels));
}

Json one(Json item) {
  Json list = Json::array();
  return list.push(std::move(item));
}

std::string chunk(const char* type, std::string content, char filler) {
  while (content.size() % 4 != 0) content += filler;
  return little(static_cast<std::uint32_t>(content.size())) + std::string(type, 4) + content;
}

}  // namespace

// Node 0 holds the others, and is turned by -90 degrees around x where z is up.
std::string glb(const GltfScene& scene) {
  check(scene);
  Store store;
  Json meshes = Json::array(), materials = Json::array(), nodes = Json::array(), children = Json::array();
  const std::size_t surfaces = scene.surfaces.size(), copies = scene.morph ? 1 : scene.times.size();
  std::vector<std::string> names;
  for (std::size_t f = 0; f < copies; ++f)
    for (std::size_t i = 0; i < surfaces; ++i) {
      const GltfSurface surface = scene.morph ? scene.surfaces[i] : still(scene.surfaces[i], f);
      meshes.push(mesh_of(surface, static_cast<std::int64_t>(i), store));
      names.push_back(surface.name);
      children.push(names.size());
    }
  for (const GltfSurface& surface : scene.surfaces) materials.push(material_of(surface));
  Json root = Json::object();
  root.set("name", "scene").set("children", std::move(children));
  if (scene.z_up) root.set("rotation", std::vector<double>{-std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
  nodes.push(std::move(root));
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json node = Json::object();
    node.set("name", names[i]).set("mesh", i);
    if (i >= surfaces)
      node.set("scale", std::vector<double>{0, 0, 0});  // where nothing is animated: the first
    nodes.push(std::move(node));
  }
  Json file = Json::object();
  file.set("asset", Json::object().set("version", "2.0").set("generator", scene.generator));
  file.set("scene", 0).set("scenes", one(Json::object().set("nodes", one(0)))).set("nodes", std::move(nodes));
  file.set("meshes", std::move(meshes)).set("materials", std::move(materials));
  if (scene.times.size() > 1)
    file.set("animations", one(scene.morph ? animation(scene, store) : show_by_turns(scene, store)));
  file.set("accessors", store.accessors()).set("bufferViews", store.views());
  file.set("buffers", one(Json::object().set("byteLength", store.data().size())));
  if (store.data().size() > std::numeric_limits<std::uint32_t>::max() / 2)
    throw Error("glTF: the frames take more than 2 GB: expected fewer of them");
  const std::string body = chunk("JSON", file.text(), ' ') + chunk("BIN\0", store.data(), '\0');
  return "glTF" + little(2) + little(static_cast<std::uint32_t>(12 + body.size())) + body;
}

}  // namespace fabricsh::format
