// run.json, beside the outputs of a run: program, options, steps, energy balance, warnings. It is written
// when a run first begins, and where each call ends.
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "base/hash.hpp"
#include "base/version.hpp"
#include "card/fields.hpp"
#include "run/job.hpp"
#include "simd/isa.hpp"
#include "system/atomic.hpp"

namespace fabricsh::run {

namespace {

format::Json steps_json(const Run& run) {
  std::int64_t iterations = 0, cuts = 0;
  double worst = 0;
  for (const auto& step : run.steps()) {
    iterations += step.iterations;
    cuts += step.cuts;
    if (!step.residuals.empty()) worst = std::max(worst, step.residuals.back());
  }
  format::Json json = format::Json::object();
  json.set("count", run.steps().size()).set("iterations", iterations).set("cuts", cuts);
  json.set("largest_final_residual", worst).set("tolerance", run.tolerance());
  if (run.moves()) return json;
  const auto of = [&](solver::Stability kind) {
    return std::count_if(run.steps().begin(), run.steps().end(),
                         [kind](const StepReport& step) { return step.stability == kind; });
  };
  json.set("stable", of(solver::Stability::stable)).set("unstable", of(solver::Stability::unstable));
  json.set("unchecked", of(solver::Stability::unchecked));
  return json;
}

format::Json beyond_json(const Run& run) {
  const auto far = run.beyond();
  if (!far) return {};
  format::Json json = format::Json::object();
  json.set("share", far->strain_ratio).set("yarn", far->yarn).set("element", far->element + 1);
  json.set("time", far->time).set("first", far->first).set("elements", run.elements_beyond());
  return json.set("strain", far->strain).set("tested", far->tested);
}

format::Json warnings_json(const Run& run) {
  format::Json list = format::Json::array();
  for (const Warning& w : run.warnings()) {
    format::Json json = format::Json::object();
    json.set("code", w.code).set("text", w.text).set("time", w.time);
    if (w.element >= 0) json.set("element", w.element + 1);
    list.push(json.set("serious", w.serious));
  }
  return list;
}

format::Json energies_json(const EnergyAccount& account) {
  format::Json json = format::Json::object();
  for (const auto& [name, value] : energies(account)) json.set(name, value);
  return json;
}

format::Json report(const Job& job, const std::string& status) {
  const Run& run = job.run();
  const model::Model& model = run.model();
  format::Json mine = format::Json::object();
  mine.set("number", job.number()).set("kind", run.kind()).set("card", model.card().name);
  mine.set("card_hash", hash_text(card::lua_text(model.card()))).set("model", model.describe());
  mine.set("status", status)
      .set("time", run.time())
      .set("duration", run.duration())
      .set("seconds", job.seconds());
  const EnergyAccount energy = run.energy();
  mine.set("steps", steps_json(run)).set("energy_error", energy.error);
  mine.set("energies", energies_json(energy));
  mine.set("beyond", beyond_json(run)).set("warnings", warnings_json(run));
  if (run.moves()) mine.set("scaled_inertia", run.scaled_share());
  format::Json outputs = format::Json::array();
  for (const auto& output : job.outputs()) outputs.push(output->written);
  mine.set("outputs", std::move(outputs));
  return mine;
}

void write(const Job& job, const std::string& status) {
  if (job.outputs().empty()) return;
  const format::Json mine = report(job, status);
  Journal& journal = job.journal();
  std::set<std::string> folders;
  for (const auto& output : job.outputs())
    folders.insert(std::filesystem::path(output->written).parent_path().string());
  for (const std::string& folder : folders) {
    auto& runs = journal.folders[folder];
    runs[job.number()] = mine;
    format::Json json = format::Json::object();
    json.set("program", "fabricsh").set("version", version()).set("build", build_kind());
    json.set("compiler", compiler()).set("instructions", name(best_isa()));
    if (journal.about) journal.about(json);
    json.set("threads", omp_get_max_threads());
    format::Json list = format::Json::array();
    for (const auto& [number, record] : runs) list.push(record);
    json.set("runs", list);
    system::write_file((folder.empty() ? "" : folder + "/") + "run.json", json.text(), system::Sync::no,
                       system::Folder::expect);
  }
}

class RunJson final : public Listener {
  ListenerOrder turn() const override { return ListenerOrder::report; }
  void begin(Job& job) override {
    if (job.seconds() == 0) write(job, "running");
  }
  void end(Job& job, const Ending& ending) override { write(job, ending.status); }
};

}  // namespace

std::shared_ptr<Listener> make_run_json() { return std::make_shared<RunJson>(); }

std::string hash_text(const std::string& bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "fnv1a64:%016llx", static_cast<unsigned long long>(hash(bytes)));
  return text;
}

}  // namespace fabricsh::run
