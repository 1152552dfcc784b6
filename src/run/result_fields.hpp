// The fields of a run, one row each. VTK files, tables, a:field, a:mean, a:node, a:element, pictures, help
// and the reference all take names, units and values from here. A term that a C++ program adds to a run shows
// further ones (mechanics::Term::shows).
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mechanics/term.hpp"
#include "mesh/mesh.hpp"

namespace fabricsh::run {

class Readings;
struct ElementValues;

enum class FieldPlace { node, point, element, facet };
// Number of values: 1; 2, mostly for warp and weft; 3, global; 5, symmetric tensor in material axes without
// 33, in the order 11 22 23 13 12 (files have six, in VTK's order).
enum class FieldShape { scalar, pair, vector, tensor };
const char* name(FieldPlace place);
const char* name(FieldShape shape);

struct ResultField {
  std::string name;  // also the name of the array in a file
  std::string unit;  // SI; empty: dimensionless
  FieldShape shape;
  FieldPlace place;
  std::string sentence;
  // Names of its single values, each of which is available alone: "E11". A scalar has its own name; empty:
  // only the whole field is available.
  std::vector<std::string> components;
  // Computes the values for one node or element, of a ply or (empty) of all; out has room for all of them.
  std::function<void(const Readings&, mesh::Index, const std::string& ply, double* out)> values;
  std::vector<std::string> labels = {};  // of the components in a file; empty: x y z
  std::string letter = {};               // for a vector's length in a picture: |u|
  bool usual = true;                     // written to files for which no fields were chosen
  bool moving = false;                   // only in dynamic runs
  bool touching = false;                 // only in runs with contact
  bool continuous = true;                // of elements: the mean over neighbours is meaningful
  bool by_ply = false;                   // each ply has values of its own
  bool of_yarns = false;                 // of plies with different axes there are only those
  // For a field whose values are found only all together; `values` is then empty.
  std::function<std::vector<double>(const Readings&)> all = {};

  std::size_t size() const;
};

const std::vector<ResultField>& result_fields();
bool has(const Readings& run, const ResultField& field);
// Those of result_fields(), whether the run has them or not, and those that its added terms show.
std::vector<const ResultField*> fields_of(const Readings& run);
ResultField field_of(const mechanics::TermField& shown);

// A field, or one of its values; of one ply, or of all together.
struct FieldPart {
  const ResultField* field;
  int component;         // -1: the whole field
  std::string ply = {};  // see Model::ply_of; empty: all
  std::string array() const { return (ply.empty() ? "" : ply + ".") + field->name; }  // its name in a file
};
// "E11", "E"; of a ply "ply2.E11", or by its name "face.E11". Errors: unknown name (the message has the
// nearest one); a field that has no values by ply. Whether there is such a ply is known to a run alone.
FieldPart find_field(const std::string& name);
// Also of its added terms. Further errors: the run has no such ply; a field that plies with different axes
// have only each for itself.
FieldPart find_field(const Readings& run, const std::string& name);
bool is_field(const Readings& run, const std::string& name);

// Errors: the run has no such field, because nothing touches in it; one of several numbers; a set that is
// unknown or holds no node or whole element: what would prevent Readings::mean from reading it at any time.
void check_mean(const Readings& run, const std::string& name, const std::string& set);

// Names of single values, then those of whole fields.
std::vector<std::string> scalar_names();
std::vector<std::string> scalar_names(FieldPlace place);
std::vector<std::string> field_names();

// A field, or one of its values, for all nodes or elements.
std::vector<double> values_of(const Readings& run, const FieldPart& part);

// The members of ElementValues that are fields.
const std::vector<double ElementValues::*>& element_members();

}  // namespace fabricsh::run
