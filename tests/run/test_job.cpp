// A run with all that it writes, driven without a deck.
#include "catch.hpp"
#include "message_of.hpp"
#include "run/dynamic.hpp"
#include "run/job.hpp"
#include "run/problems.hpp"
#include "scratch.hpp"
#include "test_cards.hpp"

using namespace fabricsh;
using namespace fabricsh::test;

namespace {

std::shared_ptr<run::Run> falling(double gravity = -9.81) {
  auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(0.1, 0.1, 3, 3));
  auto m = std::make_shared<model::Model>(mesh, isotropic(1e6, 0.3, 1e-3), model::Options{});
  m->fix("bottom", model::parse_freedoms("x y z"));
  m->gravity(model::steady({0, 0, gravity}));
  run::DynamicOptions options;
  options.duration = 1e-3;
  return run::make_dynamic(m, options, quiet());
}

struct Outputs {
  std::string folder;
  void of(run::Job& job) const {
    job.record(folder + "/fall.csv", {{"z", [](const run::Run& r) { return r.node(15).u.z(); }, "m"}}, 1e-4);
    job.vtk(folder + "/fall", 2.5e-4, {"displacement"});
    job.checkpoint(folder + "/fall.ckpt", 2.5e-4);
  }
};

}  // namespace

TEST_CASE("a job writes its table, its series, a run.json and a checkpoint") {
  const ScratchFolder scratch;
  run::Job job(falling());
  Outputs{scratch.path}.of(job);
  job.solve();
  const std::string table = content_of(scratch / "fall.csv");
  CHECK(table.starts_with("time (s),z (m)\n0,0\n"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 12);
  CHECK(scratch.listing() == std::set<std::string>{"fall.csv", "fall.pvd", "fall.ckpt", "run.json",
                                                   "fall_00000.vtu", "fall_00001.vtu", "fall_00002.vtu",
                                                   "fall_00003.vtu", "fall_00004.vtu"});
  const std::string report = content_of(scratch / "run.json");
  CHECK(report.find("\"status\": \"done\"") != std::string::npos);
  CHECK(report.find("\"kind\": \"dynamic\"") != std::string::npos);
}

namespace {

// The calls that it gets, in one word each; a table's rows at that moment.
struct Heard final : run::Listener {
  Heard(ListenerOrder t, std::string f, std::vector<std::string>& w) : at(t), table(std::move(f)), words(w) {}
  ListenerOrder at;
  std::string table;
  std::vector<std::string>& words;
  ListenerOrder turn() const override { return at; }
  void say(const char* event) {
    const std::string text = content_of(table);
    words.push_back(std::string(at == ListenerOrder::output ? "first " : "last ") + event + " " +
                    std::to_string(std::count(text.begin(), text.end(), '\n') - 1));
  }
  void begin(run::Job&) override { say("begin"); }
  void step(run::Job& job) override {
    if (job.run().steps().size() == 1) say("step");
  }
  void end(run::Job&, const run::Ending& ending) override { say(ending.status.c_str()); }
  void forget(run::Job&) override { say("forget"); }
  void restored(run::Job&) override { say("restored"); }
  void save(std::vector<run::Checkpoint::CheckpointPart>&) override { say("save"); }
};

}  // namespace

TEST_CASE("listeners hear each event once, in the order of their turns, and back through it at a restore") {
  const ScratchFolder scratch;
  run::Job job(falling());
  std::vector<std::string> words;
  const std::string table = scratch / "fall.csv";
  using ListenerOrder = run::Listener::ListenerOrder;
  job.listen(std::make_shared<Heard>(ListenerOrder::watch, table, words));
  job.record(table, {{"z", [](const run::Run& r) { return r.node(15).u.z(); }, "m"}}, 5e-4);
  job.listen(std::make_shared<Heard>(ListenerOrder::output, table, words));
  const auto start = job.run().snapshot();
  job.solve();
  job.now();
  job.run().restore(*start);
  CHECK(words == std::vector<std::string>{"first begin 0", "last begin 0", "first step 1", "last step 1",
                                          "first done 3", "last done 3", "first save 3", "last save 3",
                                          "first forget 3", "last forget 3", "last restored 3",
                                          "first restored 3"});
}

TEST_CASE("a job that another process goes on with writes what one that was never cut writes") {
  const ScratchFolder whole, cut;
  {
    run::Job job(falling());
    Outputs{whole.path}.of(job);
    job.solve();
  }
  {
    run::Job job(falling());
    Outputs{cut.path}.of(job);
    job.advance(5e-4);
    CHECK(content_of(cut / "run.json").find("\"status\": \"under way\"") != std::string::npos);
  }
  run::Job job(falling());
  job.restart(cut / "fall.ckpt");
  Outputs{cut.path}.of(job);
  job.solve();
  CHECK(content_of(cut / "fall.csv") == content_of(whole / "fall.csv"));
  for (int i = 0; i < 5; ++i) {
    const std::string frame = "fall_0000" + std::to_string(i) + ".vtu";
    CHECK(content_of(cut / frame) == content_of(whole / frame));
  }
}

TEST_CASE("a checkpoint is refused by another problem, and by outputs that it does not have") {
  const ScratchFolder scratch;
  {
    run::Job job(falling());
    Outputs{scratch.path}.of(job);
    job.advance(5e-4);
  }
  run::Job other(falling(-1.62));
  CHECK(message_of([&] {
          other.restart(scratch / "fall.ckpt");
        }).find("is of another problem: it differs in ") != std::string::npos);
  run::Job job(falling());
  job.restart(scratch / "fall.ckpt");
  job.record(scratch / "fall.csv", {{"z", [](const run::Run& r) { return r.node(15).u.z(); }, "m"}}, 1e-4);
  CHECK(message_of([&] {
          job.record(scratch / "more.csv", {}, 1e-4);
        }).find("the run that wrote it had no table '") != std::string::npos);
  CHECK(message_of([&] { job.solve(); }).find("which this run does not continue") != std::string::npos);
  run::Job late(falling());
  late.record(scratch / "late.csv", {}, 1e-4);
  CHECK(message_of([&] { late.restart(scratch / "fall.ckpt"); }).find("expected to be called before") !=
        std::string::npos);
}

TEST_CASE("a checkpoint of a build that derives other masses, or compared other parts, is refused") {
  const ScratchFolder scratch;
  const auto run = falling();
  run::Checkpoint c = run::checkpoint_of(*run);
  run->advance(5e-4);
  CHECK(run::difference(c, *run).empty());  // what is derived does not change as a run goes on
  c.edition = 2;
  run::write_checkpoint(scratch / "old.ckpt", c);
  says(message_of([&] { run::read_checkpoint(scratch / "old.ckpt"); }), "another build of fabricsh wrote it");
  int changed = 0;
  for (auto& part : c.problem)
    if (part.name.starts_with("masses of the nodes")) part.hash += static_cast<std::uint64_t>(++changed);
  CHECK(changed == 1);
  says(run::difference(c, *run), "the masses of the nodes or default contact (which another build derives");
}

TEST_CASE("two outputs of a job on one path are refused; a failure leaves the last state and its reason") {
  const ScratchFolder scratch;
  run::Job job(falling());
  Outputs{scratch.path}.of(job);
  CHECK(message_of([&] {
          job.record(scratch / "fall.csv", {}, 1e-4);
        }).find("is an output of this run already") != std::string::npos);
  job.run().every(6e-4, [](run::Run& r) {
    if (r.time() > 0) throw Error("the hook has had enough");
  });
  CHECK(message_of([&] { job.solve(); }) == "the hook has had enough");
  CHECK(content_of(scratch / "run.json").find("the hook has had enough") != std::string::npos);
  const std::string broken = content_of(scratch / "fall.csv");
  CHECK(std::count(broken.begin(), broken.end(), '\n') == 8);
  job.solve();
  const std::string table = content_of(scratch / "fall.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 12);
}

TEST_CASE(
    "a hook may throw anything: the run's record says so, and the job goes on when it is driven again") {
  const ScratchFolder scratch;
  run::Job job(falling());
  Outputs{scratch.path}.of(job);
  job.run().every(6e-4, [](run::Run& r) {
    if (r.time() > 0) throw 42;
  });
  CHECK_THROWS_AS(job.solve(), int);
  CHECK(!job.driving());
  CHECK(content_of(scratch / "run.json").find("\"status\": \"an error in a hook\"") != std::string::npos);
  job.solve();
  CHECK(content_of(scratch / "run.json").find("\"status\": \"done\"") != std::string::npos);
}

TEST_CASE("an obstacle to an output is told when it is declared") {
  const ScratchFolder scratch;
  run::Job job(falling());
  CHECK(message_of([&] {
          job.record(scratch / "x.csv", {{"z", {}, "m"}});
        }).find("record: column 'z': expected a function") != std::string::npos);
  std::filesystem::create_directory(scratch / "folder");
  CHECK(message_of([&] { job.checkpoint(scratch / "folder"); }).find("Is a directory") != std::string::npos);
  std::ofstream(scratch / "file") << "x";
  CHECK(message_of([&] { job.checkpoint(scratch / "file/x.ckpt"); }).find("Not a directory") !=
        std::string::npos);
  CHECK(scratch.listing() == std::set<std::string>{"file", "folder"});
  job.checkpoint(scratch / "run.ckpt");
  CHECK(scratch.listing() == std::set<std::string>{".fabricsh.lock", "file", "folder"});  // held from here on
}

namespace {

// Tables and series with rows at other times than the interruption; a checkpoint is written only where a run
// ends, as by default in the first ten minutes.
void sparse_outputs(run::Job& job, const std::string& folder) {
  job.record(folder + "/fall.csv", {{"z", [](const run::Run& r) { return r.node(15).u.z(); }, "m"}}, 1.5e-4);
  job.vtk(folder + "/fall", 4e-4, {"displacement"});
  job.checkpoint(folder + "/fall.ckpt");
}

std::shared_ptr<run::Job> gone_on(const std::string& folder) {
  auto job = std::make_shared<run::Job>(falling());
  job->restart(folder + "/fall.ckpt");
  sparse_outputs(*job, folder);
  return job;
}

// Throws after the step that passes the time, as a signal does.
struct Interrupting final : run::Listener {
  explicit Interrupting(double t) : time(t) {}
  double time;
  ListenerOrder turn() const override { return ListenerOrder::watch; }
  void step(run::Job& job) override {
    if (job.run().time() > time) throw Error("interrupted");
  }
};

void interrupt_at(run::Job& job, double time) { job.listen(std::make_shared<Interrupting>(time)); }

void check_same(const ScratchFolder& one, const ScratchFolder& other) {
  for (const char* name : {"fall.csv", "fall.pvd", "fall_00000.vtu", "fall_00001.vtu", "fall_00002.vtu"}) {
    INFO(name);
    CHECK((content_of(one / name) == content_of(other / name)));
  }
}

}  // namespace

TEST_CASE("an interrupted job goes on from its checkpoint however often it is killed before the next one") {
  const ScratchFolder whole, cut;
  run::Job undisturbed(falling());
  sparse_outputs(undisturbed, whole.path);
  undisturbed.solve();
  {
    run::Job job(falling());
    sparse_outputs(job, cut.path);
    interrupt_at(job, 3.7e-4);
    CHECK(message_of([&] { job.solve(); }) == "interrupted");
  }
  const auto rows = [&] {
    const std::string table = content_of(cut / "fall.csv");
    return std::count(table.begin(), table.end(), '\n');
  };
  CHECK(rows() == 1 + 3 + 1);  // the last one at the moment of the interruption
  for (const double time : {4e-4, 5e-4, 9.5e-4}) {
    const auto job = gone_on(cut.path);
    job->take_up();
    job->begin();
    CHECK(rows() == 1 + 3);
    job->run().advance(time);  // then the process is killed
  }
  {
    const auto job = gone_on(cut.path);  // interrupted again, so that there is a new checkpoint
    interrupt_at(*job, 6.2e-4);
    CHECK(message_of([&] { job->solve(); }) == "interrupted");
  }
  {
    const auto begun = gone_on(cut.path);  // killed at once
    begun->take_up();
    begun->begin();
  }
  gone_on(cut.path)->solve();
  check_same(whole, cut);
}

TEST_CASE("a job killed after it has returned to a snapshot goes on from the checkpoint") {
  const ScratchFolder whole, cut;
  run::Job undisturbed(falling());
  sparse_outputs(undisturbed, whole.path);
  undisturbed.advance(2e-4);
  undisturbed.solve();
  {
    run::Job job(falling());
    sparse_outputs(job, cut.path);
    job.advance(2e-4);
    const auto snapshot = job.run().snapshot();
    interrupt_at(job, 7.1e-4);
    CHECK(message_of([&] { job.solve(); }) == "interrupted");  // the checkpoint counts rows up to here
    job.run().restore(*snapshot);
  }
  const std::string table = content_of(cut / "fall.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 2);
  const auto job = gone_on(cut.path);
  job->take_up();
  CHECK(job->run().time() == 2e-4);
  job->solve();
  check_same(whole, cut);
}

namespace {

std::uintmax_t bytes_in(const ScratchFolder& scratch) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path))
    bytes += entry.path().string().find(".ckpt") != std::string::npos ? entry.file_size() : 0;
  return bytes;
}

// As many jobs as a deck of many small runs makes, each with its checkpoint in a file of its own or in one.
void run_many(const ScratchFolder& scratch, int count, bool own) {
  const auto journal = std::make_shared<run::Journal>();
  for (int i = 1; i <= count; ++i) {
    run::Job job(falling(), journal, i);
    job.checkpoint(scratch / (own ? std::to_string(i) + ".ckpt" : "all.ckpt"), 2.5e-4);
    job.solve();
  }
}

}  // namespace

