// Shared by the bindings of models and analyses.
#pragma once
#include "script/bind/rooms.hpp"
#include "script/runs/run.hpp"

namespace fabricsh::script {

// The rows of a run that may begin from the state of another one, and what a call gives of them. Errors:
// neither a model nor such a run; a release without one; a run that has made no step.
std::vector<Argument> with_beginning(std::vector<Argument> others);
struct Begins {
  std::shared_ptr<model::Model> model;
  run::Beginning beginning;
};
Begins read_beginning(Call& call);
// s, the time at which it ends, for what is said of it.
void say_beginning(Call& call, const run::Run& run);

// For examples: defines fabric, mesh, m and a, a strip of three elements pulled in 4 steps.
std::string sample_run();

void bind_point(Session& session);
void bind_model(Session& session);
void bind_files(Session& session);
void bind_plot(Session& session);
void bind_render(Session& session);
void bind_gltf(Session& session);
void bind_analysis(Session& session);
void bind_joints(Session& session);
void bind_static(Session& session);
void bind_dynamic(Session& session);
void bind_modes(Session& session);
void bind_outputs(Session& session);
void bind_keep(Session& session);
void bind_check(Session& session);
void bind_table(Session& session);
void bind_lab(Session& session);
void bind_track(Session& session);
void bind_identify(Session& session);
void bind_sample(Session& session);

}  // namespace fabricsh::script
