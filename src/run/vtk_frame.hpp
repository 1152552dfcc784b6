// The state of a run as a VTK grid: what a frame of a series holds, and what a:write puts into a .vtu.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "format/vtu.hpp"
#include "run/recovery.hpp"
#include "run/result_fields.hpp"

namespace fabricsh::run {

struct VtkContents {
  std::vector<std::string> fields = {};  // names of find_field(); empty: the usual ones
  bool reference = false;                // points where the nodes were, not where they are
  bool averaged = false;                 // fields of elements also on the points, by recovery
};

// Points, cells, and arrays: displacement and reference position always, the fields, and the node sets as 0
// and 1 (but for those of all nodes). A name of one number of a tensor or pair ("E12") puts that number
// alone into the array of its field; where that leaves a tensor whole, it is in VTK's order: 11 22 33 12
// 23 13. Fields of single plies follow in arrays of their own, "ply2.E".
class VtkFrame {
 public:
  VtkFrame(const Readings& run, const VtkContents& contents);
  VtkFrame(const VtkFrame&) = delete;
  VtkFrame& operator=(const VtkFrame&) = delete;
  const format::VtuGrid& grid() const { return grid_; }

 private:
  void add_field(const Readings& run, const VtkContents& contents, const ResultField& field,
                 const std::string& ply);
  void add_average(const Readings& run, format::Array array, bool directions);
  void add_sets(const Readings& run);
  std::vector<Vec3> points_;
  format::VtuGrid grid_;
  std::unique_ptr<Recovery> recovery_;  // once it is needed
};

// Error, of the call's name: a name that is no field's.
void check_fields(const Readings& run, const VtkContents& contents, const std::string& call);

// The whole field of a run, of the part's ply, as an array of a file.
format::Array array_of(const Readings& run, const FieldPart& part);

}  // namespace fabricsh::run
