// A user of the core: a square of cloth, held at two corners, falls under its weight. The run writes a table,
// a series for ParaView and a checkpoint.
//
//   drape <folder>           the whole run
//   drape <folder> stop      the first half; its checkpoint stays
//   drape <folder> go-on     the rest, from the checkpoint
#include <cstdio>
#include <memory>
#include <string>

#include "run/dynamic.hpp"
#include "run/job.hpp"

int main(int count, char** words) {
  using namespace fabricsh;
  const std::string folder = count > 1 ? words[1] : "out", how = count > 2 ? words[2] : "whole";
  card::Card cloth;
  cloth.name = "linear";
  cloth.source = "example";
  cloth.density = 500;
  cloth.thickness = 3e-4;
  cloth.law = card::Svk{1e6, 1e6, 1e6 / 2.6, 0.3, 0.3, std::nullopt, std::nullopt};

  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.3, 0.3, 8, 8));
  mesh->define("held", mesh::NodeSet{72, 80});  // the two upper corners
  mesh->define("middle", mesh::NodeSet{40});
  auto model = std::make_shared<model::Model>(mesh, cloth, model::Options{});
  model->fix("held", model::parse_freedoms("x y z"));
  model->gravity(model::steady({0, 0, -9.81}));

  run::DynamicOptions options;
  options.duration = 0.04;
  options.mass_damping = 5;
  auto notices = std::make_shared<Notices>();
  run::Job job(run::make_dynamic(model, options, notices));
  if (how == "go-on") job.restart(folder + "/drape.ckpt");
  job.record(folder + "/drape.csv",
             {{"middle_z", [](const run::Run& r) { return r.node(40).u.z(); }, "m"},
              {"weight", [](const run::Run& r) { return r.reaction("held").z(); }, "N"}},
             0.005);
  job.vtk(folder + "/drape", 0.01);
  job.checkpoint(folder + "/drape.ckpt", 0.01);

  try {
    job.advance(how == "stop" ? options.duration / 2 : options.duration);
  } catch (const Error& error) {  // of what was asked for; NumericalFailure: of the numbers
    std::printf("%s\n", error.what());
    return 1;
  }
  const auto& energy = job.run().energy();
  std::printf("at %g s the middle is %.3f mm lower, ledger error %.1e\n", job.run().time(),
              -1e3 * job.run().node(40).u.z(), energy.error);
  return 0;
}
