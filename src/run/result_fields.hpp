// The fields that a run shows, one row each. VTK files, tables, a:field, a:mean, a:node, a:element, pictures,
// help and the reference take names, units and numbers from here and from nowhere else.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace fabricsh::run {

class Run;
struct ElementValues;

enum class Place { node, point, element, facet };
// How many numbers: 1; 2, mostly of the warp and of the weft; 3, global; 5, symmetric in material axes
// without 33: 11 22 23 13 12.
enum class Shape { scalar, pair, vector, tensor };
const char* name(Place place);
const char* name(Shape shape);

struct ResultField {
  std::string name;  // also of the array in a file
  std::string unit;  // SI; empty: a plain number
  Shape shape;
  Place place;
  std::string sentence;
  // Its numbers by name, each of which can be asked for alone: "E11". A scalar has its own name; none: only
  // whole.
  std::vector<std::string> components;
  // Of one node or element; out has room for all numbers.
  std::function<void(const Run&, mesh::Index, double* out)> values;
  std::vector<std::string> labels = {};  // of the components in a file; none: x y z, which need no words
  std::string letter = {};               // of a vector's length in a picture: |u|
  bool usual = true;                     // in a file for which no fields were chosen
  bool moving = false;                   // only of runs in motion
  bool touching = false;                 // only of runs with contact

  std::size_t size() const;
};

const std::vector<ResultField>& result_fields();
bool has(const Run& run, const ResultField& field);

// A field, or one number of it.
struct FieldPart {
  const ResultField* field;
  int component;  // -1: all of it
};
// Error: unknown name, with the nearest one.
FieldPart find_field(const std::string& name);

// Names of single numbers, then those of whole fields.
std::vector<std::string> scalar_names();
std::vector<std::string> scalar_names(Place place);
std::vector<std::string> field_names();

// All numbers of a field, or one of them, item by item.
std::vector<double> values_of(const Run& run, const FieldPart& part);

// The members of ElementValues that are fields.
const std::vector<double ElementValues::*>& element_members();

}  // namespace fabricsh::run
