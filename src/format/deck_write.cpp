#include "base/error.hpp"
#include "base/number.hpp"
#include "format/deck_mesh.hpp"
#include "format/mesh_file.hpp"

namespace fabricsh::format {

namespace {

using mesh::Index;
using mesh::Mesh;

// The number with as many digits as fit into so many characters, up to all of them.
std::string short_number(double x, std::size_t most) {
  std::string text = exact_number(x);
  for (int digits = 17; text.size() > most && digits > 0; --digits) text = number(x, digits);
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string columns(std::initializer_list<Index> numbers, std::size_t width) {
  std::string line;
  for (const Index number : numbers) line += right(std::to_string(number), width);
  return line;
}

bool triangle(const std::array<Index, 4>& ids) { return ids[3] < 0; }

// Those of the parts of a joined mesh too.
std::vector<std::pair<std::string, mesh::NodeSet>> sets_of(const Mesh& mesh) {
  std::vector<std::pair<std::string, mesh::NodeSet>> sets;
  for (const std::string& name : mesh.set_names()) sets.emplace_back(name, mesh.set(name));
  return sets;
}

void check(const Mesh& mesh) {
  for (const auto& [name, ids] : sets_of(mesh))
    if (name.find_first_of("\n\r\"") != std::string::npos || trimmed(name) != name || name.empty())
      throw Error("set '" + name +
                  "': a name with quotes or line ends, or blanks around it, does not go into a deck");
  const std::size_t most = 99999999;  // what 8 columns hold
  if (mesh.nodes.size() > most || mesh.elements.size() > most)
    throw Error("a mesh of more than " + std::to_string(most) + " nodes or elements does not go into a deck");
}

// Rows of node numbers from 1, so many to a line.
std::string rows(const mesh::NodeSet& ids, std::size_t to_a_line, std::size_t width, const char* between) {
  std::string text;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool last = i + 1 == ids.size() || (i + 1) % to_a_line == 0;
    text += right(std::to_string(ids[i] + 1), width) + (last ? "\n" : between);
  }
  return text;
}

// Abaqus takes upper and lower case for the same, and other names than plain words in quotes.
std::string abaqus_name(const std::string& name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && (i == 0 || ((c < '0' || c > '9') && c != '_' && c != '-' && c != '.')))
      return '"' + name + '"';
  }
  return name;
}

void check_cases(const Mesh& mesh) {
  std::map<std::string, std::string> seen;
  for (const auto& [name, ids] : sets_of(mesh))
    if (const auto [other, fresh] = seen.emplace(upper(name), name); !fresh)
      throw Error("sets '" + other->second + "' and '" + name +
                  "' are one in a deck of Abaqus, which takes upper and lower case for the same");
}

}  // namespace

// A number takes 20 characters at most there.
std::string abaqus_lines(const Mesh& mesh, const DeckForm& form) {
  check(mesh);
  check_cases(mesh);
  std::string text = "*NODE\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    text += std::to_string(i + 1);
    for (int k = 0; k < 3; ++k) text += ", " + short_number(mesh.nodes[i][k] * form.length, 20);
    text += "\n";
  }
  std::string type;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& ids = mesh.elements[e];
    const std::string now = triangle(ids) ? (form.membrane ? "M3D3" : "S3") : form.membrane ? "M3D4R" : "S4";
    if (now != type) text += "*ELEMENT, TYPE=" + now + ", ELSET=" + form.elements + "\n";
    type = now;
    text += std::to_string(e + 1);
    for (std::size_t k = 0; k < (triangle(ids) ? 3 : 4); ++k) text += ", " + std::to_string(ids[k] + 1);
    text += "\n";
  }
  for (const auto& [name, ids] : sets_of(mesh))
    text += "*NSET, NSET=" + abaqus_name(name) + "\n" + rows(ids, 12, 0, ", ");
  return text;
}

std::string dyna_lines(const Mesh& mesh, const DeckForm& form) {
  check(mesh);
  std::string text = "*NODE\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    text += columns({static_cast<Index>(i) + 1}, 8);
    for (int k = 0; k < 3; ++k) text += right(short_number(mesh.nodes[i][k] * form.length, 15), 16);
    text += "\n";
  }
  text += "*ELEMENT_SHELL\n";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto& ids = mesh.elements[e];
    text += columns({static_cast<Index>(e) + 1, 1, ids[0] + 1, ids[1] + 1, ids[2] + 1,
                     ids[triangle(ids) ? 2 : 3] + 1},
                    8) +
            "\n";
  }
  Index set = 0;
  for (const auto& [name, ids] : sets_of(mesh))
    text += "*SET_NODE_LIST_TITLE\n" + name + "\n" + columns({++set}, 10) + "\n" + rows(ids, 8, 10, "");
  return text;
}

std::string radioss_lines(const Mesh& mesh, const DeckForm& form) {
  check(mesh);
  std::string text = "/NODE\n";
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    text += columns({static_cast<Index>(i) + 1}, 10);
    for (int k = 0; k < 3; ++k) text += right(short_number(mesh.nodes[i][k] * form.length, 19), 20);
    text += "\n";
  }
  for (const bool three : {false, true}) {
    bool first = true;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      const auto& ids = mesh.elements[e];
      if (triangle(ids) != three) continue;
      if (first) text += three ? "/SH3N/1\n" : "/SHELL/1\n";
      first = false;
      text += columns({static_cast<Index>(e) + 1, ids[0] + 1, ids[1] + 1, ids[2] + 1}, 10);
      text += (three ? "" : columns({ids[3] + 1}, 10)) + "\n";
    }
  }
  Index group = 0;
  for (const auto& [name, ids] : sets_of(mesh))
    text += "/GRNOD/NODE/" + std::to_string(++group) + "\n" + name + "\n" + rows(ids, 10, 10, "");
  return text;
}

}  // namespace fabricsh::format