TEST_CASE("checkpoints of many finished jobs keep each of them once") {
  for (const bool own : {true, false}) {
    const ScratchFolder few, many;
    run_many(few, 4, own);
    run_many(many, 16, own);
    // Besides the states there are only the names of the others.
    CHECK(static_cast<double>(bytes_in(many)) < 4.4 * static_cast<double>(bytes_in(few)));
    const auto last = run::read_checkpoint(many / (own ? "16.ckpt" : "all.ckpt"));
    CHECK(last->number == 16);
    REQUIRE(last->finished.size() == 15);
    for (const auto& finished : last->finished) {
      CHECK(finished.file ==
            (own ? "" : "all.ckpt.") + std::to_string(finished.number) + (own ? ".ckpt" : ""));
      CHECK(run::read_finished(*last, finished)->number == finished.number);
    }
    CHECK(last->finished_run(3)->number == 3);
    CHECK(last->finished_run(16) == nullptr);
    const std::string file = many / last->finished[4].file;
    std::filesystem::copy_file(many / last->finished[7].file, file,
                               std::filesystem::copy_options::overwrite_existing);
    CHECK(message_of([&] { run::read_finished(*last, last->finished[4]); }) ==
          "checkpoint '" + file + "': it is not as it was when '" + last->path + "' was written");
  }
}

TEST_CASE("a finished job whose checkpoint somebody has removed is forgotten by the others") {
  const ScratchFolder scratch;
  const auto journal = std::make_shared<run::Journal>();
  for (int i = 1; i <= 3; ++i) {
    run::Job job(falling(), journal, i);
    job.checkpoint(scratch / "all.ckpt", 2.5e-4);
    if (i == 2) std::filesystem::remove(scratch / "all.ckpt");
    job.solve();
  }
  const auto last = run::read_checkpoint(scratch / "all.ckpt");
  REQUIRE(last->finished.size() == 1);
  CHECK(last->finished[0].number == 2);
}
