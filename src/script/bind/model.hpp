// Shared by the bindings of a model: components, frames and directions read from a call.
#pragma once
#include "model/model.hpp"
#include "script/call/call.hpp"
#include "script/values/classes.hpp"

namespace fabricsh::script {

Vec3 read_vector(const std::vector<double>& v, const std::string& what);  // Error unless three numbers
// Of the arguments "set" or, in its place, "line": two points or more.
std::pair<std::string, std::vector<Vec3>> read_set_or_line(const Call& call);
model::Components read_components(const Call& call);  // of argument "components"
Mat3 read_frame(const Call& call);                    // of argument "options", field frame
Argument components_row(const char* unit, const char* sentence);
Argument frame_row();
Argument set_or_body_row();
std::vector<Argument> model_rows();  // of fabric.model: its bodies, each with a card or plies and regions
int make_model(Call& call);          // pushes the model
std::string sample_model();          // for examples: defines fabric, mesh and m, a strip of three elements
int return_self(const Call& call);   // so that methods of a model can be chained
// Declares it, and returns the model.
template <class Declaration>
int declare(const Call& call, Declaration declaration) {
  call.self<model::Model>()->add(std::move(declaration));
  return return_self(call);
}
void bind_loads(Session& session);
void bind_told(Session& session);
void bind_declared(Session& session);
void bind_declarations(Session& session);
void bind_ties(Session& session);
void bind_seams(Session& session);
void bind_creases(Session& session);
void bind_gas(Session& session);
void bind_contact(Session& session);

}  // namespace fabricsh::script
