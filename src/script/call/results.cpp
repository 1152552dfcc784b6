#include "script/call/results.hpp"

#include <map>

namespace fabricsh::script {

std::string result_class(std::string_view entry) {
  static const std::map<std::string_view, std::string_view> classes = {
      {"fabric.card", "card"},       {"fabric.woven", "card"},       {"fabric.svk", "card"},
      {"fabric.linear", "card"},     {"card:with", "card"},          {"fabric.point", "point"},
      {"fabric.history", "history"}, {"fabric.ramp", "history"},     {"fabric.model", "model"},
      {"fabric.static", "analysis"}, {"fabric.dynamic", "analysis"}, {"analysis:snapshot", "snapshot"},
      {"model.mesh", "mesh"},        {"model.card", "card"},         {"analysis.model", "model"},
      {"analysis.mesh", "mesh"},     {"analysis:solve", "self"},     {"analysis:advance", "self"},
      {"analysis:step", "self"},     {"analysis:every", "self"},     {"analysis:event", "self"},
      {"analysis:record", "self"},   {"analysis:vtk", "self"},       {"analysis:checkpoint", "self"},
      {"analysis:restore", "self"},  {"mesh:map", "self"},           {"mesh:wrap", "self"},
      {"model:fix", "self"},         {"model:move", "self"},         {"model:force", "self"},
      {"model:gravity", "self"},     {"model:moment", "self"},       {"model:traction", "self"},
      {"model:pressure", "self"},    {"model:spring", "self"},       {"model:turn", "self"},
      {"model:velocity", "self"},    {"model:symmetry", "self"},     {"model:tie", "self"},
      {"model:remove", "self"},      {"model:contact", "self"},      {"analysis:write", "self"},
      {"model:gas", "gas"},
  };
  if (entry.starts_with("fabric.mesh.")) return "mesh";
  if (entry.starts_with("fabric.rigid.")) return "body";
  const auto found = classes.find(entry);
  return found == classes.end() ? std::string() : std::string(found->second);
}

}  // namespace fabricsh::script
