// Shared by the bindings of models and analyses.
#pragma once
#include "script/bind/rooms.hpp"
#include "script/runs/run.hpp"

namespace fabricsh::script {

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
void bind_runs(Session& session);
void bind_modes(Session& session);
void bind_outputs(Session& session);
void bind_keep(Session& session);
void bind_check(Session& session);
void bind_table(Session& session);
void bind_lab(Session& session);
void bind_photographs(Session& session);
void bind_identify(Session& session);
void bind_sample(Session& session);

}  // namespace fabricsh::script
